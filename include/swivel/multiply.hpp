#ifndef SWIVEL_MULTIPLY_HPP
#define SWIVEL_MULTIPLY_HPP

#include "swivel/types.hpp"

// multiply: products of quaternions
//
// Formula    The Hamilton product a b: as rotations, b first.
// Domain     Any quaternions whose products neither overflow nor underflow.
// Singular   Nowhere.
// NaN/Inf    An element with a NaN or an infinity in any component of a or b comes out as NaN in every
//            component; no other element is affected.
// Accuracy   3.5 units of 2^-24 (float) or 2^-53 (double), relative to |a| |b| (algebra_test.cpp).
// Identity   A factor (0, 0, 0, 1) leaves the other one as it is, exactly.
// Aliasing   The output may be exactly an input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 8 streams in and 4 out. Of the options only accuracy matters.
// Source     Hamilton. compose is the same product of a swing and a twist, in the order of the options.

namespace swivel {

status multiply(const quat_view<const float>& a, const quat_view<const float>& b, const quat_view<float>& out,
                options = {}) noexcept;
status multiply(const quat_view<const double>& a, const quat_view<const double>& b,
                const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
