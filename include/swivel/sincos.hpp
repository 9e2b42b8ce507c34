#ifndef SWIVEL_SINCOS_HPP
#define SWIVEL_SINCOS_HPP

#include "swivel/types.hpp"

// sincos: sine and cosine of angles
//
// Formula    (sin x, cos x).
// Domain     |x| <= 2^13 (double: 2^20) radians, 1304 (166,886) turns. A larger angle counts as 0: the result
//            is still finite and of unit length, and the same everywhere.
// Singular   Nowhere.
// NaN/Inf    NaN for either.
// Accuracy   In units in the last place of the result, over the whole domain; for float every angle is tried
//            (exhaustive_angles_test.cpp; double: angles_test.cpp): reproducible 2, fast 2.
// Identity   0 gives exactly (0, 1), with the sign of 0 kept.
// Aliasing   Either output may be exactly the input (types.hpp).
// Cost       One pass, 1 stream in and 2 out; no branch, no table.
// Source     Reduction by parts of pi/2 after Cody and Waite; the polynomials are minimax fits
//            (kernels/constants.hpp). No library function is equal in bits on two systems.

namespace swivel {

status sincos(const scalar_view<const float>& radians, const scalar_view<float>& sine,
              const scalar_view<float>& cosine, options = {}) noexcept;
status sincos(const scalar_view<const double>& radians, const scalar_view<double>& sine,
              const scalar_view<double>& cosine, options = {}) noexcept;

}  // namespace swivel

#endif
