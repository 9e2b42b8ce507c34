#ifndef SWIVEL_SRC_REFERENCE_SCALAR_HPP
#define SWIVEL_SRC_REFERENCE_SCALAR_HPP

// The formulas that several operations share, for one element. The order of additions is part of the
// contract, since precision::reproducible promises the same bits; contraction is off for the whole library.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>

#include "kernels/constants.hpp"
#include "src/call/unit_axis.hpp"
#include "swivel/types.hpp"

namespace swivel::reference {

// c[first] + c[first + step] x + ... by Horner's rule.
template <class T, std::size_t N>
T horner(std::size_t first, std::size_t step, T x, const T (&c)[N]) {
    std::size_t k = first + (N - 1 - first) / step * step;
    T p = c[k];
    while (k > first) {
        k -= step;
        p = p * x + c[k];
    }
    return p;
}

// c0 + c1 x + ...; of the long ones all but the first two coefficients as even and odd part.
template <class T, std::size_t N>
T polynomial(T x, const T (&c)[N]) {
    if (N < 5) return horner(0, 1, x, c);
    const T rest = horner(3, 2, x * x, c) * x + horner(2, 2, x * x, c);
    return (rest * x + c[1]) * x + c[0];
}

// x^2 for a series in it.
template <class T>
T series_square(T x) {
    const T least = constants<T>::negligible, size = std::fabs(x), no_less = least > size ? least : size;
    return no_less * no_less;
}

// For |z| <= 1.
template <class T>
T atan_of(T z) {
    const T s = series_square(z);
    return (z * s) * polynomial(s, constants<T>::atan) + z;
}

template <class T>
T atan2_of(T y, T x) {
    using C = constants<T>;
    const T ax = std::fabs(x), ay = std::fabs(y);
    const bool steep = ay > ax;
    const T small = steep ? ax : ay, large = steep ? ay : ax;
    const bool left = std::signbit(x);
    const T ratio = small / (large == 0 ? T(1) : large), z = steep != left ? -ratio : ratio,
            s = series_square(z);
    const T quarters = steep ? 1 : left ? 2 : 0;
    const T bend = (z * s) * polynomial(s, C::atan) + quarters * C::half_pi_rest;
    const T angle = quarters * C::half_pi + (z + bend);
    return std::signbit(y) ? -angle : angle;
}

// The same of a point at that distance from (0, 0): twice the angle at half the way.
template <class T>
T angle_of(T y, T x, T distance) {
    const T half = atan_of(y / (distance + std::fabs(x)));
    if (!std::signbit(x)) return half + half;
    return std::copysign(constants<T>::pi, y) - (half + half);
}

template <class T>
struct sine_cosine {
    T sine, cosine;
};

// Sine and cosine of r = |x| - k pi/2, exchanged where k is odd, with the signs of the quadrant.
template <class T>
sine_cosine<T> sincos_of(T x) {
    using C = constants<T>;
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    T r = std::fabs(x);
    if (r > C::largest_angle) r = T(0) * r;
    const T rounded = r * C::two_over_pi + C::round, k = rounded - C::round;
    const unsigned quadrant = static_cast<unsigned>(std::bit_cast<bits>(rounded)) & 3U;
    // Exact, up to here; what the difference of the third product rounds off goes back in with the fourth.
    const T rest = (r - k * C::half_pi_parts[0]) - k * C::half_pi_parts[1], third = k * C::half_pi_parts[2];
    const T reduced = rest - third;
    r = reduced + (((rest - reduced) - third) - k * C::half_pi_parts[3]);

    const T s = series_square(r);
    T sine = (r * s) * polynomial(s, C::sin) + r;
    T cosine = (s * s) * polynomial(s, C::cos) + (1 - T(0.5) * s);
    if (quadrant % 2 != 0) std::swap(sine, cosine);
    if ((quadrant >= 2) != std::signbit(x)) sine = -sine;
    if (quadrant == 1 || quadrant == 2) cosine = -cosine;
    return {sine, cosine};
}

template <class T>
struct hyperbolic {
    T sinh, cosh;
};

// Sinh and cosh of 0 <= x <= largest_boost by way of m = e^x - 1 = 2^k (e^r - 1) + (2^k - 1), x = r + k ln 2.
template <class T>
hyperbolic<T> sinhcosh_of(T x) {
    using C = constants<T>;
    const T k = (x * C::one_over_ln_2 + C::round) - C::round;
    const T r = (x - k * C::ln_2) - k * C::ln_2_rest;
    const T power = std::ldexp(T(1), static_cast<int>(k));
    const T m = ((r * r) * polynomial(r, C::expm1) + r) * power + (power - 1), part = m / (m + 1);
    return {T(0.5) * (m + part), (T(0.5) * m) * part + 1};
}

// For 0 <= x: log(1 + t) with t = x + (sqrt(1 + x^2) - 1), 1 + t = 2^k (1 + f) / (1 - f).
template <class T>
T asinh_of(T x) {
    using C = constants<T>;
    const T square = x * x, t = x + square / (1 + std::sqrt(square + 1)), sum = 1 + t;
    const int exponent = std::ilogb(sum * C::sqrt_2);
    const T k = static_cast<T>(exponent), rest = exponent == 0 ? t : sum * std::ldexp(T(1), -exponent) - 1;
    const T f = rest / (rest + 2), s = series_square(f);
    return k * C::ln_2 + ((f * s) * polynomial(s, C::log) + (k * C::ln_2_rest + (f + f)));
}

// A NaN for an infinity, everything else as it is.
template <class T>
T finite_or_nan(T a) {
    return T(0) * a + a;
}

// 0, or NaN where one of the numbers is not finite.
template <class T, std::size_t N>
T zero_or_nan(const std::array<T, N>& numbers) {
    T sum = 0;
    for (const T a : numbers) sum = T(0) * a + sum;
    return sum;
}

template <class T>
vec3<T> vector_part(const quat<T>& q) {
    return {q.x, q.y, q.z};
}

template <class T>
quat<T> joined(const vec3<T>& v, T w) {
    return {v.x, v.y, v.z, w};
}

template <class T>
quat<T> reversed(const quat<T>& q) {
    return {-q.x, -q.y, -q.z, q.w};
}

template <class T>
quat<T> hamilton(const quat<T>& l, const quat<T>& r) {
    return {
        ((l.w * r.x + l.x * r.w) + l.y * r.z) - l.z * r.y, ((l.w * r.y + l.y * r.w) + l.z * r.x) - l.x * r.z,
        ((l.w * r.z + l.z * r.w) + l.x * r.y) - l.y * r.x, ((l.w * r.w - l.x * r.x) - l.y * r.y) - l.z * r.z};
}

template <class T>
quat<T> multiply(const quat<T>& l, const quat<T>& r) {
    const quat<T> p = hamilton(l, r);
    return {finite_or_nan(p.x), finite_or_nan(p.y), finite_or_nan(p.z), finite_or_nan(p.w)};
}

// No less than the smallest square that has all its bits; NaN as it is.
template <class T>
T floored(T square) {
    return constants<T>::pole_floor > square ? constants<T>::pole_floor : square;
}

template <class T>
vec3<T> cross(const vec3<T>& l, const vec3<T>& r) {
    return {l.y * r.z - l.z * r.y, l.z * r.x - l.x * r.z, l.x * r.y - l.y * r.x};
}

template <class T>
quat<T> minus(const quat<T>& q) {
    return {-q.x, -q.y, -q.z, -q.w};
}

template <class T>
T dot(const quat<T>& a, const quat<T>& b) {
    return ((a.x * b.x + a.y * b.y) + a.z * b.z) + a.w * b.w;
}

template <class T>
T dot(const vec3<T>& a, const vec3<T>& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

// v + w t + u x t with t = 2 u x v and q = (u, w).
template <class T>
vec3<T> rotated(const vec3<T>& v, const quat<T>& q) {
    const vec3<T> u{q.x, q.y, q.z}, half = cross(u, v);
    const vec3<T> t{half.x + half.x, half.y + half.y, half.z + half.z}, turned = cross(u, t);
    return {finite_or_nan(v.x + (turned.x + q.w * t.x)), finite_or_nan(v.y + (turned.y + q.w * t.y)),
            finite_or_nan(v.z + (turned.z + q.w * t.z))};
}

// A power of two that brings the largest of some magnitudes to 2..4, as far as there is one.
template <class T>
T scale_for(std::initializer_list<T> magnitudes) {
    T largest = 0;
    for (T m : magnitudes) largest = largest > m ? largest : m;
    if (!std::isfinite(largest)) return 0;
    int exponent;
    std::frexp(largest, &exponent);
    const int most = std::numeric_limits<T>::max_exponent - 1;
    return std::ldexp(T(1), 2 - exponent < most ? 2 - exponent : most);
}

template <class T>
T scale_for(const vec3<T>& v) {
    return scale_for({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

template <class T>
vec3<T> scaled(const vec3<T>& v, T by) {
    return {by * v.x, by * v.y, by * v.z};
}

// Times a power of two that brings the largest component to 2..4, of subnormal ones in two steps.
template <class T>
vec3<T> in_range(const vec3<T>& v) {
    using C = constants<T>;
    const bool subnormal = std::fabs(v.x) < C::smallest_normal && std::fabs(v.y) < C::smallest_normal &&
                           std::fabs(v.z) < C::smallest_normal;
    const vec3<T> lifted = scaled(v, subnormal ? 1 / C::rounding : T(1));
    return scaled(lifted, scale_for(lifted));
}

// One of the vectors perpendicular to v, of length |v| or somewhat less.
template <class T>
vec3<T> perpendicular(const vec3<T>& v) {
    if (std::fabs(v.x) > std::fabs(v.z)) return {-v.y, v.x, 0};
    return {0, -v.z, v.y};
}

// The axis of one element to unit length, by way of a power of two that keeps the squares in range. What
// rounding left over is not known here.
template <class T>
unit_axis<T> normalized(const vec3<T>& v) {
    const vec3<T> s = scaled(v, scale_for(v));
    const T root = std::sqrt(floored(dot(s, s)));
    return {s.x / root, s.y / root, s.z / root, 0};
}

// The same of a quaternion; the zero quaternion gives the identity.
template <class T>
quat<T> normalized(const quat<T>& q) {
    const T scale = scale_for({std::fabs(q.x), std::fabs(q.y), std::fabs(q.z), std::fabs(q.w)});
    const quat<T> s{scale * q.x, scale * q.y, scale * q.z, scale * q.w};
    const T squared = dot(s, s), root = std::sqrt(floored(squared));
    return {s.x / root, s.y / root, s.z / root, squared == 0 ? T(1) : s.w / root};
}

}  // namespace swivel::reference

#endif
