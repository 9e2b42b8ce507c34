#include <cstring>
#include <utility>

#include "peers.hpp"

namespace swivel_bench {

namespace {

// By the compilers' vector type, since neither vectorises a loop over so many streams that may overlap.
template <class T>
struct vector_of {
    typedef T type __attribute__((vector_size(64), aligned(1), may_alias));
};

template <class V, class T, int inputs>
V value(const T* const (&from)[inputs], std::size_t i, int stream, int outputs) noexcept {
    V sum = *reinterpret_cast<const V*>(from[stream % inputs] + i);
    for (int k = stream + outputs; k < inputs; k += outputs) sum += *reinterpret_cast<const V*>(from[k] + i);
    return sum;
}

template <class T, int inputs, int outputs, std::size_t... I, std::size_t... O>
void one_pass(const T* const (&in)[inputs], T* const (&out)[outputs], std::size_t n,
              std::index_sequence<I...>, std::index_sequence<O...>) noexcept {
    using vector = typename vector_of<T>::type;
    constexpr std::size_t width = 64 / sizeof(T);
    const T* const from[] = {in[I]...};
    T* const to[] = {out[O]...};
    std::size_t i = 0;
    for (; i + width <= n; i += width)
        ((*reinterpret_cast<vector*>(to[O] + i) = value<vector>(from, i, static_cast<int>(O), outputs)), ...);
    for (; i < n; ++i) ((to[O][i] = value<T>(from, i, static_cast<int>(O), outputs)), ...);
}

}  // namespace

template <class T, int inputs, int outputs>
void copy(const T* const (&in)[inputs], T* const (&out)[outputs], std::size_t n) noexcept {
    one_pass(in, out, n, std::make_index_sequence<inputs>(), std::make_index_sequence<outputs>());
}

template <class T, int inputs, int outputs>
void copy_by_memcpy(const T* const (&in)[inputs], T* const (&out)[outputs], std::size_t n) noexcept {
    static_assert(inputs <= outputs);
    for (int k = 0; k < outputs; ++k) std::memcpy(out[k], in[k % inputs], n * sizeof(T));
}

template void copy(const float* const (&)[4], float* const (&)[8], std::size_t) noexcept;
template void copy(const double* const (&)[4], double* const (&)[8], std::size_t) noexcept;
template void copy(const float* const (&)[7], float* const (&)[8], std::size_t) noexcept;
template void copy(const double* const (&)[7], double* const (&)[8], std::size_t) noexcept;
template void copy(const float* const (&)[4], float* const (&)[5], std::size_t) noexcept;
template void copy(const double* const (&)[4], double* const (&)[5], std::size_t) noexcept;
template void copy(const float* const (&)[4], float* const (&)[4], std::size_t) noexcept;
template void copy(const double* const (&)[4], double* const (&)[4], std::size_t) noexcept;
template void copy(const float* const (&)[4], float* const (&)[1], std::size_t) noexcept;
template void copy(const double* const (&)[4], double* const (&)[1], std::size_t) noexcept;
template void copy(const float* const (&)[8], float* const (&)[4], std::size_t) noexcept;
template void copy(const double* const (&)[8], double* const (&)[4], std::size_t) noexcept;
template void copy(const float* const (&)[5], float* const (&)[4], std::size_t) noexcept;
template void copy(const double* const (&)[5], double* const (&)[4], std::size_t) noexcept;
template void copy(const float* const (&)[1], float* const (&)[2], std::size_t) noexcept;
template void copy(const double* const (&)[1], double* const (&)[2], std::size_t) noexcept;
template void copy(const float* const (&)[1], float* const (&)[1], std::size_t) noexcept;
template void copy(const double* const (&)[1], double* const (&)[1], std::size_t) noexcept;
template void copy(const float* const (&)[2], float* const (&)[1], std::size_t) noexcept;
template void copy(const double* const (&)[2], double* const (&)[1], std::size_t) noexcept;
template void copy(const float* const (&)[7], float* const (&)[3], std::size_t) noexcept;
template void copy(const double* const (&)[7], double* const (&)[3], std::size_t) noexcept;
template void copy(const float* const (&)[3], float* const (&)[3], std::size_t) noexcept;
template void copy(const double* const (&)[3], double* const (&)[3], std::size_t) noexcept;
template void copy(const float* const (&)[6], float* const (&)[4], std::size_t) noexcept;
template void copy(const double* const (&)[6], double* const (&)[4], std::size_t) noexcept;
template void copy(const float* const (&)[9], float* const (&)[4], std::size_t) noexcept;
template void copy(const double* const (&)[9], double* const (&)[4], std::size_t) noexcept;
template void copy(const float* const (&)[4], float* const (&)[9], std::size_t) noexcept;
template void copy(const double* const (&)[4], double* const (&)[9], std::size_t) noexcept;

template void copy_by_memcpy(const float* const (&)[4], float* const (&)[8], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[4], double* const (&)[8], std::size_t) noexcept;
template void copy_by_memcpy(const float* const (&)[7], float* const (&)[8], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[7], double* const (&)[8], std::size_t) noexcept;
template void copy_by_memcpy(const float* const (&)[4], float* const (&)[5], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[4], double* const (&)[5], std::size_t) noexcept;
template void copy_by_memcpy(const float* const (&)[4], float* const (&)[4], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[4], double* const (&)[4], std::size_t) noexcept;
template void copy_by_memcpy(const float* const (&)[1], float* const (&)[2], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[1], double* const (&)[2], std::size_t) noexcept;
template void copy_by_memcpy(const float* const (&)[4], float* const (&)[9], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[4], double* const (&)[9], std::size_t) noexcept;
template void copy_by_memcpy(const float* const (&)[1], float* const (&)[1], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[1], double* const (&)[1], std::size_t) noexcept;
template void copy_by_memcpy(const float* const (&)[3], float* const (&)[3], std::size_t) noexcept;
template void copy_by_memcpy(const double* const (&)[3], double* const (&)[3], std::size_t) noexcept;

}  // namespace swivel_bench
