#ifndef SWIVEL_KERNELS_INTERPOLATION_STERP_HPP
#define SWIVEL_KERNELS_INTERPOLATION_STERP_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/interpolation/interpolation.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/swing_twist/axis_form.hpp"

namespace swivel {
namespace {

// A part of a turn, as cosine and sine of its half, at constant speed.
template <precision_index P>
struct constant_speed {
    // The t-th part of the turn whose half has that cosine and sine, times `length`.
    template <class V>
    static void part(V cosine, V sine, V length, V t, V& part_cosine, V& part_sine) noexcept {
        sincos_of<P, true>(t * angle_of<P>(sine, cosine, length), part_sine, part_cosine);
    }
};

// The same along the chord.
template <precision_index P>
struct along_the_chord {
    template <class V>
    static void part(V cosine, V sine, V length, V t, V& part_cosine, V& part_sine) noexcept {
        using T = scalar_of<V>;
        using M = arithmetic<P>;
        const V zero(T(0)), one(T(1));
        V x = M::multiply_add(t, cosine, (one - t) * length), y = t * sine;
        // No square of it that would be subnormal: it counts for nothing.
        const V size = larger(V(constants<T>::root_of_smallest_normal), magnitude(y));
        V squared = M::multiply_add(size, size, x * x);
        // The middle of a full turn is a half turn, the way that a sine of 0 belongs to.
        const mask_of<V> nothing = squared <= V(constants<T>::pole_threshold) * (length * length);
        x = select(nothing, zero, x);
        y = select(nothing, one_signed_like(sine), y);
        squared = select(nothing, one, squared);
        if constexpr (P == reproducible_index) {
            const V root = square_root_of(squared);
            part_cosine = quotient(x, root);
            part_sine = quotient(y, root);
        } else {
            const V scale = M::reciprocal_root(squared);
            part_cosine = x * scale;
            part_sine = y * scale;
        }
    }
};

template <int Chord, precision_index P>
using motion = std::conditional_t<Chord != 0, along_the_chord<P>, constant_speed<P>>;

// Streams in: a x y z w, b x y z w, those of the form's axis, the parameters of swing and twist. Uniform:
// that of the form, -0 for the long way, else 0, and 1 where the axis is that of the body, else 0.
//
// With D = b a* (in the body a* b) = S T, the result is S^s T^t a (in the body a S^s T^t). Where T = c + d l
// and the swing's S = r + (c p + d k) with k = l x p, the factors come together as
//   S^s T^t = cos(f) cos(g) + cos(f) sin(g) l + sin(f)/|p| (cos(h - g) p + sin(h - g) k),
// f = s atan2(|p|, r), h = atan2(d, c), g = t h.
template <precision_index P, class Form, class Motion, class V>
struct sterp_op : Form {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    static constexpr bool has_own_axis = Form::reads::groups == 2;
    using reads = std::conditional_t<has_own_axis, streams<4, 4, 3, 1, 1>, streams<4, 4, 1, 1>>;
    using writes = streams<4>;

    V long_way;
    mask_of<V> in_body;

    explicit sterp_op(const T* uniform) noexcept
        : Form(uniform), long_way(uniform[5]), in_body(V(uniform[6]) > V(T(0))) {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1));
        const rotor<V> a{in[0], in[1], in[2], in[3]}, b{in[4], in[5], in[6], in[7]};
        const V s = in[reads::count - 2], t = in[reads::count - 1];
        const rotor<V> back = reversed(a);
        rotor<V> d = hamilton<P>(either(in_body, back, b), either(in_body, b, back));
        // The sign of a zero would choose the way of the twist.
        d.w = d.w + zero;
        const V way = way_of<false>(d.w) ^ long_way;
        d = flipped(d, way);

        V projected[Form::reads::count];
        put(d, projected);
        if constexpr (has_own_axis) {
            projected[4] = in[8];
            projected[5] = in[9];
            projected[6] = in[10];
        }
        typename Form::element q;
        half_twist<V> h;
        this->read(projected, q, h);

        const V px = M::negate_multiply_add(q.u, q.ax, q.x), py = M::negate_multiply_add(q.u, q.ay, q.y),
                pz = M::negate_multiply_add(q.u, q.az, q.z);
        const V kx = M::negate_multiply_add(q.az, py, q.ay * pz),
                ky = M::negate_multiply_add(q.ax, pz, q.az * px),
                kz = M::negate_multiply_add(q.ay, px, q.ax * py);
        const V floor(constants<T>::pole_floor), r = M::multiply_add(h.sine, q.u, h.cosine * q.w);
        const V pp = larger(floor, M::multiply_add(pz, pz, M::multiply_add(py, py, px * px)));
        const V dd = M::multiply_add(r, r, pp);
        V length, scale, whole;
        if constexpr (P == reproducible_index) {
            length = square_root_of(pp);
            whole = square_root_of(dd);
        } else {
            scale = M::reciprocal_root(pp);
            length = pp * scale;
            whole = dd * M::reciprocal_root(dd);
        }
        V cos_f, sin_f, cos_g, sin_g;
        Motion::part(r, length, whole, s, cos_f, sin_f);
        Motion::part(h.cosine, h.sine, one, t, cos_g, sin_g);
        const V across = P == reproducible_index ? quotient(sin_f, length) : sin_f * scale;
        const V on_p = across * M::multiply_add(h.sine, sin_g, h.cosine * cos_g);
        const V on_k = across * M::negate_multiply_add(h.cosine, sin_g, h.sine * cos_g);
        const V on_axis = cos_f * sin_g;
        const rotor<V> e{M::multiply_add(on_k, kx, M::multiply_add(on_p, px, on_axis * q.ax)),
                         M::multiply_add(on_k, ky, M::multiply_add(on_p, py, on_axis * q.ay)),
                         M::multiply_add(on_k, kz, M::multiply_add(on_p, pz, on_axis * q.az)), cos_f * cos_g};
        const rotor<V> between = normalized<P>(hamilton<P>(either(in_body, a, e), either(in_body, e, a)));
        put(with_ends<P>(between, (s == zero) & (t == zero), a, (s == one) & (t == one), flipped(b, way)),
            out);
    }
};

}  // namespace
}  // namespace swivel

#endif
