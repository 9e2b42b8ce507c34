#ifndef SWIVEL_TESTS_SUPPORT_ROTATIONS_HPP
#define SWIVEL_TESTS_SUPPORT_ROTATIONS_HPP

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "swivel/types.hpp"

namespace swivel::tests {

using generator = std::mt19937_64;

// Not std::normal_distribution: its numbers differ between standard libraries.
inline double uniform(generator& g, double low, double high) {
    return low + (high - low) * (static_cast<double>(g() >> 11) * 0x1p-53);
}

template <class T>
quat<T> rounded(double x, double y, double z, double w) {
    return {static_cast<T>(x), static_cast<T>(y), static_cast<T>(z), static_cast<T>(w)};
}

// Uniform over the rotations (Shoemake).
template <class T>
quat<T> random_rotation(generator& g) {
    const double u = uniform(g, 0, 1), a = uniform(g, 0, 6.283185307179586),
                 b = uniform(g, 0, 6.283185307179586);
    const double r = std::sqrt(1 - u), s = std::sqrt(u);
    return rounded<T>(r * std::sin(a), r * std::cos(a), s * std::sin(b), s * std::cos(b));
}

template <class T>
vec3<T> random_direction(generator& g) {
    for (;;) {
        const double x = uniform(g, -1, 1), y = uniform(g, -1, 1), z = uniform(g, -1, 1);
        const double n = x * x + y * y + z * z;
        if (n < 0.01 || n > 1) continue;
        const double s = 1 / std::sqrt(n);
        return {static_cast<T>(x * s), static_cast<T>(y * s), static_cast<T>(z * s)};
    }
}

// A unit quaternion at distance r from the pole of the axis: sqrt(w^2 + (a.v)^2) = r up to rounding.
template <class T>
quat<T> near_pole(generator& g, const vec3<T>& a, double r) {
    const double n = std::sqrt(double(a.x) * a.x + double(a.y) * a.y + double(a.z) * a.z);
    const vec3<double> axis{a.x / n, a.y / n, a.z / n};
    vec3<double> p = random_direction<double>(g);
    const double along = p.x * axis.x + p.y * axis.y + p.z * axis.z;
    p = {p.x - along * axis.x, p.y - along * axis.y, p.z - along * axis.z};
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z), s = std::sqrt(1 - r * r) / length;
    const double angle = uniform(g, 0, 6.283185307179586), w = r * std::cos(angle), u = r * std::sin(angle);
    return rounded<T>(p.x * s + u * axis.x, p.y * s + u * axis.y, p.z * s + u * axis.z, w);
}

// Finite quaternions at which an implementation goes wrong first, about the coordinate axes.
template <class T>
std::vector<quat<T>> corner_rotations() {
    using limits = std::numeric_limits<T>;
    const T h = static_cast<T>(0.70710678118654752);
    const T denormal = limits::denorm_min(), smallest = limits::min(), eps = limits::epsilon();
    std::vector<quat<T>> q = {
        {0, 0, 0, 1},
        {0, 0, 0, -1},
        {T(-0.0), T(-0.0), T(-0.0), 1},
        {T(-0.0), 0, T(-0.0), -1},
        {1, 0, 0, 0},
        {0, 1, 0, 0},
        {0, 0, 1, 0},
        {1, 0, 0, T(-0.0)},
        {0, 1, 0, T(-0.0)},
        {0, 0, 1, T(-0.0)},
        {-1, 0, 0, 0},
        {0, 0, -1, T(-0.0)},
        {h, h, 0, 0},
        {h, -h, T(-0.0), T(-0.0)},
        {h, h, denormal, 0},
        {h, h, 0, denormal},
        {h, h, 0, -denormal},
        {h, h, -denormal, denormal},
        {h, h, smallest, smallest},
        {h, h, -smallest, -smallest},
        {h, h, eps, eps},
        {h, h, eps * eps, -eps * eps},
        {h, 0, h, 0},
        {0, h, h, T(-0.0)},
        {0, 0, h, h},
        {0, 0, -h, h},
        {0, 0, h, -h},
        {0, 0, -h, -h},
        {0, 0, denormal, 1},
        {0, 0, denormal, -1},
        {0, 0, -denormal, -1},
        {denormal, 0, 0, 1},
        {0, 0, 0, 0},
        {T(-0.0), T(-0.0), T(-0.0), T(-0.0)},
        {0, 0, 0, T(-0.0)},
        {denormal, denormal, denormal, denormal},
        {h, h, eps / 2, 0},
        {h, h, 0, eps / 2},
        {h, h, 0, -eps / 2},
        {T(0.5), T(0.5), T(0.5), T(0.5)},
        {2, 0, 0, 0},
        {0, 0, 3, 4},
        {T(1e-6), T(2e-6), T(3e-6), T(4e-6)},
        {T(1e9), T(-2e9), T(3e9), T(-4e9)},
    };
    return q;
}

}  // namespace swivel::tests

#endif
