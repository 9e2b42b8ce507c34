#ifndef SWIVEL_KERNELS_MOTORS_MOTOR_HPP
#define SWIVEL_KERNELS_MOTORS_MOTOR_HPP

// Motors in registers, and the operations of their algebra. Streams of a motor: x y z w dx dy dz dw.

#include "kernels/loops/streams.hpp"
#include "kernels/quat.hpp"
#include "kernels/swing_twist/decompose.hpp"
#include "kernels/vector3.hpp"

namespace swivel {
namespace {

template <class V>
struct motor {
    rotor<V> r, d;
};

template <class V>
inline motor<V> motor_from(const V* in) noexcept {
    return {{in[0], in[1], in[2], in[3]}, {in[4], in[5], in[6], in[7]}};
}

template <class V>
inline rotor<V> sum_of(const rotor<V>& a, const rotor<V>& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}

template <precision_index P, class V>
inline motor<V> product_of(const motor<V>& a, const motor<V>& b) noexcept {
    return {hamilton<P>(a.r, b.r), sum_of(hamilton<P>(a.r, b.d), hamilton<P>(a.d, b.r))};
}

template <class V>
inline void put(const motor<V>& m, V* out) noexcept {
    put(m.r, out);
    put(m.d, out + 4);
}

// NaN in every component where poison is not 0.
template <class V>
inline motor<V> poisoned(const motor<V>& m, V poison) noexcept {
    const rotor<V> p{poison, poison, poison, poison};
    return {sum_of(m.r, p), sum_of(m.d, p)};
}

// The dual part of a rotation q that is followed by a translation t.
template <precision_index P, class V>
inline rotor<V> dual_part(const rotor<V>& q, const V* t) noexcept {
    using M = arithmetic<P>;
    const V half(scalar_of<V>(0.5));
    const V x = half * t[0], y = half * t[1], z = half * t[2];
    return {M::negate_multiply_add(z, q.y, M::multiply_add(y, q.z, x * q.w)),
            M::negate_multiply_add(x, q.z, M::multiply_add(z, q.x, y * q.w)),
            M::negate_multiply_add(y, q.x, M::multiply_add(x, q.y, z * q.w)),
            M::negate_multiply_add(z, q.z, M::negate_multiply_add(y, q.y, (V(scalar_of<V>(0)) - x * q.x)))};
}

// t = 2 d r* / |r|^2, of which every component has all of the motor in it.
template <precision_index P, class V>
inline void translation_of(const motor<V>& m, V* t) noexcept {
    using M = arithmetic<P>;
    const rotor<V>&r = m.r, &d = m.d;
    const V scale =
        quotient(V(scalar_of<V>(2)), larger(V(constants<scalar_of<V>>::pole_floor), dot_of<P>(r, r)));
    const auto component = [](V w, V e, V dw, V v, V a, V b, V c, V f) {
        return M::negate_multiply_add(c, f, M::multiply_add(a, b, M::negate_multiply_add(dw, v, w * e)));
    };
    t[0] = scale * component(r.w, d.x, d.w, r.x, r.y, d.z, r.z, d.y);
    t[1] = scale * component(r.w, d.y, d.w, r.y, r.z, d.x, r.x, d.z);
    t[2] = scale * component(r.w, d.z, d.w, r.z, r.x, d.y, r.y, d.x);
}

// Streams in: a, b. Out: a b.
template <precision_index P, class V>
struct motor_multiply_op {
    using reads = streams<8, 8>;
    using writes = streams<8>;

    explicit motor_multiply_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const motor<V> product = product_of<P>(motor_from(in), motor_from(in + 8));
        // Both factors are whole in any component of the dual part.
        put(poisoned(product, V(scalar_of<V>(0)) * product.d.x), out);
    }
};

// Streams in: a motor. Out: the same.
template <class V>
struct motor_conjugate_op {
    using reads = streams<8>;
    using writes = streams<8>;

    explicit motor_conjugate_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const motor<V> m = motor_from(in);
        put(motor<V>{reversed(m.r), reversed(m.d)}, out);
    }
};

// Streams in: a motor. Out: the same.
template <precision_index P, class V>
struct motor_normalize_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<8>;
    using writes = streams<8>;

    explicit motor_normalize_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1));
        const motor<V> m = motor_from(in);
        const V largest = larger(largest_magnitude(m.r.x, m.r.y, m.r.z), magnitude(m.r.w));
        const mask_of<V> nothing = largest == zero;
        const V scale = select(nothing, zero, reciprocal_power_of_two(largest));
        rotor<V> r = scaled(m.r, scale), d = scaled(m.d, scale);
        r.w = select(nothing, one, r.w);
        const root_divisor<P, V> length(dot_of<P>(r, r));
        r = {length.divide(r.x), length.divide(r.y), length.divide(r.z), length.divide(r.w)};
        d = {length.divide(d.x), length.divide(d.y), length.divide(d.z), length.divide(d.w)};
        const V along = dot_of<P>(r, d);
        d = {M::negate_multiply_add(along, r.x, d.x), M::negate_multiply_add(along, r.y, d.y),
             M::negate_multiply_add(along, r.z, d.z), M::negate_multiply_add(along, r.w, d.w)};
        put(poisoned(motor<V>{r, d}, zero_or_nan<4>(in + 4)), out);
    }
};

// Streams in: the rotation x y z w, the translation x y z. Out: a motor.
template <precision_index P, class V>
struct from_rotation_translation_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<4, 3>;
    using writes = streams<8>;

    explicit from_rotation_translation_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const rotor<V> q{in[0], in[1], in[2], in[3]};
        const rotor<V> d = dual_part<P>(q, in + 4);
        const V zero(T(0)), poison = M::multiply_add(zero, d.y, zero * d.x);
        const mask_of<V> finite = poison == zero;
        const rotor<V> p{poison, poison, poison, poison};
        put(motor<V>{either(finite, q, p), either(finite, d, p)}, out);
    }
};

// Streams in: a motor. Out: the rotation x y z w, the translation x y z.
template <precision_index P, class V>
struct to_rotation_translation_op {
    using T = scalar_of<V>;
    using reads = streams<8>;
    using writes = streams<4, 3>;

    explicit to_rotation_translation_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const motor<V> m = motor_from(in);
        V t[3];
        translation_of<P>(m, t);
        const V zero(T(0)), poison = zero * t[0];
        const mask_of<V> finite = poison == zero;
        put(either(finite, m.r, rotor<V>{poison, poison, poison, poison}), out);
        out[4] = t[0] + poison;
        out[5] = t[1] + poison;
        out[6] = t[2] + poison;
    }
};

// Streams in: a motor, a point x y z. Out: x y z.
template <precision_index P, class V>
struct motor_transform_op {
    using M = arithmetic<P>;
    using reads = streams<8, 3>;
    using writes = streams<3>;

    explicit motor_transform_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const motor<V> m = motor_from(in);
        const vector3<V> v{m.r.x, m.r.y, m.r.z}, p{in[8], in[9], in[10]};
        vector3<V> c = cross_of<P>(v, p);
        c = {c.x + m.d.x, c.y + m.d.y, c.z + m.d.z};
        const vector3<V> turned = cross_of<P>(v, c);
        const auto moved = [&](V at, V along, V across, V part) {
            const V half = M::negate_multiply_add(m.d.w, part, M::multiply_add(m.r.w, along, across));
            return nan_for_infinity<M>(at + (half + half));
        };
        out[0] = moved(p.x, c.x, turned.x, v.x);
        out[1] = moved(p.y, c.y, turned.y, v.y);
        out[2] = moved(p.z, c.z, turned.z, v.z);
    }
};

// Streams in: the sum so far, the rotation x y z w that signs are aligned with, a motor, its weight. Out: the
// sum.
template <precision_index P, class V>
struct motor_blend_op {
    using M = arithmetic<P>;
    using reads = streams<8, 4, 8, 1>;
    using writes = streams<8>;

    explicit motor_blend_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(scalar_of<V>(0)), minus(scalar_of<V>(-0.0));
        const rotor<V> first{in[8], in[9], in[10], in[11]};
        const motor<V> m = motor_from(in + 12);
        const V weight = in[20] ^ select(dot_of<P>(first, m.r) < zero, minus, zero);
        const motor<V> sum = motor_from(in);
        const auto added = [&](const rotor<V>& q, const rotor<V>& to) {
            return rotor<V>{M::multiply_add(weight, q.x, to.x), M::multiply_add(weight, q.y, to.y),
                            M::multiply_add(weight, q.z, to.z), M::multiply_add(weight, q.w, to.w)};
        };
        put(motor<V>{added(m.r, sum.r), added(m.d, sum.d)}, out);
    }
};

// Streams in: those of decompose, a motor. Out: those of decompose, the translation x y z.
template <precision_index P, class Form, class V>
struct motor_decompose_op : decompose_op<Form, false, V> {
    using rotation = decompose_op<Form, false, V>;
    using reads = joined_streams<typename Form::reads, streams<8>>;
    using writes = streams<4, 4, 3>;

    using rotation::rotation;

    void operator()(const V* in, V* out) const noexcept {
        rotation::operator()(in, out);
        V t[3];
        translation_of<P>(motor_from(in + Form::reads::count), t);
        // An axis that is not finite, too.
        const V zero(scalar_of<V>(0)), poison = zero * out[3] + zero * t[0];
        put(poisoned(motor_from(out), poison), out);
        out[8] = t[0] + poison;
        out[9] = t[1] + poison;
        out[10] = t[2] + poison;
    }
};

// Streams in: l x y z w, r x y z w, the translation x y z. Out: the motor of l r, translated.
template <precision_index P, class V>
struct motor_compose_op {
    using M = arithmetic<P>;
    using reads = streams<4, 4, 3>;
    using writes = streams<8>;

    explicit motor_compose_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const rotor<V> q =
            hamilton<P>(rotor<V>{in[0], in[1], in[2], in[3]}, rotor<V>{in[4], in[5], in[6], in[7]});
        const rotor<V> d = dual_part<P>(q, in + 8);
        const V zero(scalar_of<V>(0));
        put(poisoned(motor<V>{q, d}, M::multiply_add(zero, d.y, zero * d.x)), out);
    }
};

}  // namespace
}  // namespace swivel

#endif
