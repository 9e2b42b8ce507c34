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
// Domain     Any quaternion with 2^-26 <= |q| < 2^63 (double: 2^-427 <= |q| < 2^511), unit or not; |S| = |q|.
//            Below, ever more elements count as at the pole; above, they come out as NaN.
// Pole       Where w^2 + u^2 <= pole_threshold |q|^2: T = (0, 0, 0, sgn w) and S = (sgn(w) (v - u a), |w|).
//            sgn w is the sign bit of w, so that -0 counts as negative. The zero quaternion gives S = 0.
//            Everywhere, the pole included: |T| = 1, S is perpendicular to a, S(-q) = S(q), T(-q) = -T(q),
//            and at the default threshold S T = q to rounding.
//            Near the pole the twist is ill conditioned: if q carries noise h, its angle is known to about
//            2.8 h / r radians. S T, |T|, |S| and perpendicularity do not suffer.
// NaN/Inf    An element with a NaN or an infinity in any component of q or of its own axis comes out as NaN
//            in every component (a kept sign is 1 or -1 still); no other element is affected.
// Accuracy   Bounds in units of 2^-24 (float) and 2^-53 (double), relative to |q|; tools/accuracy_report
//            measures them and decompose_test.cpp asserts them:
//                                                       |T|   |S|   S T - q   a.S
//              reproducible                              4     4       8       3
//              reproducible, an axis for each element    4.5   5.5     9.5     3.5
//              fast                                      5     5      10       3
//              fast, an axis for each element            7     7.5    13       5
//            T and S themselves: about a coordinate axis 4 (fast 5) at any distance from the pole above the
//            threshold; about another axis about 4/r (fast 6/r), since a.v is rounded.
// Identity   (0, 0, 0, 1) gives T = S = (0, 0, 0, 1) to rounding, exactly in reproducible.
// Aliasing   Outputs may be exactly inputs, stream for stream in any pairing (types.hpp).
// Cost       One pass; 4 streams in, 3 more for an axis for each element; 8 (compact: 5) out, 1 more for
//            signs. bench/README.md has figures.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", Algorithm 1; compact form:
//            Reynolds, "Quaternion swing-twist decomposition".

namespace swivel {

// Both factors as quaternions.
status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, options = {}) noexcept;
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist, options = {}) noexcept;

// The same with options::positive_twist, and what was flipped kept: signs is -1 where the twist is that of
// -q, and 1 elsewhere. compose() with the same signs restores q itself instead of the rotation. (The options
// have no default here, so that {} in their place stays unambiguous above.)
status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const scalar_view<float>& signs, options) noexcept;
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const scalar_view<double>& signs, options) noexcept;

// The compact form about a coordinate axis: the five numbers that are not zero.
status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out,
                 options = {}) noexcept;
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 options = {}) noexcept;
status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out,
                 const scalar_view<float>& signs, options) noexcept;
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 const scalar_view<double>& signs, options) noexcept;

}  // namespace swivel

#endif
