#ifndef SWIVEL_KERNELS_ANGLES_ATAN2_HPP
#define SWIVEL_KERNELS_ANGLES_ATAN2_HPP

#include "kernels/constants.hpp"
#include "kernels/kernel.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/polynomial.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

// For |z| <= 1.
template <precision_index P, class V>
inline V atan_of(V z) noexcept {
    using M = arithmetic<P>;
    const V s = series_square(magnitude(z));
    return M::multiply_add(z * s, polynomial<M>(s, constants<scalar_of<V>>::atan), z);
}

// The angle of the point (x, y), y >= 0, in [0, pi]; (0, 0) counts as (+-1, 0). It is k pi/2 plus or minus
// that of the quotient of the smaller by the larger coordinate, with k pi/2 in two parts of which the first
// is exact.
template <precision_index P, class V>
inline V atan2_above(V y, V x) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V zero(T(0)), one(T(1));
    const V ax = magnitude(x);
    const mask_of<V> steep = y > ax;
    const V small = select(steep, ax, y);
    const V large = select(steep, y, ax);
    const mask_of<V> left = one_signed_like(x) < zero;
    const V quarters = select(steep, one, select(left, V(T(2)), zero));

    // The angle of the quotient is odd: its sign is that of z.
    const V minus(T(-0.0));
    V z = quotient(small, select(large == zero, one, large));
    const V s = series_square(z);
    z = z ^ select(steep, minus, zero) ^ select(left, minus, zero);
    // The smallest first: each sum rounds once, and the last one not at all where the angle is small.
    const V bend = M::multiply_add(z * s, polynomial<M>(s, C::atan), quarters * V(C::half_pi_rest));
    return M::multiply_add(quarters, V(C::half_pi), z + bend);
}

// In [-pi, pi], of any point. No libm gives the same bits on two systems.
template <precision_index P, class V>
inline V atan2_of(V y, V x) noexcept {
    return atan2_above<P>(magnitude(y), x) ^ sign_of(y);
}

// The same of a point at that distance from (0, 0), without a comparison of its coordinates: twice the angle
// at half the way, whose tangent is y / (distance + |x|).
template <precision_index P, class V>
inline V angle_of(V y, V x, V distance) noexcept {
    using T = scalar_of<V>;
    const V half = atan_of<P>(quotient(y, distance + magnitude(x)));
    const V right = half + half;
    const mask_of<V> left = one_signed_like(x) < V(T(0));
    return select(left, (V(constants<T>::pi) ^ sign_of(y)) - right, right);
}

// Streams in: y x. Out: the angle.
template <precision_index P, class V>
struct atan2_op {
    using M = arithmetic<P>;
    using reads = streams<1, 1>;
    using writes = streams<1>;

    explicit atan2_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(scalar_of<V>(0));
        // An infinity would be a limit; here it is an element that is wrong.
        const V poison = zero * in[0] + zero * in[1];
        const V angle = atan2_of<P>(in[0], in[1]);
        out[0] = select(poison == zero, angle, poison);
    }
};

}  // namespace
}  // namespace swivel

#endif
