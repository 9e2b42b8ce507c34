#ifndef SWIVEL_KERNELS_REGISTERS_X86_128_HPP
#define SWIVEL_KERNELS_REGISTERS_X86_128_HPP

// SSE2.

#include <cstddef>

#include "kernels/registers/every_isa.hpp"
#include "kernels/registers/unmasked.hpp"
#include "kernels/registers/x86.hpp"

namespace swivel {
namespace {

using architecture = xsimd::sse2;
inline __m128 rsqrt_estimate(__m128 t) noexcept { return _mm_rsqrt_ps(t); }
inline constexpr bool has_fma = false;
inline constexpr bool has_32_registers = false;
// Not measured.
inline constexpr bool takes_twins = false;
// There is no estimate for double, and one by way of float has neither the range nor, after the steps that it
// needs, the speed of a square root and a division.
template <class T>
inline constexpr int newton_steps = sizeof(T) == 4 ? 1 : -1;
// After one step from an estimate of 11 bits the root is too small by up to 3 units of 2^-24, never too
// large; this adds 1.
template <class T>
inline constexpr T newton_one = sizeof(T) == 4 ? T(1 + 0x1p-23) : T(1);

template <int Places, class V>
inline V shifted_left(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm_castsi128_ps(_mm_slli_epi32(_mm_castps_si128(a), Places)));
    else
        return V(_mm_castsi128_pd(_mm_slli_epi64(_mm_castpd_si128(a), Places)));
}

template <int Places, class V>
inline V shifted_right(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm_castsi128_ps(_mm_srli_epi32(_mm_castps_si128(a), Places)));
    else
        return V(_mm_castsi128_pd(_mm_srli_epi64(_mm_castpd_si128(a), Places)));
}

template <class V>
inline V larger(V a, V b) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm_max_ps(a, b));
    else
        return V(_mm_max_pd(a, b));
}

template <class V>
inline mask_of<V> not_less_equal(V a, V b) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm_cmpnle_ps(a, b));
    else
        return mask_of<V>(_mm_cmpnle_pd(a, b));
}

template <class V>
requires requires { typename V::arch_type; }
inline V load_first(const scalar_of<V>* from, std::size_t count) noexcept {
    using T = scalar_of<V>;
    const V first(*from);
    if constexpr (sizeof(T) == 8) {
        return V(_mm_loadl_pd(first, from));
    } else {
        if (count == 1) return V(_mm_move_ss(first, _mm_load_ss(from)));
        const __m128 two = _mm_loadl_pi(first, reinterpret_cast<const __m64*>(from));
        return count == 2 ? V(two) : V(_mm_movelh_ps(two, _mm_move_ss(first, _mm_load_ss(from + 2))));
    }
}

template <class V>
inline void store_first(V a, scalar_of<V>* to, std::size_t count) noexcept {
    using T = scalar_of<V>;
    if constexpr (sizeof(T) == 8) {
        _mm_storel_pd(to, a);
    } else {
        if (count == 1) return _mm_store_ss(to, a);
        _mm_storel_pi(reinterpret_cast<__m64*>(to), a);
        if (count == 3) _mm_store_ss(to + 2, _mm_movehl_ps(a, a));
    }
}

inline void transpose(const __m128 (&r)[4], __m128 (&c)[4]) noexcept {
    const __m128 low01 = _mm_unpacklo_ps(r[0], r[1]), low23 = _mm_unpacklo_ps(r[2], r[3]);
    const __m128 high01 = _mm_unpackhi_ps(r[0], r[1]), high23 = _mm_unpackhi_ps(r[2], r[3]);
    c[0] = _mm_movelh_ps(low01, low23);
    c[1] = _mm_movehl_ps(low23, low01);
    c[2] = _mm_movelh_ps(high01, high23);
    c[3] = _mm_movehl_ps(high23, high01);
}
template <class A>
inline void load_quaternions(const float* from, xsimd::batch<float, A>* c) noexcept {
    __m128 t[4];
    transpose({_mm_loadu_ps(from), _mm_loadu_ps(from + 4), _mm_loadu_ps(from + 8), _mm_loadu_ps(from + 12)},
              t);
    for (int k = 0; k < 4; ++k) c[k] = t[k];
}
template <class A>
inline void store_quaternions(const xsimd::batch<float, A>* c, float* to) noexcept {
    __m128 t[4];
    transpose({c[0], c[1], c[2], c[3]}, t);
    for (int k = 0; k < 4; ++k) _mm_storeu_ps(to + 4 * k, t[k]);
}
template <class A>
inline void load_quaternions(const double* from, xsimd::batch<double, A>* c) noexcept {
    for (int k = 0; k < 4; k += 2) {
        const __m128d r0 = _mm_loadu_pd(from + k), r1 = _mm_loadu_pd(from + 4 + k);
        c[k] = _mm_unpacklo_pd(r0, r1);
        c[k + 1] = _mm_unpackhi_pd(r0, r1);
    }
}
template <class A>
inline void store_quaternions(const xsimd::batch<double, A>* c, double* to) noexcept {
    for (int k = 0; k < 4; k += 2) {
        _mm_storeu_pd(to + k, _mm_unpacklo_pd(c[k], c[k + 1]));
        _mm_storeu_pd(to + 4 + k, _mm_unpackhi_pd(c[k], c[k + 1]));
    }
}

}  // namespace
}  // namespace swivel

#endif
