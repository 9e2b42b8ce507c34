#ifndef SWIVEL_KERNELS_REGISTERS_OPS_HPP
#define SWIVEL_KERNELS_REGISTERS_OPS_HPP

// What the kernels need from a vector register, and the only file with intrinsics: the differences between
// ISAs, and between xsimd releases, end here. Everything is in the unnamed namespace, since an inline
// function that two ISAs shared by name could be kept by the linker with the instructions of the wrong one.

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <xsimd/xsimd.hpp>

namespace swivel {
namespace {

template <class V>
using scalar_of = typename V::value_type;

template <class V>
using mask_of = typename V::batch_bool_type;

// Whether there are registers enough to work on three elements' worth of streams at a time. (NEON has them
// too; it was not measured there.)
#if defined(__AVX512F__)
inline constexpr bool has_32_registers = true;
#else
inline constexpr bool has_32_registers = false;
#endif

// Whether two registers at a time are quicker where each step waits for the one before (twin.hpp). With sixteen
// registers some values go by way of the stack, and still most operations gain. (SSE and NEON were not measured.)
#if defined(__AVX2__)
inline constexpr bool takes_twins = true;
#else
inline constexpr bool takes_twins = false;
#endif

#if defined(__AVX512F__)

using architecture = xsimd::avx512bw;
// xsimd 8.1.0 does not fuse here, and has no rsqrt.
inline __m512 fused(__m512 a, __m512 b, __m512 c) noexcept { return _mm512_fmadd_ps(a, b, c); }
inline __m512d fused(__m512d a, __m512d b, __m512d c) noexcept { return _mm512_fmadd_pd(a, b, c); }
inline __m512 fused_negative(__m512 a, __m512 b, __m512 c) noexcept { return _mm512_fnmadd_ps(a, b, c); }
inline __m512d fused_negative(__m512d a, __m512d b, __m512d c) noexcept { return _mm512_fnmadd_pd(a, b, c); }
inline __m512 rsqrt_estimate(__m512 t) noexcept { return _mm512_rsqrt14_ps(t); }
inline __m512d rsqrt_estimate(__m512d t) noexcept { return _mm512_rsqrt14_pd(t); }
inline constexpr bool has_fma = true;
template <class T>
inline constexpr int newton_steps = sizeof(T) == 4 ? 1 : 2;
template <class T>
inline constexpr T newton_one = 1;

#elif defined(__SSE2__)

#if defined(__AVX2__)
using architecture = xsimd::fma3<xsimd::avx2>;
inline __m256 fused(__m256 a, __m256 b, __m256 c) noexcept { return _mm256_fmadd_ps(a, b, c); }
inline __m256d fused(__m256d a, __m256d b, __m256d c) noexcept { return _mm256_fmadd_pd(a, b, c); }
inline __m256 fused_negative(__m256 a, __m256 b, __m256 c) noexcept { return _mm256_fnmadd_ps(a, b, c); }
inline __m256d fused_negative(__m256d a, __m256d b, __m256d c) noexcept { return _mm256_fnmadd_pd(a, b, c); }
inline __m256 rsqrt_estimate(__m256 t) noexcept { return _mm256_rsqrt_ps(t); }
inline constexpr bool has_fma = true;
#else
using architecture = xsimd::sse2;
inline __m128 rsqrt_estimate(__m128 t) noexcept { return _mm_rsqrt_ps(t); }
inline constexpr bool has_fma = false;
#endif
// There is no estimate for double, and one by way of float has neither the range nor, after the steps that it
// needs, the speed of a square root and a division.
template <class T>
inline constexpr int newton_steps = sizeof(T) == 4 ? 1 : -1;
// After one step from an estimate of 11 bits the root is too small by up to 3 units of 2^-24, never too
// large; this adds 1.
template <class T>
inline constexpr T newton_one = sizeof(T) == 4 ? T(1 + 0x1p-23) : T(1);

#elif defined(__aarch64__)

using architecture = xsimd::neon64;
inline float32x4_t fused(float32x4_t a, float32x4_t b, float32x4_t c) noexcept { return vfmaq_f32(c, a, b); }
inline float64x2_t fused(float64x2_t a, float64x2_t b, float64x2_t c) noexcept { return vfmaq_f64(c, a, b); }
inline float32x4_t fused_negative(float32x4_t a, float32x4_t b, float32x4_t c) noexcept {
    return vfmsq_f32(c, a, b);
}
inline float64x2_t fused_negative(float64x2_t a, float64x2_t b, float64x2_t c) noexcept {
    return vfmsq_f64(c, a, b);
}
inline float32x4_t rsqrt_estimate(float32x4_t t) noexcept { return vrsqrteq_f32(t); }
inline float64x2_t rsqrt_estimate(float64x2_t t) noexcept { return vrsqrteq_f64(t); }
inline constexpr bool has_fma = true;
// The estimate has only 8 bits.
template <class T>
inline constexpr int newton_steps = sizeof(T) == 4 ? 2 : 3;
template <class T>
inline constexpr T newton_one = 1;

#endif

// Where the operand of a root or a divisor is a choice of which nothing but one side is used, clang, for which no
// exception flag counts, takes the root or the quotient of the other. Not of what it cannot see through.
template <class V>
inline V chosen(V a) noexcept {
#if defined(__clang__) && defined(__aarch64__)
    asm("" : "+w"(a.data));
#elif defined(__clang__)
    asm("" : "+x"(a.data));
#endif
    return a;
}

// Correctly rounded on every ISA: xsimd's float versions for NEON are Newton approximations.
template <class V>
inline V square_root_of(V choice) noexcept {
    const V a = chosen(choice);
#if defined(__aarch64__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vsqrtq_f32(a));
    else
        return V(vsqrtq_f64(a));
#else
    return xsimd::sqrt(a);
#endif
}

template <class V>
inline V quotient(V a, V divisor) noexcept {
    const V b = chosen(divisor);
#if defined(__aarch64__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vdivq_f32(a, b));
    else
        return V(vdivq_f64(a, b));
#else
    return a / b;
#endif
}

template <class V>
inline V sign_of(V a) noexcept {
    return a & V(scalar_of<V>(-0.0));
}

template <class V>
inline V magnitude(V a) noexcept {
    // Not bitwise_andnot: releases of xsimd disagree on which operand it inverts.
    return a & ~V(scalar_of<V>(-0.0));
}

// 1 with the sign of a.
template <class V>
inline V one_signed_like(V a) noexcept {
#if defined(__AVX512F__)
    // gcc 12 does not merge the two operations. The truth table is that of (a & b) | c.
    constexpr int and_or = 0xea;
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_castsi512_ps(_mm512_ternarylogic_epi32(
            _mm512_castps_si512(a), _mm512_castps_si512(V(-0.0F)), _mm512_castps_si512(V(1.0F)), and_or)));
    else
        return V(_mm512_castsi512_pd(_mm512_ternarylogic_epi64(
            _mm512_castpd_si512(a), _mm512_castpd_si512(V(-0.0)), _mm512_castpd_si512(V(1.0)), and_or)));
#else
    return sign_of(a) | V(scalar_of<V>(1));
#endif
}

// Whether that bit is set: that of 1, 2, 4 ...
template <int Bit, class V>
inline mask_of<V> has_bit(V a) noexcept {
#if defined(__AVX512F__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm512_test_epi32_mask(_mm512_castps_si512(a), _mm512_set1_epi32(1 << Bit)));
    else
        return mask_of<V>(_mm512_test_epi64_mask(_mm512_castpd_si512(a), _mm512_set1_epi64(1LL << Bit)));
#else
    using T = scalar_of<V>;
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    // Beside the bits of 1, since a comparison may take a number as small as that bit alone for 0.
    const V one(T(1)), bit(__builtin_bit_cast(T, static_cast<bits>(bits{1} << Bit)));
    return ((a & bit) | one) > one;
#endif
}

// The bits of every number moved to higher places.
template <int Places, class V>
inline V shifted_left(V a) noexcept {
#if defined(__AVX512F__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_castsi512_ps(_mm512_slli_epi32(_mm512_castps_si512(a), Places)));
    else
        return V(_mm512_castsi512_pd(_mm512_slli_epi64(_mm512_castpd_si512(a), Places)));
#elif defined(__AVX2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm256_castsi256_ps(_mm256_slli_epi32(_mm256_castps_si256(a), Places)));
    else
        return V(_mm256_castsi256_pd(_mm256_slli_epi64(_mm256_castpd_si256(a), Places)));
#elif defined(__SSE2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm_castsi128_ps(_mm_slli_epi32(_mm_castps_si128(a), Places)));
    else
        return V(_mm_castsi128_pd(_mm_slli_epi64(_mm_castpd_si128(a), Places)));
#else
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vreinterpretq_f32_u32(vshlq_n_u32(vreinterpretq_u32_f32(a), Places)));
    else
        return V(vreinterpretq_f64_u64(vshlq_n_u64(vreinterpretq_u64_f64(a), Places)));
#endif
}

// To lower places, with zeros behind them.
template <int Places, class V>
inline V shifted_right(V a) noexcept {
#if defined(__AVX512F__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_castsi512_ps(_mm512_srli_epi32(_mm512_castps_si512(a), Places)));
    else
        return V(_mm512_castsi512_pd(_mm512_srli_epi64(_mm512_castpd_si512(a), Places)));
#elif defined(__AVX2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm256_castsi256_ps(_mm256_srli_epi32(_mm256_castps_si256(a), Places)));
    else
        return V(_mm256_castsi256_pd(_mm256_srli_epi64(_mm256_castpd_si256(a), Places)));
#elif defined(__SSE2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm_castsi128_ps(_mm_srli_epi32(_mm_castps_si128(a), Places)));
    else
        return V(_mm_castsi128_pd(_mm_srli_epi64(_mm_castpd_si128(a), Places)));
#else
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vreinterpretq_f32_u32(vshrq_n_u32(vreinterpretq_u32_f32(a), Places)));
    else
        return V(vreinterpretq_f64_u64(vshrq_n_u64(vreinterpretq_u64_f64(a), Places)));
#endif
}

// That bit as the sign of 0.
template <int Bit, class V>
inline V sign_from_bit(V a) noexcept {
    return sign_of(shifted_left<static_cast<int>(8 * sizeof(scalar_of<V>)) - 1 - Bit>(a));
}

// The larger one; b where either is NaN. The max of x86 does just that, that of NEON does not.
template <class V>
inline V larger(V a, V b) noexcept {
#if defined(__AVX512F__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_max_ps(a, b));
    else
        return V(_mm512_max_pd(a, b));
#elif defined(__AVX2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm256_max_ps(a, b));
    else
        return V(_mm256_max_pd(a, b));
#elif defined(__SSE2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm_max_ps(a, b));
    else
        return V(_mm_max_pd(a, b));
#else
    return select(a > b, a, b);
#endif
}

// not (a <= b): true where either is NaN.
template <class V>
inline mask_of<V> not_less_equal(V a, V b) noexcept {
#if defined(__AVX512F__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm512_cmp_ps_mask(a, b, _CMP_NLE_UQ));
    else
        return mask_of<V>(_mm512_cmp_pd_mask(a, b, _CMP_NLE_UQ));
#elif defined(__AVX2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm256_cmp_ps(a, b, _CMP_NLE_UQ));
    else
        return mask_of<V>(_mm256_cmp_pd(a, b, _CMP_NLE_UQ));
#elif defined(__SSE2__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return mask_of<V>(_mm_cmpnle_ps(a, b));
    else
        return mask_of<V>(_mm_cmpnle_pd(a, b));
#else
    return ~(a <= b);
#endif
}

// m ? a b : other
template <class V>
inline V product_or(mask_of<V> m, V a, V b, V other) noexcept {
#if defined(__AVX512F__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_mask_mul_ps(other, m, a, b));
    else
        return V(_mm512_mask_mul_pd(other, m, a, b));
#else
    return select(m, a * b, other);
#endif
}

// m ? a b : 0
template <class V>
inline V product_or_zero(mask_of<V> m, V a, V b) noexcept {
#if defined(__AVX512F__)
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(_mm512_maskz_mul_ps(m, a, b));
    else
        return V(_mm512_maskz_mul_pd(m, a, b));
#else
    return select(m, a * b, V(scalar_of<V>(0)));
#endif
}

// Arithmetic of one precision: the formulas are written once over these names.
template <precision_index P>
struct arithmetic {
    static constexpr bool fuses = P == fast_index && has_fma;

    // a b + c
    template <class V>
    static V multiply_add(V a, V b, V c) noexcept {
        if constexpr (fuses)
            return V(fused(a, b, c));
        else
            return a * b + c;
    }

    // c - a b
    template <class V>
    static V negate_multiply_add(V a, V b, V c) noexcept {
        if constexpr (fuses)
            return V(fused_negative(a, b, c));
        else
            return c - a * b;
    }

    // 1 / sqrt(t) for t in the normal range, NaN for NaN; anything for the rest, which callers mask.
    template <class V>
    static V reciprocal_root(V t) noexcept {
        using T = scalar_of<V>;
        if constexpr (P == reproducible_index || newton_steps<T> < 0) {
            return quotient(V(T(1)), square_root_of(t));
        } else {
            V y(rsqrt_estimate(t));
            for (int step = 0; step < newton_steps<T>; ++step) {
                const V residual = negate_multiply_add(t * y, y, V(newton_one<T>));
                y = multiply_add(V(T(0.5)) * y, residual, y);
            }
            return y;
        }
    }
};

// Adds NaN where a is infinite, so that an infinity does not leave as one.
template <class M, class V>
inline V nan_for_infinity(V a) noexcept {
    return M::multiply_add(V(scalar_of<V>(0)), a, a);
}

// 0, or NaN where one of the N numbers is not finite.
template <int N, class V>
inline V zero_or_nan(const V* numbers) noexcept {
    V sum(scalar_of<V>(0));
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((sum = V(scalar_of<V>(0)) * numbers[K] + sum), ...);
    }
    (std::make_integer_sequence<int, N>());
    return sum;
}

#if defined(__AVX2__) && !defined(__AVX512F__)
inline __m256i first_lanes_32(std::size_t count) noexcept {
    return _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(count)),
                              _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
}
inline __m256i first_lanes_64(std::size_t count) noexcept {
    return _mm256_cmpgt_epi64(_mm256_set1_epi64x(static_cast<long long>(count)),
                              _mm256_setr_epi64x(0, 1, 2, 3));
}
#endif

// The first `count` lanes, of which there are some but not all, from memory; the first of them in the
// others, a value like the rest: a number of no meaning might take a slow way through a kernel.
template <class V>
requires requires { typename V::arch_type; }
inline V load_first(const scalar_of<V>* from, std::size_t count) noexcept {
    using T = scalar_of<V>;
#if defined(__AVX512F__)
    if constexpr (sizeof(T) == 4)
        return V(_mm512_mask_loadu_ps(V(*from), static_cast<__mmask16>((1U << count) - 1U), from));
    else
        return V(_mm512_mask_loadu_pd(V(*from), static_cast<__mmask8>((1U << count) - 1U), from));
#elif defined(__AVX2__)
    if constexpr (sizeof(T) == 4) {
        const __m256i lanes = first_lanes_32(count);
        return V(_mm256_blendv_ps(V(*from), _mm256_maskload_ps(from, lanes), _mm256_castsi256_ps(lanes)));
    } else {
        const __m256i lanes = first_lanes_64(count);
        return V(_mm256_blendv_pd(V(*from), _mm256_maskload_pd(from, lanes), _mm256_castsi256_pd(lanes)));
    }
#elif defined(__SSE2__)
    const V first(*from);
    if constexpr (sizeof(T) == 8) {
        return V(_mm_loadl_pd(first, from));
    } else {
        if (count == 1) return V(_mm_move_ss(first, _mm_load_ss(from)));
        const __m128 two = _mm_loadl_pi(first, reinterpret_cast<const __m64*>(from));
        return count == 2 ? V(two) : V(_mm_movelh_ps(two, _mm_move_ss(first, _mm_load_ss(from + 2))));
    }
#else
    alignas(V) T block[V::size];
    V(*from).store_aligned(block);
    for (std::size_t i = 0; i < count; ++i) block[i] = from[i];
    return V::load_aligned(block);
#endif
}

template <class V>
inline void store_first(V a, scalar_of<V>* to, std::size_t count) noexcept {
    using T = scalar_of<V>;
#if defined(__AVX512F__)
    if constexpr (sizeof(T) == 4)
        _mm512_mask_storeu_ps(to, static_cast<__mmask16>((1U << count) - 1U), a);
    else
        _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1U << count) - 1U), a);
#elif defined(__AVX2__)
    if constexpr (sizeof(T) == 4)
        _mm256_maskstore_ps(to, first_lanes_32(count), a);
    else
        _mm256_maskstore_pd(to, first_lanes_64(count), a);
#elif defined(__SSE2__)
    if constexpr (sizeof(T) == 8) {
        _mm_storel_pd(to, a);
    } else {
        if (count == 1) return _mm_store_ss(to, a);
        _mm_storel_pi(reinterpret_cast<__m64*>(to), a);
        if (count == 3) _mm_store_ss(to + 2, _mm_movehl_ps(a, a));
    }
#else
    alignas(V) T block[V::size];
    a.store_aligned(block);
    for (std::size_t i = 0; i < count; ++i) to[i] = block[i];
#endif
}

// V::size quaternions between an array and one register for each component.
#if defined(__AVX512F__)

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
    // slot[k] is the place in a quaternion in memory of the component in register k. In registers alone: indices
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

#elif defined(__AVX2__)

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

#elif defined(__SSE2__)

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

#elif defined(__aarch64__)

template <class A>
inline void load_quaternions(const float* from, xsimd::batch<float, A>* c) noexcept {
    const float32x4x4_t r = vld4q_f32(from);
    for (int k = 0; k < 4; ++k) c[k] = r.val[k];
}
template <class A>
inline void store_quaternions(const xsimd::batch<float, A>* c, float* to) noexcept {
    vst4q_f32(to, float32x4x4_t{{c[0], c[1], c[2], c[3]}});
}
template <class A>
inline void load_quaternions(const double* from, xsimd::batch<double, A>* c) noexcept {
    const float64x2x4_t r = vld4q_f64(from);
    for (int k = 0; k < 4; ++k) c[k] = r.val[k];
}
template <class A>
inline void store_quaternions(const xsimd::batch<double, A>* c, double* to) noexcept {
    vst4q_f64(to, float64x2x4_t{{c[0], c[1], c[2], c[3]}});
}

#endif

#if !defined(__AVX512F__)

// Components in another order than that of memory pass through the stack; the processor forwards them without
// waiting for memory.
template <class V>
class quaternion_shuffle {
    using T = scalar_of<V>;

    int place_[4];
    bool as_it_is_;

public:
    // slot[k] is the place in a quaternion in memory of the component in register k.
    void set(const std::ptrdiff_t* slot) noexcept {
        as_it_is_ = true;
        for (int k = 0; k < 4; ++k) {
            place_[slot[k]] = k;
            as_it_is_ = as_it_is_ && slot[k] == k;
        }
    }

    void load(const T* from, V* c) const noexcept {
        load_quaternions(from, c);
        if (as_it_is_) return;
        alignas(V) T slot[4][V::size];
        c[0].store_aligned(slot[place_[0]]);
        c[1].store_aligned(slot[place_[1]]);
        c[2].store_aligned(slot[place_[2]]);
        c[3].store_aligned(slot[place_[3]]);
        c[0] = V::load_aligned(slot[0]);
        c[1] = V::load_aligned(slot[1]);
        c[2] = V::load_aligned(slot[2]);
        c[3] = V::load_aligned(slot[3]);
    }

    void store(const V* c, T* to) const noexcept {
        if (as_it_is_) return store_quaternions(c, to);
        alignas(V) T slot[4][V::size];
        c[0].store_aligned(slot[0]);
        c[1].store_aligned(slot[1]);
        c[2].store_aligned(slot[2]);
        c[3].store_aligned(slot[3]);
        const V m[4] = {V::load_aligned(slot[place_[0]]), V::load_aligned(slot[place_[1]]),
                        V::load_aligned(slot[place_[2]]), V::load_aligned(slot[place_[3]])};
        store_quaternions(m, to);
    }
};

#endif

}  // namespace
}  // namespace swivel

#endif
