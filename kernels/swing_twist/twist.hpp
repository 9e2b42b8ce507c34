#ifndef SWIVEL_KERNELS_SWING_TWIST_TWIST_HPP
#define SWIVEL_KERNELS_SWING_TWIST_TWIST_HPP

#include "kernels/swing_twist/decompose.hpp"

namespace swivel {
namespace {

// Streams in: those of the form. Out: four, in the order of the form.
template <class Form, twist_sign Sign, class V>
struct twist_op : Form {
    static constexpr int outputs = 4, quaternions_out = 1;

    using Form::Form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        Form::twist(q, Sign == sign_left ? h : positive(h, q.w), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
