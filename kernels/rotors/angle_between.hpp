#ifndef SWIVEL_KERNELS_ROTORS_ANGLE_BETWEEN_HPP
#define SWIVEL_KERNELS_ROTORS_ANGLE_BETWEEN_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/exponentials/polar_form.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/quat.hpp"

namespace swivel {
namespace {

// Streams in: a x y z w, b x y z w. Out: the angle.
template <precision_index P, class V>
struct angle_between_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<4, 4>;
    using writes = streams<1>;

    explicit angle_between_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const rotor<V> a{in[0], in[1], in[2], in[3]}, b{in[4], in[5], in[6], in[7]};
        const V cosine = dot_of<P>(a, b), a_squared = dot_of<P>(a, a), b_squared = dot_of<P>(b, b);
        // Where the lengths are nearly the same the difference from a or -a is exact: what is left of the angle is
        // right in all its bits.
        const mask_of<V> same_length = magnitude(a_squared - b_squared) < V(T(0x1p-10)) * a_squared;
        const V k = select(same_length, one_signed_like(cosine),
                           quotient(cosine, larger(V(constants<T>::pole_floor), a_squared)));
        const rotor<V> apart{M::negate_multiply_add(k, a.x, b.x), M::negate_multiply_add(k, a.y, b.y),
                             M::negate_multiply_add(k, a.z, b.z), M::negate_multiply_add(k, a.w, b.w)};
        const rotor<V> turn = hamilton<P>(reversed(a), apart);
        const V between[4] = {turn.x, turn.y, turn.z, magnitude(cosine)};
        const polar_form<P, V> q = polar<P>(between, 1);
        const V half = atan2_above<P>(q.m, q.w);
        out[0] = half + half;
    }
};

}  // namespace
}  // namespace swivel

#endif
