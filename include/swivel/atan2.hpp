#ifndef SWIVEL_ATAN2_HPP
#define SWIVEL_ATAN2_HPP

#include "swivel/types.hpp"

// atan2: the angles of points
//
// Formula    The angle of (x, y), in [-pi, pi] as rounded to the type, with the sign of y, -0 included.
// Domain     |x| and |y| below 2^126 (double: 2^1022).
// Singular   (0, 0) gives 0 or pi, by the signs of the zeros, as std::atan2 does.
// NaN/Inf    NaN where either is NaN or infinite.
// Accuracy   In units in the last place of the result (exhaustive_angles_test.cpp, with x = +-1; others and
//            double: angles_test.cpp): reproducible 2, fast 2.
// Identity   (1, 0) gives 0.
// Aliasing   The output may be exactly either input (types.hpp).
// Cost       One pass, 2 streams in and 1 out; one division, no branch, no table.
// Source     A minimax polynomial on [0, 1] (kernels/constants.hpp).

namespace swivel {

status atan2(const scalar_view<const float>& y, const scalar_view<const float>& x,
             const scalar_view<float>& radians, options = {}) noexcept;
status atan2(const scalar_view<const double>& y, const scalar_view<const double>& x,
             const scalar_view<double>& radians, options = {}) noexcept;

}  // namespace swivel

#endif
