#ifndef SWIVEL_KERNELS_INTERPOLATION_NLERP_HPP
#define SWIVEL_KERNELS_INTERPOLATION_NLERP_HPP

#include "kernels/interpolation/interpolation.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// Streams in: a x y z w, b x y z w, t. Uniform: the sign bit for the long way.
template <precision_index P, class V>
struct nlerp_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<4, 4, 1>;
    using writes = streams<4>;

    V long_way;

    explicit nlerp_op(const T* uniform) noexcept : long_way(uniform[0]) {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1));
        const rotor<V> a{in[0], in[1], in[2], in[3]}, given{in[4], in[5], in[6], in[7]};
        const V t = in[8], s = one - t;
        const V way = way_of<false>(dot_of<P>(a, given)) ^ long_way;
        const rotor<V> b = scaled(given, ratio_of_lengths<P>(dot_of<P>(a, a), dot_of<P>(given, given)) ^ way);

        rotor<V> m{M::multiply_add(t, b.x, s * a.x), M::multiply_add(t, b.y, s * a.y),
                   M::multiply_add(t, b.z, s * a.z), M::multiply_add(t, b.w, s * a.w)};
        const V mm = dot_of<P>(m, m);
        // A chord through the middle has no direction there.
        const mask_of<V> nothing = mm <= V(constants<T>::pole_threshold) * dot_of<P>(a, a);
        const rotor<V> between =
            normalized<P>(either(nothing, turned_about_x(a), m), V(constants<T>::smallest_normal));
        put(with_ends<P>(between, t == zero, a, t == one, flipped(given, way)), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
