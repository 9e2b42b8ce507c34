#ifndef SWIVEL_SRC_REFERENCE_SCALAR_HPP
#define SWIVEL_SRC_REFERENCE_SCALAR_HPP

// The formulas that several operations share, for one element. The order of additions is part of the contract, since
// precision::reproducible promises the same bits; contraction is off for the whole library.

#include <cmath>
#include <iterator>
#include <limits>

#include "../../kernels/constants.hpp"
#include "../unit_axis.hpp"
#include "swivel/types.hpp"

namespace swivel::reference {

template <class T>
T atan2_of(T y, T x) {
    using C = constants<T>;
    const T ax = std::fabs(x), ay = std::fabs(y);
    const bool steep = ay > ax;
    const T small = steep ? ax : ay, large = steep ? ay : ax;
    const bool turned = small > C::tan_eighth_pi * large;
    const T z = turned ? (small - large) / (small + large) : small / large;

    const T s = z * z;
    T p = 0;
    for (auto c = std::end(C::atan); c != std::begin(C::atan);) p = p * s + *--c;
    T rest = (z * s) * p + z;

    T eighths = turned ? T(1) : T(0);
    if (steep) {
        eighths = 2 - eighths;
        rest = 0 - rest;
    }
    if (std::signbit(x)) {
        eighths = 4 - eighths;
        rest = 0 - rest;
    }
    const T angle = eighths * C::quarter_pi + (eighths * C::quarter_pi_rest + rest);
    return std::signbit(y) ? -angle : angle;
}

// A NaN for an infinity, everything else as it is.
template <class T>
T finite_or_nan(T a) {
    return T(0) * a + a;
}

template <class T>
quat<T> multiply(const quat<T>& l, const quat<T>& r) {
    return {finite_or_nan(((l.w * r.x + l.x * r.w) + l.y * r.z) - l.z * r.y),
            finite_or_nan(((l.w * r.y + l.y * r.w) + l.z * r.x) - l.x * r.z),
            finite_or_nan(((l.w * r.z + l.z * r.w) + l.x * r.y) - l.y * r.x),
            finite_or_nan(((l.w * r.w - l.x * r.x) - l.y * r.y) - l.z * r.z)};
}

template <class T>
vec3<T> cross(const vec3<T>& l, const vec3<T>& r) {
    return {l.y * r.z - l.z * r.y, l.z * r.x - l.x * r.z, l.x * r.y - l.y * r.x};
}

// The axis of one element to unit length, by way of a power of two that keeps the squares in range. What
// rounding left over is not known here.
template <class T>
unit_axis<T> normalized(const vec3<T>& v) {
    T largest = std::fabs(v.x) > std::fabs(v.y) ? std::fabs(v.x) : std::fabs(v.y);
    largest = largest > std::fabs(v.z) ? largest : std::fabs(v.z);
    T scale = 0;
    if (std::isfinite(largest)) {
        int exponent;
        std::frexp(largest, &exponent);
        const int most = std::numeric_limits<T>::max_exponent - 1;
        scale = std::ldexp(T(1), 2 - exponent < most ? 2 - exponent : most);
    }
    const vec3<T> s{scale * v.x, scale * v.y, scale * v.z};
    const T squared = (s.x * s.x + s.y * s.y) + s.z * s.z;
    const T root = std::sqrt(constants<T>::pole_floor > squared ? constants<T>::pole_floor : squared);
    return {s.x / root, s.y / root, s.z / root, 0};
}

}  // namespace swivel::reference

#endif
