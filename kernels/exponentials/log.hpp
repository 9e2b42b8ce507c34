#ifndef SWIVEL_KERNELS_EXPONENTIALS_LOG_HPP
#define SWIVEL_KERNELS_EXPONENTIALS_LOG_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/exponentials/polar_form.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// Streams in: x y z w. Out: x y z of half the angle times the axis.
template <precision_index P, class V>
struct log_op {
    using reads = streams<4>;
    using writes = streams<3>;

    explicit log_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const polar_form<P, V> q = polar<P>(in, 1);
        q.along(atan2_above<P>(q.m, q.w), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
