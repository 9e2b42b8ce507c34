#ifndef SWIVEL_AXIS_ANGLE_HPP
#define SWIVEL_AXIS_ANGLE_HPP

#include "swivel/types.hpp"

// from_axis_angle, to_axis_angle: a rotation by its axis and angle
//
// Formula    q = (sin(angle/2) a, cos(angle/2)), a of unit length; angle = 2 atan2(|v|, w), a = v / |v|.
// Domain     from: |angle| <= 2^14 (double: 2^21) radians; a larger angle counts as 0. Vectors of any length,
//            from the smallest subnormal number on; a zero or non-finite one for all elements is a
//            bad_argument. to: any quaternion with |q| < 2^126 (double: 2^1022), unit or not, however small v
//            is. The angle is in [0, 2 pi], and above pi where w < 0: q and -q have opposite axes.
// Singular   from: a zero vector among those per element gives (0, 0, 0, 1), whatever the angle.
//            to: where v = 0 the axis is (1, 0, 0), and the angle 0 or, where the sign bit of w is set, 2 pi.
// NaN/Inf    An element with a NaN or an infinity anywhere comes out as NaN in every component.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), asserted by axis_angle_test.cpp: q 3, with an axis
//            for each element 4, fast 4.5; the axis 4, and the angle, relative to itself, 4, fast 4.5, however
//            small it is down to where numbers become subnormal.
// Identity   The angle 0 gives exactly (0, 0, 0, 1), and (0, 0, 0, 1) exactly the angle 0.
// Aliasing   Outputs may be exactly inputs (types.hpp).
// Cost       One pass. from: 1 stream in, 3 more for an axis for each element, 4 out. to: 4 in, 4 out.
// Source     The definition.

namespace swivel {

status from_axis_angle(const twist_axis<float>& a, const scalar_view<const float>& radians,
                       const quat_view<float>& q, options = {}) noexcept;
status from_axis_angle(const twist_axis<double>& a, const scalar_view<const double>& radians,
                       const quat_view<double>& q, options = {}) noexcept;

status to_axis_angle(const quat_view<const float>& q, const vec3_view<float>& a,
                     const scalar_view<float>& radians, options = {}) noexcept;
status to_axis_angle(const quat_view<const double>& q, const vec3_view<double>& a,
                     const scalar_view<double>& radians, options = {}) noexcept;

}  // namespace swivel

#endif
