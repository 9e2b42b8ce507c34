#ifndef SWIVEL_KERNELS_ANGLES_SINCOS_HPP
#define SWIVEL_KERNELS_ANGLES_SINCOS_HPP

#include "kernels/constants.hpp"
#include "kernels/kernel.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/polynomial.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

// Sine and cosine of angles up to constants::largest_angle. The angle is brought to r = |x| - k pi/2 in
// [-pi/4, pi/4], with pi/2 in parts so short that their products with k are exact, all but the last. NaN
// gives NaN. MayBeTiny: whether the angle may be the root of a floor or a part of it, whose powers are subnormal; what
// comes out is the same.
template <precision_index P, bool MayBeTiny = false, class V>
inline void sincos_within(V x, V& sine, V& cosine) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V one(T(1));
    V r = magnitude(x);

    // The sum has k in its lowest bits.
    const V rounded = M::multiply_add(r, V(C::two_over_pi), V(C::round));
    const V k = rounded - V(C::round);
    if constexpr (M::fuses) {
        r = M::negate_multiply_add(k, V(C::half_pi_fused[0]), r);
        r = M::negate_multiply_add(k, V(C::half_pi_fused[1]), r);
        r = M::negate_multiply_add(k, V(C::half_pi_fused[2]), r);
    } else {
        // Exact, up to here; what the difference of the third product rounds off goes back in with the
        // fourth.
        const V rest = (r - k * V(C::half_pi_parts[0])) - k * V(C::half_pi_parts[1]);
        const V third = k * V(C::half_pi_parts[2]), reduced = rest - third;
        r = reduced + (((rest - reduced) - third) - k * V(C::half_pi_parts[3]));
    }
    const V s = MayBeTiny ? series_square(magnitude(r)) : r * r;
    const V sin_r = M::multiply_add(r * s, polynomial<M>(s, C::sin), r);
    const V cos_r =
        M::multiply_add(s * s, polynomial<M>(s, C::cos), M::negate_multiply_add(V(T(0.5)), s, one));
    const mask_of<V> odd = has_bit<0>(rounded);
    const V sign = sign_from_bit<1>(rounded);
    sine = select(odd, cos_r, sin_r) ^ sign ^ sign_of(x);
    cosine = select(odd, sin_r, cos_r) ^ sign ^ sign_from_bit<0>(rounded);
}

// Those that are larger count as 0. NaN and infinity give NaN.
template <precision_index P, bool MayBeTiny = false, class V>
inline void sincos_of(V x, V& sine, V& cosine) noexcept {
    using T = scalar_of<V>;
    const mask_of<V> beyond = magnitude(x) > V(constants<T>::largest_angle);
    sincos_within<P, MayBeTiny>(select(beyond, V(T(0)) * x, x), sine, cosine);
}

// Streams in: the angle. Out: its sine and cosine.
template <precision_index P, class V>
struct sincos_op {
    using reads = streams<1>;
    using writes = streams<1, 1>;

    explicit sincos_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept { sincos_of<P>(in[0], out[0], out[1]); }
};

}  // namespace
}  // namespace swivel

#endif
