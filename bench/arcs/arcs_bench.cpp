#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

template <class T>
[[maybe_unused]] inline constexpr T angle = T(0.7);

template <class T, class Function>
void add_peer(std::string_view op, std::string_view who, Function function) {
    add_rows<T>(op, who, layout::aos, [function](workload<T>& streams) {
        const auto v = streams.axes(), w = streams.other_axes();
        const auto q = streams.quaternions();
        return [=] { function(v.x, w.x, q.x, q.size); };
    });
}

template <class T, class Function>
void add_twist_peer(std::string_view who, Function function) {
    add_peer<T>("arc_with_twist", who,
                [function](const T* v, const T* w, T* q, std::size_t n) { function(v, w, angle<T>, q, n); });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_peer<T>("shortest_arc", "eigen", eigen::shortest_arc<T>);
    add_twist_peer<T>("eigen", eigen::arc_with_twist<T>);
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_peer<T>("shortest_arc", "glm", glm_peer::shortest_arc<T>);
    add_twist_peer<T>("glm", glm_peer::arc_with_twist<T>);
#endif
    add_copy_rows<T, 6, 4>("shortest_arc", layout::soa);
}

}  // namespace

void add_arcs_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
