#ifndef SWIVEL_TESTS_SUPPORT_EXACT_HPP
#define SWIVEL_TESTS_SUPPORT_EXACT_HPP

// Quaternion arithmetic for judging results: in double for float, and in quadruple precision for double.

#include <cfloat>
#include <cmath>

#include "swivel/types.hpp"

namespace swivel::tests {

#ifdef __SIZEOF_FLOAT128__
using quadruple = __float128;
#else
using quadruple = long double;
static_assert(LDBL_MANT_DIG == 113);
#endif

template <class T>
struct wider;
template <>
struct wider<float> {
    using type = double;
};
template <>
struct wider<double> {
    using type = quadruple;
};
template <class T>
using wide = typename wider<T>::type;

template <class W, class T>
quat<W> widen(const quat<T>& q) {
    return {W(q.x), W(q.y), W(q.z), W(q.w)};
}

template <class W, class T>
vec3<W> widen(const vec3<T>& v) {
    return {W(v.x), W(v.y), W(v.z)};
}

inline double root(double a) { return std::sqrt(a); }
#ifdef __SIZEOF_FLOAT128__
inline long double root(long double a) { return std::sqrt(a); }
#endif

// From the double root, which has 53 bits, by one step of Newton's method.
inline quadruple root(quadruple a) {
    if (a == 0) return 0;
    // Brought near 1, so that the double neither overflows nor underflows.
    quadruple scale = 1;
    while (a > 4) a /= 4, scale *= 2;
    while (a < 1) a *= 4, scale /= 2;
    quadruple r = std::sqrt(static_cast<double>(a));
    r = (r + a / r) / 2;
    r = (r + a / r) / 2;
    return r * scale;
}

template <class W>
W dot(const quat<W>& a, const quat<W>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

template <class W>
W norm(const quat<W>& q) {
    return root(dot(q, q));
}

template <class W>
W norm(const vec3<W>& v) {
    return root(v.x * v.x + v.y * v.y + v.z * v.z);
}

template <class W>
quat<W> times(const quat<W>& l, const quat<W>& r) {
    return {l.w * r.x + l.x * r.w + l.y * r.z - l.z * r.y, l.w * r.y + l.y * r.w + l.z * r.x - l.x * r.z,
            l.w * r.z + l.z * r.w + l.x * r.y - l.y * r.x, l.w * r.w - l.x * r.x - l.y * r.y - l.z * r.z};
}

template <class W>
quat<W> conjugate(const quat<W>& q) {
    return {-q.x, -q.y, -q.z, q.w};
}

template <class W>
quat<W> minus(const quat<W>& a, const quat<W>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
}

template <class W>
vec3<W> unit(const vec3<W>& v) {
    const W n = norm(v);
    return {v.x / n, v.y / n, v.z / n};
}

template <class W>
W along(const vec3<W>& a, const quat<W>& q) {
    return a.x * q.x + a.y * q.y + a.z * q.z;
}

template <class W>
W magnitude(W a) {
    return a < 0 ? -a : a;
}

// The factors of q off the pole, from the formula. order says which product the swing belongs to.
template <class W>
struct exact_factors {
    quat<W> swing, twist;
    W closeness;  // sqrt(w^2 + (a.v)^2) / |q|
};

template <class W>
exact_factors<W> factor(const quat<W>& q, const vec3<W>& a, product order) {
    const W u = along(a, q), r = root(q.w * q.w + u * u);
    const quat<W> t{u / r * a.x, u / r * a.y, u / r * a.z, q.w / r};
    return {order == product::swing_twist ? times(q, conjugate(t)) : times(conjugate(t), q), t, r / norm(q)};
}

// By way of long double, whose 11 bits more than double has are enough to judge by.
template <class W>
W sine(W a) {
    return W(std::sin(static_cast<long double>(a)));
}
template <class W>
W cosine(W a) {
    return W(std::cos(static_cast<long double>(a)));
}
template <class W>
W angle_of(W y, W x) {
    return W(std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
}

// The unit of the errors: 2^-24 or 2^-53.
template <class T>
constexpr double rounding_unit = sizeof(T) == 4 ? 0x1p-24 : 0x1p-53;

}  // namespace swivel::tests

#endif
