#ifndef SWIVEL_KERNELS_EXPONENTIALS_SQUARE_ROOT_HPP
#define SWIVEL_KERNELS_EXPONENTIALS_SQUARE_ROOT_HPP

#include "kernels/exponentials/polar_form.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// Streams in: x y z w. Out: the same.
template <precision_index P, class V>
struct square_root_op {
    using T = scalar_of<V>;
    using reads = streams<4>;
    using writes = streams<4>;

    explicit square_root_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        // Half, so that m does not overflow.
        const polar_form<P, V> q = polar<P>(in, T(0.5));
        const V zero(T(0)), largest = larger(q.m, magnitude(q.w)), scale = reciprocal_power_of_two(largest);
        V sine;
        half_of<P>(q.m * scale, select(largest == zero, V(T(1)), q.w * scale), sine, out[3]);
        q.along(sine, out);
    }
};

}  // namespace
}  // namespace swivel

#endif
