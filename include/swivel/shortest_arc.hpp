#ifndef SWIVEL_SHORTEST_ARC_HPP
#define SWIVEL_SHORTEST_ARC_HPP

#include "swivel/types.hpp"

// shortest_arc: the shortest rotation from one vector to another
//
// Formula    q with q n(v) q* = n(w) about an axis perpendicular to both: n(1 + n(v).n(w), n(v) x n(w)); w >=
//            0.
// Domain     Vectors of any length from the smallest subnormal number on.
// Singular   Where v and w are opposite every half turn about an axis perpendicular to v would do; it gets
//            one about an axis perpendicular to x or to z. Within rounding of that place the axis is ill
//            conditioned: it is known to about h/|n(v) + n(w)| radians if the vectors carry noise h. What q
//            does to v does not suffer. A vector of zeros gives the identity.
// NaN/Inf    An element with a NaN or an infinity in any component of v or w comes out as NaN in every
//            component.
// Accuracy   Bounds in units of 2^-24 (float) and 2^-53 (double), asserted by arcs_test.cpp at every angle
//            from 0 to 180 degrees, that included:
//                             |q n(v) q* - n(w)|    |q| - 1
//              reproducible          7              3
//              fast                  11            4
// Identity   v = w gives (0, 0, 0, 1) to rounding.
// Aliasing   Output streams may be exactly input streams (types.hpp).
// Cost       One pass, 6 streams in and 4 out; no branch.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", proposition 2.

namespace swivel {

status shortest_arc(const vec3_view<const float>& v, const vec3_view<const float>& w,
                    const quat_view<float>& out, options = {}) noexcept;
status shortest_arc(const vec3_view<const double>& v, const vec3_view<const double>& w,
                    const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
