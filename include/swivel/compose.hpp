#ifndef SWIVEL_COMPOSE_HPP
#define SWIVEL_COMPOSE_HPP

#include "swivel/types.hpp"

// compose: the rotation of a swing and a twist, the inverse of decompose
//
// Formula    q = S T, or q = T R with product::twist_swing: the Hamilton product, of any two quaternions.
//            Of the compact form about a coordinate axis, (A; B, C) cyclic as in decompose.hpp:
//              w = sc tc   A = sc ts   B = s1 tc + s2 ts   C = s2 tc - s1 ts   (q = S T)
//                                      B = s1 tc - s2 ts   C = s2 tc + s1 ts   (q = T R)
//            Given the signs that decompose kept, the sign bit of each is first exchanged into every component
//            of the twist. That restores q right whatever was done to the twist in between, also where it has
//            been pushed past 180 degrees; setting the sign of w instead would not.
// Domain     Any factors whose products neither overflow nor underflow.
// Singular   Nowhere.
// NaN/Inf    An element with a NaN or an infinity in any component of its factors comes out as NaN in every
//            component; no other element is affected. An infinite sign counts as its sign.
// Accuracy   3.5 units of 2^-24 (float) or 2^-53 (double) of |S| |T|, the compact form 2, by
//            tools/accuracy_report.
// Identity   A factor (0, 0, 0, 1) leaves the other one as it is, exactly.
// Aliasing   The output may be exactly an input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 8 (compact: 5) streams in and 4 out. Of the options only order and accuracy matter.
// Source     Reynolds, "Quaternion swing-twist decomposition", Reconstruction.

namespace swivel {

status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const quat_view<float>& q, options = {}) noexcept;
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const quat_view<double>& q, options = {}) noexcept;
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const scalar_view<const float>& signs, const quat_view<float>& q, options = {}) noexcept;
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const scalar_view<const double>& signs, const quat_view<double>& q, options = {}) noexcept;

status compose(const factor_view<const float>& factors, axis a, const quat_view<float>& q,
               options = {}) noexcept;
status compose(const factor_view<const double>& factors, axis a, const quat_view<double>& q,
               options = {}) noexcept;
status compose(const factor_view<const float>& factors, axis a, const scalar_view<const float>& signs,
               const quat_view<float>& q, options = {}) noexcept;
status compose(const factor_view<const double>& factors, axis a, const scalar_view<const double>& signs,
               const quat_view<double>& q, options = {}) noexcept;

}  // namespace swivel

#endif
