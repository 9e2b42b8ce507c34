#ifndef SWIVEL_CONJUGATE_HPP
#define SWIVEL_CONJUGATE_HPP

#include "swivel/types.hpp"

// conjugate: quaternions with the opposite vector part
//
// Formula    q* = (-x, -y, -z, w). Of a unit quaternion it is the inverse; else the inverse is q* / |q|^2.
// Domain     Any quaternion.
// Singular   Nowhere.
// NaN/Inf    Kept as they are, in their component; the sign bit of x, y and z is exchanged there too.
// Accuracy   Exact: only sign bits change.
// Identity   (0, 0, 0, 1) gives (-0, -0, -0, 1), equal to it.
// Aliasing   The output may be exactly the input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 4 streams in and 4 out. None of the options matters.
// Source     Hamilton.

namespace swivel {

status conjugate(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status conjugate(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
