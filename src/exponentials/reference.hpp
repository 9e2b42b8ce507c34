#ifndef SWIVEL_SRC_EXPONENTIALS_REFERENCE_HPP
#define SWIVEL_SRC_EXPONENTIALS_REFERENCE_HPP

#include "src/reference/scalar.hpp"

namespace swivel::reference {

// A quaternion as m d + w with a unit vector d, x where there is no vector part.
template <class T>
struct polar_form {
    T m, w;
    vec3<T> v;  // the vector part on a scale of its own
    T length;   // of that
    bool scalar_only;

    vec3<T> along(T a) const {
        const T factor = a / length;
        return {scalar_only ? a : v.x * factor, v.y * factor, v.z * factor};
    }
};

// Of q times by, which is a power of two.
template <class T>
polar_form<T> polar(const quat<T>& q, T by) {
    const vec3<T> part{q.x, q.y, q.z};
    const T most = 2 / constants<T>::pole_floor, fitting = scale_for(part),
            scale = fitting < most ? fitting : most;
    const vec3<T> v = scaled(part, scale);
    const T squared = dot(v, v);
    const bool scalar_only = squared == 0;
    const T length = scalar_only ? T(1) : std::sqrt(squared);
    return {scalar_only ? T(0) : length * (by / scale), by * q.w + T(0) * std::fabs(q.w), v, length,
            scalar_only};
}

// Of half of the angle with the sine m and the cosine w, times any length: |w| + sqrt(w^2 + m^2) and m are in
// proportion to cosine and sine, or for negative w to sine and cosine.
template <class T>
sine_cosine<T> half_of(T m, T w) {
    const T sum = std::sqrt(floored(w * w + m * m)) + std::fabs(w);
    const T length = std::sqrt(floored(sum * sum + m * m));
    if (w < 0) return {sum / length, m / length};
    return {m / length, sum / length};
}

}  // namespace swivel::reference

#endif
