#ifndef SWIVEL_TWIST_ANGLE_HPP
#define SWIVEL_TWIST_ANGLE_HPP

#include "swivel/types.hpp"

// twist_angle: the angle of the twist about the axis
//
// Formula    2 atan2(u, w), u = a.v, in (-2 pi, 2 pi]; with positive_twist 2 atan2(u sgn w, |w|), in [-pi,
//            pi]. The bounds are those of the type: 2 pi comes out as the number nearest to it. Never by
//            acos, which loses every angle below 5e-4 radians.
// Domain     That of decompose (decompose.hpp).
// Pole       That of the twist which decompose gives: 0 where the sign bit of w is clear, else 2 pi; with
//            positive_twist 0.
// NaN/Inf    As in decompose.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), by tools/accuracy_report and twist_angle_test.cpp:
//            about a coordinate axis 4 (fast 5) relative to the angle, however small. About another axis the
//            rounding of a.v makes it 10/r units of angle, r = sqrt(w^2 + u^2) / |q|.
// Identity   (0, 0, 0, 1) gives 0; -q differs from q by 2 pi.
// Aliasing   The output may be exactly one of the streams that are read (types.hpp).
// Cost       One pass, 4 streams in (7 with an axis for each element) and 1 out, with a polynomial of its
//            own: no library function is equal in bits on two systems.
// Source     Reynolds, "Quaternion swing-twist decomposition"; the polynomial is a minimax fit
//            (kernels/atan2.hpp).

namespace swivel {

status twist_angle(const quat_view<const float>& q, const twist_axis<float>& a,
                   const scalar_view<float>& radians, options = {}) noexcept;
status twist_angle(const quat_view<const double>& q, const twist_axis<double>& a,
                   const scalar_view<double>& radians, options = {}) noexcept;

}  // namespace swivel

#endif
