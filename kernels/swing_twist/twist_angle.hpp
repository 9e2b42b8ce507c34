#ifndef SWIVEL_KERNELS_SWING_TWIST_TWIST_ANGLE_HPP
#define SWIVEL_KERNELS_SWING_TWIST_TWIST_ANGLE_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/swing_twist/decompose.hpp"

namespace swivel {
namespace {

// Streams in: those of the form. Out: the angle.
template <precision_index P, class Form, class V>
struct twist_angle_op : signed_form<Form, V> {
    using writes = streams<1>;

    using signed_form<Form, V>::signed_form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        h = this->with_sign(h, q.w);
        // A sine of -0 next to a negative cosine would be the angle -2 pi, which is outside the range.
        const V sine = h.sine + V(scalar_of<V>(0));
        const V half = atan2_of<P>(sine, h.cosine);
        out[0] = half + half;
    }
};

}  // namespace
}  // namespace swivel

#endif
