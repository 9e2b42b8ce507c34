#include "support/peer_rows.hpp"

namespace swivel_bench {

namespace {

// make_axis(workload<T>&) gives what the twist axis is made from.
template <class T, class MakeAxis>
void add_form(std::string_view op, MakeAxis make_axis) {
    add_library_rows<T>(op, [make_axis](workload<T>& streams, swivel::options o) {
        const auto q = streams.rotations();
        const swivel::twist_axis<T> a = make_axis(streams);
        const auto out = streams.scalars();
        return [=] { return swivel::twist_angle(q, a, out, o); };
    });
}

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
    add_form<T>("twist_angle", [](workload<T>&) { return oblique<T>; });
    add_form<T>("twist_angle_z", [](workload<T>&) { return swivel::axis::z; });
    add_form<T>("twist_angle_per_element", [](workload<T>& streams) { return streams.axes(); });
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
