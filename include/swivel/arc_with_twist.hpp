#ifndef SWIVEL_ARC_WITH_TWIST_HPP
#define SWIVEL_ARC_WITH_TWIST_HPP

#include "swivel/types.hpp"

// arc_with_twist: every rotation from one vector to another, by the angle of its twist
//
// Formula    With A the shortest arc from v to w, and T_a(angle) = (sin(angle/2) n(a), cos(angle/2)) the
//            right-handed turn about a
//              q = A T_v(angle)    options::order swing_twist: twist about v, then the arc
//              q = T_w(angle) A    options::order twist_swing: the arc, then twist about w
//            Both are the same rotation, equal but for rounding. The angle is one number for all elements or one
//            for each. Of q = A T_v(angle), A and T_v(angle) are the swing and the twist about v that decompose
//            gives.
// Domain     Vectors of any length from the smallest subnormal number on; |angle| <= 2^14 (double: 2^21). A
//            larger angle counts as 0.
// Singular   That of shortest_arc: opposite v and w. A vector of zeros makes A the identity, and where the
//            twist is about it, q too.
// NaN/Inf    An element with a NaN or an infinity in any component of v or w or in its angle comes out as NaN
//            in every component.
// Accuracy   Bounds in units of 2^-24 (float) and 2^-53 (double), asserted by arcs_test.cpp for all angles
//            between the vectors:
//                             |q n(v) q* - n(w)|    |q| - 1
//              reproducible          9             3
//              fast                 12             4.5
// Identity   v = w and 0 give (0, 0, 0, 1) to rounding.
// Aliasing   Output streams may be exactly input streams (types.hpp).
// Cost       One pass, 6 streams in, 1 more for an angle for each element, 4 out; no branch, no table.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", proposition 3. His exp(e123 alpha
//            n(v)) turns by -2 alpha.

namespace swivel {

status arc_with_twist(const vec3_view<const float>& v, const vec3_view<const float>& w,
                      const parameter<float>& radians, const quat_view<float>& out, options = {}) noexcept;
status arc_with_twist(const vec3_view<const double>& v, const vec3_view<const double>& w,
                      const parameter<double>& radians, const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
