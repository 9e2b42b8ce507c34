#ifndef SWIVEL_SWING_HPP
#define SWIVEL_SWING_HPP

#include "swivel/types.hpp"

// swing: the swing alone
//
// Formula    S = q T* for q = S T: the rotation through the least angle that takes the axis where q takes it.
//            R = T* q for q = T R: the rotation through the least angle that takes to the axis what q takes
//            there.
// Domain     That of decompose (decompose.hpp).
// Pole       (sgn(w) (v - u a), |w|), as in decompose.
// NaN/Inf    As in decompose.
// Accuracy   That of S in decompose, of which this is the same computation, bit for bit.
// Identity   (0, 0, 0, 1) to itself, and every twist about a to (0, 0, 0, |q|), to rounding. positive_twist
//            makes no difference.
// Aliasing   The output may be exactly the input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 4 streams in (7 with an axis for each element) and 4 out.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", Theorems 1 and 2.

namespace swivel {

status swing(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& out,
             options = {}) noexcept;
status swing(const quat_view<const double>& q, const twist_axis<double>& a, const quat_view<double>& out,
             options = {}) noexcept;

}  // namespace swivel

#endif
