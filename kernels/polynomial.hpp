#ifndef SWIVEL_KERNELS_POLYNOMIAL_HPP
#define SWIVEL_KERNELS_POLYNOMIAL_HPP

#include "ops.hpp"

namespace swivel {
namespace {

// c[K] + c[K + 1] x + ..., by Horner's rule, without a loop that could be left rolled up.
template <class M, std::size_t K = 0, class V, std::size_t N>
inline V polynomial(V x, const scalar_of<V> (&c)[N]) noexcept {
    if constexpr (K + 1 == N)
        return V(c[K]);
    else
        return M::multiply_add(polynomial<M, K + 1>(x, c), x, V(c[K]));
}

}  // namespace
}  // namespace swivel

#endif
