#ifndef SWIVEL_VERSORS_HPP
#define SWIVEL_VERSORS_HPP

#include <limits>

#include "swivel/types.hpp"

// Products of vectors: the tools of Dorst's slides, for one element at a time
//
// A versor is a geometric product of vectors, a rotor one of length 1. The product b a of two vectors of
// space is the quaternion (a x b, a.b), which turns by twice the angle from a to b. These functions are to
// read and to check by. They are plain scalar code, have no form for streams, and exist for float and double.
// None throws or allocates. But for from_spinor and to_spinor an infinity in an argument counts as a NaN. No
// result of finite arguments is NaN. Bounds are in units of 2^-24 (float) and 2^-53 (double) and asserted by
// versors_test.cpp, rotor_arcs_test.cpp and halving_test.cpp.

namespace swivel {

template <class T>
struct vec2 {
    T x, y;
    friend constexpr bool operator==(const vec2&, const vec2&) = default;
};

// scalar + e12 times the unit of the plane: the ratio of two vectors of the plane.
template <class T>
struct spinor2 {
    T scalar, e12;
    friend constexpr bool operator==(const spinor2&, const spinor2&) = default;
};

// a + b e12 + c e23 + d e31
template <class T>
struct spinor {
    T a, b, c, d;
    friend constexpr bool operator==(const spinor&, const spinor&) = default;
};

// The arcs of two rotors on the unit sphere, slid along their circles until the first ends where the second
// starts.
template <class T>
struct composed_arcs {
    vec3<T> start, common, end;  // first = common start, second = end common, rotor = end start
    quat<T> rotor;               // the composite; its w is the cosine of the arc from start to end
};

}  // namespace swivel

namespace swivel::reference {

// ratio: what takes a to b in the plane
//
// Formula    b/a = b a^-1 = (b.a + b^a) / |a|^2 = r exp(-e12 f), r the ratio of the lengths and f the angle
//            from a to b, counted from e1 to e2.
// Domain     Vectors of any length.
// Singular   a = 0 gives 1, whatever b is; b = 0 alone gives 0. A ratio of lengths beyond the largest number
//            is infinite and one below the smallest 0.
// NaN/Inf    Both parts are NaN.
// Accuracy   |error| <= 5 times |b| / |a|, where that is a normal number.
// Identity   ratio(a, a) is 1, exactly.
// Source     Dorst, slide 1.
template <class T>
spinor2<T> ratio(const vec2<T>& b, const vec2<T>& a) noexcept;

// apply: the vector that is to v what b is to a, for s = b/a
//
// Formula    s v, the geometric product: v turned by the angle of s and stretched by its length.
// Domain     Any s and v.
// Singular   Nowhere. A result beyond the largest number is infinite.
// NaN/Inf    Both components are NaN.
// Accuracy   |error| <= 2.5 times |s| |v|, where that is a normal number.
// Identity   apply(ratio(b, a), a) is b to rounding.
// Source     Dorst, slide 1.
template <class T>
vec2<T> apply(const spinor2<T>& s, const vec2<T>& v) noexcept;

// reflect: v mirrored in the plane through the origin with the normal a
//
// Formula    -a v a^-1 = v - 2 (v.a) a / |a|^2.
// Domain     Vectors of any length; a need not be a unit vector.
// Singular   a = 0 is the normal of no plane and leaves v as it is. A component beyond the largest number is
//            infinite.
// NaN/Inf    Every component is NaN.
// Accuracy   |error| <= 12 times |v|, where that is a normal number.
// Identity   Vectors of the plane stay and a turns to -a, to rounding. Twice the same reflection is none.
// Source     Dorst, slide 2.
template <class T>
vec3<T> reflect(const vec3<T>& v, const vec3<T>& a) noexcept;

// rotation_from_reflections: mirrored first in the plane with the normal a, then in that with the normal b
//
// Formula    n(b a) = n(a x b, a.b): the rotation by twice the angle from a to b, about a x b.
// Domain     Vectors of any length.
// Singular   A vector of zeros gives (0, 0, 0, 1), as it does in shortest_arc. Opposite vectors give -1,
//            (0, 0, 0, -1): both planes are the same, and the full turn of the rotor remains. square_root of
//            the result is shortest_arc(a, b) but there, where the half turn of square_root is about x and
//            that of shortest_arc about an axis perpendicular to a.
// NaN/Inf    Every component is NaN.
// Accuracy   |error| <= 3.5.
// Identity   a = b gives (0, 0, 0, 1) exactly.
// Source     Dorst, slides 3, 4 and 11.
template <class T>
quat<T> rotation_from_reflections(const vec3<T>& a, const vec3<T>& b) noexcept;

// half_angle_cosine: the cosine of half the angle of two rotations made one after the other
//
// Formula    cos h = cos f cos g - sin f sin g cos b, for half angles f and g of the two rotations and the
//            angle b between their axes. As a cosine rule of the triangle of arcs it has a plus and the angle
//            at the common corner, pi - b. It is the same for either order.
// Domain     Radians. Angles of any size, as far as std::sin and std::cos are good for them.
// Singular   Nowhere. The result never leaves [-1, 1].
// NaN/Inf    NaN.
// Accuracy   |error| <= 3.
// Identity   Axes alike (b = 0): cos(f + g) to rounding.
// Source     Dorst, slide 7, where the cosine of the plus is <I2 I1>_0 and not that of the angle between the
//            planes I1 and I2, which would be its negative.
template <class T>
T half_angle_cosine(T first_half_angle, T second_half_angle, T between_axes) noexcept;

// compose_arcs: the product of two rotors as a sum of arcs
//
// Formula    rotor = n(second first), first made first. common = n(v1 x v2), perpendicular to both axes, from
//            where the arcs reach back to start = first^-1 common and on to end = second common; rotor is end
//            start. Each arc is half as long as its rotation turns.
// Domain     Quaternions of any length, of which only the direction counts.
// Singular   About one and the same axis, to rounding, common is any point of the plane of both. A rotor 1 or
//            -1 has no axis: it takes that of the other, and if there is none either, x. An arc of -1 ends
//            opposite to where it starts. Zero quaternions count as 1.
// NaN/Inf    Every component of all parts is NaN.
// Accuracy   |error| of rotor <= 3.5; of what the arcs are to give (the three products of the vectors, their
//            lengths less 1) <= 10.
// Identity   rotor.w is half_angle_cosine.
// Source     Dorst, slides 5 to 7. Slides 5 and 10 print the two angles of the composite exchanged: the first
//            rotation is by the angle and the plane of the factor on the right, exp(-J psi/2) exp(-I phi/2).
template <class T>
composed_arcs<T> compose_arcs(const quat<T>& first, const quat<T>& second) noexcept;

// from_spinor, to_spinor: quaternions and rotors, one element of the operations in spinor.hpp
//
// Formula    q0 - I3 q: the quaternion (x, y, z, w) is w - z e12 - x e23 - y e31. Products are products:
//            (p0 q0 - p.q) - I3 (p0 q + q0 p + q x p) for the factor q on the left.
// Domain     Any numbers.
// Singular   Nowhere.
// NaN/Inf    Come out as they are, in the component that they are in.
// Accuracy   Exact.
// Identity   Each undoes the other in every bit.
// Source     Dorst, slide 8, whose last line prints a plus before I3.
template <class T>
quat<T> from_spinor(const spinor<T>& s) noexcept;
template <class T>
spinor<T> to_spinor(const quat<T>& q) noexcept;

// power_by_halving: q^t from square roots and products only
//
// Formula    t to the nearest multiple of 2^-bits, 0.b1 b2 b3 ... as a binary fraction: the product of those
//            roots q^(1/2), q^(1/4), q^(1/8) ... whose bit is 1.
// Domain     Any quaternion, of which only the direction counts. t below 0 counts as 0, above 1 as 1; bits
//            below 0 as 0, above 62 as 62.
// Singular   q = -1 is the full turn about x, as in power and square_root. The zero quaternion gives (0, 0,
//            0, 1).
// NaN/Inf    Every component is NaN, if any of q or t is a NaN or an infinity.
// Accuracy   |error| <= 2^-(bits + 1) |log q|, from the rounding of t, plus 8 (float) or 11 (double), the
//            more the more bits: each bit halves the error, down to rounding. |log q| is half of the angle of
//            q. With all bits it is within 12 of power.
// Identity   t = 0 gives (0, 0, 0, 1) exactly, t = 1 gives q/|q|.
// Source     Dorst, slides 12, 16 and 20.
template <class T>
quat<T> power_by_halving(const quat<T>& q, T t, int bits = std::numeric_limits<T>::digits) noexcept;

// interpolate_by_halving: slerp from square roots and products only
//
// Formula    (b a*)^t a by power_by_halving; where a.b < 0, -b stands for b.
// Domain     Quaternions of any length, of which only the direction counts. t and bits as above.
// Singular   Nowhere: by the short way b a* is at most a half turn.
// NaN/Inf    Every component is NaN, if any of a, b or t is a NaN or an infinity.
// Accuracy   |error| <= 2^-(bits + 1) times the angle between a and b as vectors of four numbers, plus 9
//            (float) or 12 (double).
// Identity   t = 0 gives a/|a| and t = 1 gives b/|b| or -b/|b|, to rounding.
// Source     Dorst, slides 16, 20 and 23.
template <class T>
quat<T> interpolate_by_halving(const quat<T>& a, const quat<T>& b, T t,
                               int bits = std::numeric_limits<T>::digits) noexcept;

}  // namespace swivel::reference

#endif
