#ifndef SWIVEL_KERNELS_LOOPS_STREAM_LOOP_HPP
#define SWIVEL_KERNELS_LOOPS_STREAM_LOOP_HPP

#include <type_traits>
#include <utility>

#include "kernels/kernel_table.hpp"
#include "kernels/registers/ops.hpp"
#include "kernels/registers/twin.hpp"

namespace swivel {
namespace {

// Loops of an operation over the elements of a batch, a register of each stream at a time. The elements left
// over at the end go through the same function, in registers whose other lanes are filled up. Op has
//   static constexpr int inputs, outputs;                     streams
//   static constexpr int quaternions_in, quaternions_out;     how many fours of them, from the first on, are
//   views of
//                                                             quaternions
//   explicit Op(const T* uniform)                  takes the numbers that are the same for all elements
//   void operator()(const V* in, V* out) const     the maths for one register
// Registers are named by index sequences: gcc leaves a loop over them rolled up, with every register in
// memory.

// For each view of quaternions that is an array: its shuffle, and room for the elements left over.
template <class V, class T>
struct array_of {
    quaternion_shuffle<V> shuffle;
    T* at;
    alignas(V) scalar_of<V> rest[4 * V::size];

    void begin(const quaternion_array<T>& a) noexcept {
        at = a.first;
        if (at != nullptr) shuffle.set(a.place);
    }
};

template <class V, class Op, std::size_t... I, std::size_t... O, std::size_t... GI, std::size_t... GO>
void array_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...>, std::index_sequence<O...>,
                std::index_sequence<GI...>, std::index_sequence<GO...>) noexcept {
    using T = scalar_of<V>;
    const Op op(b.uniform);
    // One more than needed, since there may be none.
    array_of<V, const T> from[sizeof...(GI) + 1];
    array_of<V, T> to[sizeof...(GO) + 1];
    (from[GI].begin(b.in_array[GI]), ...);
    (to[GO].begin(b.out_array[GO]), ...);

    const auto read = [&]<bool Whole>(std::size_t i, std::size_t count, V * in, std::bool_constant<Whole>)
        __attribute__((always_inline)) {
        [[maybe_unused]] const auto load = [&](const T* stream) __attribute__((always_inline)) {
            return Whole ? V::load_unaligned(stream + i) : load_first<V>(stream + i, count);
        };
        [[maybe_unused]] const auto group = [&](auto& array, const T* const* stream, V* four)
            __attribute__((always_inline)) {
            if (array.at == nullptr) {
                four[0] = load(stream[0]);
                four[1] = load(stream[1]);
                four[2] = load(stream[2]);
                four[3] = load(stream[3]);
                return;
            }
            for (std::size_t k = 0; k < 4 * V::size && !Whole; ++k)
                array.rest[k] = k < 4 * count ? array.at[4 * i + k] : T(1);
            array.shuffle.load(Whole ? array.at + 4 * i : array.rest, four);
        };
        (group(from[GI], b.in + 4 * GI, in + 4 * GI), ...);
        ((I < 4 * sizeof...(GI) ? void() : void(in[I] = load(b.in[I]))), ...);
    };
    const auto write = [&]<bool Whole>(std::size_t i, std::size_t count, const V* out,
                                       std::bool_constant<Whole>) __attribute__((always_inline)) {
        [[maybe_unused]] const auto store = [&](V result, T * stream) __attribute__((always_inline)) {
            if constexpr (Whole)
                result.store_unaligned(stream + i);
            else
                store_first(result, stream + i, count);
        };
        [[maybe_unused]] const auto group = [&](auto& array, T* const* stream, const V* four)
            __attribute__((always_inline)) {
            if (array.at == nullptr) {
                store(four[0], stream[0]);
                store(four[1], stream[1]);
                store(four[2], stream[2]);
                store(four[3], stream[3]);
                return;
            }
            array.shuffle.store(four, Whole ? array.at + 4 * i : array.rest);
            for (std::size_t k = 0; k < 4 * count && !Whole; ++k) array.at[4 * i + k] = array.rest[k];
        };
        (group(to[GO], b.out + 4 * GO, out + 4 * GO), ...);
        ((O < 4 * sizeof...(GO) ? void() : store(out[O], b.out[O])), ...);
    };
    constexpr std::true_type whole;

    const std::size_t size = b.size;
    std::size_t i = 0;
    if constexpr (has_32_registers) {
        // Three stages, each a register behind the one before it: what a stage needs has long been there, so
        // that the processor's window does not fill up with instructions that wait.
        if (size >= V::size) {
            const std::size_t last = size - size % V::size - V::size;
            V current[Op::inputs], done[Op::outputs];
            read(0, V::size, current, whole);
            for (; i <= last; i += V::size) {
                V next[Op::inputs], out[Op::outputs];
                read(i == last ? last : i + V::size, V::size, next, whole);
                op(current, out);
                if (i != 0) write(i - V::size, V::size, done, whole);
                ((current[I] = next[I]), ...);
                ((done[O] = out[O]), ...);
            }
            write(last, V::size, done, whole);
        }
    } else {
        for (; i + V::size <= size; i += V::size) {
            V in[Op::inputs], out[Op::outputs];
            read(i, V::size, in, whole);
            op(in, out);
            write(i, V::size, out, whole);
        }
    }
    if (i < size) {
        V in[Op::inputs], out[Op::outputs];
        read(i, size - i, in, std::false_type());
        op(in, out);
        write(i, size - i, out, std::false_type());
    }
}

template <class V, class Op, std::size_t... I, std::size_t... O>
inline void stream_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...> inputs,
                        std::index_sequence<O...> outputs) noexcept {
    using T = scalar_of<V>;
    if (b.has_arrays)
        return array_loop<V, Op>(b, inputs, outputs, std::make_index_sequence<Op::quaternions_in>(),
                                 std::make_index_sequence<Op::quaternions_out>());
    const Op op(b.uniform);
    // Vector stores may alias anything, so pointers left in the batch would be read again for every register.
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

// The same, two registers at a time by `Wide` as long as there are two; for operations of many steps that
// wait for one another (twin.hpp).
template <class V, class Op, class Wide, std::size_t... I, std::size_t... O>
inline void twin_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...> inputs,
                      std::index_sequence<O...> outputs) noexcept {
    using T = scalar_of<V>;
    using W = twin<V>;
    if (b.has_arrays || b.size < W::size) return stream_loop<V, Op>(b, inputs, outputs);
    const Wide op(b.uniform);
    const T* const from[] = {b.in[I]...};
    T* const to[] = {b.out[O]...};
    const std::size_t whole = b.size / W::size * W::size;
    for (std::size_t i = 0; i < whole; i += W::size) {
        const W in[] = {W::load_unaligned(from[I] + i)...};
        W out[Op::outputs];
        op(in, out);
        (out[O].store_unaligned(to[O] + i), ...);
    }
    if (whole == b.size) return;
    batch<T> rest = b;
    ((rest.in[I] = from[I] + whole), ...);
    ((rest.out[O] = to[O] + whole), ...);
    rest.size = b.size - whole;
    stream_loop<V, Op>(rest, inputs, outputs);
}

template <class V, class Op, class Wide>
[[gnu::flatten]] void twin_loop(const batch<scalar_of<V>>& b) noexcept {
    constexpr std::make_index_sequence<Op::inputs> inputs;
    constexpr std::make_index_sequence<Op::outputs> outputs;
    if constexpr (takes_twins)
        twin_loop<V, Op, Wide>(b, inputs, outputs);
    else
        stream_loop<V, Op>(b, inputs, outputs);
}

// Flattened: gcc 12 would leave the second call of the operation, that of the tail, out of line, and every
// register in memory.
template <class V, class Op>
[[gnu::flatten]] void stream_loop(const batch<scalar_of<V>>& b) noexcept {
    stream_loop<V, Op>(b, std::make_index_sequence<Op::inputs>(), std::make_index_sequence<Op::outputs>());
}

}  // namespace
}  // namespace swivel

#endif
