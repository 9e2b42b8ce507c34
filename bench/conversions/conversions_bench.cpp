#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

// The functions of a peer's namespace.
template <class T>
struct conversions {
    using convert = void (*)(const T*, T*, std::size_t) noexcept;
    convert from_matrix, to_matrix, from_euler, to_euler;
    void (*from_axis_angle)(swivel::vec3<T>, const T*, T*, std::size_t) noexcept;
};

template <class T>
void add_peer(std::string_view who, const conversions<T>& peer) {
    add_rows<T>("from_matrix", who, layout::aos, [convert = peer.from_matrix](workload<T>& streams) {
        const auto m = streams.matrices();
        const auto q = streams.quaternions();
        return [=] { convert(m.xx, q.x, q.size); };
    });
    add_rows<T>("to_matrix", who, layout::aos, [convert = peer.to_matrix](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto m = streams.written_matrices();
        return [=] { convert(q.x, m.xx, q.size); };
    });
    add_rows<T>("from_euler", who, layout::aos, [convert = peer.from_euler](workload<T>& streams) {
        const auto radians = streams.axes();
        const auto q = streams.quaternions();
        return [=] { convert(radians.x, q.x, q.size); };
    });
    add_rows<T>("to_euler", who, layout::aos, [convert = peer.to_euler](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto radians = streams.vectors();
        return [=] { convert(q.x, radians.x, q.size); };
    });
    add_rows<T>("from_axis_angle", who, layout::aos, [convert = peer.from_axis_angle](workload<T>& streams) {
        const auto radians = streams.parameters();
        const auto q = streams.quaternions();
        return [=] { convert(oblique<T>, radians.data, q.x, q.size); };
    });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_peer<T>("eigen", {eigen::from_matrix<T>, eigen::to_matrix<T>, eigen::from_euler<T>,
                          eigen::to_euler<T>, eigen::from_axis_angle<T>});
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_peer<T>("glm", {glm_peer::from_matrix<T>, glm_peer::to_matrix<T>, glm_peer::from_euler<T>,
                        glm_peer::to_euler<T>, glm_peer::from_axis_angle<T>});
#endif
    add_copy_rows<T, 9, 4>("from_matrix", layout::soa);
    add_copy_rows<T, 4, 9>("to_matrix", layout::soa);
}

}  // namespace

void add_conversions_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
