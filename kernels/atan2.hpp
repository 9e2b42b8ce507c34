#ifndef SWIVEL_KERNELS_ATAN2_HPP
#define SWIVEL_KERNELS_ATAN2_HPP

#include "constants.hpp"
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

// The angle of the point (x, y), in [-pi, pi], for points that are not (0, 0): no libm gives the same bits on
// two systems. The quotient of the smaller by the larger coordinate is brought to at most tan(pi/8) by
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
    const mask_of<V> turned = small > V(C::tan_eighth_pi) * large;
    const V z =
        quotient(xsimd::select(turned, small - large, small), xsimd::select(turned, small + large, large));

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

}  // namespace
}  // namespace swivel

#endif
