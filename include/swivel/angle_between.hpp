#ifndef SWIVEL_ANGLE_BETWEEN_HPP
#define SWIVEL_ANGLE_BETWEEN_HPP

#include "swivel/types.hpp"

// angle_between: how far one rotation is from another
//
// Formula    2 atan2(|v|, |w|) with (v, w) = a* b: the angle in radians of the rotation from a to b, the same as that
//            from b to a, in [0, pi] (pi as it is rounded: 3.14159274 in float). v is that of a* (b - k a), with
//            k = a.b / a.a, or the sign of a.b where |a|^2 and |b|^2 are within 2^-10 of each other: nothing cancels
//            where b is near a or -a, as it would in acos(|a.b|), which sees no angle below 3e-4 (float) or 1e-8
//            (double).
// Domain     Quaternions of lengths from 2^-30 to 2^30 (float) or 2^-250 to 2^250 (double). q and -q are the same
//            rotation, and at the same angle. A zero quaternion is at angle 0 from all.
// Singular   Nowhere.
// NaN/Inf    An element with a NaN or an infinity in any component of a or b comes out as NaN; no other element is
//            affected.
// Accuracy   Of quaternions of the same length to 2^-11 of it, 7.5 units of 2^-24 (float) or 2^-53 (double) relative to
//            the angle, down to the smallest, and 2^-9 units of a radian; of others 9 units of a radian
//            (angle_between_test.cpp).
// Identity   b = a and b = -a give 0 exactly.
// Aliasing   The output may be exactly a stream of an input (types.hpp).
// Cost       One pass, 8 streams in and 1 out. Of the options only accuracy matters.
// Source     Kahan, "How futile are mindless assessments of roundoff", section 12, for the cause; the form is swivel's.

namespace swivel {

status angle_between(const quat_view<const float>& a, const quat_view<const float>& b,
                     const scalar_view<float>& radians, options = {}) noexcept;
status angle_between(const quat_view<const double>& a, const quat_view<const double>& b,
                     const scalar_view<double>& radians, options = {}) noexcept;

}  // namespace swivel

#endif
