#ifndef SWIVEL_MATRIX_HPP
#define SWIVEL_MATRIX_HPP

#include "swivel/types.hpp"

// from_matrix, to_matrix: a rotation as a matrix that turns column vectors
//
// Formula    xx = 1 - s (y^2 + z^2)   xy = s (x y - z w)   and so on, with s = 2 / |q|^2. Back: the column of
//              4 q q^T = (1 + xx - yy - zz   xy + yx            xz + zx            zy - yz
//                         xy + yx            1 - xx + yy - zz   yz + zy            xz - zx
//                         xz + zx            yz + zy            1 - xx - yy + zz   yx - xy
//                         zy - yz            xz - zx            yx - xy            1 + xx + yy + zz)
//            that has a diagonal element of at least 1, brought to unit length. No angle is a special one.
// Domain     to: any quaternion with 2^-50 < |q| < 2^63 (double: 2^-480 < |q| < 2^511), unit or not: the
//            length is divided out. from: elements of magnitude up to 2^60 (double: 2^500). The result always
//            has unit length. A matrix that is only nearly orthogonal, with errors up to h in its elements,
//            gives a quaternion at most 2.5 h from that of the rotation; a scaled one must be scaled back
//            first, and a reflection gives a rotation that means nothing.
// Singular   to: a quaternion too short for its domain counts as (0, 0, 0, 1).
//            from: w >= 0, and never -0. Of a half turn, where q and -q have w = 0, z is positive where
//            zz >= 0, else x where xx > yy, else y.
// NaN/Inf    An element with a NaN or an infinity anywhere comes out as NaN in every component.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), asserted by matrix_test.cpp: the elements of the
//            matrix 4.5; q 4 from a matrix whose elements are rounded right; |q| 3, fast 4, whatever the
//            matrix.
// Identity   (0, 0, 0, 1) gives exactly the unit matrix, and the unit matrix gives it, exactly in
//            reproducible.
// Aliasing   Outputs may be exactly inputs, stream for stream in any pairing (types.hpp).
// Cost       One pass, no branch; 9 streams on one side and 4 on the other.
// Source     Shepperd, "Quaternion from rotation matrix"; the choice by three signs is Day's, "Converting a
//            rotation matrix to a quaternion".

namespace swivel {

status from_matrix(const matrix_view<const float>& m, const quat_view<float>& q, options = {}) noexcept;
status from_matrix(const matrix_view<const double>& m, const quat_view<double>& q, options = {}) noexcept;

status to_matrix(const quat_view<const float>& q, const matrix_view<float>& m, options = {}) noexcept;
status to_matrix(const quat_view<const double>& q, const matrix_view<double>& m, options = {}) noexcept;

}  // namespace swivel

#endif
