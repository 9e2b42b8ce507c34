#ifndef SWIVEL_KERNELS_EXPONENTIALS_POWER_HPP
#define SWIVEL_KERNELS_EXPONENTIALS_POWER_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/exponentials/polar_form.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// Streams in: x y z w of the base, the exponent. Out: x y z w.
template <precision_index P, class V>
struct power_op {
    using T = scalar_of<V>;
    using reads = streams<4, 1>;
    using writes = streams<4>;

    explicit power_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), t = in[4];
        const polar_form<P, V> q = polar<P>(in, 1);
        const V angle = atan2_above<P>(q.m, q.w), product = t * angle;
        // A large product may overflow, which must not look like an infinity.
        const mask_of<V> beyond = magnitude(product) > V(constants<T>::largest_angle);
        V sine;
        sincos_within<P>(select(beyond, zero * t, product), sine, out[3]);
        q.along(sine, out);
        if constexpr (P == reproducible_index) {
            // Not where something is not finite.
            const mask_of<V> same = zero * angle + t == V(T(1));
            out[0] = select(same, in[0], out[0]);
            out[1] = select(same, in[1], out[1]);
            out[2] = select(same, in[2], out[2]);
            out[3] = select(same, in[3], out[3]);
        }
    }
};

}  // namespace
}  // namespace swivel

#endif
