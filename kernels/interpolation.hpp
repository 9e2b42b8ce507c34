#ifndef SWIVEL_KERNELS_INTERPOLATION_HPP
#define SWIVEL_KERNELS_INTERPOLATION_HPP

// What slerp, nlerp and sterp share. b stands for b or -b, whichever is on the way that was asked for.

#include "constants.hpp"
#include "kernel_table.hpp"
#include "ops.hpp"

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

// The sign of b on the short way, where the product of a and b is not negative, or on the long way.
template <bool LongWay, class V>
inline V way_of(V product) noexcept {
    const V plus(scalar_of<V>(0)), minus(scalar_of<V>(-0.0));
    return xsimd::select(product < plus, LongWay ? plus : minus, LongWay ? minus : plus);
}

template <class V>
inline rotor<V> flipped(const rotor<V>& q, V sign) noexcept {
    return {q.x ^ sign, q.y ^ sign, q.z ^ sign, q.w ^ sign};
}

// i q, which is at right angles to q.
template <class V>
inline rotor<V> turned_about_x(const rotor<V>& q) noexcept {
    return {q.w, V(scalar_of<V>(0)) - q.z, q.y, V(scalar_of<V>(0)) - q.x};
}

template <class V>
inline rotor<V> either(mask_of<V> m, const rotor<V>& a, const rotor<V>& b) noexcept {
    return {xsimd::select(m, a.x, b.x), xsimd::select(m, a.y, b.y), xsimd::select(m, a.z, b.z),
            xsimd::select(m, a.w, b.w)};
}

// The factor that brings b to the length of a, without which sum and difference are not at right angles.
template <precision_index P, class V>
inline V matching_length(const rotor<V>& a, const rotor<V>& b) noexcept {
    const V aa = dot_of<P>(a, a), bb = dot_of<P>(b, b), floor(constants<scalar_of<V>>::pole_floor);
    if constexpr (P == reproducible_index)
        return square_root_of(quotient(aa, larger(floor, bb)));
    else
        return aa * arithmetic<P>::reciprocal_root(larger(floor, aa * bb));
}

template <class V>
inline rotor<V> scaled(const rotor<V>& q, V by) noexcept {
    return {q.x * by, q.y * by, q.z * by, q.w * by};
}

// Of length 1; NaN where something is not finite.
template <precision_index P, class V>
inline rotor<V> normalized(const rotor<V>& q) noexcept {
    const V zero(scalar_of<V>(0)), floor(constants<scalar_of<V>>::pole_floor);
    const V squared = dot_of<P>(q, q);
    // The quotient by an infinity would be 0.
    const V no_less = larger(floor, arithmetic<P>::multiply_add(zero, squared, squared));
    if constexpr (P == reproducible_index) {
        const V root = square_root_of(no_less);
        return {quotient(q.x, root), quotient(q.y, root), quotient(q.z, root), quotient(q.w, root)};
    } else {
        return scaled(q, arithmetic<P>::reciprocal_root(no_less));
    }
}

// In reproducible the ends themselves, with all their bits, unless the result says that something is not finite.
template <precision_index P, class V>
inline rotor<V> with_ends(const rotor<V>& between, mask_of<V> at_a, const rotor<V>& a, mask_of<V> at_b,
                          const rotor<V>& b) noexcept {
    if constexpr (P == fast_index) return between;
    const mask_of<V> regular = between.w == between.w;
    return either(regular & at_a, a, either(regular & at_b, b, between));
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
