#ifndef SWIVEL_KERNELS_SLERP_HPP
#define SWIVEL_KERNELS_SLERP_HPP

#include "atan2.hpp"
#include "interpolation.hpp"
#include "sincos.hpp"

namespace swivel {
namespace {

// Streams in: a x y z w, b x y z w, t.
//
// With p = a + b and n = b - a, which are at right angles, the way from a to b is cos(f) p/|p| + sin(f) n/|n|, f going
// from -h to h = atan2(|n|, |p|), half of the angle between them. Nothing is divided by the sine of an angle, and one
// sincos does.
template <precision_index P, bool LongWay, class V>
struct slerp_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    static constexpr int inputs = 9, quaternions_in = 2;
    static constexpr int outputs = 4, quaternions_out = 1;

    explicit slerp_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1)), floor(constants<T>::pole_floor);
        const rotor<V> a{in[0], in[1], in[2], in[3]}, given{in[4], in[5], in[6], in[7]};
        const V t = in[8];
        const V way = way_of<LongWay>(dot_of<P>(a, given));
        const rotor<V> b = scaled(given, matching_length<P>(a, given) ^ way);

        rotor<V> p{a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
        const rotor<V> n{b.x - a.x, b.y - a.y, b.z - a.z, b.w - a.w};
        // Where a and b are so near that the squares vanish, only the quotient of sin(f) and |n| matters.
        const V nn = larger(floor, dot_of<P>(n, n));
        if constexpr (LongWay) {
            // Near a full turn p is all rounding: its part along n has to go, and what remains may be nothing, when the
            // turn is about x and p stays short, since its length is the cosine of h.
            const V part = quotient(dot_of<P>(p, n), nn);
            p = {M::negate_multiply_add(part, n.x, p.x), M::negate_multiply_add(part, n.y, p.y),
                 M::negate_multiply_add(part, n.z, p.z), M::negate_multiply_add(part, n.w, p.w)};
            p = either(dot_of<P>(p, p) <= V(constants<T>::pole_threshold) * nn,
                       scaled(turned_about_x(n), V(T(-0x1p-40))), p);
        }
        const V pp = larger(floor, dot_of<P>(p, p));

        V half, along, across;
        if constexpr (P == reproducible_index) {
            const V p_root = square_root_of(pp), n_root = square_root_of(nn);
            half = atan2_of<P>(n_root, p_root);
            sincos_of<P>(M::multiply_add(t + t, half, zero - half), across, along);
            along = quotient(along, p_root);
            across = quotient(across, n_root);
        } else {
            const V p_scale = M::reciprocal_root(pp), n_scale = M::reciprocal_root(nn);
            half = atan2_of<P>(nn * n_scale, pp * p_scale);
            sincos_of<P>(M::multiply_add(t + t, half, zero - half), across, along);
            along = along * p_scale;
            across = across * n_scale;
        }
        const rotor<V> between{
            M::multiply_add(across, n.x, along * p.x), M::multiply_add(across, n.y, along * p.y),
            M::multiply_add(across, n.z, along * p.z), M::multiply_add(across, n.w, along * p.w)};
        put(with_ends<P>(between, t == zero, a, t == one, flipped(given, way)), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
