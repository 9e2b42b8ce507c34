#ifndef SWIVEL_TWIST_HPP
#define SWIVEL_TWIST_HPP

#include "swivel/types.hpp"

// twist: the twist alone, the paper's projection sigma_a(q) = n((q - a q a) / 2)
//
// Formula    T = (u a, w) / sqrt(w^2 + u^2), u = a.v. The unit quaternion about a that is closest to q. The
// same in
//            both products.
// Domain, Pole, NaN/Inf, Accuracy, Aliasing   as for decompose (decompose.hpp), of whose results this is one.
// Identity   (0, 0, 0, 1) to itself; T(T(q)) = T(q) and T(q*) = T(q)* to rounding.
// Cost       One pass, 4 streams in and 4 out.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", Theorem 1.

namespace swivel {

status twist(quat_view<const float> q, twist_axis<float> a, quat_view<float> out, options = {}) noexcept;
status twist(quat_view<const double> q, twist_axis<double> a, quat_view<double> out, options = {}) noexcept;

}  // namespace swivel

#endif
