#ifndef SWIVEL_TWIST_ANGLE_HPP
#define SWIVEL_TWIST_ANGLE_HPP

#include "swivel/types.hpp"

// twist_angle: the angle of the twist about the axis
//
// Formula    2 atan2(u, w), u = a.v, in (-2 pi, 2 pi]; with options::positive_twist 2 atan2(u sgn w, |w|), in
//            [-pi, pi]. Never by acos, which loses every angle below 5e-4 radians. The bounds are those of
//            the rounded type: 2 pi comes out as the number nearest to it.
// Domain     As for decompose (decompose.hpp).
// Pole       0 where the sign bit of w is clear, else 2 pi (0 with positive_twist): the angle of the twist
// that
//            decompose gives.
// NaN/Inf    As for decompose.
// Accuracy   Relative to the angle, in units of 2^-24 (float) and 2^-53 (double), largest seen by
//            tools/accuracy_report about a coordinate axis: 5 in reproducible, 8 in fast. About another axis
//            the rounding of u adds about 2/r units of angle, r = sqrt(w^2 + u^2) / |q|.
// Identity   (0, 0, 0, 1) gives 0; -q differs from q by 2 pi.
// Aliasing   The output may be exactly one of the inputs (types.hpp).
// Cost       One pass, 4 streams in and 1 out, a polynomial of its own: no library function is equal in bits
// on
//            two systems.

namespace swivel {

status twist_angle(quat_view<const float> q, twist_axis<float> a, scalar_view<float> radians,
                   options = {}) noexcept;
status twist_angle(quat_view<const double> q, twist_axis<double> a, scalar_view<double> radians,
                   options = {}) noexcept;

}  // namespace swivel

#endif
