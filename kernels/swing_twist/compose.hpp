#ifndef SWIVEL_KERNELS_SWING_TWIST_COMPOSE_HPP
#define SWIVEL_KERNELS_SWING_TWIST_COMPOSE_HPP

#include "kernels/loops/streams.hpp"
#include "kernels/rotors/multiply.hpp"

namespace swivel {
namespace {

// The Hamilton product l r. Streams in: l x y z w, r x y z w, and the signs of r where they are given. Out: x
// y z w.
template <precision_index P, bool Signs, class V>
struct compose_op {
    using reads = std::conditional_t<Signs, streams<4, 4, 1>, streams<4, 4>>;
    using writes = streams<4>;

    explicit compose_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const rotor<V> l{in[0], in[1], in[2], in[3]}, r{in[4], in[5], in[6], in[7]};
        if constexpr (Signs)
            product_of<P>(l, flipped(r, sign_of(in[8])), out);
        else
            product_of<P>(l, r, out);
    }
};

// Streams in: s1 s2 sc ts tc, and the signs where they are given. Out: B C A w.
template <precision_index P, bool Signs, class V>
struct compose_compact_op {
    using M = arithmetic<P>;
    using reads = std::conditional_t<Signs, streams<5, 1>, streams<5>>;
    using writes = streams<4>;

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
