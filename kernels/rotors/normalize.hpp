#ifndef SWIVEL_KERNELS_ROTORS_NORMALIZE_HPP
#define SWIVEL_KERNELS_ROTORS_NORMALIZE_HPP

#include "kernels/constants.hpp"
#include "kernels/kernel.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

// 2^(1 - e) for 2^e <= a < 2^(e + 1), at most the largest power of two; 0 for infinity and NaN. Inverting
// the exponent bits of 2^e does it.
template <class V>
inline V reciprocal_power_of_two(V a) noexcept {
    using C = constants<scalar_of<V>>;
    const V exponent_bits(C::infinity), largest(C::largest_power_of_two);
    const V inverse = (a & exponent_bits) ^ exponent_bits;
    return select(inverse > largest, largest, inverse);
}

// Brings the vector of the components to unit length, from any length from the smallest subnormal number on:
// a power of two brings the largest component to 2..4 before it is squared. Zero stays zero; NaN and infinity
// become NaN. True where the vector is zero.
template <precision_index P, class V, class... Vs>
inline mask_of<V> to_unit_length(V& first, Vs&... others) noexcept {
    using M = arithmetic<P>;
    V scale = magnitude(first);
    ((scale = larger(scale, magnitude(others))), ...);
    scale = reciprocal_power_of_two(scale);
    first = first * scale;
    ((others = others * scale), ...);
    V squared = first * first;
    ((squared = M::multiply_add(others, others, squared)), ...);
    const V least(constants<scalar_of<V>>::pole_floor), no_less = larger(least, squared);
    if constexpr (P == reproducible_index) {
        const V root = square_root_of(no_less);
        first = quotient(first, root);
        ((others = quotient(others, root)), ...);
    } else {
        const V root = M::reciprocal_root(no_less);
        first = first * root;
        ((others = others * root), ...);
    }
    return squared < least;
}

// Streams in: x y z w. Out: the same.
template <precision_index P, class V>
struct normalize_op {
    using reads = streams<4>;
    using writes = streams<4>;

    explicit normalize_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        V x = in[0], y = in[1], z = in[2], w = in[3];
        const mask_of<V> zero = to_unit_length<P>(x, y, z, w);
        out[0] = x;
        out[1] = y;
        out[2] = z;
        out[3] = select(zero, V(scalar_of<V>(1)), w);
    }
};

}  // namespace
}  // namespace swivel

#endif
