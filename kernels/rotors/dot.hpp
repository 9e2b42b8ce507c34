#ifndef SWIVEL_KERNELS_ROTORS_DOT_HPP
#define SWIVEL_KERNELS_ROTORS_DOT_HPP

#include "kernels/loops/streams.hpp"
#include "kernels/quat.hpp"

namespace swivel {
namespace {

// Streams in: a x y z w, b x y z w. Out: a.b, NaN where anything is NaN or infinite.
template <precision_index P, class V>
struct dot_op {
    using reads = streams<4, 4>;
    using writes = streams<1>;

    explicit dot_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const rotor<V> a{in[0], in[1], in[2], in[3]}, b{in[4], in[5], in[6], in[7]};
        out[0] = nan_for_infinity<arithmetic<P>>(dot_of<P>(a, b));
    }
};

}  // namespace
}  // namespace swivel

#endif
