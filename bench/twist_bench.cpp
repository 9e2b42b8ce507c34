#include "support/peer_rows.hpp"

namespace swivel_bench {

namespace {

// make_axis(workload<T>&) gives what the twist axis is made from.
template <class T, class MakeAxis>
void add_form(std::string_view op, MakeAxis make_axis) {
    add_library_rows<T>(op, [make_axis](workload<T>& streams, swivel::options o) {
        const auto q = streams.rotations();
        const swivel::twist_axis<T> a = make_axis(streams);
        const auto out = streams.quaternions();
        return [=] { return swivel::twist(q, a, out, o); };
    });
}

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
    add_form<T>("twist", [](workload<T>&) { return oblique<T>; });
    add_form<T>("twist_z", [](workload<T>&) { return swivel::axis::z; });
    add_form<T>("twist_per_element", [](workload<T>& streams) { return streams.axes(); });
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
