#ifndef SWIVEL_EXP_HPP
#define SWIVEL_EXP_HPP

#include "swivel/types.hpp"

// exp: the rotation of a rotation vector
//
// Formula    q = (sin|b|/|b| b, cos|b|). b is half of the angle times the unit axis: q turns by 2|b| about b.
// Domain     |b| <= 2^13 (double: 2^20). A longer b counts as 0 and gives the identity.
// Singular   Nowhere: exact at 0 and smooth through it.
// NaN/Inf    An element with a NaN or an infinity in any component comes out as NaN in every component.
// Accuracy   Bounds of |q - exact| in units of 2^-24 (float) and 2^-53 (double), asserted by
//            exponentials_test.cpp. Up to |b| = pi: reproducible 7, fast 12. Beyond, |b| is rounded: 2.5 (1 +
//            |b|), fast 5 (1 + |b|). Below 1/2 the vector part is right to 3 units of its own length, fast
//            7.5.
// Identity   0 gives exactly (0, 0, 0, 1).
// Aliasing   Output streams may be exactly input streams (types.hpp).
// Cost       One pass, 3 streams in and 4 out; no branch, no table.
// Source     Dorst, "Rotors and motors".

namespace swivel {

status exp(const vec3_view<const float>& b, const quat_view<float>& out, options = {}) noexcept;
status exp(const vec3_view<const double>& b, const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
