#ifndef SWIVEL_KERNELS_REGISTERS_OPS_HPP
#define SWIVEL_KERNELS_REGISTERS_OPS_HPP

// What the kernels need from a vector register. The differences between ISAs, and between xsimd releases, end in
// this folder, the only one with intrinsics.
//
// SWIVEL_KERNEL_REGISTERS is the header of the registers of SWIVEL_KERNEL_ISA, by the row of the ISA in
// tools/cmake/isa.cmake. For V, the xsimd::batch of float or double of its architecture, it has:
//
//   architecture                 that of xsimd
//   has_32_registers             whether there are registers enough to work on three elements' worth of streams at
//                                a time
//   takes_twins                  whether two registers at a time are quicker where each step waits for the one
//                                before (twin.hpp)
//   has_fma                      whether there are fused(a, b, c), a b + c, and fused_negative(a, b, c), c - a b, each
//                                rounded once
//   rsqrt_estimate(t)            1 / sqrt(t), roughly
//   newton_steps<T>              how many steps of Newton it takes from there to full precision; -1: there is no
//                                estimate for T
//   newton_one<T>                the 1 of those steps, and what keeps the root from being too small
//   square_root_of(a)            correctly rounded
//   quotient(a, b)               correctly rounded
//   larger(a, b)                 the larger one; b where either is NaN
//   not_less_equal(a, b)         not (a <= b): true where either is NaN
//   one_signed_like(a)           1 with the sign of a
//   has_bit<Bit>(a)              whether that bit is set: that of 1, 2, 4 ...
//   shifted_left<Places>(a)      the bits of every number moved to higher places
//   shifted_right<Places>(a)     to lower places, with zeros behind them
//   product_or(m, a, b, other)   m ? a b : other
//   product_or_zero(m, a, b)     m ? a b : 0
//   load_first<V>(from, count)   the first `count` lanes, of which there are some but not all, from memory; the first
//                                of them in the others, a value like the rest: a number of no meaning might take a
//                                slow way through a kernel
//   store_first(a, to, count)    those lanes, and nothing else, to memory
//   quaternion_shuffle<V>        V::size quaternions between an array and one register for each component:
//     set(slot)                  slot[k] is the place in a quaternion in memory of the component in register k
//     load(from, c), store(c, to)

#include <cstddef>
#include <utility>

#include "kernels/kernel.hpp"
#include "kernels/registers/every_isa.hpp"
#include SWIVEL_KERNEL_REGISTERS

namespace swivel {
namespace {

// That bit as the sign of 0.
template <int Bit, class V>
inline V sign_from_bit(V a) noexcept {
    return sign_of(shifted_left<static_cast<int>(8 * sizeof(scalar_of<V>)) - 1 - Bit>(a));
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

}  // namespace
}  // namespace swivel

#endif
