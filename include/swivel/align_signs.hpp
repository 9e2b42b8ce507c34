#ifndef SWIVEL_ALIGN_SIGNS_HPP
#define SWIVEL_ALIGN_SIGNS_HPP

#include "swivel/types.hpp"

// align_signs: q and -q are one rotation; the one on the side of its neighbour
//
// Formula    q where q.n >= 0, else -q. The neighbour n is given for each element (the pose of the frame
//            before), or it is the element before in the output (along a sequence, a curve over time); there
//            the first element stays as it is.
// Domain     Quaternions with |q| |n| in 2^-100..2^126 (double: 2^-960..2^1022), unit or not. Where all
//            products underflow, q.n counts as 0; where one overflows, as NaN.
// Singular   q.n = 0, either sign of zero: q stays as it is.
// NaN/Inf    With a neighbour for each: an element with a NaN or an infinity in any component of q or n comes
//            out as NaN in every component; no other element is affected. Along a sequence: an element with a
//            NaN or an infinity stays as it is, and the next one is compared with the last finite element
//            before it.
// Accuracy   Exact: only sign bits change. Which one is taken may differ from the exact q.n where that is
//            below 3.5 units of 2^-24 (float) or 2^-53 (double) of |q| |n|, the error of dot
//            (algebra_test.cpp).
// Identity   Aligned elements stay as they are: done twice is done once.
// Aliasing   The output may be exactly an input, stream for stream in any pairing (types.hpp).
// Cost       One pass, 8 streams in (along a sequence 4) and 4 out. Of the options only accuracy matters, and
//            only where q.n is 0 to rounding. Along a sequence the comparisons are made in batches and
//            followed one element after the other.
// Source     Definition.

namespace swivel {

status align_signs(const quat_view<const float>& q, const quat_view<const float>& neighbour,
                   const quat_view<float>& out, options = {}) noexcept;
status align_signs(const quat_view<const double>& q, const quat_view<const double>& neighbour,
                   const quat_view<double>& out, options = {}) noexcept;
status align_signs(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status align_signs(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
