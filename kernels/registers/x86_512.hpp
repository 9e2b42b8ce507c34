#ifndef SWIVEL_KERNELS_REGISTERS_X86_512_HPP
#define SWIVEL_KERNELS_REGISTERS_X86_512_HPP

// AVX-512: F, CD, DQ, BW and VL.

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "kernels/registers/every_isa.hpp"
#include "kernels/registers/x86.hpp"

namespace swivel {
namespace {

using architecture = xsimd::avx512bw;
// xsimd 8.1.0 does not fuse here, and has no rsqrt.
inline __m512 fused(__m512 a, __m512 b, __m512 c) noexcept { return _mm512_fmadd_ps(a, b, c); }
inline __m512d fused(__m512d a, __m512d b, __m512d c) noexcept { return _mm512_fmadd_pd(a, b, c); }
inline __m512 fused_negative(__m512 a, __m512 b, __m512 c) noexcept { return _mm512_fnmadd_ps(a, b, c); }
inline __m512d fused_negative(__m512d a, __m512d b, __m512d c) noexcept { return _mm512_fnmadd_pd(a, b, c); }
inline __m512 rsqrt_estimate(__m512 t) noexcept { return _mm512_rsqrt14_ps(t); }
inline __m512d rsqrt_estimate(__m512d t) noexcept { return _mm512_rsqrt14_pd(t); }
inline constexpr bool has_fma = true;
inline constexpr bool has_32_registers = true;
inline constexpr bool takes_twins = true;
template <class T>
inline constexpr int newton_steps = sizeof(T) == 4 ? 1 : 2;
template <class T>
inline constexpr T newton_one = 1;

template <int Places, class V>
inline V shifted_left(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_castsi512_ps(_mm512_slli_epi32(_mm512_castps_si512(a), Places)));
    else
        return V(_mm512_castsi512_pd(_mm512_slli_epi64(_mm512_castpd_si512(a), Places)));
}

template <int Places, class V>
inline V shifted_right(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_castsi512_ps(_mm512_srli_epi32(_mm512_castps_si512(a), Places)));
    else
        return V(_mm512_castsi512_pd(_mm512_srli_epi64(_mm512_castpd_si512(a), Places)));
}

template <class V>
inline V larger(V a, V b) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_max_ps(a, b));
    else
        return V(_mm512_max_pd(a, b));
}

template <class V>
inline mask_of<V> not_less_equal(V a, V b) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm512_cmp_ps_mask(a, b, _CMP_NLE_UQ));
    else
        return mask_of<V>(_mm512_cmp_pd_mask(a, b, _CMP_NLE_UQ));
}

template <class V>
inline V one_signed_like(V a) noexcept {
    // gcc 12 does not merge the two operations. The truth table is that of (a & b) | c.
    constexpr int and_or = 0xea;
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_castsi512_ps(_mm512_ternarylogic_epi32(
            _mm512_castps_si512(a), _mm512_castps_si512(V(-0.0F)), _mm512_castps_si512(V(1.0F)), and_or)));
    else
        return V(_mm512_castsi512_pd(_mm512_ternarylogic_epi64(
            _mm512_castpd_si512(a), _mm512_castpd_si512(V(-0.0)), _mm512_castpd_si512(V(1.0)), and_or)));
}

template <int Bit, class V>
inline mask_of<V> has_bit(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm512_test_epi32_mask(_mm512_castps_si512(a), _mm512_set1_epi32(1 << Bit)));
    else
        return mask_of<V>(_mm512_test_epi64_mask(_mm512_castpd_si512(a), _mm512_set1_epi64(1LL << Bit)));
}

template <class V>
inline V product_or(mask_of<V> m, V a, V b, V other) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_mask_mul_ps(other, m, a, b));
    else
        return V(_mm512_mask_mul_pd(other, m, a, b));
}

template <class V>
inline V product_or_zero(mask_of<V> m, V a, V b) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_maskz_mul_ps(m, a, b));
    else
        return V(_mm512_maskz_mul_pd(m, a, b));
}

template <class V>
requires requires { typename V::arch_type; }
inline V load_first(const scalar_of<V>* from, std::size_t count) noexcept {
    using T = scalar_of<V>;
    if constexpr (sizeof(T) == 4)
        return V(_mm512_mask_loadu_ps(V(*from), static_cast<__mmask16>((1U << count) - 1U), from));
    else
        return V(_mm512_mask_loadu_pd(V(*from), static_cast<__mmask8>((1U << count) - 1U), from));
}

template <class V>
inline void store_first(V a, scalar_of<V>* to, std::size_t count) noexcept {
    using T = scalar_of<V>;
    if constexpr (sizeof(T) == 4)
        _mm512_mask_storeu_ps(to, static_cast<__mmask16>((1U << count) - 1U), a);
    else
        _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1U << count) - 1U), a);
}

// The order of the components is in the indices of the shuffles, at no cost.
template <class V>
class quaternion_shuffle {
    using T = scalar_of<V>;
    using index = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    static constexpr int half = static_cast<int>(V::size) / 2, quarter = half / 2;

    static __m512 pick(__m512 a, __m512i i, __m512 b) noexcept { return _mm512_permutex2var_ps(a, i, b); }
    static __m512d pick(__m512d a, __m512i i, __m512d b) noexcept { return _mm512_permutex2var_pd(a, i, b); }
    template <int Lanes>
    static __m512 lanes(__m512 a, __m512 b) noexcept {
        return _mm512_shuffle_f32x4(a, b, Lanes);
    }
    template <int Lanes>
    static __m512d lanes(__m512d a, __m512d b) noexcept {
        return _mm512_shuffle_f64x2(a, b, Lanes);
    }

    static __m512i sum(__m512i a, __m512i b) noexcept {
        return sizeof(T) == 4 ? _mm512_add_epi32(a, b) : _mm512_add_epi64(a, b);
    }
    // a in the lower half, b in the upper one.
    static __m512i halves_of(std::ptrdiff_t a, std::ptrdiff_t b) noexcept {
        if constexpr (sizeof(T) == 4)
            return _mm512_mask_set1_epi32(_mm512_set1_epi32(static_cast<int>(a)), 0xff00,
                                          static_cast<int>(b));
        else
            return _mm512_mask_set1_epi64(_mm512_set1_epi64(a), 0xf0, b);
    }
    // 0, 4, 8 ... in either half.
    static __m512i every_fourth() noexcept {
        if constexpr (sizeof(T) == 4)
            return _mm512_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28, 0, 4, 8, 12, 16, 20, 24, 28);
        else
            return _mm512_setr_epi64(0, 4, 8, 12, 0, 4, 8, 12);
    }
    // Four numbers below 4, in a byte each, times half a register, for every quaternion; and its number.
    static __m512i quaternions_of(int bytes) noexcept {
        const __m128i four = _mm_cvtsi32_si128(bytes);
        if constexpr (sizeof(T) == 4)
            return sum(_mm512_slli_epi32(_mm512_broadcast_i32x4(_mm_cvtepu8_epi32(four)), 3),
                       _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3));
        else
            return sum(_mm512_slli_epi64(_mm512_broadcast_i64x4(_mm256_cvtepu8_epi64(four)), 2),
                       _mm512_setr_epi64(0, 0, 0, 0, 1, 1, 1, 1));
    }

    __m512i first_two_, last_two_, low_, high_;

public:
    // In registers alone: indices
    // that were just stored one by one could not be loaded as a vector before they have reached the cache.
    void set(const std::ptrdiff_t* slot) noexcept {
        first_two_ = sum(every_fourth(), halves_of(slot[0], slot[1]));
        last_two_ = sum(every_fourth(), halves_of(slot[2], slot[3]));
        low_ = quaternions_of((1 << (8 * slot[1])) | (2 << (8 * slot[2])) | (3 << (8 * slot[3])));
        high_ = sum(low_, halves_of(quarter, quarter));
    }

    void load(const T* from, V* c) const noexcept {
        const auto r0 = V::load_unaligned(from), r1 = V::load_unaligned(from + V::size);
        const auto r2 = V::load_unaligned(from + 2 * V::size), r3 = V::load_unaligned(from + 3 * V::size);
        const auto first01 = pick(r0, first_two_, r1), first23 = pick(r2, first_two_, r3);
        const auto last01 = pick(r0, last_two_, r1), last23 = pick(r2, last_two_, r3);
        c[0] = lanes<0x44>(first01, first23);
        c[1] = lanes<0xee>(first01, first23);
        c[2] = lanes<0x44>(last01, last23);
        c[3] = lanes<0xee>(last01, last23);
    }

    void store(const V* c, T* to) const noexcept {
        const auto low01 = lanes<0x44>(c[0], c[1]), high01 = lanes<0xee>(c[0], c[1]);
        const auto low23 = lanes<0x44>(c[2], c[3]), high23 = lanes<0xee>(c[2], c[3]);
        V(pick(low01, low_, low23)).store_unaligned(to);
        V(pick(low01, high_, low23)).store_unaligned(to + V::size);
        V(pick(high01, low_, high23)).store_unaligned(to + 2 * V::size);
        V(pick(high01, high_, high23)).store_unaligned(to + 3 * V::size);
    }
};

}  // namespace
}  // namespace swivel

#endif
