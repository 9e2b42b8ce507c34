#ifndef SWIVEL_KERNELS_SQUARE_ROOT_HPP
#define SWIVEL_KERNELS_SQUARE_ROOT_HPP

#include "polar_form.hpp"

namespace swivel {
namespace {

// With q = n (c + s d), n its length, the root is that of half the angle: n + |w| and m, or for negative w m
// and n + |w|, are in proportion to its cosine and sine. Nothing cancels near -1. Streams in: x y z w. Out:
// the same.
template <precision_index P, class V>
struct square_root_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    static constexpr int inputs = 4, quaternions_in = 1;
    static constexpr int outputs = 4, quaternions_out = 1;

    explicit square_root_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        // Half, so that m does not overflow.
        const polar_form<P, V> q = polar<P>(in, T(0.5));
        const V zero(T(0)), largest = larger(q.m, magnitude(q.w)), scale = reciprocal_power_of_two(largest);
        const V m = q.m * scale, squared = m * m;
        const V w = select(largest == zero, V(T(1)), q.w * scale);
        const V sum = root_divisor<P, V>(M::multiply_add(w, w, squared)).root() + magnitude(w);
        const root_divisor<P, V> length(M::multiply_add(sum, sum, squared));
        const mask_of<V> negative = w < zero;
        q.along(length.divide(select(negative, sum, m)), out);
        out[3] = length.divide(select(negative, m, sum));
    }
};

}  // namespace
}  // namespace swivel

#endif
