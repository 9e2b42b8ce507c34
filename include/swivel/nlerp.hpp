#ifndef SWIVEL_NLERP_HPP
#define SWIVEL_NLERP_HPP

#include "swivel/types.hpp"

// nlerp: between two rotations along the chord
//
// Formula    n((1 - t) a + t b), with -b for b where a.b < 0, or with options::long_way elsewhere. The same
//            path as slerp, at a speed that is lower at the ends than in the middle: half of it where a.b =
//            0.
// Domain     Quaternions of any length from 2^-30 to 2^30 (double: 2^-250 to 2^250), of which only the
//            direction counts; the result is a unit quaternion. Any t with |t| < 2^60 (double: 2^500).
// Singular   Where the chord meets 0, |(1 - t) a + t b|^2 <= eps^2 (the middle of the long way from a to a):
//            a half turn about x beyond a.
// NaN/Inf    An element with a NaN or an infinity in a, b or t comes out as NaN in every component.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), by slerp_test.cpp, for t in [-0.25, 1.25] on the
//            short way: reproducible 4, norm 3.5; fast 5, norm 4.5. On the long way the same, divided by |(1
//            - t) a + t b|.
// Identity   In reproducible t = 0 gives the bits of a, whatever its length, and t = 1 those of b (of -b,
//            where that is on the way); in fast to rounding, of length 1.
// Aliasing   The output may be exactly one of the streams that are read (types.hpp).
// Cost       One pass, 8 streams in (9 with a parameter for each element) and 4 out; no trigonometry.
// Source     Common.

namespace swivel {

status nlerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options = {}) noexcept;
status nlerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
