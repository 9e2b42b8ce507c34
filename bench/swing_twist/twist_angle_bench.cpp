#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

template <class T, class Function>
void add_quaternion_peer(std::string_view who, Function twist_angle) {
    add_rows<T>("twist_angle", who, layout::aos, [twist_angle](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto out = streams.scalars();
        return [=] { twist_angle(q.x, oblique<T>, out.data, q.size); };
    });
}

template <class T, class Plain>
void add_plain(Plain, std::string_view who) {
    add_rows<T>("twist_angle", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto out = streams.scalars();
        return [=] {
            Plain::twist_angle(q.x, q.y, q.z, q.w, oblique<T>.x, oblique<T>.y, oblique<T>.z, out.data,
                               q.size);
        };
    });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_quaternion_peer<T>("eigen", eigen::twist_angle<T>);
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_quaternion_peer<T>("glm", glm_peer::twist_angle<T>);
#endif
    for_each_plain<T>([](auto peer, std::string_view who) { add_plain<T>(peer, who); });
    add_copy_rows<T, 4, 1>("twist_angle", layout::soa);
}

}  // namespace

void add_twist_angle_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
