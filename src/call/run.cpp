#include "src/call/run.hpp"

namespace swivel {

namespace {

// The streams that are neither contiguous nor in an array of quaternions are staged in blocks, which fit in a
// first-level cache of 32 KiB and in the stack of a small fibre.
template <class T>
constexpr std::size_t block_size = 512 / sizeof(T);

template <class T>
void gather(const T* from, std::ptrdiff_t stride, std::size_t count, T* block) noexcept {
    for (std::size_t e = 0; e < count; ++e) block[e] = from[static_cast<std::ptrdiff_t>(e) * stride];
}

template <class T>
void scatter(const T* block, std::size_t count, T* to, std::ptrdiff_t stride) noexcept {
    for (std::size_t e = 0; e < count; ++e) to[static_cast<std::ptrdiff_t>(e) * stride] = block[e];
}

// Finds out where the components of the group lie in an array of quaternions, if it is one.
template <class T>
bool is_quaternion_array(const any_group<T>& g, quaternion_array<T>& array) noexcept {
    if (g.count != 4 || g.stride != 4) return false;
    T* first = g.stream[0];
    for (int k = 1; k < 4; ++k)
        if (g.stream[k] < first) first = g.stream[k];
    unsigned seen = 0;
    for (int k = 0; k < 4; ++k) {
        const std::ptrdiff_t at = g.stream[k] - first;
        if (at > 3) return false;
        array.place[at] = k;
        seen |= 1U << at;
    }
    if (seen != 0xfU) return false;
    array.first = first;
    return true;
}

}  // namespace

template <class T>
void run_any(kernel<T> run_kernel, const call_streams<T>& s, batch<T>& b) noexcept {
    alignas(64) T in_block[most_inputs][block_size<T>], out_block[most_outputs][block_size<T>];
    bool in_staged[most_groups], out_staged[most_groups];
    bool any_staged = false;
    for (quaternion_array<const T>& a : b.in_array) a.first = nullptr;
    for (quaternion_array<T>& a : b.out_array) a.first = nullptr;
    for (int i = 0; i < s.inputs; ++i) {
        const bool array = is_quaternion_array(s.in[i], b.in_array[i]);
        in_staged[i] = !array && s.in[i].stride != 1;
        b.has_arrays |= array;
        any_staged |= in_staged[i];
    }
    for (int i = 0; i < s.outputs; ++i) {
        const bool array = is_quaternion_array(s.out[i], b.out_array[i]);
        out_staged[i] = !array && s.out[i].stride != 1;
        b.has_arrays |= array;
        any_staged |= out_staged[i];
    }

    const std::size_t most = any_staged ? block_size<T> : s.size;
    for (std::size_t done = 0; done < s.size; done += b.size) {
        const auto at = static_cast<std::ptrdiff_t>(done);
        b.size = s.size - done < most ? s.size - done : most;

        int stream = 0;
        for (int i = 0; i < s.inputs; ++i) {
            const any_group<const T>& g = s.in[i];
            for (int k = 0; k < g.count; ++k, ++stream) {
                const T* from = g.stream[k] + at * g.stride;
                b.in[stream] = in_staged[i] ? in_block[stream] : from;
                // One element for all is the same in every block.
                if (in_staged[i] && (g.stride != 0 || done == 0))
                    gather(from, g.stride, b.size, in_block[stream]);
            }
        }
        stream = 0;
        for (int i = 0; i < s.outputs; ++i) {
            const any_group<T>& g = s.out[i];
            for (int k = 0; k < g.count; ++k, ++stream)
                b.out[stream] = out_staged[i] ? out_block[stream] : g.stream[k] + at * g.stride;
        }

        run_kernel(b);

        stream = 0;
        for (int i = 0; i < s.outputs; ++i) {
            const any_group<T>& g = s.out[i];
            for (int k = 0; k < g.count; ++k, ++stream)
                if (out_staged[i]) scatter(out_block[stream], b.size, g.stream[k] + at * g.stride, g.stride);
        }
        for (quaternion_array<const T>& a : b.in_array)
            if (a.first != nullptr) a.first += 4 * b.size;
        for (quaternion_array<T>& a : b.out_array)
            if (a.first != nullptr) a.first += 4 * b.size;
    }
}

template void run_any(kernel<float>, const call_streams<float>&, batch<float>&) noexcept;
template void run_any(kernel<double>, const call_streams<double>&, batch<double>&) noexcept;

}  // namespace swivel
