#ifndef SWIVEL_SQUARE_ROOT_HPP
#define SWIVEL_SQUARE_ROOT_HPP

#include "swivel/types.hpp"

// square_root: half of a rotation
//
// Formula    r with r r = q/|q| and w >= 0: n(1 + q/|q|), half of the angle of q about the same axis. It is
//            the root of q itself, not of -q: where w < 0 q turns by more than 180 degrees, and r by more
//            than 90.
// Domain     Any quaternion with |q| >= 2^-100 (double: 2^-960), unit or not; |r| = 1. Below, r is less
//            accurate.
// Singular   q = -1 (no vector part, w < 0) has a root about every axis; it gets the half turn about x, (1,
//            0, 0, 0). Beside it there is one root only, however small the vector part. The zero quaternion,
//            of either sign, gives (0, 0, 0, 1).
// NaN/Inf    An element with a NaN or an infinity in any component comes out as NaN in every component.
// Accuracy   Bounds of |r - exact| in units of 2^-24 (float) and 2^-53 (double), asserted by
//            exponentials_test.cpp over all rotations and lengths: reproducible 4, fast 6.5.
// Identity   (0, 0, 0, 1) gives itself to rounding, exactly in reproducible.
// Aliasing   The output may be exactly the input (types.hpp).
// Cost       One pass, 4 streams in and 4 out; no branch.
// Source     Dobrowolski, "Swing-twist decomposition in Clifford algebra", proposition 2; Dorst, "Rotors and
//            motors".

namespace swivel {

status square_root(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status square_root(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;

}  // namespace swivel

#endif
