#ifndef SWIVEL_KERNELS_ROTORS_MULTIPLY_HPP
#define SWIVEL_KERNELS_ROTORS_MULTIPLY_HPP

#include "kernels/quat.hpp"

namespace swivel {
namespace {

// The Hamilton product l r, NaN where anything in it is NaN or infinite. multiply runs the kernel of compose
// without signs.
template <precision_index P, class V>
inline void product_of(const rotor<V>& l, const rotor<V>& r, V* out) noexcept {
    using M = arithmetic<P>;
    const rotor<V> product = hamilton<P>(l, r);
    out[0] = nan_for_infinity<M>(product.x);
    out[1] = nan_for_infinity<M>(product.y);
    out[2] = nan_for_infinity<M>(product.z);
    out[3] = nan_for_infinity<M>(product.w);
}

}  // namespace
}  // namespace swivel

#endif
