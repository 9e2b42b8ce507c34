#ifndef SWIVEL_KERNELS_EXPONENTIALS_EXP_HPP
#define SWIVEL_KERNELS_EXPONENTIALS_EXP_HPP

#include "kernels/angles/sincos.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/vector3.hpp"

namespace swivel {
namespace {

// Streams in: x y z of half the angle times the axis. Out: x y z w.
template <precision_index P, class V>
struct exp_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<3>;
    using writes = streams<4>;

    explicit exp_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), largest(constants<T>::largest_angle);
        const vector3<V> b{in[0], in[1], in[2]};
        const V squared = dot_of<P>(b, b);
        // The square of a large number overflows, which must not look like an infinity.
        const V zero_or_nan = M::multiply_add(zero, b.z, M::multiply_add(zero, b.y, zero * b.x));
        const mask_of<V> beyond = squared > largest * largest;
        // Below the floor the sine is the angle, whatever that is.
        const root_divisor<P, V> angle(
            larger(V(constants<T>::pole_floor), select(beyond, zero_or_nan, squared)));
        V sine;
        sincos_within<P, true>(angle.root(), sine, out[3]);
        const V factor = select(beyond, zero_or_nan, angle.divide(sine));
        out[0] = b.x * factor;
        out[1] = b.y * factor;
        out[2] = b.z * factor;
    }
};

}  // namespace
}  // namespace swivel

#endif
