#ifndef SWIVEL_SWING_HPP
#define SWIVEL_SWING_HPP

#include "swivel/types.hpp"

// swing: the swing alone
//
// Formula    S = q T* for q = S T, R = T* q for q = T R: the rotation through the least angle that takes the
// axis
//            where q takes it (S), or that takes to the axis what q takes there (R).
// Domain, Pole, NaN/Inf, Accuracy, Aliasing   as for decompose (decompose.hpp), of whose results this is one;
//            options::positive_twist makes no difference.
// Identity   (0, 0, 0, 1) to itself, and every twist about a to (0, 0, 0, |q|), to rounding.
// Cost       One pass, 4 streams in and 4 out.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", Theorems 1 and 2.

namespace swivel {

status swing(quat_view<const float> q, twist_axis<float> a, quat_view<float> out, options = {}) noexcept;
status swing(quat_view<const double> q, twist_axis<double> a, quat_view<double> out, options = {}) noexcept;

}  // namespace swivel

#endif
