#ifndef SWIVEL_MOTOR_HPP
#define SWIVEL_MOTOR_HPP

#include <span>

#include "swivel/types.hpp"

// Rigid motions: every operation on motors. What a motor is, types.hpp says at motor_view.
//
// Common to all
//
// Domain     Unit motors, |r| = 1 and r.d = 0 to rounding, where nothing else is said; what is longer or
//            shorter, up to 16 times, gives finite numbers without a meaning. Lengths of translations from
//            2^-60 to 2^60 (double: 2^-500 to 2^500).
// NaN/Inf    An element with a NaN or an infinity in anything that is read for it comes out as NaN in every
//            component; no other element is affected.
// Accuracy   In units of 2^-24 (float) and 2^-53 (double), as distances of the real parts, and of the dual
//            parts or translations divided by the largest of 1 and the translations that were put in.
//            Asserted by motor_test.cpp.
// Aliasing   Outputs may be exactly streams that are read (types.hpp).
// Cost       One pass; bench/README.md has figures. Of the options only those count that are named.
// Source     Dorst's slides 15 and 16 for roots and logarithms; Study; Kavan et al. for the blend.

namespace swivel {

// multiply: the motion b, then the motion a
//
// Formula    (r1 + eps d1)(r2 + eps d2) = r1 r2 + eps (r1 d2 + d1 r2), of any two dual quaternions.
// Accuracy   3 for unit motors.
// Identity   (0, 0, 0, 1, 0, 0, 0, 0) leaves the other factor as it is.
status multiply(const motor_view<const float>& a, const motor_view<const float>& b,
                const motor_view<float>& out, options = {}) noexcept;
status multiply(const motor_view<const double>& a, const motor_view<const double>& b,
                const motor_view<double>& out, options = {}) noexcept;

// conjugate: the motion backwards
//
// Formula    r* + eps d*, the inverse of a unit motor. Exact: six signs change.
// NaN/Inf    Stay where they are: nothing is computed.
status conjugate(const motor_view<const float>& m, const motor_view<float>& out, options = {}) noexcept;
status conjugate(const motor_view<const double>& m, const motor_view<double>& out, options = {}) noexcept;

// normalize: onto the manifold of unit motors
//
// Formula    M / sqrt(M M~): r / |r|, and of d / |r| the part at right angles to r.
// Domain     Any dual quaternion whose r has a component from 2^-60 to 2^60 (double: 2^-500 to 2^500), and
//            d / |r| as translations above.
// Singular   r = 0 gives the identity.
// Accuracy   Real part 3, fast 4.5; dual part 6, fast 8.
status normalize(const motor_view<const float>& m, const motor_view<float>& out, options = {}) noexcept;
status normalize(const motor_view<const double>& m, const motor_view<double>& out, options = {}) noexcept;

// from_rotation_translation: turned by q, then moved by t
//
// Formula    q + eps t q / 2. The real part is q, with all bits.
// to_rotation_translation: the same backwards
//
// Formula    q = r, with all bits; t = 2 d r* / |r|^2, of a motor of any length.
// Singular   r = 0 has the translation 0.
// Accuracy   from 1.5; to 6.
status from_rotation_translation(const quat_view<const float>& q, const vec3_view<const float>& t,
                                 const motor_view<float>& out, options = {}) noexcept;
status from_rotation_translation(const quat_view<const double>& q, const vec3_view<const double>& t,
                                 const motor_view<double>& out, options = {}) noexcept;
status to_rotation_translation(const motor_view<const float>& m, const quat_view<float>& q,
                               const vec3_view<float>& t, options = {}) noexcept;
status to_rotation_translation(const motor_view<const double>& m, const quat_view<double>& q,
                               const vec3_view<double>& t, options = {}) noexcept;

// transform: points moved by motors; with stride 0, by one motor for all
//
// Formula    p' = p + 2 (w c + v x c - dw v), c = v x p + (dx, dy, dz), v = (x, y, z): r p r* + t.
// Accuracy   10, relative to the largest of 1, |p| and |t|.
status transform(const motor_view<const float>& m, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options = {}) noexcept;
status transform(const motor_view<const double>& m, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options = {}) noexcept;

// square_root: half of the motion, the root whose real part has w >= 0
//
// Formula    s = sqrt(r) = (u, c) and eps e, 2 c e = (d - (dw / 2c) u), ew = dw / 4c: from (s + eps e)^2 = M.
// Singular   r = -1 (to 2^-24; double: 2^-53), a motor's -M of a translation: a screw of 180 degrees about
//            the direction of the translation, whose square it is; about x where there is no translation.
// Accuracy   Real part 4, fast 6; dual part 2 (1 + 1/c), c = sqrt((1 + w) / 2). The square of the result is
//            near M: real part 6.5, fast 13, dual part 2.5 (1 + 1/c).
status square_root(const motor_view<const float>& m, const motor_view<float>& out, options = {}) noexcept;
status square_root(const motor_view<const double>& m, const motor_view<double>& out, options = {}) noexcept;

// log: the bivector of the motion, in two vectors
//
// Formula    M = exp(b + eps n): b = half of the angle in radians times the axis, 0 <= |b| <= pi; n = f e + p
//            (1 - w f) u, with v = m u, f = atan2(m, w) / m, e = (dx, dy, dz) and p = w (u.e) - m dw. No
//            screw is taken apart, and a pure translation is nothing special.
// Singular   r = -1 (to 2^-24; double: 2^-53): b = pi times the direction of e, or x where e = 0, and n = -e.
//            exp of that is M.
// Accuracy   The exact exp of the result is M: real part 11.5, fast 13; dual part 4, times 1 + pi/m where w <
//            0, since near a full turn the axis is that uncertain. This library's exp of it: 14, fast 20; and
//            4, fast 7, times the same.
status log(const motor_view<const float>& m, const vec3_view<float>& b, const vec3_view<float>& n,
           options = {}) noexcept;
status log(const motor_view<const double>& m, const vec3_view<double>& b, const vec3_view<double>& n,
           options = {}) noexcept;

// exp: the motor of a bivector
//
// Formula    a = |b|, u = b / a, S = sin a / a: real (u sin a, cos a), dual (S n + (u.n)(cos a - S) u, -(u.n)
//            sin a).
// Domain     |b| <= 2^13 (double: 2^20); a larger b counts as 0.
// Identity   exp(0, 0) is exactly the identity, exp(0, n) exactly the translation by 2 n.
// Accuracy   For |b| <= pi the real part 7.5, fast 12; the dual part 8, fast 11, relative to the largest of 1
//            and |n|.
status exp(const vec3_view<const float>& b, const vec3_view<const float>& n, const motor_view<float>& out,
           options = {}) noexcept;
status exp(const vec3_view<const double>& b, const vec3_view<const double>& n, const motor_view<double>& out,
           options = {}) noexcept;

// power: a part or a multiple of the motion
//
// Formula    exp(t log M), in one piece.
// Singular   As log.
// Domain     |t| <= 2^11 (double: 2^18); beyond, results are finite and mean nothing.
// Identity   In reproducible t = 1 gives the bits of M.
// Accuracy   For t in [-0.25, 1.25] the real part 6, fast 7.5, the dual part 4, times 1 + pi/m where w < 0.
status power(const motor_view<const float>& m, const parameter<float>& t, const motor_view<float>& out,
             options = {}) noexcept;
status power(const motor_view<const double>& m, const parameter<double>& t, const motor_view<double>& out,
             options = {}) noexcept;

// sclerp: between two poses on the screw from the one to the other, at constant speed
//
// Formula    a (a~ b)^t, by way of the one of b and -b that is nearer (options::long_way: further), outside
//            of [0, 1] too.
// Singular   On the long way from a pose to itself turned by nothing, as log.
// Identity   In reproducible t = 0 gives the bits of a and t = 1 those of b (of -b where that is on the way);
//            in fast to rounding.
// Accuracy   For t in [-0.25, 1.25] the real part 5, fast 6.5, the dual part 4.5, fast 5. On the long way, where
//            the real part of a~ b has a sine of m, times 1 + pi/m, the dual part times the square of that.
status sclerp(const motor_view<const float>& a, const motor_view<const float>& b, const parameter<float>& t,
              const motor_view<float>& out, options = {}) noexcept;
status sclerp(const motor_view<const double>& a, const motor_view<const double>& b,
              const parameter<double>& t, const motor_view<double>& out, options = {}) noexcept;

// blend: the normalised sum of motors, each times its weight (dual quaternion skinning)
//
// Formula    normalize(sum w_k s_k M_k), s_k = -1 where r_k . r_1 < 0, else 1. Any number of motors from 1
//            on, as many weights; another number, or none, is a size_mismatch or a bad_argument.
// Singular   A sum whose real part is 0 gives the identity.
// Accuracy   2 + the number of motors, times the sum of the magnitudes of the weights, divided by the length
//            of the sum's real part.
// Cost       One pass for each motor and one to normalise, over blocks that stay in the cache.
status blend(std::span<const motor_view<const float>> motors, std::span<const parameter<float>> weights,
             const motor_view<float>& out, options = {}) noexcept;
status blend(std::span<const motor_view<const double>> motors, std::span<const parameter<double>> weights,
             const motor_view<double>& out, options = {}) noexcept;

// decompose: the rotation of a motion as swing and twist, and its translation
//
// Formula    M = (1 + eps t/2) S T, or T R with product::twist_swing: the rotation r as decompose.hpp says of
//            quaternions, the translation as of to_rotation_translation.
// compose: the same backwards.
//
// Pole       That of decompose.hpp, with its options.
// Accuracy   Swing and twist as there; the translation 6. The motor of all three: real part 9, dual part 7.
status decompose(const motor_view<const float>& m, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const vec3_view<float>& translation, options = {}) noexcept;
status decompose(const motor_view<const double>& m, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const vec3_view<double>& translation, options = {}) noexcept;
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const vec3_view<const float>& translation, const motor_view<float>& out,
               options = {}) noexcept;
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const vec3_view<const double>& translation, const motor_view<double>& out,
               options = {}) noexcept;

}  // namespace swivel

#endif
