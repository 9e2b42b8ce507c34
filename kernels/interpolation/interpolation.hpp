#ifndef SWIVEL_KERNELS_INTERPOLATION_INTERPOLATION_HPP
#define SWIVEL_KERNELS_INTERPOLATION_INTERPOLATION_HPP

// What slerp, nlerp and sterp share. b stands for b or -b, whichever is on the way that was asked for.

#include "kernels/constants.hpp"
#include "kernels/quat.hpp"

namespace swivel {
namespace {

// The sign of b on the short way, where the product of a and b is not negative, or on the long way.
template <bool LongWay, class V>
inline V way_of(V product) noexcept {
    const V plus(scalar_of<V>(0)), minus(scalar_of<V>(-0.0));
    return select(product < plus, LongWay ? plus : minus, LongWay ? minus : plus);
}

// i q, which is at right angles to q.
template <class V>
inline rotor<V> turned_about_x(const rotor<V>& q) noexcept {
    return {q.w, V(scalar_of<V>(0)) - q.z, q.y, V(scalar_of<V>(0)) - q.x};
}

// |a| / |b| from their squares: the factor that brings b to the length of a.
template <precision_index P, class V>
inline V ratio_of_lengths(V aa, V bb) noexcept {
    using C = constants<scalar_of<V>>;
    // The product of the squares is good as far as it is normal.
    if constexpr (P == reproducible_index)
        return square_root_of(quotient(aa, larger(V(C::pole_floor), bb)));
    else
        return aa * arithmetic<P>::reciprocal_root(larger(V(C::smallest_normal), aa * bb));
}

// In reproducible the ends themselves, with all their bits, unless the result says that something is not
// finite.
template <precision_index P, class V>
inline rotor<V> with_ends(const rotor<V>& between, mask_of<V> at_a, const rotor<V>& a, mask_of<V> at_b,
                          const rotor<V>& b) noexcept {
    if constexpr (P == fast_index) return between;
    const mask_of<V> regular = between.w == between.w;
    return either(regular & at_a, a, either(regular & at_b, b, between));
}

}  // namespace
}  // namespace swivel

#endif
