#ifndef SWIVEL_KERNELS_LOOPS_STAGED_HPP
#define SWIVEL_KERNELS_LOOPS_STAGED_HPP

// Streams of any stride, by way of contiguous blocks on the stack, which fit in a first-level cache.

#include "kernels/loops/arrays.hpp"

namespace swivel {
namespace {

// Bytes of one stream: so many that all of an operation stay below 7 KiB, since a call is to take no more than 16 KiB
// of stack with what the registers of the operation spill. At least one register of the widest ISA.
template <class Op>
inline constexpr std::size_t block_bytes = Op::reads::count + Op::writes::count <= 13   ? 512
                                           : Op::reads::count + Op::writes::count <= 28 ? 256
                                                                                        : 64;

// One view as it lies in memory, and the blocks that stand for it; without blocks it is used where it is.
template <class V, class T>
struct staged_group {
    T* const* stream;
    std::ptrdiff_t stride;
    int components;
    scalar_of<V>* block = nullptr;
    // Of an array of quaternions, else null. The shuffle of its places is made anew for each block: kept, those of all
    // groups would take kilobytes.
    T* array = nullptr;
    std::ptrdiff_t place[4];

    // Element `at` of each of its streams.
    T* element(int k, std::size_t at) const noexcept {
        return stream[k] + static_cast<std::ptrdiff_t>(at) * stride;
    }
};

// Takes blocks for the group where it needs them, and returns the next free one.
template <class V, class T>
inline scalar_of<V>* take_blocks(staged_group<V, T>& g, scalar_of<V>* room, std::size_t block) noexcept {
    if (g.stride == 1 || (g.components == 1 && g.stride == 0)) return room;
    g.block = room;
    if (g.components == 4) g.array = quaternion_array(g.stream, g.stride, g.place);
    return room + static_cast<std::size_t>(g.components) * block;
}

// Out of line, as is put_back: their registers need not be on the stack while the operation runs.
template <class V, class T>
[[gnu::noinline]] void fetch(const staged_group<V, T>& g, std::size_t at, std::size_t count,
                             std::size_t block) noexcept {
    if (g.array != nullptr) {
        quaternion_shuffle<V> shuffle;
        shuffle.set(g.place);
        for (std::size_t e = 0; e < count; e += V::size) {
            V four[4];
            T* const from = g.array + 4 * (at + e);
            if (count - e >= V::size)
                shuffle.load(from, four);
            else
                load_first_quaternions<V>(shuffle, from, count - e, four);
            for (std::size_t k = 0; k < 4; ++k) four[k].store_aligned(g.block + k * block + e);
        }
        return;
    }
    for (int k = 0; k < g.components; ++k) {
        T* const from = g.element(k, at);
        scalar_of<V>* const to = g.block + static_cast<std::size_t>(k) * block;
        for (std::size_t e = 0; e < count; ++e) to[e] = from[static_cast<std::ptrdiff_t>(e) * g.stride];
    }
}

template <class V, class T>
[[gnu::noinline]] void put_back(const staged_group<V, T>& g, std::size_t at, std::size_t count,
                                std::size_t block) noexcept {
    if (g.array != nullptr) {
        quaternion_shuffle<V> shuffle;
        shuffle.set(g.place);
        for (std::size_t e = 0; e < count; e += V::size) {
            V four[4];
            for (std::size_t k = 0; k < 4; ++k) four[k] = V::load_aligned(g.block + k * block + e);
            T* const to = g.array + 4 * (at + e);
            if (count - e >= V::size)
                shuffle.store(four, to);
            else
                store_first_quaternions<V>(shuffle, four, to, count - e);
        }
        return;
    }
    for (int k = 0; k < g.components; ++k) {
        T* const to = g.element(k, at);
        const scalar_of<V>* const from = g.block + static_cast<std::size_t>(k) * block;
        for (std::size_t e = 0; e < count; ++e) to[static_cast<std::ptrdiff_t>(e) * g.stride] = from[e];
    }
}

// Out of line, once for all operations of a source: `blocks` has room for every stream.
template <class V>
[[gnu::noinline]] void staged_loop(const batch<scalar_of<V>>& b, const int* in_components, int in_groups,
                                   const int* out_components, int out_groups, kernel<scalar_of<V>> contiguous,
                                   scalar_of<V>* blocks, std::size_t block) noexcept {
    using T = scalar_of<V>;
    staged_group<V, const T> in[most_groups];
    staged_group<V, T> out[most_groups];
    batch<T> staged;
    T* room = blocks;
    int stream = 0;
    for (int g = 0; g < in_groups; ++g) {
        in[g].stream = b.in + stream;
        in[g].stride = b.in_stride[g];
        in[g].components = in_components[g];
        room = take_blocks(in[g], room, block);
        staged.in_stride[g] = in[g].block != nullptr ? 1 : in[g].stride;
        stream += in_components[g];
    }
    stream = 0;
    for (int g = 0; g < out_groups; ++g) {
        out[g].stream = b.out + stream;
        out[g].stride = b.out_stride[g];
        out[g].components = out_components[g];
        room = take_blocks(out[g], room, block);
        staged.out_stride[g] = 1;
        stream += out_components[g];
    }
    for (int k = 0; k < 7; ++k) staged.uniform[k] = b.uniform[k];

    for (std::size_t done = 0; done < b.size; done += block) {
        const std::size_t count = b.size - done < block ? b.size - done : block;
        staged.size = count;
        stream = 0;
        for (int g = 0; g < in_groups; ++g) {
            const bool is_staged = in[g].block != nullptr;
            // One element for all is the same in every block.
            if (is_staged && (in[g].stride != 0 || done == 0)) fetch(in[g], done, count, block);
            for (int k = 0; k < in[g].components; ++k)
                staged.in[stream++] =
                    is_staged ? in[g].block + static_cast<std::size_t>(k) * block : in[g].element(k, done);
        }
        stream = 0;
        for (int g = 0; g < out_groups; ++g)
            for (int k = 0; k < out[g].components; ++k)
                staged.out[stream++] = out[g].block != nullptr
                                           ? out[g].block + static_cast<std::size_t>(k) * block
                                           : out[g].element(k, done);
        contiguous(staged);
        for (int g = 0; g < out_groups; ++g)
            if (out[g].block != nullptr) put_back(out[g], done, count, block);
    }
}

template <class V, class Op>
void staged_loop(const batch<scalar_of<V>>& b, kernel<scalar_of<V>> contiguous) noexcept {
    using T = scalar_of<V>;
    constexpr std::size_t block = block_bytes<Op> / sizeof(T);
    alignas(64) T blocks[(Op::reads::count + Op::writes::count) * block];
    staged_loop<V>(b, Op::reads::components, Op::reads::groups, Op::writes::components, Op::writes::groups,
                   contiguous, blocks, block);
}

}  // namespace
}  // namespace swivel

#endif
