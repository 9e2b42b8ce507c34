#ifndef SWIVEL_KERNELS_REGISTERS_NEON_HPP
#define SWIVEL_KERNELS_REGISTERS_NEON_HPP

// NEON of AArch64.

#include <cstddef>

#include "kernels/registers/every_isa.hpp"
#include "kernels/registers/unmasked.hpp"

namespace swivel {
namespace {

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
// Neither was measured; it has the registers.
inline constexpr bool has_32_registers = false;
inline constexpr bool takes_twins = false;

// Against clang, as on x86 (x86.hpp).
template <class V>
inline V chosen(V a) noexcept {
#if defined(__clang__)
    asm("" : "+w"(a.data));
#endif
    return a;
}

// xsimd's float versions are Newton approximations.
template <class V>
inline V square_root_of(V choice) noexcept {
    const V a = chosen(choice);
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vsqrtq_f32(a));
    else
        return V(vsqrtq_f64(a));
}

template <class V>
inline V quotient(V a, V divisor) noexcept {
    const V b = chosen(divisor);
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vdivq_f32(a, b));
    else
        return V(vdivq_f64(a, b));
}

template <int Places, class V>
inline V shifted_left(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vreinterpretq_f32_u32(vshlq_n_u32(vreinterpretq_u32_f32(a), Places)));
    else
        return V(vreinterpretq_f64_u64(vshlq_n_u64(vreinterpretq_u64_f64(a), Places)));
}

template <int Places, class V>
inline V shifted_right(V a) noexcept {
    if constexpr (sizeof(scalar_of<V>) == 4)
        return V(vreinterpretq_f32_u32(vshrq_n_u32(vreinterpretq_u32_f32(a), Places)));
    else
        return V(vreinterpretq_f64_u64(vshrq_n_u64(vreinterpretq_u64_f64(a), Places)));
}

// The max of NEON is NaN where either is.
template <class V>
inline V larger(V a, V b) noexcept {
    return select(a > b, a, b);
}

template <class V>
inline mask_of<V> not_less_equal(V a, V b) noexcept {
    return ~(a <= b);
}

template <class V>
requires requires { typename V::arch_type; }
inline V load_first(const scalar_of<V>* from, std::size_t count) noexcept {
    using T = scalar_of<V>;
    alignas(V) T block[V::size];
    V(*from).store_aligned(block);
    for (std::size_t i = 0; i < count; ++i) block[i] = from[i];
    return V::load_aligned(block);
}

template <class V>
inline void store_first(V a, scalar_of<V>* to, std::size_t count) noexcept {
    using T = scalar_of<V>;
    alignas(V) T block[V::size];
    a.store_aligned(block);
    for (std::size_t i = 0; i < count; ++i) to[i] = block[i];
}

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

}  // namespace
}  // namespace swivel

#endif
