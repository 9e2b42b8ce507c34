#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

template <class T>
[[maybe_unused]] inline constexpr T exponent = T(0.3);

// Functions of n rotations, which give n quaternions or vectors.
template <class T, class Function>
void add_peer(std::string_view op, std::string_view who, Function function) {
    add_rows<T>(op, who, layout::aos, [function](workload<T>& streams) {
        const auto q = streams.rotations();
        const auto out = streams.quaternions();
        return [=] { function(q.x, out.x, q.size); };
    });
}

template <class T, class Function>
void add_exp_peer(std::string_view who, Function exp) {
    add_rows<T>("exp", who, layout::aos, [exp](workload<T>& streams) {
        const auto b = streams.axes();
        const auto out = streams.quaternions();
        return [=] { exp(b.x, out.x, b.size); };
    });
}

template <class T, class Function>
void add_power_peer(std::string_view who, Function power) {
    add_peer<T>("power", who, [power](const T* q, T* out, std::size_t n) { power(q, exponent<T>, out, n); });
}

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN
    add_peer<T>("square_root", "eigen", eigen::square_root<T>);
    add_exp_peer<T>("eigen", eigen::exp<T>);
    add_peer<T>("log", "eigen", eigen::log<T>);
    add_power_peer<T>("eigen", eigen::power<T>);
#endif
#ifdef SWIVEL_BENCH_HAS_GLM
    add_peer<T>("square_root", "glm", glm_peer::square_root<T>);
    add_exp_peer<T>("glm", glm_peer::exp<T>);
    add_peer<T>("log", "glm", glm_peer::log<T>);
    add_power_peer<T>("glm", glm_peer::power<T>);
#endif
    add_copy_rows<T, 4, 4>("power", layout::soa);
}

}  // namespace

void add_exponentials_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
