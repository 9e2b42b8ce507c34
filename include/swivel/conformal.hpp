#ifndef SWIVEL_CONFORMAL_HPP
#define SWIVEL_CONFORMAL_HPP

#include "swivel/types.hpp"

// Conformal rotors: rotations, translations, dilations and all that they compose to, as even elements of one
// algebra
//
//   Algebra    e1 e2 e3 e4 square to 1, e5 to -1. no = (e5 - e4)/2 is the origin, ni = e4 + e5 infinity, I3 =
//              e1 e2 e3. Components in the order of conformal_view and bivector_view (types.hpp).
//   Action     A point p is the vector no + p + p^2 ni/2, and R turns it into R (...) R~. R and -R act alike.
//              Products read right to left.
//   Rotors     have R R~ = 1, to rounding. What is not a rotor gives finite numbers that mean nothing.
//   Motions    Translation by t: exp(-t ni/2) = 1 - t ni/2. Rotation by the angle h about the unit axis n:
//              exp(-(h/2) I3 n). The quaternion w + x i + y j + z k is w - x e23 + y e13 - z e12. Dilation by
//              s: exp(-(log s)/2 e45).
//   Planes     A bivector is a A + b B, two commuting parts; A turns by the half angle a in [0, pi], b
//              belongs to a smaller turn, a translation or a dilation (boost).
//   unique     square_root, log, power and interpolate say for each element, 1 or 0, whether what they are
//              asked for is unique, and known in spite of rounding: then square_root(R)^2 = R and exp(log R)
//              = R. It is 0 where a = pi (R = -1, minus a translation, a dilation or a boost) and where a + b
//              = pi for two turns, and so near these that the sign of the difference is lost: cos a + cos b
//              or cos(a/2) cos(b/2), squared, below 2^-16 (double: 2^-40) of the terms that they are the
//              difference of; square_root(R)^2 = R then holds to 5e-3 (5e-4). A rotation about an axis
//              through the origin is unique up to 2^-25 (double: 2^-240) from -1. Where it is 0 the result is
//              that of -R, which acts like R; where -R has none either, or R is -1 to 2^-22 (double: 2^-51), it
//              is the half turn -e23 (square_root) and -pi e23 (log), as for quaternions.
//   Domain     Rotors and bivectors of a length, the root of the sum of the squares of all components, up to
//              2^20 (double: 2^200). Others count as -1 with unique = 0, in exp as 0.
//   Errors     are differences of components divided by the length of the expected element where that is
//              larger than 1, asserted by conformal_test.cpp and conformal_split_test.cpp over translations up to 5, half angles up to 2.5
//              and dilations by up to e^2. What exp and log do grows with the square of translations, since a
//              bivector is as uncertain as its rounding; square_root, power and interpolate are within 6e-6
//              (double: 2e-14) about places up to 2^9 away. Of two turns with a + b beyond 2.5, 2e-7 (double:
//              4e-16) over (pi - a - b)^2.

namespace swivel {

// multiply: a b
//
// Formula    The geometric product of even elements, b first as motions.
// Domain     Anything whose products do not overflow.
// Singular   Nowhere.
// NaN/Inf    An element with a NaN or an infinity in any component comes out as NaN in every component.
// Accuracy   3e-7 (double: 5e-16) of the product of the lengths.
// Identity   1 leaves the other factor in every bit, but for -0.
// Aliasing   The output may be exactly an input (types.hpp).
// Cost       One pass, 32 streams in and 16 out; 256 products.
// Source     Dorst, "Rotors and motors".

status multiply(const conformal_view<const float>& a, const conformal_view<const float>& b,
                const conformal_view<float>& out, options = {}) noexcept;
status multiply(const conformal_view<const double>& a, const conformal_view<const double>& b,
                const conformal_view<double>& out, options = {}) noexcept;

// reverse: the inverse of a rotor
//
// Formula    c~: the bivector changes its sign.
// Domain     Anything.
// Singular   Nowhere.
// NaN/Inf    Moved like any number.
// Accuracy   Exact.
// Identity   1 gives 1; twice gives c.
// Aliasing   The output may be exactly the input.
// Cost       One pass, 16 streams in and 16 out.
// Source     Dorst, "Rotors and motors".

status reverse(const conformal_view<const float>& c, const conformal_view<float>& out, options = {}) noexcept;
status reverse(const conformal_view<const double>& c, const conformal_view<double>& out,
               options = {}) noexcept;

// from_motor, from_rotation, from_translation, from_dilation: rotors of motions
//
// Formula    As above. A motor r + eps d is r - (dx e1 + dy e2 + dz e3) ni - dw I3 ni, and products of motors
//            are products of rotors. factor is that by which lengths grow, about the origin.
// Domain     Any numbers; unit motors and quaternions give rotors. factor > 0; any other counts as 1.
// Singular   Nowhere.
// NaN/Inf    NaN in every component.
// Accuracy   Exact, from_dilation 1.5e-7 (double: 3e-16).
// Identity   No motion gives exactly 1.
// Aliasing   Views of different kinds do not overlap but where an output is exactly one stream of the input.
// Cost       One pass, 8, 4, 3 or 1 stream in and 16 out.
// Source     Dorst, "Rotors and motors"; signs verified against the action on points.

status from_motor(const motor_view<const float>& m, const conformal_view<float>& out, options = {}) noexcept;
status from_motor(const motor_view<const double>& m, const conformal_view<double>& out,
                  options = {}) noexcept;
status from_rotation(const quat_view<const float>& q, const conformal_view<float>& out,
                     options = {}) noexcept;
status from_rotation(const quat_view<const double>& q, const conformal_view<double>& out,
                     options = {}) noexcept;
status from_translation(const vec3_view<const float>& t, const conformal_view<float>& out,
                        options = {}) noexcept;
status from_translation(const vec3_view<const double>& t, const conformal_view<double>& out,
                        options = {}) noexcept;
status from_dilation(const scalar_view<const float>& factor, const conformal_view<float>& out,
                     options = {}) noexcept;
status from_dilation(const scalar_view<const double>& factor, const conformal_view<double>& out,
                     options = {}) noexcept;

// transform: points
//
// Formula    R (no + p + p^2 ni/2) R~, divided by its weight; computed as (A p + b) / (c p + D) with
//            quaternions A D and vectors b c, which does not square p.
// Domain     Points up to 2^30 (double: 2^300).
// Singular   A point that goes to infinity, |c p + D|^2 at most 2^-100 (double: 2^-960), gives (0, 0, 0)
//            where it goes there exactly, and beside that a finite point.
// NaN/Inf    An element with a NaN or an infinity anywhere comes out as NaN in every component.
// Accuracy   1.5e-6 (double: 3e-15) of the larger of 1 and the distance from the origin, for motions and
//            dilations of points up to 10.
// Identity   1 leaves the point exactly.
// Aliasing   The output may be exactly the points.
// Cost       One pass, 19 streams in and 3 out; one division.
// Source     Vahlen's matrices; derived from the formula.

status transform(const conformal_view<const float>& r, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options = {}) noexcept;
status transform(const conformal_view<const double>& r, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options = {}) noexcept;

// square_root: half of a motion
//
// Formula    (1 + R)(k^2 - R4) / (2 n k), R4 the part of four vectors, n^2 = (1 + R0)^2 - R4^2, k^2 = 1 + R0
//            + n: half of the logarithm. n = cos a + cos b, k = 2 cos(a/2) cos(b/2).
// Domain     Rotors.
// Singular   unique, above. 1 + R0 is found without cancellation near -1.
// NaN/Inf    NaN in every component, unique too.
// Accuracy   5e-7 (double: 1e-15).
// Identity   1 gives exactly 1.
// Aliasing   out may be exactly the input.
// Cost       One pass, 16 streams in and 17 out; no branch.
// Source     Dorst, "Rotors and motors", slide 14, simplified.

status square_root(const conformal_view<const float>& r, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options = {}) noexcept;
status square_root(const conformal_view<const double>& r, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options = {}) noexcept;

// exp: rotors of bivectors
//
// Formula    exp B in closed form; no plane is needed, so that it has no exception.
// Domain     Lengths as above, a up to 2^12 (double: 2^19), b of a boost up to 40 (double: 300); anything
//            else counts as 0.
// Singular   Nowhere: null, zero and isoclinic bivectors are regular.
// NaN/Inf    NaN in every component.
// Accuracy   5e-7 (double: 1e-15).
// Identity   0 gives exactly 1.
// Aliasing   Output streams may be exactly input streams.
// Cost       One pass, 10 streams in and 16 out; two sines and cosines and one sinh and cosh.
// Source     Dorst, "Rotors and motors", corrected and made stable.

status exp(const bivector_view<const float>& b, const conformal_view<float>& out, options = {}) noexcept;
status exp(const bivector_view<const double>& b, const conformal_view<double>& out, options = {}) noexcept;

// log: bivectors of rotors
//
// Formula    The principal logarithm, a + b <= pi: G(R0 + R4) R2 with G(c) = acosh(c) / sinh(acosh(c)). Of R
//            itself, not of -R.
// Domain     Rotors.
// Singular   unique, above.
// NaN/Inf    NaN in every component, unique too.
// Accuracy   exp(log R) = R to 1.5e-6 (double: 3e-15); without dilations 1.5e-6 (double: 2e-15).
// Identity   1 gives exactly 0.
// Aliasing   Output streams may be exactly input streams.
// Cost       One pass, 16 streams in and 11 out; two arc tangents and one asinh.
// Source     As exp.

status log(const conformal_view<const float>& r, const bivector_view<float>& out,
           const scalar_view<float>& unique, options = {}) noexcept;
status log(const conformal_view<const double>& r, const bivector_view<double>& out,
           const scalar_view<double>& unique, options = {}) noexcept;

// power: a part or a multiple of a motion
//
// Formula    exp(t log R), in one piece: the same combination of R as log, with sin(t a) / sin a for a / sin a.
//            t is one number for all elements or one for each, in [0, 1] or not.
// Domain     Rotors; t a up to 2^13 (double: 2^20), t b of a boost up to 40 (double: 300), otherwise t counts
//            as 0.
// Singular   unique, above.
// NaN/Inf    NaN in every component, unique too.
// Accuracy   1.2e-6 (double: 2e-15) for t in [0, 1].
// Identity   t = 0 gives exactly 1. In reproducible t = 1 gives R in every bit.
// Aliasing   Output streams may be exactly input streams.
// Cost       One pass, 16 streams in, 1 more for a t for each element, 17 out; two arc tangents, two sines and
//            cosines, one asinh, sinh and cosh.
// Source     Dorst, "Rotors and motors".

status power(const conformal_view<const float>& r, const parameter<float>& t,
             const conformal_view<float>& out, const scalar_view<float>& unique, options = {}) noexcept;
status power(const conformal_view<const double>& r, const parameter<double>& t,
             const conformal_view<double>& out, const scalar_view<double>& unique, options = {}) noexcept;

// interpolate: between two motions
//
// Formula    (b a~)^t a, the motion from a to b at constant speed. b is taken as it is: of b and -b it may be
//            the long way. t is one number for all elements or one for each, in [0, 1] or not
//            (extrapolation).
// Domain     Rotors.
// Singular   unique of b a~, above.
// NaN/Inf    NaN in every component, unique too.
// Accuracy   1e-6 (double: 3e-14) times the length of a, for t in [-0.25, 1.25].
// Identity   In reproducible t = 0 gives a and t = 1 gives b in every bit.
// Aliasing   Output streams may be exactly input streams.
// Cost       One pass, 32 streams in, 1 more for a t for each element, 17 out; power and two products.
// Source     Dorst, "Rotors and motors", slide 23.

status interpolate(const conformal_view<const float>& a, const conformal_view<const float>& b,
                   const parameter<float>& t, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options = {}) noexcept;
status interpolate(const conformal_view<const double>& a, const conformal_view<const double>& b,
                   const parameter<double>& t, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options = {}) noexcept;

// split: the two commuting parts of a bivector
//
// Formula    B = first + second, which commute and are simple (each squares to a number), first^2 <=
//            second^2: first is the larger turn, second the smaller one, the translation or the dilation. A
//            simple bivector is one of both, the other is 0.
// Domain     Bivectors of any length.
// Singular   Where the squares differ by less than 2^-16 (double: 2^-40) of |B|^2 - zero, null, isoclinic -
//            the parts are not unique: unique is 0, first is B and second 0. Elsewhere unique is 1.
// NaN/Inf    NaN in every component, unique too.
// Accuracy   first + second = B to rounding. Commutators and squares 6e-7 (double: 1.5e-15) of |B|^2, over
//            the relative difference of the squares.
// Identity   0 gives 0 and 0.
// Aliasing   Output streams may be exactly input streams.
// Cost       One pass, 10 streams in and 21 out.
// Source     Dorst, "Rotors and motors", slide 18.

status split(const bivector_view<const float>& b, const bivector_view<float>& first,
             const bivector_view<float>& second, const scalar_view<float>& unique, options = {}) noexcept;
status split(const bivector_view<const double>& b, const bivector_view<double>& first,
             const bivector_view<double>& second, const scalar_view<double>& unique, options = {}) noexcept;

}  // namespace swivel

#endif
