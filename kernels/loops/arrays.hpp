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
    T* first = stream[0];
    for (int k = 1; k < 4; ++k)
        if (stream[k] < first) first = stream[k];
    unsigned seen = 0;
    for (int k = 0; k < 4; ++k) {
        place[k] = stream[k] - first;
        if (place[k] > 3) return nullptr;
        seen |= 1U << place[k];
    }
    return seen == 0xfU ? first : nullptr;
}

// The first `count` quaternions, of which there are some but not a register, by way of a whole block; numbers of
// no meaning in the other lanes.
template <class V>
inline void load_first_quaternions(const quaternion_shuffle<V>& shuffle, const scalar_of<V>* from,
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
}

template <class V>
inline void store_first_quaternions(const quaternion_shuffle<V>& shuffle, const V* four, scalar_of<V>* to,
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

// The first of them in all lanes from `count` on.
template <class V>
inline void fill_up(V* four, std::size_t count) noexcept {
    alignas(V) scalar_of<V> block[4 * V::size];
    for (std::size_t k = 0; k < 4; ++k) four[k].store_aligned(block + k * V::size);
    for (std::size_t k = 0; k < 4; ++k) four[k] = load_first<V>(block + k * V::size, count);
}

// A group of four streams: an array of quaternions, or where `first` is null contiguous streams.
template <class V, class T>
struct quaternions {
    T* first = nullptr;
    quaternion_shuffle<V> shuffle;
};

// Whether every group is contiguous, a repeated scalar, or an array of quaternions.
template <class V, class Streams, class T, std::size_t... G>
inline bool are_arrays(T* const* stream, const std::ptrdiff_t* stride, quaternions<V, T>* group,
                       std::index_sequence<G...>) noexcept {
    const auto is_one = [&]<std::size_t K>(std::integral_constant<std::size_t, K>) {
        constexpr int components = Streams::components[K];
        if (stride[K] == 1 || (components == 1 && stride[K] == 0)) return true;
        if constexpr (components == 4) {
            std::ptrdiff_t place[4];
            group[K].first = quaternion_array(stream + Streams::first_of(K), stride[K], place);
            if (group[K].first == nullptr) return false;
            group[K].shuffle.set(place);
            return true;
        }
        return false;
    };
    return (is_one(std::integral_constant<std::size_t, G>()) && ...);
}

// For light operations, whose arithmetic hides the shuffles: they are done in registers, without a block in
// between. False, and nothing done, where the groups are of another kind.
template <class V, class Op, std::size_t... I, std::size_t... O, std::size_t... GI, std::size_t... GO>
inline bool array_loop(const batch<scalar_of<V>>& b, std::index_sequence<I...>, std::index_sequence<O...>,
                       std::index_sequence<GI...> groups_in, std::index_sequence<GO...> groups_out) noexcept {
    using T = scalar_of<V>;
    using reads = typename Op::reads;
    using writes = typename Op::writes;
    quaternions<V, const T> from[reads::groups];
    quaternions<V, T> to[writes::groups];
    if (!are_arrays<V, reads>(b.in, b.in_stride, from, groups_in) ||
        !are_arrays<V, writes>(b.out, b.out_stride, to, groups_out))
        return false;
    const Op op(b.uniform);
    const input_streams<Op, T, std::index_sequence<I...>> in_streams(b);
    T* const to_streams[] = {b.out[O]...};

    const auto read = [&]<bool Whole>(std::size_t i, std::size_t count, V * in, std::bool_constant<Whole>)
        __attribute__((always_inline)) {
        const auto load = [&]<std::size_t K>(std::integral_constant<std::size_t, K>)
            __attribute__((always_inline)) {
            const T* const at = in_streams.template at<K>(i);
            return Whole ? V::load_unaligned(at) : load_first<V>(at, count);
        };
        const auto group = [&]<std::size_t K>(std::integral_constant<std::size_t, K>)
            __attribute__((always_inline)) {
            constexpr std::size_t first = static_cast<std::size_t>(reads::first_of(K));
            if constexpr (reads::components[K] == 4) {
                if (from[K].first != nullptr) {
                    if constexpr (Whole) {
                        from[K].shuffle.load(from[K].first + 4 * i, in + first);
                    } else {
                        load_first_quaternions(from[K].shuffle, from[K].first + 4 * i, count, in + first);
                        fill_up(in + first, count);
                    }
                    return;
                }
            }
            [&]<std::size_t... C>(std::index_sequence<C...>) __attribute__((always_inline)) {
                ((in[first + C] = load(std::integral_constant<std::size_t, first + C>())), ...);
            }
            (std::make_index_sequence<reads::components[K]>());
        };
        (group(std::integral_constant<std::size_t, GI>()), ...);
    };
    const auto write = [&]<bool Whole>(std::size_t i, std::size_t count, const V* out,
                                       std::bool_constant<Whole>) __attribute__((always_inline)) {
        const auto group = [&]<std::size_t K>(std::integral_constant<std::size_t, K>)
            __attribute__((always_inline)) {
            constexpr std::size_t first = static_cast<std::size_t>(writes::first_of(K));
            if constexpr (writes::components[K] == 4) {
                if (to[K].first != nullptr) {
                    if constexpr (Whole)
                        to[K].shuffle.store(out + first, to[K].first + 4 * i);
                    else
                        store_first_quaternions(to[K].shuffle, out + first, to[K].first + 4 * i, count);
                    return;
                }
            }
            [&]<std::size_t... C>(std::index_sequence<C...>) __attribute__((always_inline)) {
                if constexpr (Whole)
                    (out[first + C].store_unaligned(to_streams[first + C] + i), ...);
                else
                    (store_first(out[first + C], to_streams[first + C] + i, count), ...);
            }
            (std::make_index_sequence<writes::components[K]>());
        };
        (group(std::integral_constant<std::size_t, GO>()), ...);
    };
    constexpr std::true_type whole;

    const std::size_t size = b.size;
    std::size_t i = 0;
    if constexpr (has_32_registers) {
        // Three stages, each a register behind the one before it: what a stage needs has long been there, so
        // that the processor's window does not fill up with instructions that wait.
        if (size >= V::size) {
            const std::size_t last = size - size % V::size - V::size;
            V current[sizeof...(I)], done[sizeof...(O)];
            read(0, V::size, current, whole);
            for (; i <= last; i += V::size) {
                V next[sizeof...(I)], out[sizeof...(O)];
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
            V in[sizeof...(I)], out[sizeof...(O)];
            read(i, V::size, in, whole);
            op(in, out);
            write(i, V::size, out, whole);
        }
    }
    if (i < size) {
        V in[sizeof...(I)], out[sizeof...(O)];
        read(i, size - i, in, std::false_type());
        op(in, out);
        write(i, size - i, out, std::false_type());
    }
    return true;
}

template <class V, class Op>
[[gnu::flatten]] bool array_loop(const batch<scalar_of<V>>& b) noexcept {
    return array_loop<V, Op>(b, inputs_of<Op>(), outputs_of<Op>(),
                             std::make_index_sequence<Op::reads::groups>(),
                             std::make_index_sequence<Op::writes::groups>());
}

}  // namespace
}  // namespace swivel

#endif
