#ifndef SWIVEL_KERNELS_QUAT_HPP
#define SWIVEL_KERNELS_QUAT_HPP

// Quaternions in registers, and what several operations do with them. An infinity may come out as one.

#include "kernels/constants.hpp"
#include "kernels/kernel.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

template <class V>
struct rotor {
    V x, y, z, w;
};

template <precision_index P, class V>
inline V dot_of(const rotor<V>& a, const rotor<V>& b) noexcept {
    using M = arithmetic<P>;
    return M::multiply_add(a.w, b.w, M::multiply_add(a.z, b.z, M::multiply_add(a.y, b.y, a.x * b.x)));
}

// The Hamilton product l r.
template <precision_index P, class V>
inline rotor<V> hamilton(const rotor<V>& l, const rotor<V>& r) noexcept {
    using M = arithmetic<P>;
    const auto component = [](V first, V a, V b, V c, V d, V e, V f) {
        return M::negate_multiply_add(e, f, M::multiply_add(c, d, M::multiply_add(a, b, first)));
    };
    return {component(l.w * r.x, l.x, r.w, l.y, r.z, l.z, r.y),
            component(l.w * r.y, l.y, r.w, l.z, r.x, l.x, r.z),
            component(l.w * r.z, l.z, r.w, l.x, r.y, l.y, r.x),
            M::negate_multiply_add(
                l.z, r.z, M::negate_multiply_add(l.y, r.y, M::negate_multiply_add(l.x, r.x, l.w * r.w)))};
}

template <class V>
inline rotor<V> reversed(const rotor<V>& q) noexcept {
    const V minus(scalar_of<V>(-0.0));
    return {q.x ^ minus, q.y ^ minus, q.z ^ minus, q.w};
}

template <class V>
inline rotor<V> flipped(const rotor<V>& q, V sign) noexcept {
    return {q.x ^ sign, q.y ^ sign, q.z ^ sign, q.w ^ sign};
}

template <class V>
inline rotor<V> either(mask_of<V> m, const rotor<V>& a, const rotor<V>& b) noexcept {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z), select(m, a.w, b.w)};
}

template <class V>
inline rotor<V> scaled(const rotor<V>& q, V by) noexcept {
    return {q.x * by, q.y * by, q.z * by, q.w * by};
}

// Of length 1, if the square of its length is at least that; NaN where something is not finite.
template <precision_index P, class V>
inline rotor<V> normalized(const rotor<V>& q, V least = V(constants<scalar_of<V>>::pole_floor)) noexcept {
    // The quotient by an infinity would be 0.
    const V no_less = larger(least, nan_for_infinity<arithmetic<P>>(dot_of<P>(q, q)));
    if constexpr (P == reproducible_index) {
        const V root = square_root_of(no_less);
        return {quotient(q.x, root), quotient(q.y, root), quotient(q.z, root), quotient(q.w, root)};
    } else {
        return scaled(q, arithmetic<P>::reciprocal_root(no_less));
    }
}

template <class V>
inline void put(const rotor<V>& q, V* out) noexcept {
    out[0] = q.x;
    out[1] = q.y;
    out[2] = q.z;
    out[3] = q.w;
}

}  // namespace
}  // namespace swivel

#endif
