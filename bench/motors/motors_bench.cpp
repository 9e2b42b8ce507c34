#include "bench/support/peer_rows.hpp"

namespace swivel_bench {

namespace {

#ifdef SWIVEL_BENCH_HAS_EIGEN_MOTORS
template <class T>
void add_eigen() {
    add_rows<T>("sclerp", "eigen", layout::aos, [](workload<T>& streams) {
        const auto a = streams.motors(0), b = streams.motors(1);
        const auto t = streams.parameters();
        const auto out = streams.written_motors();
        return [=] { eigen::sclerp(a.x, b.x, t.data, out.x, a.size); };
    });
    add_rows<T>("transform", "eigen", layout::aos, [](workload<T>& streams) {
        const auto m = streams.motors();
        const auto p = streams.axes();
        const auto out = streams.vectors();
        return [=] { eigen::transform(m.x, p.x, out.x, m.size); };
    });
    add_rows<T>("motor_multiply", "eigen", layout::aos, [](workload<T>& streams) {
        const auto a = streams.motors(0), b = streams.motors(1);
        const auto out = streams.written_motors();
        return [=] { eigen::motor_multiply(a.x, b.x, out.x, a.size); };
    });
    add_rows<T>("blend_4", "eigen", layout::aos, [](workload<T>& streams) {
        const T *motors[4], *weights[4];
        for (std::size_t k = 0; k < 4; ++k) {
            motors[k] = streams.motors(k).x;
            weights[k] = streams.parameters().data;
        }
        const auto out = streams.written_motors();
        return [=] { eigen::blend_4(motors, weights, out.x, out.size); };
    });
}
#endif

template <class T>
void add_all() {
#ifdef SWIVEL_BENCH_HAS_EIGEN_MOTORS
    add_eigen<T>();
#endif
}

}  // namespace

void add_motors_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
