#ifndef SWIVEL_SRC_RUN_HPP
#define SWIVEL_SRC_RUN_HPP

#include "active_kernels.hpp"
#include "checks.hpp"

namespace swivel {

// Runs the kernel over streams of which some are not contiguous, a block at a time by way of the stack.
template <class T>
void run_staged(kernel<T> run_kernel, const operations<T>& table, const streams<T>& s, batch<T>& b) noexcept;

// Runs the kernel over checked streams: those of the input groups one after the other, then the output
// groups'.
template <class T>
void run(kernel<T> run_kernel, const operations<T>& table, const streams<T>& s, batch<T>& b) noexcept {
    if (!s.contiguous) return run_staged(run_kernel, table, s, b);
    const T** in = b.in;
    for (int i = 0; i < s.inputs; ++i)
        for (int k = 0; k < s.in[i].count; ++k) *in++ = s.in[i].stream[k];
    T** out = b.out;
    for (int i = 0; i < s.outputs; ++i)
        for (int k = 0; k < s.out[i].count; ++k) *out++ = s.out[i].stream[k];
    b.size = s.size;
    run_kernel(b);
}

}  // namespace swivel

#endif
