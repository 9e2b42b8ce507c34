#ifndef SWIVEL_KERNELS_ARCS_SHORTEST_ARC_HPP
#define SWIVEL_KERNELS_ARCS_SHORTEST_ARC_HPP

#include "kernels/loops/streams.hpp"
#include "kernels/quat.hpp"
#include "kernels/vector3.hpp"

namespace swivel {
namespace {

// v less its part along a, given 1/|a|^2.
template <precision_index P, class V>
inline vector3<V> without_part(const vector3<V>& v, const vector3<V>& a, V scale) noexcept {
    using M = arithmetic<P>;
    const V part = dot_of<P>(v, a) * scale;
    return {M::negate_multiply_add(part, a.x, v.x), M::negate_multiply_add(part, a.y, v.y),
            M::negate_multiply_add(part, a.z, v.z)};
}

// A positive multiple of the shortest arc from a to b. Where they are more than 90 degrees apart it
// is a half turn from a to -a, about an axis g near that of the arc, and then the arc from -a to b: near 180
// degrees a x b is all rounding, and has a part along a that must go. Where that leaves little, any axis
// perpendicular to a is as good. A vector of zeros gives the identity.
template <precision_index P, class V>
inline rotor<V> arc_between(const vector3<V>& a, const vector3<V>& b) noexcept {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    const V zero(T(0)), minus(T(-0.0));
    const V aa = dot_of<P>(a, a), squares = aa * dot_of<P>(b, b), cosine = dot_of<P>(a, b);
    const vector3<V> c = cross_of<P>(a, b);
    const mask_of<V> obtuse = cosine < zero, nothing = squares == zero;
    const V one(T(1));
    const V h =
        select(nothing, one, root_divisor<P, V>(select(nothing, one, squares)).root() + magnitude(cosine));

    const V scale = quotient(one, larger(one, aa));
    // Twice: what rounding leaves of the part the first time counts double in the half turn.
    const vector3<V> e = without_part<P>(without_part<P>(c, a, scale), a, scale);
    const mask_of<V> known =
        dot_of<P>(e, e) > larger(V(constants<T>::pole_floor), V(T(0.75)) * dot_of<P>(c, c));
    const mask_of<V> flat = magnitude(a.x) > magnitude(a.z);
    const vector3<V> g{select(known, e.x, select(flat, a.y ^ minus, zero)),
                       select(known, e.y, select(flat, a.x, a.z ^ minus)),
                       select(known, e.z, select(flat, zero, a.y))};

    // (-c, h) g. Its w is negative by rounding only.
    const V w = dot_of<P>(c, g), flip = sign_of(w);
    const V x = M::multiply_add(c.z, g.y, M::negate_multiply_add(c.y, g.z, h * g.x)),
            y = M::multiply_add(c.x, g.z, M::negate_multiply_add(c.z, g.x, h * g.y)),
            z = M::multiply_add(c.y, g.x, M::negate_multiply_add(c.x, g.y, h * g.z));
    return {select(obtuse, x ^ flip, c.x), select(obtuse, y ^ flip, c.y), select(obtuse, z ^ flip, c.z),
            select(obtuse, magnitude(w), h)};
}

// Streams in: x y z of the vector that is turned, x y z of that to which. Out: x y z w.
template <precision_index P, class V>
struct shortest_arc_op {
    using reads = streams<3, 3>;
    using writes = streams<4>;

    explicit shortest_arc_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        put(normalized<P>(arc_between<P>(in_range(in), in_range(in + 3))), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
