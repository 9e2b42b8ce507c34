#ifndef SWIVEL_KERNELS_SWING_TWIST_DECOMPOSE_HPP
#define SWIVEL_KERNELS_SWING_TWIST_DECOMPOSE_HPP

#include <type_traits>

#include "kernels/loops/streams.hpp"
#include "kernels/swing_twist/axis_form.hpp"

namespace swivel {
namespace {

// A form, and the sign of the twist. Uniform, after those of the form: the sign bit where the twist is to be
// that of sgn(w) q, otherwise 0.
template <class Form, class V>
struct signed_form : Form {
    V positive;

    explicit signed_form(const scalar_of<V>* uniform) noexcept : Form(uniform), positive(uniform[5]) {}

    // The cosine has the sign of w, so clearing and exchanging sign bits does it.
    half_twist<V> with_sign(const half_twist<V>& h, V w) const noexcept {
        return {h.cosine & ~positive, h.sine ^ (w & positive)};
    }
};

// Streams in: those of the form. Out: swing and twist, in the order of the form, and where signs are kept 1
// or -1.
template <class Form, bool KeepsSigns, class V>
struct decompose_op : signed_form<Form, V> {
    using writes = std::conditional_t<KeepsSigns, streams<4, 4, 1>, streams<4, 4>>;

    using signed_form<Form, V>::signed_form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        Form::swing(q, h, out);
        Form::twist(q, this->with_sign(h, q.w), out + 4);
        if constexpr (KeepsSigns) out[8] = one_signed_like(q.w);
    }
};

// Streams in: B C A w. Out: s1 s2 sc ts tc, and where signs are kept 1 or -1.
template <class Form, bool KeepsSigns, class V>
struct decompose_compact_op : signed_form<Form, V> {
    using writes = std::conditional_t<KeepsSigns, streams<5, 1>, streams<5>>;

    using signed_form<Form, V>::signed_form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        Form::swing_compact(q, h, out[0], out[1], out[2]);
        h = this->with_sign(h, q.w);
        out[3] = h.sine;
        out[4] = h.cosine;
        if constexpr (KeepsSigns) out[5] = one_signed_like(q.w);
    }
};

}  // namespace
}  // namespace swivel

#endif
