#ifndef SWIVEL_KERNELS_STREAM_LOOP_HPP
#define SWIVEL_KERNELS_STREAM_LOOP_HPP

#include <utility>

#include "kernel_table.hpp"
#include "ops.hpp"

namespace swivel {
namespace {

// Runs Op over the streams of a batch, a register of each at a time. The elements left over at the end go
// through the same function, in registers whose other lanes are filled up. Op has
//   static constexpr int inputs, outputs;
//   explicit Op(const T* uniform)                  takes the numbers that are the same for all elements
//   void operator()(const V* in, V* out) const     the maths for one register
template <class V, class Op, std::size_t... I, std::size_t... O>
inline void stream_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...>,
                        std::index_sequence<O...>) noexcept {
    using T = scalar_of<V>;
    const Op op(b.uniform);
    // Vector stores may alias anything, so pointers left in the batch would be read again for every register;
    // and gcc leaves a loop over the streams rolled up, with every register in memory.
    const T* const from[] = {b.in[I]...};
    T* const to[] = {b.out[O]...};
    const std::size_t size = b.size;

    std::size_t i = 0;
    for (; i + V::size <= size; i += V::size) {
        const V in[] = {V::load_unaligned(from[I] + i)...};
        V out[Op::outputs];
        op(in, out);
        (out[O].store_unaligned(to[O] + i), ...);
    }
    if (i < size) {
        const std::size_t rest = size - i;
        const V in[] = {load_first<V>(from[I] + i, rest)...};
        V out[Op::outputs];
        op(in, out);
        (store_first(out[O], to[O] + i, rest), ...);
    }
}

template <class V, class Op>
void stream_loop(const batch<scalar_of<V>>& b) noexcept {
    stream_loop<V, Op>(b, std::make_index_sequence<Op::inputs>(), std::make_index_sequence<Op::outputs>());
}

}  // namespace
}  // namespace swivel

#endif
