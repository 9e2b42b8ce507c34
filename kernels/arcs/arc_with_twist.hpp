#ifndef SWIVEL_KERNELS_ARCS_ARC_WITH_TWIST_HPP
#define SWIVEL_KERNELS_ARCS_ARC_WITH_TWIST_HPP

#include "kernels/angles/sincos.hpp"
#include "kernels/arcs/shortest_arc.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// Streams in: x y z of the vector that is turned, x y z of that to which, the angle of the twist; before the
// arc about the first vector, or after it about the second. Out: x y z w.
template <precision_index P, bool TwistFirst, class V>
struct arc_with_twist_op {
    using T = scalar_of<V>;
    using reads = streams<3, 3, 1>;
    using writes = streams<4>;

    explicit arc_with_twist_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const vector3<V> from = in_range(in), to = in_range(in + 3);
        const vector3<V>& axis = TwistFirst ? from : to;
        const rotor<V> arc = arc_between<P>(from, to);
        const V zero(T(0)), one(T(1)), squared = dot_of<P>(axis, axis);
        V sine, cosine;
        sincos_of<P>(V(T(0.5)) * in[6], sine, cosine);
        const V factor = root_divisor<P, V>(larger(V(constants<T>::pole_floor), squared)).divide(sine);
        // No twist about a vector without direction.
        const rotor<V> twist{factor * axis.x, factor * axis.y, factor * axis.z,
                             select(squared == zero, one, cosine)};
        put(normalized<P>(TwistFirst ? hamilton<P>(arc, twist) : hamilton<P>(twist, arc)), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
