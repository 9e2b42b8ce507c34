#ifndef SWIVEL_NORMALIZE_HPP
#define SWIVEL_NORMALIZE_HPP

#include "swivel/types.hpp"

// normalize: quaternions of length 1
//
// Formula    q / |q|, by way of a power of two that brings the largest component to 2..4.
// Domain     Any quaternion, from the smallest subnormal to the largest finite components.
// Singular   The zero quaternion gives the identity (0, 0, 0, 1); x, y and z keep the signs of their zeros.
// NaN/Inf    An element with a NaN or an infinity in any component comes out as NaN in every component; no
//            other element is affected.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double) (algebra_test.cpp):
//                            |result|   result
//              reproducible     3          3
//              fast             4.5        4.5
// Identity   (0, 0, 0, 1) comes out as it is to rounding, exactly in reproducible.
// Aliasing   The output may be exactly the input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 4 streams in and 4 out. Of the options only accuracy matters.
// Source     Definition.

namespace swivel {

status normalize(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status normalize(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
