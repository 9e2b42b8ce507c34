#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

template <class T, class Function>
void add_quaternion_peer(std::string_view who, Function compose) {
    add_rows<T>("compose", who, layout::aos, [compose](workload<T>& streams) {
        const auto swing = streams.rotations(), twist = streams.rotations();
        const auto q = streams.quaternions();
        return [=] { compose(swing.x, twist.x, q.x, q.size); };
    });
}

template <class T, class Plain>
void add_plain(Plain, std::string_view who) {
    add_rows<T>("compose", who, layout::soa, [](workload<T>& streams) {
        const auto s = streams.rotations(), t = streams.rotations();
        const auto q = streams.quaternions();
        return [=] { Plain::compose(s.x, s.y, s.z, s.w, t.x, t.y, t.z, t.w, q.x, q.y, q.z, q.w, q.size); };
    });
    add_rows<T>("compose_compact", who, layout::soa, [](workload<T>& streams) {
        const auto f = streams.factors();
        const auto q = streams.quaternions();
        return [=] { Plain::compose_compact(f.s1, f.s2, f.sc, f.ts, f.tc, q.x, q.y, q.z, q.w, q.size); };
    });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_quaternion_peer<T>("eigen", eigen::compose<T>);
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_quaternion_peer<T>("glm", glm_peer::compose<T>);
#endif
    for_each_plain<T>([](auto peer, std::string_view who) { add_plain<T>(peer, who); });
    add_copy_rows<T, 8, 4>("compose", layout::soa);
    add_copy_rows<T, 2, 1>("compose", layout::aos, 4);
    add_copy_rows<T, 5, 4>("compose_compact", layout::soa);
}

}  // namespace

void add_compose_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
