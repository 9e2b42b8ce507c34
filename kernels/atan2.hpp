#ifndef SWIVEL_KERNELS_ATAN2_HPP
#define SWIVEL_KERNELS_ATAN2_HPP

#include "constants.hpp"
#include "kernel_table.hpp"
#include "ops.hpp"
#include "polynomial.hpp"

namespace swivel {
namespace {

// The angle of the point (x, y), in [-pi, pi]; (0, 0) counts as (+-1, 0): no libm gives the same bits on two systems. The quotient of the smaller by the larger coordinate is brought to at most 1/2 by
// turning the point back by pi/4, so that a short polynomial serves; the angle is then k pi/4 plus or minus
// its value, with k pi/4 in two parts of which the first is exact.
template <precision_index P, class V>
inline V atan2_of(V y, V x) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V zero(T(0)), one(T(1));
    const V ax = magnitude(x), ay = magnitude(y);
    const mask_of<V> steep = ay > ax;
    const V small = xsimd::select(steep, ax, ay);
    const V large = xsimd::select(steep, ay, ax);
    const mask_of<V> turned = small > V(T(0.5)) * large;
    const V divisor = xsimd::select(turned, small + large, large);
    const V z =
        quotient(xsimd::select(turned, small - large, small), xsimd::select(divisor == zero, one, divisor));

    const V s = z * z;
    V rest = M::multiply_add(z * s, polynomial<M>(s, C::atan), z);

    V eighths = xsimd::select(turned, one, zero);
    eighths = xsimd::select(steep, V(T(2)) - eighths, eighths);
    rest = xsimd::select(steep, zero - rest, rest);
    const mask_of<V> left = one_signed_like(x) < zero;
    eighths = xsimd::select(left, V(T(4)) - eighths, eighths);
    rest = xsimd::select(left, zero - rest, rest);

    const V angle = eighths * V(C::quarter_pi) + M::multiply_add(eighths, V(C::quarter_pi_rest), rest);
    return angle ^ sign_of(y);
}

// Streams in: y x. Out: the angle.
template <precision_index P, class V>
struct atan2_op {
    using M = arithmetic<P>;
    static constexpr int inputs = 2, quaternions_in = 0;
    static constexpr int outputs = 1, quaternions_out = 0;

    explicit atan2_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(scalar_of<V>(0));
        // An infinity would be a limit; here it is an element that is wrong.
        const V poison = zero * in[0] + zero * in[1];
        const V angle = atan2_of<P>(in[0], in[1]);
        out[0] = xsimd::select(poison == zero, angle, poison);
    }
};

}  // namespace
}  // namespace swivel

#endif
