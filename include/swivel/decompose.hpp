#ifndef SWIVEL_DECOMPOSE_HPP
#define SWIVEL_DECOMPOSE_HPP

#include "swivel/types.hpp"

// decompose: a rotation into swing and twist
//
// Formula    With a the unit axis, u = a.v and r = sqrt(w^2 + u^2)
//              twist   T = (u/r a, w/r)                                           always unit
//              swing   S = q T* for q = S T, or R = T* q for q = T R;  S.w = R.w = r
//            For a coordinate axis with (A; B, C) = (x; y, z), (y; z, x) or (z; x, y):
//              tc = w/r   ts = A/r   sc = r   s1 = tc B - ts C   s2 = tc C + ts B   (q = S T)
//                                             s1 = tc B + ts C   s2 = tc C - ts B   (q = T R)
// Domain     Any quaternion with 2^-26 <= |q| < 2^63 (double: 2^-427 <= |q| < 2^511), unit or not: |S| = |q|.
//            Below that range more and more elements count as at the pole; above it they come out as NaN.
// Pole       w^2 + u^2 <= pole_threshold |q|^2: T = (0, 0, 0, sgn w), S = (sgn(w) (v - u a), |w|), where sgn
// w is
//            the sign bit of w, so that -0 counts as negative. At every element, at the pole and off it, |T|
//            = 1, S is perpendicular to a, S(-q) = S(q), T(-q) = -T(q), and at the default threshold S T = q
//            to rounding. Near the pole the twist is ill conditioned: if q carries noise h, the twist angle
//            is known to about 2.8 h / r radians; S T, |T|, |S| and perpendicularity do not suffer. The zero
//            quaternion gives T = (0, 0, 0, sgn w), S = 0.
// NaN/Inf    An element with a NaN or an infinity in any component of q or of its own axis comes out as NaN
// in
//            every component (a kept sign is 1 or -1 still); no other element is affected.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), largest seen by tools/accuracy_report, see README:
//            reproducible: |T| and |S| 4, S T against q 8, a.S 3, and about a coordinate axis T and S 4 each;
//            fast: norms 5, S T 10. About another axis T and S carry in addition about 1/r units.
// Identity   (0, 0, 0, 1) gives T = S = (0, 0, 0, 1) to rounding, exactly in reproducible.
// Aliasing   Outputs may be exactly inputs, stream for stream in any pairing (types.hpp).
// Cost       One pass, 4 streams in and 8 (compact: 5) out. bench/README.md has figures.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", Algorithm 1; compact form:
// Reynolds,
//            "Quaternion swing-twist decomposition".

namespace swivel {

// Both factors as quaternions.
status decompose(quat_view<const float> q, twist_axis<float> a, quat_view<float> swing,
                 quat_view<float> twist, options = {}) noexcept;
status decompose(quat_view<const double> q, twist_axis<double> a, quat_view<double> swing,
                 quat_view<double> twist, options = {}) noexcept;

// The same with options::positive_twist, and what was flipped kept: signs is -1 where the twist is that of
// -q, and 1 elsewhere. compose() with the same signs restores q itself instead of the rotation. (The options have
// no default here, so that {} in their place stays unambiguous above.)
status decompose(quat_view<const float> q, twist_axis<float> a, quat_view<float> swing,
                 quat_view<float> twist, scalar_view<float> signs, options) noexcept;
status decompose(quat_view<const double> q, twist_axis<double> a, quat_view<double> swing,
                 quat_view<double> twist, scalar_view<double> signs, options) noexcept;

// The compact form about a coordinate axis: the five numbers that are not zero.
status decompose(quat_view<const float> q, axis a, factor_view<float> out, options = {}) noexcept;
status decompose(quat_view<const double> q, axis a, factor_view<double> out, options = {}) noexcept;
status decompose(quat_view<const float> q, axis a, factor_view<float> out, scalar_view<float> signs,
                 options) noexcept;
status decompose(quat_view<const double> q, axis a, factor_view<double> out, scalar_view<double> signs,
                 options) noexcept;

}  // namespace swivel

#endif
