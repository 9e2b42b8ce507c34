#ifndef SWIVEL_KERNELS_CONVERSIONS_AXIS_ANGLE_HPP
#define SWIVEL_KERNELS_CONVERSIONS_AXIS_ANGLE_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/swing_twist/axis_form.hpp"

namespace swivel {
namespace {

// For each form of the axis one.
template <int Form, precision_index P, class V>
struct from_axis_angle_op;

// Streams in: the angle. Out: B C A w.
template <precision_index P, class V>
struct from_axis_angle_op<coordinate_index, P, V> {
    using T = scalar_of<V>;
    using reads = streams<1>;
    using writes = streams<4>;

    explicit from_axis_angle_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        sincos_of<P>(V(T(0.5)) * in[0], out[2], out[3]);
        // A component that is 0 by construction is no place for a NaN to vanish in.
        out[0] = out[1] = V(T(0)) * magnitude(out[2]);
    }
};

// Uniform: the threshold, which is not looked at, and the unit axis. Streams in: the angle. Out: x y z w.
template <precision_index P, class V>
struct from_axis_angle_op<uniform_index, P, V> {
    using T = scalar_of<V>;
    using reads = streams<1>;
    using writes = streams<4>;

    V ax, ay, az;

    explicit from_axis_angle_op(const T* uniform) noexcept : ax(uniform[1]), ay(uniform[2]), az(uniform[3]) {}

    void operator()(const V* in, V* out) const noexcept {
        V sine;
        sincos_of<P>(V(T(0.5)) * in[0], sine, out[3]);
        out[0] = sine * ax;
        out[1] = sine * ay;
        out[2] = sine * az;
    }
};

// Streams in: the angle, and the axis x y z. Out: x y z w.
template <precision_index P, class V>
struct from_axis_angle_op<per_element_index, P, V> {
    using T = scalar_of<V>;
    using reads = streams<1, 3>;
    using writes = streams<4>;

    explicit from_axis_angle_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1));
        const unit_vector<V> a = per_element_form<P, V>::normalized(in[1], in[2], in[3]);
        V sine, cosine;
        sincos_of<P>(V(T(0.5)) * in[0], sine, cosine);
        out[0] = sine * a.x;
        out[1] = sine * a.y;
        out[2] = sine * a.z;
        const mask_of<V> no_axis = magnitude(a.x | a.y | a.z) == zero;
        out[3] = select(no_axis, one, cosine) + zero * ((out[0] + out[1]) + out[2]);
    }
};

// Streams in: x y z w. Out: the axis x y z, and the angle.
template <precision_index P, class V>
struct to_axis_angle_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<4>;
    using writes = streams<3, 1>;

    explicit to_axis_angle_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1));
        // A power of two brings the largest component to 2..4, so that the smallest vector has a direction.
        const V scale =
            reciprocal_power_of_two(larger(larger(magnitude(in[0]), magnitude(in[1])), magnitude(in[2])));
        const V x = in[0] * scale, y = in[1] * scale, z = in[2] * scale;
        const V squared = M::multiply_add(z, z, M::multiply_add(y, y, x * x));
        const mask_of<V> none = squared == zero;
        const V positive = select(none, one, squared);
        const V poison = M::multiply_add(zero, in[3], zero * squared);
        V root;
        if constexpr (P == reproducible_index) {
            root = square_root_of(positive);
            out[0] = quotient(x, root);
            out[1] = quotient(y, root);
            out[2] = quotient(z, root);
        } else {
            const V reciprocal = M::reciprocal_root(positive);
            root = positive * reciprocal;
            out[0] = x * reciprocal;
            out[1] = y * reciprocal;
            out[2] = z * reciprocal;
        }
        out[0] = select(none, one, out[0]) + poison;
        out[1] = out[1] + poison;
        out[2] = out[2] + poison;
        // The second power is twice what undoes the scale; that itself may be no normal number.
        const V length = select(none, zero, V(T(0.5)) * root) * reciprocal_power_of_two(scale);
        const V half = atan2_of<P>(length, in[3]);
        out[3] = (half + half) + poison;
    }
};

}  // namespace
}  // namespace swivel

#endif
