#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

template <class T, class Function>
void add_quaternion_peer(std::string_view who, Function decompose) {
    add_rows<T>("decompose", who, layout::aos, [decompose](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto swing = streams.quaternions(), twist = streams.quaternions();
        return [=] { decompose(q.x, oblique<T>, swing.x, twist.x, q.size); };
    });
}

template <class T, class Plain>
void add_plain(Plain, std::string_view who) {
    add_rows<T>("decompose", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto s = streams.quaternions(), t = streams.quaternions();
        return [=] {
            Plain::decompose(q.x, q.y, q.z, q.w, oblique<T>.x, oblique<T>.y, oblique<T>.z, s.x, s.y, s.z, s.w,
                             t.x, t.y, t.z, t.w, q.size);
        };
    });
    add_rows<T>("decompose_z", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto s = streams.quaternions(), t = streams.quaternions();
        return
            [=] { Plain::decompose_z(q.x, q.y, q.z, q.w, s.x, s.y, s.z, s.w, t.x, t.y, t.z, t.w, q.size); };
    });
    add_rows<T>("decompose_compact", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto f = streams.written_factors();
        return [=] { Plain::decompose_compact(q.x, q.y, q.z, q.w, f.s1, f.s2, f.sc, f.ts, f.tc, q.size); };
    });
}

// Lost to the z kernel on every machine so far: the record of five numbers keeps its loop from being
// vectorised.
template <class T>
void add_reynolds() {
    add_rows<T>("decompose_compact", "reynolds", layout::aos, [](workload<T>& streams) {
        const auto* q = reinterpret_cast<const swivel::quat<T>*>(streams.rotations().x);
        auto* out = reinterpret_cast<swivel::factors<T>*>(streams.written(5));
        const std::size_t n = streams.size();
        return [=] { reynolds::decompose_compact(q, out, n); };
    });
}

template <class T>
void add_physx() {
    add_rows<T>("decompose_x", "physx", layout::aos, [](workload<T>& streams) {
        const auto* q = reinterpret_cast<const swivel::quat<T>*>(streams.rotations().x);
        auto* swing = reinterpret_cast<swivel::quat<T>*>(streams.quaternions().x);
        auto* twist = reinterpret_cast<swivel::quat<T>*>(streams.quaternions().x);
        const std::size_t n = streams.size();
        return [=] { physx::decompose_x(q, swing, twist, n); };
    });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_quaternion_peer<T>("eigen", eigen::decompose<T>);
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_quaternion_peer<T>("glm", glm_peer::decompose<T>);
#endif
    for_each_plain<T>([](auto peer, std::string_view who) { add_plain<T>(peer, who); });
    add_reynolds<T>();
    add_physx<T>();
    add_copy_rows<T, 4, 8>("decompose", layout::soa);
    add_copy_rows<T, 1, 2>("decompose", layout::aos, 4);
    add_copy_rows<T, 7, 8>("decompose_per_element", layout::soa);
    add_copy_rows<T, 4, 5>("decompose_compact", layout::soa);
}

}  // namespace

void add_decompose_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
