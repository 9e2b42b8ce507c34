#ifndef SWIVEL_KERNELS_ROTORS_CONJUGATE_HPP
#define SWIVEL_KERNELS_ROTORS_CONJUGATE_HPP

#include "kernels/kernel.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

// Streams in: x y z w. Out: the same, the signs of x y z exchanged.
template <class V>
struct conjugate_op {
    using reads = streams<4>;
    using writes = streams<4>;

    explicit conjugate_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V sign(scalar_of<V>(-0.0));
        out[0] = in[0] ^ sign;
        out[1] = in[1] ^ sign;
        out[2] = in[2] ^ sign;
        out[3] = in[3];
    }
};

}  // namespace
}  // namespace swivel

#endif
