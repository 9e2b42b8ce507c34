#include <Eigen/Geometry>
#include <cmath>

#include "peers.hpp"

namespace swivel_bench::eigen {

namespace {

template <class T>
using quaternion = Eigen::Quaternion<T>;
template <class T>
using vector = Eigen::Matrix<T, 3, 1>;

// The coefficients are an array of T in memory; nothing else is in the type.
template <class T>
const quaternion<T>* array_of(const T* first) noexcept {
    static_assert(sizeof(quaternion<T>) == 4 * sizeof(T));
    return reinterpret_cast<const quaternion<T>*>(first);
}
template <class T>
quaternion<T>* array_of(T* first) noexcept {
    return reinterpret_cast<quaternion<T>*>(first);
}

// normalized() leaves a zero quaternion as it is, so it has the check that such code needs.
template <class T>
quaternion<T> twist_of(const quaternion<T>& q, const vector<T>& a) noexcept {
    const vector<T> along = a * a.dot(q.vec());
    return quaternion<T>(q.w(), along.x(), along.y(), along.z()).normalized();
}

template <class T>
const vector<T>* vectors_of(const T* first) noexcept {
    static_assert(sizeof(vector<T>) == 3 * sizeof(T));
    return reinterpret_cast<const vector<T>*>(first);
}

// Eigen has no exponentials of quaternions: scalar code of the standard library, with the checks that it
// needs.
template <class T>
vector<T> log_of(const quaternion<T>& q) noexcept {
    const T m = q.vec().norm();
    if (m == 0) return vector<T>::Zero();
    return std::atan2(m, q.w()) / m * q.vec();
}

template <class T>
quaternion<T> exp_of(const vector<T>& b) noexcept {
    const T angle = b.norm();
    if (angle == 0) return quaternion<T>::Identity();
    const vector<T> v = std::sin(angle) / angle * b;
    return quaternion<T>(std::cos(angle), v.x(), v.y(), v.z());
}

}  // namespace

template <class T>
void decompose(const T* q, swivel::vec3<T> a, T* swing, T* twist, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>*const s = array_of(swing), *const t = array_of(twist);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i) {
        const quaternion<T> about = twist_of(from[i], unit);
        s[i] = from[i] * about.conjugate();
        t[i] = about;
    }
}

template <class T>
void twist(const T* q, swivel::vec3<T> a, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>* const to = array_of(out);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i) to[i] = twist_of(from[i], unit);
}

template <class T>
void swing(const T* q, swivel::vec3<T> a, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>* const to = array_of(out);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i] * twist_of(from[i], unit).conjugate();
}

template <class T>
void twist_angle(const T* q, swivel::vec3<T> a, T* radians, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i) radians[i] = 2 * std::atan2(unit.dot(from[i].vec()), from[i].w());
}

template <class T>
void angle_between(const T* a, const T* b, T* radians, std::size_t n) noexcept {
    const quaternion<T>*from = array_of(a), *to = array_of(b);
    for (std::size_t i = 0; i < n; ++i) radians[i] = from[i].angularDistance(to[i]);
}

template <class T>
void compose(const T* swing, const T* twist, T* q, std::size_t n) noexcept {
    const quaternion<T>*const s = array_of(swing), *const t = array_of(twist);
    quaternion<T>* const to = array_of(q);
    for (std::size_t i = 0; i < n; ++i) to[i] = s[i] * t[i];
}

template <class T>
void normalize(const T* q, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i].normalized();
}

template <class T>
void rotate(const T* q, const T* v, T* out, std::size_t n) noexcept {
    const quaternion<T>* const by = array_of(q);
    const vector<T>* const from = reinterpret_cast<const vector<T>*>(v);
    vector<T>* const to = reinterpret_cast<vector<T>*>(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = by[i] * from[i];
}

template <class T>
void rotate_by_one(swivel::quat<T> q, const T* v, T* out, std::size_t n) noexcept {
    const quaternion<T> by(q.w, q.x, q.y, q.z);
    const vector<T>* const from = reinterpret_cast<const vector<T>*>(v);
    vector<T>* const to = reinterpret_cast<vector<T>*>(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = by * from[i];
}

template <class T>
void slerp(const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept {
    const quaternion<T>*const from = array_of(a), *const to = array_of(b);
    quaternion<T>* const result = array_of(out);
    for (std::size_t i = 0; i < n; ++i) result[i] = from[i].slerp(t[i], to[i]);
}

template <class T>
void nlerp(const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept {
    const quaternion<T>*const from = array_of(a), *const to = array_of(b);
    quaternion<T>* const result = array_of(out);
    for (std::size_t i = 0; i < n; ++i) {
        const T s = from[i].dot(to[i]) < 0 ? -t[i] : t[i];
        result[i].coeffs() = ((1 - t[i]) * from[i].coeffs() + s * to[i].coeffs()).normalized();
    }
}

template <class T>
void sterp(const T* a, const T* b, swivel::vec3<T> axis, const T* t, T* out, std::size_t n) noexcept {
    const quaternion<T>*const from = array_of(a), *const to = array_of(b);
    quaternion<T>* const result = array_of(out);
    const vector<T> unit(axis.x, axis.y, axis.z);
    for (std::size_t i = 0; i < n; ++i) {
        quaternion<T> d = to[i] * from[i].conjugate();
        if (d.w() < 0) d.coeffs() = -d.coeffs();
        const quaternion<T> twist = twist_of(d, unit), swing = d * twist.conjugate();
        const T length = swing.vec().norm(), half_swing = t[i] * std::atan2(length, swing.w());
        const T half_twist = t[i] * std::atan2(twist.vec().dot(unit), twist.w());
        quaternion<T> s, r;
        s.w() = std::cos(half_swing);
        s.vec() = length > 0 ? vector<T>(swing.vec() * (std::sin(half_swing) / length)) : vector<T>(0, 0, 0);
        r.w() = std::cos(half_twist);
        r.vec() = unit * std::sin(half_twist);
        result[i] = s * r * from[i];
    }
}

template <class T>
void from_matrix(const T* m, T* q, std::size_t n) noexcept {
    const auto* const from = reinterpret_cast<const Eigen::Matrix<T, 3, 3>*>(m);
    quaternion<T>* const to = array_of(q);
    for (std::size_t i = 0; i < n; ++i) to[i] = quaternion<T>(from[i]);
}

template <class T>
void to_matrix(const T* q, T* m, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    auto* const to = reinterpret_cast<Eigen::Matrix<T, 3, 3>*>(m);
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i].toRotationMatrix();
}

template <class T>
void from_euler(const T* radians, T* q, std::size_t n) noexcept {
    using turn = Eigen::AngleAxis<T>;
    quaternion<T>* const to = array_of(q);
    for (std::size_t i = 0; i < n; ++i) {
        const T* const e = radians + 3 * i;
        to[i] =
            turn(e[2], vector<T>::UnitZ()) * turn(e[0], vector<T>::UnitX()) * turn(e[1], vector<T>::UnitY());
    }
}

template <class T>
void to_euler(const T* q, T* radians, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    auto* const to = reinterpret_cast<vector<T>*>(radians);
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i].toRotationMatrix().eulerAngles(2, 0, 1);
}

template <class T>
void from_axis_angle(swivel::vec3<T> a, const T* radians, T* q, std::size_t n) noexcept {
    quaternion<T>* const to = array_of(q);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i) to[i] = Eigen::AngleAxis<T>(radians[i], unit);
}

template void from_matrix(const float*, float*, std::size_t) noexcept;
template void from_matrix(const double*, double*, std::size_t) noexcept;
template void to_matrix(const float*, float*, std::size_t) noexcept;
template void to_matrix(const double*, double*, std::size_t) noexcept;
template void from_euler(const float*, float*, std::size_t) noexcept;
template void from_euler(const double*, double*, std::size_t) noexcept;
template void to_euler(const float*, float*, std::size_t) noexcept;
template void to_euler(const double*, double*, std::size_t) noexcept;
template void from_axis_angle(swivel::vec3<float>, const float*, float*, std::size_t) noexcept;
template void from_axis_angle(swivel::vec3<double>, const double*, double*, std::size_t) noexcept;
template void slerp(const float*, const float*, const float*, float*, std::size_t) noexcept;
template void slerp(const double*, const double*, const double*, double*, std::size_t) noexcept;
template void nlerp(const float*, const float*, const float*, float*, std::size_t) noexcept;
template void nlerp(const double*, const double*, const double*, double*, std::size_t) noexcept;
template void sterp(const float*, const float*, swivel::vec3<float>, const float*, float*,
                    std::size_t) noexcept;
template void sterp(const double*, const double*, swivel::vec3<double>, const double*, double*,
                    std::size_t) noexcept;

template <class T>
void square_root(const T* q, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i)
        to[i] = quaternion<T>(1 + from[i].w(), from[i].x(), from[i].y(), from[i].z()).normalized();
}

template <class T>
void exp(const T* b, T* out, std::size_t n) noexcept {
    const vector<T>* const from = vectors_of(b);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = exp_of(from[i]);
}

template <class T>
void log(const T* q, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    for (std::size_t i = 0; i < n; ++i) Eigen::Map<vector<T>>(out + 3 * i) = log_of(from[i]);
}

template <class T>
void power(const T* q, T t, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = exp_of<T>(t * log_of(from[i]));
}

template <class T>
void shortest_arc(const T* v, const T* w, T* out, std::size_t n) noexcept {
    const vector<T>*const a = vectors_of(v), *const b = vectors_of(w);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = quaternion<T>::FromTwoVectors(a[i], b[i]);
}

template <class T>
void arc_with_twist(const T* v, const T* w, T radians, T* out, std::size_t n) noexcept {
    const vector<T>*const a = vectors_of(v), *const b = vectors_of(w);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i)
        to[i] = quaternion<T>::FromTwoVectors(a[i], b[i]) * Eigen::AngleAxis<T>(radians, a[i].normalized());
}

template void decompose(const float*, swivel::vec3<float>, float*, float*, std::size_t) noexcept;
template void decompose(const double*, swivel::vec3<double>, double*, double*, std::size_t) noexcept;
template void twist(const float*, swivel::vec3<float>, float*, std::size_t) noexcept;
template void twist(const double*, swivel::vec3<double>, double*, std::size_t) noexcept;
template void swing(const float*, swivel::vec3<float>, float*, std::size_t) noexcept;
template void swing(const double*, swivel::vec3<double>, double*, std::size_t) noexcept;
template void twist_angle(const float*, swivel::vec3<float>, float*, std::size_t) noexcept;
template void twist_angle(const double*, swivel::vec3<double>, double*, std::size_t) noexcept;
template void angle_between(const float*, const float*, float*, std::size_t) noexcept;
template void angle_between(const double*, const double*, double*, std::size_t) noexcept;
template void compose(const float*, const float*, float*, std::size_t) noexcept;
template void compose(const double*, const double*, double*, std::size_t) noexcept;
template void normalize(const float*, float*, std::size_t) noexcept;
template void normalize(const double*, double*, std::size_t) noexcept;
template void rotate(const float*, const float*, float*, std::size_t) noexcept;
template void rotate(const double*, const double*, double*, std::size_t) noexcept;
template void rotate_by_one(swivel::quat<float>, const float*, float*, std::size_t) noexcept;
template void rotate_by_one(swivel::quat<double>, const double*, double*, std::size_t) noexcept;
template void square_root(const float*, float*, std::size_t) noexcept;
template void exp(const float*, float*, std::size_t) noexcept;
template void log(const float*, float*, std::size_t) noexcept;
template void power(const float*, float, float*, std::size_t) noexcept;
template void shortest_arc(const float*, const float*, float*, std::size_t) noexcept;
template void arc_with_twist(const float*, const float*, float, float*, std::size_t) noexcept;
template void square_root(const double*, double*, std::size_t) noexcept;
template void exp(const double*, double*, std::size_t) noexcept;
template void log(const double*, double*, std::size_t) noexcept;
template void power(const double*, double, double*, std::size_t) noexcept;
template void shortest_arc(const double*, const double*, double*, std::size_t) noexcept;
template void arc_with_twist(const double*, const double*, double, double*, std::size_t) noexcept;

}  // namespace swivel_bench::eigen
