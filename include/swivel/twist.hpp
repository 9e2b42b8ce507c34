#ifndef SWIVEL_TWIST_HPP
#define SWIVEL_TWIST_HPP

#include "swivel/types.hpp"

// twist: the twist alone, the paper's projection sigma_a(q) = n((q - a q a) / 2)
//
// Formula    T = (u a, w) / sqrt(w^2 + u^2), u = a.v: the unit quaternion about a that is closest to q. The
//            same in both products.
// Domain     That of decompose (decompose.hpp).
// Pole       (0, 0, 0, sgn w), as in decompose.
// NaN/Inf    As in decompose: also a NaN in a component of q across the axis comes out as NaN.
// Accuracy   That of T in decompose, of which this is the same computation, bit for bit.
// Identity   (0, 0, 0, 1) to itself; T(T(q)) = T(q) and T(q*) = T(q)* to rounding.
// Aliasing   The output may be exactly the input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 4 streams in (7 with an axis for each element) and 4 out.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", Theorem 1.

namespace swivel {

status twist(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& out,
             options = {}) noexcept;
status twist(const quat_view<const double>& q, const twist_axis<double>& a, const quat_view<double>& out,
             options = {}) noexcept;

}  // namespace swivel

#endif
