#ifndef SWIVEL_TESTS_SUPPORT_VECTORS_HPP
#define SWIVEL_TESTS_SUPPORT_VECTORS_HPP

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include "support/exact.hpp"
#include "support/rotations.hpp"

namespace swivel::tests {

template <class W>
vec3<W> crossed(const vec3<W>& a, const vec3<W>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class W>
W dotted(const vec3<W>& a, const vec3<W>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class W>
vec3<W> difference(const vec3<W>& a, const vec3<W>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// q v q*
template <class W>
vec3<W> rotated(const quat<W>& q, const vec3<W>& v) {
    const quat<W> r = times(times(q, quat<W>{v.x, v.y, v.z, 0}), conjugate(q));
    return {r.x, r.y, r.z};
}

// The product b a of two vectors as a quaternion.
template <class W>
quat<W> product_of(const vec3<W>& b, const vec3<W>& a) {
    const vec3<W> v = crossed(a, b);
    return {v.x, v.y, v.z, dotted(a, b)};
}

template <class W>
quat<W> normalized(const quat<W>& q) {
    const W n = norm(q);
    return {q.x / n, q.y / n, q.z / n, q.w / n};
}

// v turned about the axis by Rodrigues' formula.
inline vec3<double> turned(const vec3<double>& v, const vec3<double>& axis, double radians) {
    const double c = std::cos(radians), s = std::sin(radians), along = (1 - c) * dotted(v, axis);
    const vec3<double> a = crossed(axis, v);
    return {c * v.x + s * a.x + along * axis.x, c * v.y + s * a.y + along * axis.y,
            c * v.z + s * a.z + along * axis.z};
}

inline quat<double> about(const vec3<double>& axis, double radians) {
    const double s = std::sin(radians / 2);
    return {s * axis.x, s * axis.y, s * axis.z, std::cos(radians / 2)};
}

template <class T>
vec3<T> random_vector(generator& g, double low, double high) {
    const vec3<double> d = random_direction<double>(g);
    const double s = std::exp2(uniform(g, low, high));
    return {static_cast<T>(s * d.x), static_cast<T>(s * d.y), static_cast<T>(s * d.z)};
}

// A vector near a, near -a or anywhere.
template <class T>
vec3<T> companion(generator& g, const vec3<T>& a, int i) {
    const vec3<T> d = random_vector<T>(g, -24, 0);
    const T s = i % 4 == 0 ? T(-1) : T(1);
    if (i % 2 != 0) return random_vector<T>(g, -10, 10);
    return {s * a.x + d.x * std::fabs(a.x), s * a.y + d.y * std::fabs(a.y), s * a.z + d.z * std::fabs(a.z)};
}

template <class T>
double units(wide<T> error) {
    return static_cast<double>(error) / rounding_unit<T>;
}

template <class T>
std::vector<vec3<T>> corner_vectors() {
    using limits = std::numeric_limits<T>;
    std::vector<T> numbers = {
        0, T(-0.0), 1, -1, limits::denorm_min(), -limits::min(), limits::max(), -limits::max()};
    std::vector<vec3<T>> v;
    for (T x : numbers)
        for (T y : numbers)
            for (T z : {T(0), T(1), limits::denorm_min(), -limits::max()}) v.push_back({x, y, z});
    return v;
}

template <class T>
bool no_nan(std::initializer_list<T> numbers) {
    return std::none_of(numbers.begin(), numbers.end(), [](T a) { return std::isnan(a); });
}
template <class T>
bool all_nan(std::initializer_list<T> numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](T a) { return std::isnan(a); });
}
template <class T>
inline const std::vector<T> bad_numbers = {std::numeric_limits<T>::quiet_NaN(),
                                           std::numeric_limits<T>::infinity(),
                                           -std::numeric_limits<T>::infinity()};

template <class T>
std::vector<vec3<T>> bad_vectors(const vec3<T>& v) {
    std::vector<vec3<T>> all;
    for (T bad : bad_numbers<T>) {
        all.push_back({bad, v.y, v.z});
        all.push_back({v.x, bad, v.z});
        all.push_back({v.x, v.y, bad});
    }
    return all;
}

template <class T>
std::vector<quat<T>> bad_rotations(const quat<T>& q) {
    std::vector<quat<T>> all;
    for (T bad : bad_numbers<T>) {
        all.push_back({bad, q.y, q.z, q.w});
        all.push_back({q.x, bad, q.z, q.w});
        all.push_back({q.x, q.y, bad, q.w});
        all.push_back({q.x, q.y, q.z, bad});
    }
    return all;
}

}  // namespace swivel::tests

#endif
