#ifndef SWIVEL_KERNELS_SWING_TWIST_TWIST_HPP
#define SWIVEL_KERNELS_SWING_TWIST_TWIST_HPP

#include "kernels/loops/streams.hpp"
#include "kernels/swing_twist/decompose.hpp"

namespace swivel {
namespace {

// Streams in: those of the form. Out: four, in the order of the form.
template <class Form, class V>
struct twist_op : signed_form<Form, V> {
    using writes = streams<4>;

    using signed_form<Form, V>::signed_form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        Form::twist(q, this->with_sign(h, q.w), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
