#include <cmath>

#include "peers.hpp"

namespace swivel_bench::physx {

namespace {

template <class T>
swivel::quat<T> product(const swivel::quat<T>& l, const swivel::quat<T>& r) noexcept {
    return {l.w * r.x + l.x * r.w + l.y * r.z - l.z * r.y, l.w * r.y + l.y * r.w + l.z * r.x - l.x * r.z,
            l.w * r.z + l.z * r.w + l.x * r.y - l.y * r.x, l.w * r.w - l.x * r.x - l.y * r.y - l.z * r.z};
}

}  // namespace

template <class T>
void decompose_x(const swivel::quat<T>* q, swivel::quat<T>* swing, swivel::quat<T>* twist,
                 std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        swivel::quat<T> about{0, 0, 0, 1};
        if (q[i].x != 0) {
            const T scale = 1 / std::sqrt(q[i].x * q[i].x + q[i].w * q[i].w);
            about = {q[i].x * scale, 0, 0, q[i].w * scale};
        }
        twist[i] = about;
        swing[i] = product(q[i], {-about.x, -about.y, -about.z, about.w});
    }
}

template void decompose_x(const swivel::quat<float>*, swivel::quat<float>*, swivel::quat<float>*,
                          std::size_t) noexcept;
template void decompose_x(const swivel::quat<double>*, swivel::quat<double>*, swivel::quat<double>*,
                          std::size_t) noexcept;

}  // namespace swivel_bench::physx
