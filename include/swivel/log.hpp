#ifndef SWIVEL_LOG_HPP
#define SWIVEL_LOG_HPP

#include "swivel/types.hpp"

// log: the rotation vector of a rotation
//
// Formula    b = atan2(|v|, w)/|v| v, half of the angle of q times its unit axis; |b| <= pi, and exp(b) =
//            q/|q|. For one of q and -q |b| <= pi/2.
// Domain     Any quaternion with 2^-100 <= |q| < 2^126 (double: 2^-960, 2^1022), unit or not: the logarithm
//            of q/|q|. Outside it is less accurate, but finite.
// Singular   q = -1 (no vector part, w < 0) has a logarithm along every axis; it gets (pi, 0, 0). Beside it
//            there is one only, however small the vector part. The zero quaternion gives 0.
// NaN/Inf    An element with a NaN or an infinity in any component comes out as NaN in every component.
// Accuracy   Bounds of |b - exact| in units of 2^-24 (float) and 2^-53 (double), asserted by
//            exponentials_test.cpp over all rotations and lengths, relative to max(1, |b|): reproducible 4.5,
//            fast 6; and relative to |b|, where neither b nor the vector part of q is subnormal: reproducible
//            4.5, fast 7.5.
// Identity   (0, 0, 0, w) gives exactly 0 for w >= 0.
// Aliasing   Output streams may be exactly input streams (types.hpp).
// Cost       One pass, 4 streams in and 3 out; no branch, no table.
// Source     Dorst, "Rotors and motors".

namespace swivel {

status log(const quat_view<const float>& q, const vec3_view<float>& out, options = {}) noexcept;
status log(const quat_view<const double>& q, const vec3_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
