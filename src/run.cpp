#include "run.hpp"

namespace swivel {

namespace {

// Twelve streams of it fit in half of a 32 KiB first-level cache.
template <class T>
constexpr std::size_t block_size = 1024 / sizeof(T);

template <class T>
struct block {
    alignas(64) T stream[5][block_size<T>];
};

// Where the four components of an array of quaternions lie in memory order, if the group is one.
template <class T>
T* quaternion_array(const stream_group<T>& g, int (&place)[4]) noexcept {
    if (g.count != 4 || g.stride != 4) return nullptr;
    T* first = g.stream[0];
    for (int k = 1; k < 4; ++k)
        if (g.stream[k] < first) first = g.stream[k];
    unsigned seen = 0;
    for (int k = 0; k < 4; ++k) {
        const std::ptrdiff_t at = g.stream[k] - first;
        if (at > 3) return nullptr;
        place[k] = static_cast<int>(at);
        seen |= 1U << at;
    }
    return seen == 0xfU ? first : nullptr;
}

}  // namespace

template <class T>
void run_staged(kernel<T> run_kernel, const operations<T>& table, const streams<T>& s, batch<T>& b) noexcept {
    using group_block = block<T>;
    group_block in_block[streams<T>::most], out_block[streams<T>::most];
    int in_place[streams<T>::most][4], out_place[streams<T>::most][4];
    const T* in_array[streams<T>::most];
    T* out_array[streams<T>::most];
    for (int i = 0; i < s.inputs; ++i) in_array[i] = quaternion_array(s.in[i], in_place[i]);
    for (int i = 0; i < s.outputs; ++i) out_array[i] = quaternion_array(s.out[i], out_place[i]);

    for (std::size_t done = 0; done < s.size; done += b.size) {
        const auto at = static_cast<std::ptrdiff_t>(done);
        b.size = s.size - done < block_size<T> ? s.size - done : block_size<T>;

        const T** in = b.in;
        for (int i = 0; i < s.inputs; ++i) {
            const stream_group<const T>& g = s.in[i];
            for (int k = 0; k < g.count; ++k)
                in[k] = g.stride == 1 ? g.stream[k] + at : in_block[i].stream[k];
            if (in_array[i] != nullptr) {
                T* in_memory_order[4];
                for (int k = 0; k < 4; ++k) in_memory_order[in_place[i][k]] = in_block[i].stream[k];
                table.split_quaternions(in_array[i] + 4 * at, in_memory_order, b.size);
            } else if (g.stride != 1) {
                for (int k = 0; k < g.count; ++k) {
                    const T* from = g.stream[k] + at * g.stride;
                    for (std::size_t e = 0; e < b.size; ++e)
                        in_block[i].stream[k][e] = from[static_cast<std::ptrdiff_t>(e) * g.stride];
                }
            }
            in += g.count;
        }

        T** out = b.out;
        for (int i = 0; i < s.outputs; ++i) {
            const stream_group<T>& g = s.out[i];
            for (int k = 0; k < g.count; ++k)
                *out++ = g.stride == 1 ? g.stream[k] + at : out_block[i].stream[k];
        }

        run_kernel(b);

        for (int i = 0; i < s.outputs; ++i) {
            const stream_group<T>& g = s.out[i];
            if (out_array[i] != nullptr) {
                const T* in_memory_order[4];
                for (int k = 0; k < 4; ++k) in_memory_order[out_place[i][k]] = out_block[i].stream[k];
                table.join_quaternions(in_memory_order, out_array[i] + 4 * at, b.size);
            } else if (g.stride != 1) {
                for (int k = 0; k < g.count; ++k) {
                    T* to = g.stream[k] + at * g.stride;
                    for (std::size_t e = 0; e < b.size; ++e)
                        to[static_cast<std::ptrdiff_t>(e) * g.stride] = out_block[i].stream[k][e];
                }
            }
        }
    }
}

template void run_staged(kernel<float>, const operations<float>&, const streams<float>&,
                         batch<float>&) noexcept;
template void run_staged(kernel<double>, const operations<double>&, const streams<double>&,
                         batch<double>&) noexcept;

}  // namespace swivel
