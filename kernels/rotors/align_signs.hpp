#ifndef SWIVEL_KERNELS_ROTORS_ALIGN_SIGNS_HPP
#define SWIVEL_KERNELS_ROTORS_ALIGN_SIGNS_HPP

#include "kernels/loops/streams.hpp"
#include "kernels/quat.hpp"

namespace swivel {
namespace {

// Streams in: q x y z w, its neighbour x y z w. Out: q or -q.
template <precision_index P, class V>
struct align_signs_op {
    using reads = streams<4, 4>;
    using writes = streams<4>;

    explicit align_signs_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const rotor<V> q{in[0], in[1], in[2], in[3]}, neighbour{in[4], in[5], in[6], in[7]};
        const V product = nan_for_infinity<arithmetic<P>>(dot_of<P>(q, neighbour));
        const V plus(scalar_of<V>(0)), minus(scalar_of<V>(-0.0));
        const rotor<V> aligned = flipped(q, select(product < plus, minus, plus));
        // NaN only where q or the neighbour has one: there it replaces every component.
        put(either(product == product, aligned, rotor<V>{product, product, product, product}), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
