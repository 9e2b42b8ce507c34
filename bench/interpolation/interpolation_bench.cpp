#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

template <class T, class Function>
void add_quaternion_peer(std::string_view op, std::string_view who, Function interpolate) {
    add_rows<T>(op, who, layout::aos, [interpolate](workload<T>& streams) {
        const auto a = streams.rotations(), b = streams.other_rotations();
        const auto t = streams.parameters();
        const auto out = streams.quaternions();
        return [=] { interpolate(a.x, b.x, t.data, out.x, a.size); };
    });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_quaternion_peer<T>("slerp", "eigen", eigen::slerp<T>);
    add_quaternion_peer<T>("nlerp", "eigen", eigen::nlerp<T>);
    add_quaternion_peer<T>("sterp", "eigen",
                           [](const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept {
                               eigen::sterp(a, b, oblique<T>, t, out, n);
                           });
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_quaternion_peer<T>("slerp", "glm", glm_peer::slerp<T>);
#endif
}

}  // namespace

void add_interpolation_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
