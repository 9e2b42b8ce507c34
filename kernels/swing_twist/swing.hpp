#ifndef SWIVEL_KERNELS_SWING_TWIST_SWING_HPP
#define SWIVEL_KERNELS_SWING_TWIST_SWING_HPP

#include "kernels/loops/streams.hpp"
#include "kernels/swing_twist/axis_form.hpp"

namespace swivel {
namespace {

// Streams in: those of the form. Out: four, in the order of the form.
template <class Form, class V>
struct swing_op : Form {
    using writes = streams<4>;

    using Form::Form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        Form::swing(q, h, out);
    }
};

}  // namespace
}  // namespace swivel

#endif
