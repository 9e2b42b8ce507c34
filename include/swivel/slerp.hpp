#ifndef SWIVEL_SLERP_HPP
#define SWIVEL_SLERP_HPP

#include "swivel/types.hpp"

// slerp: between two rotations at constant speed
//
// Formula    (b a*)^t a = sin((1 - t) h)/sin(h) a + sin(t h)/sin(h) b, h the angle between a and b as vectors
//            of four numbers. Where a.b < 0, -b stands for b: the short way, at most 180 degrees of rotation.
//            With options::long_way -b stands for b elsewhere. Computed as cos(f) p/|p| + sin(f) n/|n|, p = a
//            + b, n = b - a, f = (2 t - 1) atan2(|n|, |p|), in which nothing is divided by the sine of a
//            small angle.
// Domain     Quaternions of any length from 2^-30 to 2^30 (double: 2^-250 to 2^250), of which only the
//            direction counts; the result is a unit quaternion. Any t with |t| <= 2^12 (double: 2^19),
//            outside of [0, 1] too; beyond, results are finite and mean nothing.
// Singular   Opposite ends (a.b = 0 is a half turn and no such place; a.b = -1 is, and can only be met on the
//            long way from a to a): a full turn, about x.
// NaN/Inf    An element with a NaN or an infinity in a, b or t comes out as NaN in every component.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), by slerp_test.cpp, for t in [-0.25, 1.25]:
//            reproducible 6, norm 6.5; fast 9, norm 8. On the long way the direction of the turn is known
//            to 1/|a + b|, and the same figures are divided by that where it is less than 1.
// Identity   In reproducible t = 0 gives the bits of a, whatever its length, and t = 1 those of b (of -b,
//            where that is on the way); in fast to rounding, of length 1.
// Aliasing   The output may be exactly one of the streams that are read (types.hpp).
// Cost       One pass, 8 streams in (9 with a parameter for each element) and 4 out. bench/README.md has
//            figures.
// Source     Shoemake, "Animating rotation with quaternion curves"; Dorst's slide 23 for the formula of
//            rotors.

namespace swivel {

status slerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options = {}) noexcept;
status slerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
