#ifndef SWIVEL_BENCH_METHODS_METHODS_HPP
#define SWIVEL_BENCH_METHODS_METHODS_HPP

// The methods that Dobrowolski's paper ("Swing-twist decomposition in Clifford algebra") compares, one
// rotation at a time: its Algorithm 1, the direct method (section 2.1) and Huyghe's (section 2.2), and the
// form about a coordinate axis of Reynolds' article ("Quaternion swing-twist decomposition").
//
// Each takes a unit quaternion q and gives q = S T, the twist T about the axis and the swing S about one that
// is perpendicular to it. They are written as they are printed, so that each breaks where its formulas do.

#include <cmath>

#include "swivel/types.hpp"

namespace swivel_bench::methods {

// One copy in each file: the files that measure time and error are compiled with different flags.
namespace {

using swivel::quat;
using swivel::vec3;

template <class T>
struct swing_twist {
    quat<T> swing, twist;
};

template <class T>
T dot(const vec3<T>& a, const vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
vec3<T> cross(const vec3<T>& a, const vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
quat<T> product(const quat<T>& l, const quat<T>& r) {
    return {l.w * r.x + l.x * r.w + l.y * r.z - l.z * r.y, l.w * r.y + l.y * r.w + l.z * r.x - l.x * r.z,
            l.w * r.z + l.z * r.w + l.x * r.y - l.y * r.x, l.w * r.w - l.x * r.x - l.y * r.y - l.z * r.z};
}

template <class T>
quat<T> conjugate(const quat<T>& q) {
    return {-q.x, -q.y, -q.z, q.w};
}

// q a q*, in the form with the fewest multiplications.
template <class T>
vec3<T> rotated(const quat<T>& q, const vec3<T>& a) {
    const vec3<T> v{q.x, q.y, q.z}, half = cross(v, a), t{T(2) * half.x, T(2) * half.y, T(2) * half.z};
    const vec3<T> turned = cross(v, t);
    return {a.x + q.w * t.x + turned.x, a.y + q.w * t.y + turned.y, a.z + q.w * t.z + turned.z};
}

// Algorithm 1
//
// Formula    u = a.v   n = a.a   m = w n   l = sqrt(m^2 + u^2 n)   T = (u/l a, m/l)   S = q T*
// Axis       any that is not zero, of any length
// Source     Dobrowolski, section 9.1. Its spinor a + b e12 + c e23 + d e31 is the quaternion (w, x, y, z) =
//            (a, -c, -d, -b), which keeps products as they are. So u changes its sign twice and p = s q~ is S
//            = q T*.
// Breaks     At swing pi, where l = 0: T and S are 0/0. Axes whose length to the fourth power leaves the
//            range of the type.
template <class T>
swing_twist<T> algorithm_1(const quat<T>& q, const vec3<T>& a) {
    const T u = a.x * q.x + a.y * q.y + a.z * q.z;
    const T n = a.x * a.x + a.y * a.y + a.z * a.z;
    const T m = q.w * n;
    const T l = std::sqrt(m * m + u * u * n);
    const quat<T> twist{a.x * u / l, a.y * u / l, a.z * u / l, m / l};
    return {product(q, conjugate(twist)), twist};
}

// Direct method
//
// Formula    b = q a q*   n = a x b / |a x b|   cos(alpha) = a.b   S = (sin(alpha/2) n, cos(alpha/2))   T =
//            S* q
// Axis       unit
// Source     Dobrowolski, section 2.1. The twist printed there, q S*, is about b and not about a; S* q is the
//            one that belongs to S.
// Breaks     At swings 0 and pi, where n is 0/0. Next to them the arc cosine loses half of the digits: alpha
//            is known to about the root of the rounding unit, and S and T with it. Where rounding makes a.b
//            larger than 1 or smaller than -1, it gives NaN.
template <class T>
swing_twist<T> direct(const quat<T>& q, const vec3<T>& a) {
    const vec3<T> b = rotated(q, a), c = cross(a, b);
    const T length = std::sqrt(dot(c, c));
    const vec3<T> n{c.x / length, c.y / length, c.z / length};
    const T alpha = std::acos(dot(a, b));
    const T s = std::sin(alpha / 2);
    const quat<T> swing{s * n.x, s * n.y, s * n.z, std::cos(alpha / 2)};
    return {swing, product(conjugate(swing), q)};
}

// Huyghe's method about z
//
// Formula    T = (0, 0, z, w) / sqrt(w^2 + z^2)   S = (tw x - tz y, tw y + tz x, 0, tw w + tz z)
// Source     Dobrowolski, section 2.2, after Huyghe's thesis; of the two signs, the upper.
// Breaks     At swing pi, where w = z = 0: T and S are 0/0.
template <class T>
swing_twist<T> huyghe(const quat<T>& q) {
    const T root = std::sqrt(q.w * q.w + q.z * q.z);
    const T tw = q.w / root, tz = q.z / root;
    return {{tw * q.x - tz * q.y, tw * q.y + tz * q.x, T(0), tw * q.w + tz * q.z}, {T(0), T(0), tz, tw}};
}

// Huyghe's method about any axis
//
// Formula    p = ((a.v) a, w)   T = p / |p|   S = q T*
// Axis       unit
// Source     Dobrowolski, section 2.2, after the second part of the thesis.
// Breaks     At swing pi, where p = 0: T and S are 0/0.
template <class T>
swing_twist<T> huyghe(const quat<T>& q, const vec3<T>& a) {
    const T u = a.x * q.x + a.y * q.y + a.z * q.z;
    const quat<T> p{u * a.x, u * a.y, u * a.z, q.w};
    const T length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z + p.w * p.w);
    const quat<T> twist{p.x / length, p.y / length, p.z / length, p.w / length};
    return {product(q, conjugate(twist)), twist};
}

// Axis-aligned form, about z
//
// Formula    t = w^2 + z^2   s = 1 / sqrt(t)   T = (0, 0, s z, s w)   S = (s (w x - y z), s (w y + x z), 0, s
//            t)
// Source     Reynolds' article, quat_factor_z: t and the threshold, 2^-48 (double: 2^-106).
// Breaks     Not at swing pi: at and below the threshold T is the identity and S is q. But that S is not
//            perpendicular to z, and that of -q is -S where everywhere else it is S.
template <class T>
swing_twist<T> axis_aligned(const quat<T>& q) {
    constexpr T threshold = sizeof(T) == 4 ? T(0x1p-48) : T(0x1p-106);
    const T t = q.w * q.w + q.z * q.z;
    if (!(t > threshold)) return {q, {T(0), T(0), T(0), T(1)}};
    const T s = 1 / std::sqrt(t);
    return {{s * (q.w * q.x - q.y * q.z), s * (q.w * q.y + q.x * q.z), T(0), s * t},
            {T(0), T(0), s * q.z, s * q.w}};
}

}  // namespace

}  // namespace swivel_bench::methods

#endif
