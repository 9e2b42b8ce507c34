#ifndef SWIVEL_KERNELS_INTERPOLATION_SLERP_HPP
#define SWIVEL_KERNELS_INTERPOLATION_SLERP_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/interpolation/interpolation.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// Streams in: a x y z w, b x y z w, t.
//
// With p = a + b and n = b - a, which are at right angles, the way from a to b is cos(f) p/|p| + sin(f)
// n/|n|, f going from -h to h = atan(|n| / |p|), half of the angle between them. Nothing is divided by the
// sine of an angle, and one sincos does.
template <precision_index P, bool LongWay, class V>
struct slerp_op {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    using reads = streams<4, 4, 1>;
    using writes = streams<4>;

    explicit slerp_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1));
        const rotor<V> a{in[0], in[1], in[2], in[3]}, b{in[4], in[5], in[6], in[7]};
        const V t = in[8];
        const V product = dot_of<P>(a, b), aa = dot_of<P>(a, a), way = way_of<LongWay>(product);
        const V ratio = ratio_of_lengths<P>(aa, dot_of<P>(b, b));
        rotor<V> between;
        if constexpr (LongWay)
            long_way(a, scaled(b, ratio ^ way), t, between);
        else
            short_way(a, b, magnitude(product) * ratio, aa, ratio ^ way, t, between);
        put(with_ends<P>(between, t == zero, a, t == one, flipped(b, way)), out);
    }

    // scale brings b to the length of a and on the way; product is then that of a and b.
    static void short_way(const rotor<V>& a, const rotor<V>& b, V product, V aa, V scale, V t,
                          rotor<V>& between) noexcept {
        const rotor<V> n{M::negate_multiply_add(scale, b.x, a.x), M::negate_multiply_add(scale, b.y, a.y),
                         M::negate_multiply_add(scale, b.z, a.z), M::negate_multiply_add(scale, b.w, a.w)};
        V along, across;
        // |p|^2 is at least 2 |a|^2: nothing is lost by taking it from the products.
        weights<false>((aa + aa) + (product + product), dot_of<P>(n, n), t, along, across);
        const V of_a = along - across, of_b = (along + across) * scale;
        between = {M::multiply_add(of_b, b.x, of_a * a.x), M::multiply_add(of_b, b.y, of_a * a.y),
                   M::multiply_add(of_b, b.z, of_a * a.z), M::multiply_add(of_b, b.w, of_a * a.w)};
    }

    // Near a full turn p is all rounding: its part along n has to go, and what remains may be nothing, when
    // the turn is about x and p stays short, since its length is the cosine of h.
    static void long_way(const rotor<V>& a, const rotor<V>& b, V t, rotor<V>& between) noexcept {
        const rotor<V> n{b.x - a.x, b.y - a.y, b.z - a.z, b.w - a.w};
        rotor<V> p{a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
        const V nn = dot_of<P>(n, n), part = quotient(dot_of<P>(p, n), larger(V(C::pole_floor), nn));
        p = {M::negate_multiply_add(part, n.x, p.x), M::negate_multiply_add(part, n.y, p.y),
             M::negate_multiply_add(part, n.z, p.z), M::negate_multiply_add(part, n.w, p.w)};
        // So short that the tangent vanishes beside pi/2.
        const rotor<V> about_x = scaled(turned_about_x(n), V(C::rounding * T(-0x1p-8)));
        p = either(dot_of<P>(p, p) <= V(C::pole_threshold) * nn, about_x, p);
        V along, across;
        weights<true>(dot_of<P>(p, p), nn, t, along, across);
        between = {M::multiply_add(across, n.x, along * p.x), M::multiply_add(across, n.y, along * p.y),
                   M::multiply_add(across, n.z, along * p.z), M::multiply_add(across, n.w, along * p.w)};
    }

    // cos(f)/|p| and sin(f)/|n|. Where a and b are so near that the squares vanish, only the quotient of
    // sin(f) and |n| matters.
    template <bool PIsShorter>
    static void weights(V pp, V nn, V t, V& along, V& across) noexcept {
        const V turn = M::multiply_add(t, V(T(2)), V(T(-1)));
        // Of a p that is short beside short quaternions the length itself counts.
        pp = larger(V(PIsShorter ? C::smallest_normal : C::pole_floor), pp);
        nn = larger(V(C::pole_floor), nn);
        if constexpr (P == reproducible_index) {
            const V p = square_root_of(pp), n = square_root_of(nn);
            sincos_of<P, true>(turn * half_angle<PIsShorter>(PIsShorter ? quotient(p, n) : quotient(n, p)),
                               across, along);
            along = quotient(along, p);
            across = quotient(across, n);
        } else {
            const V p = M::reciprocal_root(pp), n = M::reciprocal_root(nn);
            sincos_of<P, true>(turn * half_angle<PIsShorter>(PIsShorter ? pp * p * n : nn * n * p), across,
                               along);
            along = along * p;
            across = across * n;
        }
    }

    template <bool PIsShorter>
    static V half_angle(V tangent_or_inverse) noexcept {
        const V angle = atan_of<P>(tangent_or_inverse);
        return PIsShorter ? V(C::half_pi) + (V(C::half_pi_rest) - angle) : angle;
    }
};

}  // namespace
}  // namespace swivel

#endif
