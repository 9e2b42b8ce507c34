#ifndef SWIVEL_KERNELS_CONFORMAL_HYPERBOLIC_HPP
#define SWIVEL_KERNELS_CONFORMAL_HYPERBOLIC_HPP

#include "kernels/constants.hpp"
#include "kernels/kernel.hpp"
#include "kernels/polynomial.hpp"
#include "kernels/registers/ops.hpp"
#include "kernels/rotors/normalize.hpp"

namespace swivel {
namespace {

// The bits of a number's fraction, and what is added to its exponent.
template <class T>
inline constexpr int fraction_bits = sizeof(T) == 4 ? 23 : 52;
template <class T>
inline constexpr T exponent_bias = sizeof(T) == 4 ? T(127) : T(1023);

// Sinh and cosh of 0 <= x <= constants::largest_boost by way of m = e^x - 1 = 2^k (e^r - 1) + (2^k - 1), x =
// r + k ln 2: nothing cancels where x is small. Anything for larger x, NaN for NaN.
template <precision_index P, class V>
inline void sinhcosh_of(V x, V& sinh, V& cosh) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V one(T(1)), half(T(0.5));
    // The sum has k in its lowest bits.
    const V k = M::multiply_add(x, V(C::one_over_ln_2), V(C::round)) - V(C::round);
    const V r = M::negate_multiply_add(k, V(C::ln_2_rest), M::negate_multiply_add(k, V(C::ln_2), x));
    const V power = shifted_left<fraction_bits<T>>(k + V(C::round + exponent_bias<T>));
    const V small = M::multiply_add(r * r, polynomial<M>(r, C::expm1), r);
    const V m = M::multiply_add(small, power, power - one), part = quotient(m, m + one);
    sinh = half * (m + part);
    cosh = M::multiply_add(half * m, part, one);
}

// For 0 <= x: log(1 + t) with t = x + (sqrt(1 + x^2) - 1), 1 + t = 2^k (1 + f) / (1 - f).
template <precision_index P, class V>
inline V asinh_of(V x) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V zero(T(0)), one(T(1)), two(T(2));
    const V square = x * x, t = x + quotient(square, one + square_root_of(square + one)), sum = one + t;
    const V power = (sum * V(C::sqrt_2)) & V(C::infinity);
    // The number whose fraction is the exponent.
    constexpr T first_number = sizeof(T) == 4 ? T(0x1p23) : T(0x1p52);
    const V first(first_number);
    const V k = (shifted_right<fraction_bits<T>>(power) | first) - V(first_number + exponent_bias<T>);
    const V brought = M::multiply_add(sum, V(T(0.5)) * reciprocal_power_of_two(power), V(T(-1)));
    const V rest = select(k == zero, t, brought);
    const V f = quotient(rest, rest + two), s = series_square(magnitude(f));
    const V tail = M::multiply_add(k, V(C::ln_2_rest), f + f);
    return M::multiply_add(k, V(C::ln_2), M::multiply_add(f * s, polynomial<M>(s, C::log), tail));
}

}  // namespace
}  // namespace swivel

#endif
