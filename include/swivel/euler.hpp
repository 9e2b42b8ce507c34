#ifndef SWIVEL_EULER_HPP
#define SWIVEL_EULER_HPP

#include "swivel/types.hpp"

// from_euler, to_euler: a rotation as three rotations about the coordinate axes, in any of the twelve orders
//
// Formula    euler_order::xyz is q = qx qy qz with qx = (sin(x/2), 0, 0, cos(x/2)) and so on (types.hpp). A
//            vector of angles has them by axis, (x, y, z), whatever the order. Back, with i, j, k the
//            components about the first, second and third axis and i j = k:
//              sum = atan2(i + k, w + j)   difference = atan2(i - k, w - j)
//              first = sum + difference    third = sum - difference
//              second = atan2(2 (w j + i k), |(w + j, i + k)| |(w - j, i - k)|)
//            k and the third angle have the other sign where i j = -k.
//            The proper orders, euler_order::zxz and its like, turn about the first axis again. A vector of
//            angles has them one after the other, first, second, third, as (x, y, z). Back, with k the
//            component about the axis that is left, of the other sign where i j = -k:
//              sum = atan2(i, w)   difference = atan2(k, j)   second = 2 atan2(|(j, k)|, |(w, i)|)
// Domain     from: |angle| <= 2^14 (double: 2^21) radians; a larger angle counts as 0. to: any quaternion
//            with 2^-24 <= |q| < 2^62 (double: 2^-400 <= |q| < 2^510), unit or not, and 0. The first and
//            third angle are in [-pi, pi], the second in [-pi/2, pi/2], in the proper orders in [0, pi], to
//            rounding; q and -q give the same.
// Singular   The lock, where the second angle is +-pi/2, in the proper orders 0 or pi, and only the sum or the
//            difference of the others matters: where its cosine, or sine, is at most 2^-23 (double: 2^-52)
//            the third angle is 0 and the first one takes all. The zero quaternion gives (0, 0, 0). Near the lock the first and third angle are
//            ill conditioned in q, but right for the q that is given, and from_euler restores it as well as
//            anywhere.
// NaN/Inf    An element with a NaN or an infinity anywhere comes out as NaN in every component.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), asserted by euler_test.cpp: q 4.5; from_euler of
//            to_euler is q or -q to 8 everywhere, the lock included; each angle 7, the first and third where
//            they are not locked.
// Identity   (0, 0, 0) gives exactly (0, 0, 0, 1), which gives exactly (0, 0, 0).
// Aliasing   Outputs may be exactly inputs, stream for stream in any pairing (types.hpp).
// Cost       One pass, no branch, one kernel for all orders; 3 streams on one side and 4 on the other.
// Source     Bernardes and Viollet, "Quaternion to Euler angles conversion: a direct, general and
//            computationally efficient method", with the second angle by atan2.

namespace swivel {

status from_euler(const vec3_view<const float>& radians, euler_order order, const quat_view<float>& q,
                  options = {}) noexcept;
status from_euler(const vec3_view<const double>& radians, euler_order order, const quat_view<double>& q,
                  options = {}) noexcept;

status to_euler(const quat_view<const float>& q, euler_order order, const vec3_view<float>& radians,
                options = {}) noexcept;
status to_euler(const quat_view<const double>& q, euler_order order, const vec3_view<double>& radians,
                options = {}) noexcept;

}  // namespace swivel

#endif
