#ifndef SWIVEL_KERNELS_NLERP_HPP
#define SWIVEL_KERNELS_NLERP_HPP

#include "interpolation.hpp"

namespace swivel {
namespace {

// Streams in: a x y z w, b x y z w, t.
template <precision_index P, bool LongWay, class V>
struct nlerp_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    static constexpr int inputs = 9, quaternions_in = 2;
    static constexpr int outputs = 4, quaternions_out = 1;

    explicit nlerp_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1));
        const rotor<V> a{in[0], in[1], in[2], in[3]}, given{in[4], in[5], in[6], in[7]};
        const V t = in[8], s = one - t;
        const rotor<V> b = flipped(given, way_of<LongWay>(dot_of<P>(a, given)));

        rotor<V> m{M::multiply_add(t, b.x, s * a.x), M::multiply_add(t, b.y, s * a.y),
                   M::multiply_add(t, b.z, s * a.z), M::multiply_add(t, b.w, s * a.w)};
        V mm = dot_of<P>(m, m);
        // The quotient by an infinity would be 0.
        mm = M::multiply_add(zero, mm, mm);
        const mask_of<V> finite = is_finite(mm);
        // A chord through the middle has no direction there.
        const mask_of<V> nothing = mm <= V(constants<T>::pole_threshold);
        m = either(nothing, turned_about_x(a), m);
        mm = xsimd::select(nothing, larger(V(constants<T>::pole_floor), dot_of<P>(a, a)), mm);
        rotor<V> between;
        if constexpr (P == reproducible_index) {
            const V root = square_root_of(mm);
            between = {quotient(m.x, root), quotient(m.y, root), quotient(m.z, root), quotient(m.w, root)};
        } else {
            between = scaled(m, M::reciprocal_root(mm));
        }
        put(either(finite & (t == zero), a, either(finite & (t == one), b, between)), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
