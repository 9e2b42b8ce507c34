#ifndef SWIVEL_SRC_CALL_RUN_HPP
#define SWIVEL_SRC_CALL_RUN_HPP

#include "src/call/active_kernels.hpp"
#include "src/call/checks.hpp"

namespace swivel {

// Runs the kernel over checked streams of any stride, a block at a time by way of the stack where they are
// not contiguous.
template <class T>
void run_any(kernel<T> run_kernel, const call_streams<T>& s, batch<T>& b) noexcept;

// The call that is not the usual one.
template <class T, class Numbers, class... In, class... Out>
[[gnu::noinline]] status run_checked(kernel<T> run_kernel, const Numbers& set_numbers,
                                     const std::tuple<In...>& reads,
                                     const std::tuple<Out...>& writes) noexcept {
    batch<T> b;
    call_streams<T> s(reads, writes);
    if (const status bad = check(s); bad != status::ok || s.size == 0) return bad;
    if (const status bad = set_numbers(b); bad != status::ok) return bad;
    run_any(run_kernel, s, b);
    return status::ok;
}

template <class P, class T, int N>
[[gnu::always_inline]] inline void put(P*& to, const stream_group<T, N>& g) noexcept {
    for (int k = 0; k < N; ++k) to[g.place[k]] = g.stream[k];
    to += N;
}

// Of a group that is an array, where it is.
template <class U, int N>
void put_array(quaternion_array<U>*& to, const stream_group<U, N>& g) noexcept {
    to->first = nullptr;
    if constexpr (N == 4) {
        if (is_array(g)) {
            const bool w_first = g.stream[3] < g.stream[0];
            to->first = g.stream[w_first ? 3 : 0];
            for (int k = 0; k < 4; ++k) to->place[w_first ? (k + 1) % 4 : k] = g.place[k];
        }
    }
    ++to;
}

// One call of an operation: checks the streams, then lets set_numbers(batch) check the numbers and fill them
// in, then runs the kernel. Nothing is written unless all is right.
template <class T, class Numbers, class... In, class... Out>
[[gnu::always_inline]] inline status run(kernel<T> run_kernel, const Numbers& set_numbers,
                                         const std::tuple<In...>& reads,
                                         const std::tuple<Out...>& writes) noexcept {
    usual_call<T> call(std::get<0>(reads).size);
    std::apply(
        [&](const auto&... g) __attribute__((always_inline)) { (call.read(g), ...); }, reads);
    std::apply(
        [&](const auto&... g) __attribute__((always_inline)) { (call.write(g, reads), ...); }, writes);
    if (!call) [[unlikely]]
        return run_checked(run_kernel, set_numbers, reads, writes);
    batch<T> b;
    if (const status bad = set_numbers(b); bad != status::ok) return bad;
    const T** in = b.in;
    T** out = b.out;
    std::apply(
        [&](const auto&... g) __attribute__((always_inline)) { (put(in, g), ...); }, reads);
    std::apply(
        [&](const auto&... g) __attribute__((always_inline)) { (put(out, g), ...); }, writes);
    b.size = std::get<0>(reads).size;
    b.has_arrays = call.has_arrays();
    if (b.has_arrays) {
        quaternion_array<const T>* in_array = b.in_array;
        quaternion_array<T>* out_array = b.out_array;
        std::apply([&](const auto&... g) { (put_array(in_array, g), ...); }, reads);
        std::apply([&](const auto&... g) { (put_array(out_array, g), ...); }, writes);
    }
    run_kernel(b);
    return status::ok;
}

}  // namespace swivel

#endif
