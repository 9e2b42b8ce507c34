#ifndef SWIVEL_STERP_HPP
#define SWIVEL_STERP_HPP

#include "swivel/types.hpp"

// sterp: between two rotations with swing and twist apart, so that the axis takes the shortest way
//
// Formula    With D = b a* = S T, T about the axis, S the swing:  S^s T^t a. The axis, carried along, follows
//            the great circle at constant speed (slerp's does not); T turns about it.
//            options::axis_frame says where the axis is given: frame::world in the world, as it lies at a;
//            frame::body in the body that a and b turn, l, which lies at a l a* in the world: a S^s T^t with
//            D = a* b, the same path.
//            Short way: -b stands for b where the w of D is negative; options::long_way: where it is not. The
//            swing is the same either way, the twist goes the other way round.
//            options::motion: flavour::slerp, powers as they are; flavour::nlerp, S^s and T^t replaced by the
//            normalised n((1 - s) + s S) and n((1 - t) + t T), the same paths at a speed that is not
//            constant.
//            (Chou's post prints the product in another order and without a; neither that nor its correction
//            is right.)
// Domain     Quaternions of any length from 2^-13 to 2^15 (double: 2^-120 to 2^120), of which only the
//            direction counts; the result is a unit quaternion. Any axis but 0. |s|, |t| <= 2^11 (double:
//            2^18), outside of [0, 1] too; beyond, results are finite and mean nothing.
// Pole       That of decompose: where D turns the axis into its opposite, T = (0, 0, 0, sgn w) and all of the
//            turn is swing. Twist and swing are ill conditioned near it, their product is not.
// NaN/Inf    An element with a NaN or an infinity in a, b, its axis or its parameters comes out as NaN in
//            every component.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), by sterp_test.cpp, for s and t in [-0.25, 1.25]
//            and D at r = sqrt(w^2 + (a.v)^2) from the pole: reproducible 4 + 2/r, norm 2.8; fast 4.8 +
//            2.4/r, norm 4. On the long way the direction of a twist near 360 degrees is as uncertain: r is
//            then at most the sine of its half, and the figures half as large again.
// Identity   In reproducible s = t = 0 gives the bits of a, whatever its length, and s = t = 1 those of b (of
//            -b, where that is on the way); in fast to rounding, of length 1.
// Aliasing   The output may be exactly one of the streams that are read (types.hpp).
// Cost       One pass, 8 streams in, 3 more for an axis and 1 more for each parameter per element, and 4 out.
//            bench/README.md has figures.
// Source     Chou, "Swing-twist interpolation (sterp)"; the composition: Dobrowolski's Proposition 3.

namespace swivel {

// One parameter for swing and twist.
status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& t, const quat_view<float>& out, options = {}) noexcept;
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& t, const quat_view<double>& out,
             options = {}) noexcept;

// One for the swing, one for the twist.
status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& swing, const parameter<float>& twist, const quat_view<float>& out,
             options = {}) noexcept;
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& swing, const parameter<double>& twist,
             const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
