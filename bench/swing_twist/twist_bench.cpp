#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

template <class T, class Function>
void add_quaternion_peer(std::string_view who, Function twist) {
    add_rows<T>("twist", who, layout::aos, [twist](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto out = streams.quaternions();
        return [=] { twist(q.x, oblique<T>, out.x, q.size); };
    });
}

template <class T, class Plain>
void add_plain(Plain, std::string_view who) {
    add_rows<T>("twist", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto s = streams.quaternions();
        return [=] {
            Plain::twist(q.x, q.y, q.z, q.w, oblique<T>.x, oblique<T>.y, oblique<T>.z, s.x, s.y, s.z, s.w,
                         q.size);
        };
    });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_quaternion_peer<T>("eigen", eigen::twist<T>);
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_quaternion_peer<T>("glm", glm_peer::twist<T>);
#endif
    for_each_plain<T>([](auto peer, std::string_view who) { add_plain<T>(peer, who); });
    add_copy_rows<T, 4, 4>("twist", layout::soa);
    add_copy_rows<T, 1, 1>("twist", layout::aos, 4);
}

}  // namespace

void add_twist_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
