#ifndef SWIVEL_KERNELS_REGISTERS_X86_256_HPP
#define SWIVEL_KERNELS_REGISTERS_X86_256_HPP

// AVX2 with FMA.

#include <cstddef>

#include "kernels/registers/every_isa.hpp"
#include "kernels/registers/unmasked.hpp"
#include "kernels/registers/x86.hpp"

namespace swivel {
namespace {

using architecture = xsimd::fma3<xsimd::avx2>;
inline __m256 fused(__m256 a, __m256 b, __m256 c) noexcept { return _mm256_fmadd_ps(a, b, c); }
inline __m256d fused(__m256d a, __m256d b, __m256d c) noexcept { return _mm256_fmadd_pd(a, b, c); }
inline __m256 fused_negative(__m256 a, __m256 b, __m256 c) noexcept { return _mm256_fnmadd_ps(a, b, c); }
inline __m256d fused_negative(__m256d a, __m256d b, __m256d c) noexcept { return _mm256_fnmadd_pd(a, b, c); }
inline __m256 rsqrt_estimate(__m256 t) noexcept { return _mm256_rsqrt_ps(t); }
inline constexpr bool has_fma = true;
inline constexpr bool has_32_registers = false;
// With sixteen registers some values go by way of the stack, and still most operations gain.
inline constexpr bool takes_twins = true;
// As of SSE (x86_128.hpp).
template <class T>
inline constexpr int newton_steps = sizeof(T) == 4 ? 1 : -1;
template <class T>
inline constexpr T newton_one = sizeof(T) == 4 ? T(1 + 0x1p-23) : T(1);

template <int Places, class V>
inline V shifted_left(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm256_castsi256_ps(_mm256_slli_epi32(_mm256_castps_si256(a), Places)));
    else
        return V(_mm256_castsi256_pd(_mm256_slli_epi64(_mm256_castpd_si256(a), Places)));
}

template <int Places, class V>
inline V shifted_right(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm256_castsi256_ps(_mm256_srli_epi32(_mm256_castps_si256(a), Places)));
    else
        return V(_mm256_castsi256_pd(_mm256_srli_epi64(_mm256_castpd_si256(a), Places)));
}

template <class V>
inline V larger(V a, V b) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm256_max_ps(a, b));
    else
        return V(_mm256_max_pd(a, b));
}

template <class V>
inline mask_of<V> not_less_equal(V a, V b) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm256_cmp_ps(a, b, _CMP_NLE_UQ));
    else
        return mask_of<V>(_mm256_cmp_pd(a, b, _CMP_NLE_UQ));
}

inline __m256i first_lanes_32(std::size_t count) noexcept {
    return _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(count)),
                              _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
}
inline __m256i first_lanes_64(std::size_t count) noexcept {
    return _mm256_cmpgt_epi64(_mm256_set1_epi64x(static_cast<long long>(count)),
                              _mm256_setr_epi64x(0, 1, 2, 3));
}

template <class V>
requires requires { typename V::arch_type; }
inline V load_first(const scalar_of<V>* from, std::size_t count) noexcept {
    using T = scalar_of<V>;
    if constexpr (sizeof(T) == 4) {
        const __m256i lanes = first_lanes_32(count);
        return V(_mm256_blendv_ps(V(*from), _mm256_maskload_ps(from, lanes), _mm256_castsi256_ps(lanes)));
    } else {
        const __m256i lanes = first_lanes_64(count);
        return V(_mm256_blendv_pd(V(*from), _mm256_maskload_pd(from, lanes), _mm256_castsi256_pd(lanes)));
    }
}

template <class V>
inline void store_first(V a, scalar_of<V>* to, std::size_t count) noexcept {
    using T = scalar_of<V>;
    if constexpr (sizeof(T) == 4)
        _mm256_maskstore_ps(to, first_lanes_32(count), a);
    else
        _mm256_maskstore_pd(to, first_lanes_64(count), a);
}

// Halves that are four quaternions apart, so that shuffles within the halves leave the components in order.
inline __m256 halves(const float* low, const float* high) noexcept {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
}
inline void store_halves(__m256 a, float* low, float* high) noexcept {
    _mm_storeu_ps(low, _mm256_castps256_ps128(a));
    _mm_storeu_ps(high, _mm256_extractf128_ps(a, 1));
}
template <class A>
inline void load_quaternions(const float* from, xsimd::batch<float, A>* c) noexcept {
    const __m256 r0 = halves(from, from + 16), r1 = halves(from + 4, from + 20);
    const __m256 r2 = halves(from + 8, from + 24), r3 = halves(from + 12, from + 28);
    const __m256 low01 = _mm256_unpacklo_ps(r0, r1), low23 = _mm256_unpacklo_ps(r2, r3);
    const __m256 high01 = _mm256_unpackhi_ps(r0, r1), high23 = _mm256_unpackhi_ps(r2, r3);
    c[0] = _mm256_shuffle_ps(low01, low23, 0x44);
    c[1] = _mm256_shuffle_ps(low01, low23, 0xee);
    c[2] = _mm256_shuffle_ps(high01, high23, 0x44);
    c[3] = _mm256_shuffle_ps(high01, high23, 0xee);
}
template <class A>
inline void store_quaternions(const xsimd::batch<float, A>* c, float* to) noexcept {
    const __m256 low01 = _mm256_unpacklo_ps(c[0], c[1]), low23 = _mm256_unpacklo_ps(c[2], c[3]);
    const __m256 high01 = _mm256_unpackhi_ps(c[0], c[1]), high23 = _mm256_unpackhi_ps(c[2], c[3]);
    store_halves(_mm256_shuffle_ps(low01, low23, 0x44), to, to + 16);
    store_halves(_mm256_shuffle_ps(low01, low23, 0xee), to + 4, to + 20);
    store_halves(_mm256_shuffle_ps(high01, high23, 0x44), to + 8, to + 24);
    store_halves(_mm256_shuffle_ps(high01, high23, 0xee), to + 12, to + 28);
}
inline void transpose(const __m256d (&r)[4], __m256d (&c)[4]) noexcept {
    const __m256d low01 = _mm256_unpacklo_pd(r[0], r[1]), low23 = _mm256_unpacklo_pd(r[2], r[3]);
    const __m256d high01 = _mm256_unpackhi_pd(r[0], r[1]), high23 = _mm256_unpackhi_pd(r[2], r[3]);
    c[0] = _mm256_permute2f128_pd(low01, low23, 0x20);
    c[1] = _mm256_permute2f128_pd(high01, high23, 0x20);
    c[2] = _mm256_permute2f128_pd(low01, low23, 0x31);
    c[3] = _mm256_permute2f128_pd(high01, high23, 0x31);
}
template <class A>
inline void load_quaternions(const double* from, xsimd::batch<double, A>* c) noexcept {
    __m256d t[4];
    transpose({_mm256_loadu_pd(from), _mm256_loadu_pd(from + 4), _mm256_loadu_pd(from + 8),
               _mm256_loadu_pd(from + 12)},
              t);
    for (int k = 0; k < 4; ++k) c[k] = t[k];
}
template <class A>
inline void store_quaternions(const xsimd::batch<double, A>* c, double* to) noexcept {
    __m256d t[4];
    transpose({c[0], c[1], c[2], c[3]}, t);
    for (int k = 0; k < 4; ++k) _mm256_storeu_pd(to + 4 * k, t[k]);
}

}  // namespace
}  // namespace swivel

#endif
