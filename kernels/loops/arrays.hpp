#ifndef SWIVEL_KERNELS_LOOPS_ARRAYS_HPP
#define SWIVEL_KERNELS_LOOPS_ARRAYS_HPP

// Arrays of quaternions, x y z w or w x y z or in any other order, one after the other.

#include "kernels/kernel.hpp"
#include "kernels/loops/contiguous.hpp"

namespace swivel {
namespace {

// Where the components of a group lie in an array of quaternions, if it is one: in place[k] of each quaternion
// is stream k. Null where it is none.
template <class T>
inline T* quaternion_array(T* const* stream, std::ptrdiff_t stride, std::ptrdiff_t* place) noexcept {
    if (stride != 4) return nullptr;
    T* const s[4] = {stream[0], stream[1], stream[2], stream[3]};
    T *const lower = s[0] < s[1] ? s[0] : s[1], *const upper = s[2] < s[3] ? s[2] : s[3];
    T* const first = lower < upper ? lower : upper;
    place[0] = s[0] - first;
    place[1] = s[1] - first;
    place[2] = s[2] - first;
    place[3] = s[3] - first;
    if ((place[0] | place[1] | place[2] | place[3]) > 3) return nullptr;
    return ((1 << place[0]) | (1 << place[1]) | (1 << place[2]) | (1 << place[3])) == 0xf ? first : nullptr;
}

// A group of four streams: an array of quaternions, or where `first` is null contiguous streams.
template <class V, class T>
struct quaternions {
    T* first = nullptr;
    quaternion_shuffle<V> shuffle;

    [[gnu::always_inline]] bool find(T* const* stream, std::ptrdiff_t stride) noexcept {
        std::ptrdiff_t place[4];
        first = quaternion_array(stream, stride, place);
        if (first != nullptr) shuffle.set(place);
        return first != nullptr;
    }
};

// The first `count` quaternions, of which there are some but not a register, by way of a whole block; the first
// of them in the other lanes. Out of line, as below: for each tail once.
template <class V>
[[gnu::noinline]] void load_first_quaternions(quaternion_shuffle<V> shuffle, const scalar_of<V>* from,
                                              std::size_t count, V* four) noexcept {
    alignas(V) scalar_of<V> block[4 * V::size];
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t before = k * V::size, all = 4 * count;
        if (all >= before + V::size)
            V::load_unaligned(from + before).store_aligned(block + before);
        else
            (all > before ? load_first<V>(from + before, all - before) : load_first<V>(from, 1))
                .store_aligned(block + before);
    }
    shuffle.load(block, four);
    for (std::size_t k = 0; k < 4; ++k) four[k].store_aligned(block + k * V::size);
    for (std::size_t k = 0; k < 4; ++k) four[k] = load_first<V>(block + k * V::size, count);
}

template <class V>
[[gnu::noinline]] void store_first_quaternions(quaternion_shuffle<V> shuffle, const V* four, scalar_of<V>* to,
                                               std::size_t count) noexcept {
    alignas(V) scalar_of<V> block[4 * V::size];
    shuffle.store(four, block);
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t before = k * V::size, all = 4 * count;
        if (all >= before + V::size)
            V::load_aligned(block + before).store_unaligned(to + before);
        else if (all > before)
            store_first(V::load_aligned(block + before), to + before, all - before);
    }
}

// Four registers from an array and to one; of `rest` quaternions at most. (The copies let
// the registers of a loop stay where they are.)
template <class V>
[[gnu::always_inline]] inline void load_quaternions_of(const quaternion_shuffle<V>& shuffle,
                                                       const scalar_of<V>* from, std::size_t rest,
                                                       V* four) noexcept {
    if (rest >= V::size) return shuffle.load(from, four);
    V copy[4];
    load_first_quaternions<V>(shuffle, from, rest, copy);
    for (int k = 0; k < 4; ++k) four[k] = copy[k];
}
template <class V>
[[gnu::always_inline]] inline void store_quaternions_of(const quaternion_shuffle<V>& shuffle, const V* four,
                                                        scalar_of<V>* to, std::size_t rest) noexcept {
    if (rest >= V::size) return shuffle.store(four, to);
    const V copy[4] = {four[0], four[1], four[2], four[3]};
    store_first_quaternions<V>(shuffle, copy, to, rest);
}
// Whether every group is contiguous, a repeated scalar, or an array of quaternions.
template <class Streams, class T>
inline bool are_arrays(T* const* stream, const std::ptrdiff_t* stride) noexcept {
    bool all = true;
    for (int g = 0; g < Streams::groups; ++g) {
        std::ptrdiff_t place[4];
        const int components = Streams::components[g];
        all = all && (stride[g] == 1 || (components == 1 && stride[g] == 0) ||
                      (components == 4 &&
                       quaternion_array(stream + Streams::first_of(g), stride[g], place) != nullptr));
    }
    return all;
}

// Whether that can be, in the layouts that are met: where quaternions stand in arrays, vectors and motors do too, and
// these go by way of blocks. (The compact form has no stride.)
template <class Streams>
constexpr bool may_be_arrays() noexcept {
    for (int g = 0; g < Streams::groups; ++g) {
        const int components = Streams::components[g];
        if (components != 4 && components != 1 && components != 5) return false;
    }
    return true;
}

template <class Op, class T>
inline bool are_arrays(const batch<T>& b) noexcept {
    return are_arrays<typename Op::reads>(b.in, b.in_stride) &&
           are_arrays<typename Op::writes>(b.out, b.out_stride);
}

// Registers of an operation filled from the streams and arrays of a call, and written back.
template <class V, class Op, class In, class Out, class GroupsIn, class GroupsOut>
struct memory_of;

template <class V, class Op, std::size_t... I, std::size_t... O, std::size_t... GI, std::size_t... GO>
struct memory_of<V, Op, std::index_sequence<I...>, std::index_sequence<O...>, std::index_sequence<GI...>,
                 std::index_sequence<GO...>> {
    using T = scalar_of<V>;
    using reads = typename Op::reads;
    using writes = typename Op::writes;

    input_streams<Op, T, std::index_sequence<I...>> in_streams;
    T* out_streams[sizeof...(O)];
    quaternions<V, const T> from[sizeof...(GI)];
    quaternions<V, T> to[sizeof...(GO)];

    [[gnu::always_inline]] explicit memory_of(const batch<T>& b) noexcept
        : in_streams(b), out_streams{b.out[O]...} {
        ((reads::components[GI] == 4 && from[GI].find(b.in + reads::first_of(GI), b.in_stride[GI])), ...);
        ((writes::components[GO] == 4 && to[GO].find(b.out + writes::first_of(GO), b.out_stride[GO])), ...);
    }

    // Of elements i .. i + rest - 1; a whole register where rest is as large.
    [[gnu::always_inline]] void read(std::size_t i, std::size_t rest, V* in) const noexcept {
        const auto stream = [&]<std::size_t K>(std::integral_constant<std::size_t, K>)
            __attribute__((always_inline)) {
            const T* const at = in_streams.template at<K>(i);
            in[K] = rest >= V::size ? V::load_unaligned(at) : load_first<V>(at, rest);
        };
        const auto group = [&]<std::size_t K>(std::integral_constant<std::size_t, K>)
            __attribute__((always_inline)) {
            constexpr std::size_t first = static_cast<std::size_t>(reads::first_of(K));
            if constexpr (reads::components[K] == 4)
                if (from[K].first != nullptr)
                    return load_quaternions_of(from[K].shuffle, from[K].first + 4 * i, rest, in + first);
            [&]<std::size_t... C>(std::index_sequence<C...>) __attribute__((always_inline)) {
                (stream(std::integral_constant<std::size_t, first + C>()), ...);
            }
            (std::make_index_sequence<reads::components[K]>());
        };
        (group(std::integral_constant<std::size_t, GI>()), ...);
    }

    [[gnu::always_inline]] void write(std::size_t i, std::size_t rest, const V* out) const noexcept {
        const auto stream = [&]<std::size_t K>(std::integral_constant<std::size_t, K>)
            __attribute__((always_inline)) {
            if (rest >= V::size)
                out[K].store_unaligned(out_streams[K] + i);
            else
                store_first(out[K], out_streams[K] + i, rest);
        };
        const auto group = [&]<std::size_t K>(std::integral_constant<std::size_t, K>)
            __attribute__((always_inline)) {
            constexpr std::size_t first = static_cast<std::size_t>(writes::first_of(K));
            if constexpr (writes::components[K] == 4)
                if (to[K].first != nullptr)
                    return store_quaternions_of(to[K].shuffle, out + first, to[K].first + 4 * i, rest);
            [&]<std::size_t... C>(std::index_sequence<C...>) __attribute__((always_inline)) {
                (stream(std::integral_constant<std::size_t, first + C>()), ...);
            }
            (std::make_index_sequence<writes::components[K]>());
        };
        (group(std::integral_constant<std::size_t, GO>()), ...);
    }
};

// For light operations, whose arithmetic hides the shuffles: they are done in registers, without a block in
// between.
template <class V, class Op, std::size_t... I, std::size_t... O, class GI, class GO>
inline void array_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...> in_indices,
                       std::index_sequence<O...> out_indices, GI, GO) noexcept {
    const Op op(b.uniform);
    const memory_of<V, Op, decltype(in_indices), decltype(out_indices), GI, GO> memory(b);
    const std::size_t size = b.size;
    std::size_t i = 0;
    if constexpr (has_32_registers) {
        // Three stages, each a register behind the one before it: what a stage needs has long been there, so
        // that the processor's window does not fill up with instructions that wait.
        if (size >= V::size) {
            const std::size_t last = size - size % V::size - V::size;
            V current[sizeof...(I)], done[sizeof...(O)];
            memory.read(0, V::size, current);
            for (; i <= last; i += V::size) {
                V next[sizeof...(I)], out[sizeof...(O)];
                memory.read(i == last ? last : i + V::size, V::size, next);
                op(current, out);
                if (i != 0) memory.write(i - V::size, V::size, done);
                ((current[I] = next[I]), ...);
                ((done[O] = out[O]), ...);
            }
            memory.write(last, V::size, done);
        }
    } else {
        for (; i + V::size <= size; i += V::size) {
            V in[sizeof...(I)], out[sizeof...(O)];
            memory.read(i, V::size, in);
            op(in, out);
            memory.write(i, V::size, out);
        }
    }
    if (i < size) {
        V in[sizeof...(I)], out[sizeof...(O)];
        memory.read(i, size - i, in);
        op(in, out);
        memory.write(i, size - i, out);
    }
}

template <class V, class Op>
[[gnu::flatten]] void array_loop(const batch<scalar_of<V>>& b) noexcept {
    array_loop<V, Op>(b, inputs_of<Op>(), outputs_of<Op>(), std::make_index_sequence<Op::reads::groups>(),
                      std::make_index_sequence<Op::writes::groups>());
}

}  // namespace
}  // namespace swivel

#endif
