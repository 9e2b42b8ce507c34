#ifndef SWIVEL_POWER_HPP
#define SWIVEL_POWER_HPP

#include "swivel/types.hpp"

// power: a part or a multiple of a rotation
//
// Formula    q^t = exp(t log q): t times the angle of q about the same axis, the angle of q itself, not of
//            -q. t is one number for all elements or one for each, in [0, 1] or not.
// Domain     Any quaternion with 2^-100 <= |q| < 2^126 (double: 2^-960, 2^1022), unit or not: the power of
//            q/|q|, of length 1. Outside it is less accurate. t |log q| beyond 2^13 (double: 2^20) counts as
//            0 and gives the identity.
// Singular   q = -1 (no vector part, w < 0) is taken as the full turn about x. The zero quaternion gives
//            (0, 0, 0, 1).
// NaN/Inf    An element with a NaN or an infinity in any component of q or in t comes out as NaN in every
//            component.
// Accuracy   Bounds of |q^t - exact| in units of 2^-24 (float) and 2^-53 (double), asserted by
//            exponentials_test.cpp over all rotations and lengths, for |t| <= 1: reproducible 6, fast 7;
//            beyond, times |t|.
// Identity   t = 0 gives exactly (0, 0, 0, 1). In reproducible t = 1 gives q in every bit, whatever its
//            length; in fast q/|q| to rounding.
// Aliasing   Output streams may be exactly input streams (types.hpp).
// Cost       One pass, 4 streams in, 1 more for a t for each element, 4 out; no branch, no table. Quicker
//            than log and exp in turn.
// Source     Dorst, "Rotors and motors".

namespace swivel {

status power(const quat_view<const float>& q, const parameter<float>& t, const quat_view<float>& out,
             options = {}) noexcept;
status power(const quat_view<const double>& q, const parameter<double>& t, const quat_view<double>& out,
             options = {}) noexcept;

}  // namespace swivel

#endif
