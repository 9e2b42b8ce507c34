#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

// A half turn about an oblique axis.
template <class T>
[[maybe_unused]] constexpr swivel::quat<T> one_rotation{oblique<T>.x, oblique<T>.y, oblique<T>.z, T(0)};

template <class T, class Multiply, class Normalize, class Rotate, class RotateByOne>
void add_quaternion_peer(std::string_view who, Multiply multiply, Normalize normalize, Rotate rotate,
                         RotateByOne rotate_by_one) {
    add_rows<T>("multiply", who, layout::aos, [multiply](workload<T>& streams) {
        const auto a = streams.rotations(), b = streams.rotations();
        const auto out = streams.quaternions();
        return [=] { multiply(a.x, b.x, out.x, out.size); };
    });
    add_rows<T>("normalize", who, layout::aos, [normalize](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto out = streams.quaternions();
        return [=] { normalize(q.x, out.x, out.size); };
    });
    add_rows<T>("rotate", who, layout::aos, [rotate](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto v = streams.axes();
        const auto out = streams.vectors();
        return [=] { rotate(q.x, v.x, out.x, out.size); };
    });
    add_rows<T>("rotate_by_one", who, layout::aos, [rotate_by_one](workload<T>& streams) {
        const auto v = streams.axes();
        const auto out = streams.vectors();
        return [=] { rotate_by_one(one_rotation<T>, v.x, out.x, out.size); };
    });
}

template <class T, class Function>
void add_angle_peer(std::string_view who, Function angle_between) {
    add_rows<T>("angle_between", who, layout::aos, [angle_between](workload<T>& streams) {
        const auto a = streams.rotations(), b = streams.other_rotations();
        const auto out = streams.scalars();
        return [=] { angle_between(a.x, b.x, out.data, a.size); };
    });
}

template <class T, class Plain>
void add_plain(Plain, std::string_view who) {
    add_rows<T>("multiply", who, layout::soa, [](workload<T>& streams) {
        const auto a = streams.rotations(), b = streams.rotations();
        const auto o = streams.quaternions();
        return [=] { Plain::compose(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, o.x, o.y, o.z, o.w, o.size); };
    });
    add_rows<T>("normalize", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto o = streams.quaternions();
        return [=] { Plain::normalize(q.x, q.y, q.z, q.w, o.x, o.y, o.z, o.w, o.size); };
    });
    add_rows<T>("rotate", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto v = streams.axes();
        const auto o = streams.vectors();
        return [=] { Plain::rotate(q.x, q.y, q.z, q.w, v.x, v.y, v.z, o.x, o.y, o.z, o.size); };
    });
    add_rows<T>("align_signs_sequence", who, layout::soa, [](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto o = streams.quaternions();
        return [=] { Plain::align_signs(q.x, q.y, q.z, q.w, o.x, o.y, o.z, o.w, o.size); };
    });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_quaternion_peer<T>("eigen", eigen::compose<T>, eigen::normalize<T>, eigen::rotate<T>,
                           eigen::rotate_by_one<T>);
    add_angle_peer<T>("eigen", eigen::angle_between<T>);
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_quaternion_peer<T>("glm", glm_peer::compose<T>, glm_peer::normalize<T>, glm_peer::rotate<T>,
                           glm_peer::rotate_by_one<T>);
#endif
    for_each_plain<T>([](auto peer, std::string_view who) { add_plain<T>(peer, who); });
    add_copy_rows<T, 8, 4>("multiply", layout::soa);
    add_copy_rows<T, 4, 4>("normalize", layout::soa);
    add_copy_rows<T, 7, 3>("rotate", layout::soa);
    add_copy_rows<T, 3, 3>("rotate_by_one", layout::soa);
}

}  // namespace

void add_rotors_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
