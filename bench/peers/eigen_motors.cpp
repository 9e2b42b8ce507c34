#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "peers.hpp"

namespace swivel_bench::eigen {

namespace {

template <class T>
using quaternion = Eigen::Quaternion<T>;
template <class T>
using vector = Eigen::Matrix<T, 3, 1>;

template <class T>
struct motor {
    quaternion<T> r, d;
};

template <class T>
const motor<T>* array_of(const T* first) noexcept {
    static_assert(sizeof(motor<T>) == 8 * sizeof(T));
    return reinterpret_cast<const motor<T>*>(first);
}
template <class T>
motor<T>* array_of(T* first) noexcept {
    return reinterpret_cast<motor<T>*>(first);
}

template <class T>
motor<T> product(const motor<T>& a, const motor<T>& b) noexcept {
    return {a.r * b.r, quaternion<T>((a.r * b.d).coeffs() + (a.d * b.r).coeffs())};
}

// Part by part: a whole motor is stored by a 256 bit register, after which gcc 12 forgets the vzeroupper
// before acosf, and the call takes 100 ns more.
template <class T>
void power(const motor<T>& m, T t, quaternion<T>& r, quaternion<T>& d) noexcept {
    const T sine = m.r.vec().norm();
    if (sine == 0) {
        r = quaternion<T>::Identity();
        d.w() = 0;
        d.vec() = t * m.d.vec();
        return;
    }
    const vector<T> axis = m.r.vec() / sine;
    const T half_angle = t * std::acos(std::min(m.r.w(), T(1))), half_pitch = -m.d.w() / sine;
    const vector<T> moment = (m.d.vec() - half_pitch * m.r.w() * axis) / sine;
    const T s = std::sin(half_angle), c = std::cos(half_angle), along = t * half_pitch;
    r.w() = c;
    r.vec() = s * axis;
    d.w() = -along * s;
    d.vec() = s * moment + along * c * axis;
}

}  // namespace

template <class T>
void sclerp(const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept {
    const motor<T>*const from = array_of(a), *const to = array_of(b);
    motor<T>* const result = array_of(out);
    for (std::size_t i = 0; i < n; ++i) {
        motor<T> between = product<T>({from[i].r.conjugate(), from[i].d.conjugate()}, to[i]);
        if (between.r.w() < 0) {
            between.r.coeffs() = -between.r.coeffs();
            between.d.coeffs() = -between.d.coeffs();
        }
        motor<T> part;
        power(between, t[i], part.r, part.d);
        result[i] = product(from[i], part);
    }
}

template <class T>
void transform(const T* m, const T* p, T* out, std::size_t n) noexcept {
    const motor<T>* const by = array_of(m);
    const vector<T>* const from = reinterpret_cast<const vector<T>*>(p);
    vector<T>* const to = reinterpret_cast<vector<T>*>(out);
    for (std::size_t i = 0; i < n; ++i) {
        const quaternion<T>&r = by[i].r, &d = by[i].d;
        to[i] = r * from[i] + 2 * (r.w() * d.vec() - d.w() * r.vec() + r.vec().cross(d.vec()));
    }
}

template <class T>
void motor_multiply(const T* a, const T* b, T* out, std::size_t n) noexcept {
    const motor<T>*const left = array_of(a), *const right = array_of(b);
    motor<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = product(left[i], right[i]);
}

template <class T>
void blend_4(const T* const (&motors)[4], const T* const (&weights)[4], T* out, std::size_t n) noexcept {
    const motor<T>* const first = array_of(motors[0]);
    motor<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) {
        motor<T> sum{quaternion<T>(0, 0, 0, 0), quaternion<T>(0, 0, 0, 0)};
        for (int k = 0; k < 4; ++k) {
            const motor<T>& m = array_of(motors[k])[i];
            const T weight = first[i].r.dot(m.r) < 0 ? -weights[k][i] : weights[k][i];
            sum.r.coeffs() += weight * m.r.coeffs();
            sum.d.coeffs() += weight * m.d.coeffs();
        }
        const T length = sum.r.norm();
        if (length == 0) {
            to[i] = {quaternion<T>::Identity(), quaternion<T>(0, 0, 0, 0)};
            continue;
        }
        sum.r.coeffs() /= length;
        sum.d.coeffs() /= length;
        sum.d.coeffs() -= sum.r.dot(sum.d) * sum.r.coeffs();
        to[i] = sum;
    }
}

template void sclerp(const float*, const float*, const float*, float*, std::size_t) noexcept;
template void sclerp(const double*, const double*, const double*, double*, std::size_t) noexcept;
template void transform(const float*, const float*, float*, std::size_t) noexcept;
template void transform(const double*, const double*, double*, std::size_t) noexcept;
template void motor_multiply(const float*, const float*, float*, std::size_t) noexcept;
template void motor_multiply(const double*, const double*, double*, std::size_t) noexcept;
template void blend_4(const float* const (&)[4], const float* const (&)[4], float*, std::size_t) noexcept;
template void blend_4(const double* const (&)[4], const double* const (&)[4], double*, std::size_t) noexcept;

}  // namespace swivel_bench::eigen
