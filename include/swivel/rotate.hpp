#ifndef SWIVEL_ROTATE_HPP
#define SWIVEL_ROTATE_HPP

#include "swivel/types.hpp"

// rotate: vectors turned by rotations
//
// Formula    v' = v + w t + u x t with t = 2 u x v, for q = (u, w): q v q* of a unit quaternion. For another
//            length it is v + |q|^2 (r - v), r being v turned by q / |q|: not a multiple of r. The length of
//            q goes in that way also where it is off by rounding; normalize first where that matters.
// Domain     Unit quaternions, and vectors whose products with them neither overflow nor underflow.
// Singular   Nowhere.
// NaN/Inf    An element with a NaN or an infinity in any component of q or v comes out as NaN in every
//            component; no other element is affected. One rotation for all that has one makes every element
//            NaN.
// Accuracy   9 units of 2^-24 (float) or 2^-53 (double), relative to |v|; 10 from the turn by q / |q| where
//            the components of q are those of a unit quaternion, rounded (algebra_test.cpp).
// Identity   (0, 0, 0, 1) and (0, 0, 0, -1) leave v as it is, exactly.
// Aliasing   The output may be exactly an input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 7 streams in, or 3 with one rotation for all, and 3 out. Of the options only accuracy
//            matters.
// Source     Gauss' form of Rodrigues' formula, 15 multiplications.

namespace swivel {

status rotate(const quat_view<const float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options = {}) noexcept;
status rotate(const quat_view<const double>& q, const vec3_view<const double>& v,
              const vec3_view<double>& out, options = {}) noexcept;
status rotate(const quat<float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options = {}) noexcept;
status rotate(const quat<double>& q, const vec3_view<const double>& v, const vec3_view<double>& out,
              options = {}) noexcept;

}  // namespace swivel

#endif
