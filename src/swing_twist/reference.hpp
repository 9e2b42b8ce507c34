#ifndef SWIVEL_SRC_SWING_TWIST_REFERENCE_HPP
#define SWIVEL_SRC_SWING_TWIST_REFERENCE_HPP

// The twist of one element about a unit vector.

#include <cmath>

#include "kernels/constants.hpp"
#include "src/call/unit_axis.hpp"
#include "swivel/types.hpp"

namespace swivel::reference {

template <class T>
struct half_twist {
    T cosine, sine;
};

// T = (u a, w) / sqrt(w^2 + u^2), and at the pole (0, sgn w).
template <class T>
half_twist<T> half_twist_of(T w, T u, T t, T norm_squared, T threshold) {
    const T nan_unless_finite = T(0) * norm_squared;
    t = nan_unless_finite + t;
    if (t <= threshold * norm_squared + constants<T>::pole_floor) return {std::copysign(T(1), w), T(0)};
    const T root = std::sqrt(t);
    return {w / root, u / root};
}

// The rounding of a uniform axis is known and is taken out of w^2 + (a.v)^2, so that |T| does not have it.
template <class T>
half_twist<T> half_twist_about(const unit_axis<T>& a, const quat<T>& q, T threshold) {
    const T u = (a.x * q.x + a.y * q.y) + a.z * q.z;
    const T w_squared = q.w * q.w, u_squared = u * u;
    const T norm_squared = ((q.x * q.x + q.y * q.y) + q.z * q.z) + w_squared;
    return half_twist_of(q.w, u, u_squared + (w_squared + a.excess * u_squared), norm_squared, threshold);
}

}  // namespace swivel::reference

#endif
