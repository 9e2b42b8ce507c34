#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/quaternion.hpp>

#include "peers.hpp"

namespace swivel_bench::glm_peer {

namespace {

template <class T>
using quaternion = glm::qua<T, glm::defaultp>;
template <class T>
using vector = glm::vec<3, T, glm::defaultp>;

template <class T>
const quaternion<T>* array_of(const T* first) noexcept {
    static_assert(sizeof(quaternion<T>) == 4 * sizeof(T) && offsetof(quaternion<T>, x) == 0);
    return reinterpret_cast<const quaternion<T>*>(first);
}
template <class T>
quaternion<T>* array_of(T* first) noexcept {
    return reinterpret_cast<quaternion<T>*>(first);
}

// normalize() gives the identity for a zero quaternion, so it has the check that such code needs.
template <class T>
quaternion<T> twist_of(const quaternion<T>& q, const vector<T>& a) noexcept {
    return glm::normalize(quaternion<T>(q.w, a * glm::dot(a, vector<T>(q.x, q.y, q.z))));
}

template <class T>
const vector<T>* vectors_of(const T* first) noexcept {
    static_assert(sizeof(vector<T>) == 3 * sizeof(T));
    return reinterpret_cast<const vector<T>*>(first);
}

}  // namespace

template <class T>
void decompose(const T* q, swivel::vec3<T> a, T* swing, T* twist, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>*const s = array_of(swing), *const t = array_of(twist);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i) {
        const quaternion<T> about = twist_of(from[i], unit);
        s[i] = from[i] * glm::conjugate(about);
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
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i] * glm::conjugate(twist_of(from[i], unit));
}

template <class T>
void twist_angle(const T* q, swivel::vec3<T> a, T* radians, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i)
        radians[i] = 2 * std::atan2(glm::dot(unit, vector<T>(from[i].x, from[i].y, from[i].z)), from[i].w);
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
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::normalize(from[i]);
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
    for (std::size_t i = 0; i < n; ++i) result[i] = glm::slerp(from[i], to[i], t[i]);
}

template <class T>
using matrix = glm::mat<3, 3, T, glm::defaultp>;

template <class T>
void from_matrix(const T* m, T* q, std::size_t n) noexcept {
    const auto* const from = reinterpret_cast<const matrix<T>*>(m);
    quaternion<T>* const to = array_of(q);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::quat_cast(from[i]);
}

template <class T>
void to_matrix(const T* q, T* m, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    auto* const to = reinterpret_cast<matrix<T>*>(m);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::mat3_cast(from[i]);
}

template <class T>
void from_euler(const T* radians, T* q, std::size_t n) noexcept {
    const auto* const from = reinterpret_cast<const vector<T>*>(radians);
    quaternion<T>* const to = array_of(q);
    for (std::size_t i = 0; i < n; ++i) to[i] = quaternion<T>(from[i]);
}

template <class T>
void to_euler(const T* q, T* radians, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    auto* const to = reinterpret_cast<vector<T>*>(radians);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::eulerAngles(from[i]);
}

template <class T>
void from_axis_angle(swivel::vec3<T> a, const T* radians, T* q, std::size_t n) noexcept {
    quaternion<T>* const to = array_of(q);
    const vector<T> unit(a.x, a.y, a.z);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::angleAxis(radians[i], unit);
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

template <class T>
void square_root(const T* q, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::sqrt(from[i]);
}

template <class T>
void exp(const T* b, T* out, std::size_t n) noexcept {
    const vector<T>* const from = vectors_of(b);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::exp(quaternion<T>(T(0), from[i]));
}

template <class T>
void log(const T* q, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    for (std::size_t i = 0; i < n; ++i) {
        const quaternion<T> b = glm::log(from[i]);
        out[3 * i] = b.x;
        out[3 * i + 1] = b.y;
        out[3 * i + 2] = b.z;
    }
}

template <class T>
void power(const T* q, T t, T* out, std::size_t n) noexcept {
    const quaternion<T>* const from = array_of(q);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::pow(from[i], t);
}

template <class T>
void shortest_arc(const T* v, const T* w, T* out, std::size_t n) noexcept {
    const vector<T>*const a = vectors_of(v), *const b = vectors_of(w);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::rotation(a[i], b[i]);
}

template <class T>
void arc_with_twist(const T* v, const T* w, T radians, T* out, std::size_t n) noexcept {
    const vector<T>*const a = vectors_of(v), *const b = vectors_of(w);
    quaternion<T>* const to = array_of(out);
    for (std::size_t i = 0; i < n; ++i) to[i] = glm::rotation(a[i], b[i]) * glm::angleAxis(radians, a[i]);
}

template void decompose(const float*, swivel::vec3<float>, float*, float*, std::size_t) noexcept;
template void decompose(const double*, swivel::vec3<double>, double*, double*, std::size_t) noexcept;
template void twist(const float*, swivel::vec3<float>, float*, std::size_t) noexcept;
template void twist(const double*, swivel::vec3<double>, double*, std::size_t) noexcept;
template void swing(const float*, swivel::vec3<float>, float*, std::size_t) noexcept;
template void swing(const double*, swivel::vec3<double>, double*, std::size_t) noexcept;
template void twist_angle(const float*, swivel::vec3<float>, float*, std::size_t) noexcept;
template void twist_angle(const double*, swivel::vec3<double>, double*, std::size_t) noexcept;
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

}  // namespace swivel_bench::glm_peer
