#ifndef SWIVEL_SPINOR_HPP
#define SWIVEL_SPINOR_HPP

#include "swivel/types.hpp"

// from_spinor, to_spinor: Dobrowolski's spinors
//
// Formula    a + b e12 + c e23 + d e31 is (x, y, z, w) = (-c, -d, -b, a). Products of spinors are products of
//            quaternions, and s v s^-1 is q v q*. Without the signs all rotations would be inverse and the
//            factors of every product exchanged.
// Domain     Any numbers.
// Singular   Nowhere.
// NaN/Inf    Come out as they are, in the component that they are in.
// Accuracy   Exact: components are moved, and the signs of three change.
// Identity   1 is (0, 0, 0, 1) but for signs of zeros: to_spinor of from_spinor gives the same bits.
// Aliasing   Outputs may be exactly inputs, stream for stream in any pairing (types.hpp).
// Cost       One pass, 4 streams in and 4 out.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", formula (3).

namespace swivel {

status from_spinor(const spinor_view<const float>& s, const quat_view<float>& q, options = {}) noexcept;
status from_spinor(const spinor_view<const double>& s, const quat_view<double>& q, options = {}) noexcept;

status to_spinor(const quat_view<const float>& q, const spinor_view<float>& s, options = {}) noexcept;
status to_spinor(const quat_view<const double>& q, const spinor_view<double>& s, options = {}) noexcept;

}  // namespace swivel

#endif
