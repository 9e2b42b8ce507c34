#ifndef SWIVEL_KERNELS_COMPOSE_HPP
#define SWIVEL_KERNELS_COMPOSE_HPP

#include "kernel_table.hpp"
#include "ops.hpp"

namespace swivel {
namespace {

// Adds NaN where a is infinite, so that an infinity does not leave as one.
template <class M, class V>
inline V nan_for_infinity(V a) noexcept {
    return M::multiply_add(V(scalar_of<V>(0)), a, a);
}

// The Hamilton product l r. Streams in: l x y z w, r x y z w, and the signs of r where they are given. Out: x
// y z w.
template <precision_index P, bool Signs, class V>
struct compose_op {
    using M = arithmetic<P>;
    static constexpr int inputs = Signs ? 9 : 8, quaternions_in = 2;
    static constexpr int outputs = 4, quaternions_out = 1;

    explicit compose_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V lx = in[0], ly = in[1], lz = in[2], lw = in[3];
        V rx = in[4], ry = in[5], rz = in[6], rw = in[7];
        if constexpr (Signs) {
            const V sign = sign_of(in[8]);
            rx = rx ^ sign;
            ry = ry ^ sign;
            rz = rz ^ sign;
            rw = rw ^ sign;
        }
        out[0] = component(lw * rx, lx, rw, ly, rz, lz, ry);
        out[1] = component(lw * ry, ly, rw, lz, rx, lx, rz);
        out[2] = component(lw * rz, lz, rw, lx, ry, ly, rx);
        out[3] = nan_for_infinity<M>(M::negate_multiply_add(
            lz, rz, M::negate_multiply_add(ly, ry, M::negate_multiply_add(lx, rx, lw * rw))));
    }

    // first + a b + c d - e f
    static V component(V first, V a, V b, V c, V d, V e, V f) noexcept {
        return nan_for_infinity<M>(
            M::negate_multiply_add(e, f, M::multiply_add(c, d, M::multiply_add(a, b, first))));
    }
};

// Streams in: s1 s2 sc ts tc, and the signs where they are given. Out: B C A w.
template <precision_index P, bool Signs, class V>
struct compose_compact_op {
    using M = arithmetic<P>;
    static constexpr int inputs = Signs ? 6 : 5, quaternions_in = 0;
    static constexpr int outputs = 4, quaternions_out = 1;

    explicit compose_compact_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V s1 = in[0], s2 = in[1], sc = in[2];
        V ts = in[3], tc = in[4];
        if constexpr (Signs) {
            const V sign = sign_of(in[5]);
            ts = ts ^ sign;
            tc = tc ^ sign;
        }
        // 0, or NaN where anything is NaN or infinite.
        const V zero(scalar_of<V>(0));
        const V poison =
            M::multiply_add(zero, s1 + s2, M::multiply_add(zero, sc, M::multiply_add(zero, ts, zero * tc)));
        out[0] = M::multiply_add(s2, ts, s1 * tc) + poison;
        out[1] = M::negate_multiply_add(s1, ts, s2 * tc) + poison;
        out[2] = M::multiply_add(sc, ts, poison);
        out[3] = M::multiply_add(sc, tc, poison);
    }
};

}  // namespace
}  // namespace swivel

#endif
