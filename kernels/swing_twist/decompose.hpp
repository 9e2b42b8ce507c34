#ifndef SWIVEL_KERNELS_SWING_TWIST_DECOMPOSE_HPP
#define SWIVEL_KERNELS_SWING_TWIST_DECOMPOSE_HPP

#include "kernels/swing_twist/axis_form.hpp"

namespace swivel {
namespace {

// The pair of sgn(w) q. Its cosine has the sign of w, so clearing and exchanging sign bits does it.
template <class V>
inline half_twist<V> positive(const half_twist<V>& h, V w) noexcept {
    return {magnitude(h.cosine), h.sine ^ sign_of(w)};
}

// Streams in: those of the form. Out: swing and twist, in the order of the form, and where signs are kept 1
// or -1.
template <class Form, twist_sign Sign, class V>
struct decompose_op : Form {
    static constexpr int outputs = Sign == sign_kept ? 9 : 8, quaternions_out = 2;

    using Form::Form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        Form::swing(q, h, out);
        Form::twist(q, Sign == sign_left ? h : positive(h, q.w), out + 4);
        if constexpr (Sign == sign_kept) out[8] = one_signed_like(q.w);
    }
};

// Streams in: B C A w. Out: s1 s2 sc ts tc, and where signs are kept 1 or -1.
template <class Form, twist_sign Sign, class V>
struct decompose_compact_op : Form {
    static constexpr int outputs = Sign == sign_kept ? 6 : 5, quaternions_out = 0;

    using Form::Form;

    void operator()(const V* in, V* out) const noexcept {
        half_twist<V> h;
        typename Form::element q;
        this->read(in, q, h);
        Form::swing_compact(q, h, out[0], out[1], out[2]);
        if constexpr (Sign != sign_left) h = positive(h, q.w);
        out[3] = h.sine;
        out[4] = h.cosine;
        if constexpr (Sign == sign_kept) out[5] = one_signed_like(q.w);
    }
};

}  // namespace
}  // namespace swivel

#endif
