#ifndef SWIVEL_KERNELS_POLYNOMIAL_HPP
#define SWIVEL_KERNELS_POLYNOMIAL_HPP

#include "kernels/constants.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

// c[K] + c[K + Step] x + ..., by Horner's rule, without a loop that could be left rolled up.
template <class M, std::size_t K, std::size_t Step, class V, std::size_t N>
inline V horner(V x, const scalar_of<V> (&c)[N]) noexcept {
    if constexpr (K + Step >= N)
        return V(c[K]);
    else
        return M::multiply_add(horner<M, K + Step, Step>(x, c), x, V(c[K]));
}

// c[0] + c[1] x + ...; the long ones as two chains that do not wait for each other, but for the first two
// coefficients: even and odd part alone are larger than their sum, and so are their roundings.
template <class M, class V, std::size_t N>
inline V polynomial(V x, const scalar_of<V> (&c)[N]) noexcept {
    if constexpr (N < 5) {
        return horner<M, 0, 1>(x, c);
    } else {
        const V xx = x * x;
        const V rest = M::multiply_add(horner<M, 3, 2>(xx, c), x, horner<M, 2, 2>(xx, c));
        return M::multiply_add(M::multiply_add(rest, x, V(c[1])), x, V(c[0]));
    }
}

// x^2 for a series in x >= 0.
template <class V>
inline V series_square(V x) noexcept {
    const V no_less = larger(V(constants<scalar_of<V>>::negligible), x);
    return no_less * no_less;
}

}  // namespace
}  // namespace swivel

#endif
