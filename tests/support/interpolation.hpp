#ifndef SWIVEL_TESTS_SUPPORT_INTERPOLATION_HPP
#define SWIVEL_TESTS_SUPPORT_INTERPOLATION_HPP

// Interpolation in long double, written from the textbook formulas, which differ from those of the kernels.

#include <cmath>

#include "support/exact.hpp"
#include "support/rotations.hpp"

namespace swivel::tests {

using exact_quat = quat<long double>;
using exact_vec3 = vec3<long double>;

inline exact_quat sum(long double s, const exact_quat& a, long double t, const exact_quat& b) {
    return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z, s * a.w + t * b.w};
}

template <class T>
exact_quat unit_of(const quat<T>& q) {
    const exact_quat w = widen<long double>(q);
    return sum(1 / norm(w), w, 0, w);
}

inline exact_quat on_the_way(const exact_quat& a, const exact_quat& b, bool long_way) {
    return (dot(a, b) < 0) != long_way ? sum(-1, b, 0, b) : b;
}

// From a unit quaternion: cos(angle / 2) and sin(angle / 2) times a unit vector, to the power of t.
inline exact_quat power(const exact_quat& q, long double t) {
    const long double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    if (length == 0) return {0, 0, 0, 1};
    const long double part = t * std::atan2(length, q.w), s = std::sin(part) / length;
    return {s * q.x, s * q.y, s * q.z, std::cos(part)};
}

inline exact_quat exact_slerp(const exact_quat& a, const exact_quat& b, long double t) {
    return times(power(times(b, conjugate(a)), t), a);
}

inline exact_quat exact_nlerp(const exact_quat& a, const exact_quat& b, long double t) {
    const exact_quat m = sum(1 - t, a, t, b);
    return sum(1 / norm(m), m, 0, m);
}

// A rotation at that distance from q, in a random direction.
template <class T>
quat<T> neighbour(generator& g, const quat<T>& q, double distance) {
    const quat<double> d = random_rotation<double>(g);
    const exact_quat r = unit_of(sum(1, unit_of(q), distance, widen<long double>(d)));
    return {static_cast<T>(r.x), static_cast<T>(r.y), static_cast<T>(r.z), static_cast<T>(r.w)};
}

// i q / |q|
template <class T>
quat<T> normalized_turn_about_x(const quat<T>& q) {
    const exact_quat u = unit_of(q);
    return {static_cast<T>(u.w), static_cast<T>(-u.z), static_cast<T>(u.y), static_cast<T>(-u.x)};
}

}  // namespace swivel::tests

#endif
