#ifndef SWIVEL_DOT_HPP
#define SWIVEL_DOT_HPP

#include "swivel/types.hpp"

// dot: scalar products of quaternions
//
// Formula    a.b = ax bx + ay by + az bz + aw bw: the cosine of half the angle of the rotation from a to b,
//            for unit quaternions. q.q is |q|^2.
// Domain     Any quaternions whose products neither overflow nor underflow.
// Singular   Nowhere.
// NaN/Inf    An element with a NaN or an infinity in any component of a or b comes out as NaN; no other
//            element is affected.
// Accuracy   3.5 units of 2^-24 (float) or 2^-53 (double), relative to |a| |b| (algebra_test.cpp).
// Identity   A factor (0, 0, 0, 1) gives the w of the other one exactly.
// Aliasing   The output may be exactly a stream of an input (types.hpp).
// Cost       One pass, 8 streams in and 1 out. Of the options only accuracy matters.
// Source     Definition.

namespace swivel {

status dot(const quat_view<const float>& a, const quat_view<const float>& b, const scalar_view<float>& out,
           options = {}) noexcept;
status dot(const quat_view<const double>& a, const quat_view<const double>& b, const scalar_view<double>& out,
           options = {}) noexcept;

}  // namespace swivel

#endif
