#include <cmath>

#include "peers.hpp"

namespace swivel_bench::reynolds {

template <class T>
void decompose_compact(const swivel::quat<T>* q, swivel::factors<T>* out, std::size_t n) noexcept {
    constexpr T threshold = sizeof(T) == 4 ? T(0x1p-48) : T(0x1p-106);
    for (std::size_t i = 0; i < n; ++i) {
        const T x = q[i].x, y = q[i].y, z = q[i].z, w = q[i].w;
        const T t = w * w + z * z;
        if (t > threshold) {
            const T scale = 1 / std::sqrt(t);
            out[i] = {scale * (w * x - y * z), scale * (w * y + x * z), t * scale, z * scale, w * scale};
        } else {
            out[i] = {x, y, T(0), T(0), T(1)};
        }
    }
}

template void decompose_compact(const swivel::quat<float>*, swivel::factors<float>*, std::size_t) noexcept;
template void decompose_compact(const swivel::quat<double>*, swivel::factors<double>*, std::size_t) noexcept;

}  // namespace swivel_bench::reynolds
