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
void compose(const T* swing, const T* twist, T* q, std::size_t n) noexcept {
    const quaternion<T>*const s = array_of(swing), *const t = array_of(twist);
    quaternion<T>* const to = array_of(q);
    for (std::size_t i = 0; i < n; ++i) to[i] = s[i] * t[i];
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

}  // namespace swivel_bench::eigen
