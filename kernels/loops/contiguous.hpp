#ifndef SWIVEL_KERNELS_LOOPS_CONTIGUOUS_HPP
#define SWIVEL_KERNELS_LOOPS_CONTIGUOUS_HPP

// Loops of an operation over streams that are contiguous, a register of each at a time. A scalar that is the
// same for all elements has an index of 0 in every turn.
//
// Registers are named by index sequences: gcc leaves a loop over them rolled up, with every register in memory.

#include <utility>

#include "kernels/kernel.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/registers/ops.hpp"
#include "kernels/registers/twin.hpp"

namespace swivel {
namespace {

// Element i of an input: the pointers and masks are held outside of the batch, since vector stores may alias
// anything, and what is left in the batch would be read again for every register.
template <class Op, class T, class Streams>
struct input_streams;

template <class Op, class T, std::size_t... I>
struct input_streams<Op, T, std::index_sequence<I...>> {
    const T* from[sizeof...(I)];
    std::size_t mask[sizeof...(I)];

    explicit input_streams(const batch<T>& b) noexcept
        : from{b.in[I]...}, mask{static_cast<std::size_t>(-b.in_stride[Op::reads::group_of(I)])...} {}

    template <std::size_t K>
    const T* at(std::size_t i) const noexcept {
        return from[K] + (Op::reads::is_scalar(K) ? i & mask[K] : i);
    }
};

template <class Op>
using inputs_of = std::make_index_sequence<Op::reads::count>;
template <class Op>
using outputs_of = std::make_index_sequence<Op::writes::count>;

// For light operations: those that are left over at the end go through a body of their own, beside the loop.
template <class V, class Op, std::size_t... I, std::size_t... O>
inline void light_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...>,
                       std::index_sequence<O...>) noexcept {
    using T = scalar_of<V>;
    const Op op(b.uniform);
    const input_streams<Op, T, std::index_sequence<I...>> in_streams(b);
    T* const to[] = {b.out[O]...};
    const std::size_t size = b.size;

    std::size_t i = 0;
    for (; i + V::size <= size; i += V::size) {
        const V in[] = {V::load_unaligned(in_streams.template at<I>(i))...};
        V out[sizeof...(O)];
        op(in, out);
        (out[O].store_unaligned(to[O] + i), ...);
    }
    if (i < size) {
        const std::size_t rest = size - i;
        const V in[] = {load_first<V>(in_streams.template at<I>(i), rest)...};
        V out[sizeof...(O)];
        op(in, out);
        (store_first(out[O], to[O] + i, rest), ...);
    }
}

// For heavy ones: the code of the operation stands here once, and only how its registers are filled differs.
template <class V, class Op, std::size_t... I, std::size_t... O>
inline void heavy_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...>,
                       std::index_sequence<O...>) noexcept {
    using T = scalar_of<V>;
    const Op op(b.uniform);
    const input_streams<Op, T, std::index_sequence<I...>> in_streams(b);
    T* const to[] = {b.out[O]...};
    const std::size_t size = b.size;

    for (std::size_t i = 0; i < size; i += V::size) {
        const std::size_t rest = size - i;
        V in[sizeof...(I)], out[sizeof...(O)];
        if (rest >= V::size)
            ((in[I] = V::load_unaligned(in_streams.template at<I>(i))), ...);
        else
            ((in[I] = load_first<V>(in_streams.template at<I>(i), rest)), ...);
        op(in, out);
        if (rest >= V::size)
            (out[O].store_unaligned(to[O] + i), ...);
        else
            (store_first(out[O], to[O] + i, rest), ...);
    }
}

// Flattened: gcc 12 would leave the second call of a light operation, that of the tail, out of line, and every
// register in memory.
template <class V, class Op>
[[gnu::flatten]] void light_loop(const batch<scalar_of<V>>& b) noexcept {
    light_loop<V, Op>(b, inputs_of<Op>(), outputs_of<Op>());
}

template <class V, class Op>
[[gnu::flatten]] void heavy_loop(const batch<scalar_of<V>>& b) noexcept {
    heavy_loop<V, Op>(b, inputs_of<Op>(), outputs_of<Op>());
}

}  // namespace
}  // namespace swivel

#endif
