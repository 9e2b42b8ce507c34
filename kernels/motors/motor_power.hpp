#ifndef SWIVEL_KERNELS_MOTORS_MOTOR_POWER_HPP
#define SWIVEL_KERNELS_MOTORS_MOTOR_POWER_HPP

// Root, logarithm, exponential and powers of motors, and the interpolation made of them.

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/exponentials/polar_form.hpp"
#include "kernels/interpolation/interpolation.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/motors/motor.hpp"

namespace swivel {
namespace {

// A motor as screw: m and w are sine and cosine of half the angle, u the direction of the axis, p half of the
// way along it; across is the rest of the dual vector part, m times the moment of the axis. p needs no
// quotient, since u.e = p w and dw = -p m, e being the dual vector part. For a translation u is of no
// account.
template <class V>
struct screw {
    V m, w, angle, p;
    vector3<V> u, across;

    // That divided by m; where m is 0, what it tends to.
    V over_m(V part, V limit) const noexcept {
        const mask_of<V> small = m < V(constants<scalar_of<V>>::smallest_normal);
        return select(small, limit, quotient(part, select(small, V(scalar_of<V>(1)), m)));
    }
};

// Whether r is -1 to rounding. The axis of the motion is then taken from the translation, that is from the
// dual part.
template <class V>
inline mask_of<V> is_minus_one(const rotor<V>& r) noexcept {
    using T = scalar_of<V>;
    const V rounding(constants<T>::rounding);
    // One by one, since the larger of two may not be the NaN.
    return (r.w < V(T(0))) & (magnitude(r.x) <= rounding) & (magnitude(r.y) <= rounding) &
           (magnitude(r.z) <= rounding);
}

template <class V>
inline vector3<V> vector_part(const rotor<V>& q) noexcept {
    return {q.x, q.y, q.z};
}

// MinusOne: whether r may be -1.
template <precision_index P, bool MinusOne, class V>
inline screw<V> screw_of(const motor<V>& a) noexcept {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    screw<V> s;
    const vector3<V> v = vector_part(a.r), e = vector_part(a.d);
    V m_or_zero;
    if constexpr (MinusOne) {
        const mask_of<V> pole = is_minus_one(a.r);
        const V r[4] = {select(pole, e.x, v.x), select(pole, e.y, v.y), select(pole, e.z, v.z), a.r.w};
        const polar_form<P, V> q = polar<P>(r, 1);
        V u[3];
        q.along(V(T(1)), u);
        s.u = {u[0], u[1], u[2]};
        s.m = m_or_zero = select(pole, V(T(0)), q.m);
        s.w = q.w;
    } else {
        // Shorter than 1 near r = 1, where it is multiplied by what is smaller still.
        const V floor(constants<T>::pole_floor), squared = dot_of<P>(v, v);
        const root_divisor<P, V> length(larger(floor, squared));
        s.u = {length.divide(v.x), length.divide(v.y), length.divide(v.z)};
        s.m = length.root();
        // What the floor is alone goes into no product, which would be subnormal.
        m_or_zero = select(squared < floor, V(T(0)), s.m);
        s.w = a.r.w;
    }
    s.angle = atan2_above<P>(s.m, s.w);
    s.p = M::negate_multiply_add(m_or_zero, a.d.w, s.w * dot_of<P>(s.u, e));
    const V back = s.p * s.w;
    s.across = {M::negate_multiply_add(back, s.u.x, e.x), M::negate_multiply_add(back, s.u.y, e.y),
                M::negate_multiply_add(back, s.u.z, e.z)};
    return s;
}

// The t-th power. Everything is in p: it is 0 times p that makes all NaN where something is not finite.
template <precision_index P, class V>
inline motor<V> power_of(const screw<V>& s, V t) noexcept {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    const V zero(T(0)), product = t * s.angle;
    const mask_of<V> beyond = magnitude(product) > V(constants<T>::largest_angle);
    V sine, cosine;
    sincos_within<P, true>(select(beyond, zero * t, product), sine, cosine);
    const V ratio = s.over_m(sine, t), along = t * s.p, on_u = along * cosine;
    return {
        {sine * s.u.x, sine * s.u.y, sine * s.u.z, cosine},
        {M::multiply_add(ratio, s.across.x, on_u * s.u.x), M::multiply_add(ratio, s.across.y, on_u * s.u.y),
         M::multiply_add(ratio, s.across.z, on_u * s.u.z), zero - along * sine}};
}

// Streams in: a motor. Out: the same.
template <precision_index P, class V>
struct motor_square_root_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<8>;
    using writes = streams<8>;

    explicit motor_square_root_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), half(T(0.5)), one(T(1));
        const motor<V> a = motor_from(in);
        const mask_of<V> pole = is_minus_one(a.r);
        const V real[4] = {select(pole, a.d.x, a.r.x), select(pole, a.d.y, a.r.y), select(pole, a.d.z, a.r.z),
                           a.r.w};
        const polar_form<P, V> q = polar<P>(real, 1);
        V u[3], sine, cosine;
        half_of<P>(select(pole, zero, q.m), q.w, sine, cosine);
        q.along(sine, u);
        const rotor<V> r{u[0], u[1], u[2], cosine};
        const V inverse = quotient(half, select(pole, one, r.w)), p = a.d.w * inverse;
        const rotor<V> d{inverse * M::negate_multiply_add(p, r.x, a.d.x),
                         inverse * M::negate_multiply_add(p, r.y, a.d.y),
                         inverse * M::negate_multiply_add(p, r.z, a.d.z), half * p};
        const rotor<V> at_pole{zero, zero, zero, half * q.m};
        put(poisoned(motor<V>{r, either(pole, at_pole, d)}, zero_or_nan<8>(in)), out);
    }
};

// Streams in: a motor. Out: b x y z, n x y z.
template <precision_index P, class V>
struct motor_log_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<8>;
    using writes = streams<3, 3>;

    explicit motor_log_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const screw<V> s = screw_of<P, true>(motor_from(in));
        const V ratio = s.over_m(s.angle, V(T(1))), poison = V(T(0)) * s.p;
        out[0] = M::multiply_add(s.angle, s.u.x, poison);
        out[1] = M::multiply_add(s.angle, s.u.y, poison);
        out[2] = M::multiply_add(s.angle, s.u.z, poison);
        out[3] = M::multiply_add(ratio, s.across.x, s.p * s.u.x) + poison;
        out[4] = M::multiply_add(ratio, s.across.y, s.p * s.u.y) + poison;
        out[5] = M::multiply_add(ratio, s.across.z, s.p * s.u.z) + poison;
    }
};

// Streams in: b x y z, n x y z. Out: a motor.
template <precision_index P, class V>
struct motor_exp_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<3, 3>;
    using writes = streams<8>;

    explicit motor_exp_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), largest(constants<T>::largest_angle);
        vector3<V> b{in[0], in[1], in[2]};
        const vector3<V> n{in[3], in[4], in[5]};
        // The square of a large number overflows, which must not look like an infinity.
        const V nothing = zero_or_nan<3>(in);
        V squared = dot_of<P>(b, b);
        const mask_of<V> beyond = squared > largest * largest;
        b = {select(beyond, nothing, b.x), select(beyond, nothing, b.y), select(beyond, nothing, b.z)};
        squared = select(beyond, nothing, squared);
        // Below the floor the sine is the angle, whatever that is.
        const root_divisor<P, V> angle(larger(V(constants<T>::pole_floor), squared));
        V sine, cosine;
        sincos_within<P, true>(angle.root(), sine, cosine);
        const V shape = angle.divide(sine);
        const vector3<V> u{angle.divide(b.x), angle.divide(b.y), angle.divide(b.z)};
        const V along = dot_of<P>(u, n), on_u = along * (cosine - shape);
        put(poisoned(
                motor<V>{{shape * b.x, shape * b.y, shape * b.z, cosine},
                         {M::multiply_add(shape, n.x, on_u * u.x), M::multiply_add(shape, n.y, on_u * u.y),
                          M::multiply_add(shape, n.z, on_u * u.z), zero - along * sine}},
                zero_or_nan<6>(in)),
            out);
    }
};

// Streams in: a motor, the exponent. Out: a motor.
template <precision_index P, class V>
struct motor_power_op {
    using T = scalar_of<V>;
    using reads = streams<8, 1>;
    using writes = streams<8>;

    explicit motor_power_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), t = in[8];
        const motor<V> m = motor_from(in);
        const screw<V> s = screw_of<P, true>(m);
        const V poison = zero * s.p + zero * t;
        motor<V> power = poisoned(power_of<P>(s, t), poison);
        if constexpr (P == reproducible_index) {
            const mask_of<V> same = (poison == zero) & (t == V(T(1)));
            power = {either(same, m.r, power.r), either(same, m.d, power.d)};
        }
        put(power, out);
    }
};

// Streams in: a, b, the parameter. Out: a motor.
template <precision_index P, bool LongWay, class V>
struct sclerp_op {
    using T = scalar_of<V>;
    using reads = streams<8, 8, 1>;
    using writes = streams<8>;

    explicit sclerp_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1)), t = in[16];
        const motor<V> a = motor_from(in), b = motor_from(in + 8);
        motor<V> between = product_of<P>(motor<V>{reversed(a.r), reversed(a.d)}, b);
        const V way = way_of<LongWay>(between.r.w);
        between = {flipped(between.r, way), flipped(between.d, way)};
        const screw<V> s = screw_of<P, LongWay>(between);
        const V poison = zero * s.p + zero * t;
        between = poisoned(product_of<P>(a, power_of<P>(s, t)), poison);
        if constexpr (P == reproducible_index) {
            const mask_of<V> finite = poison == zero, at_a = finite & (t == zero), at_b = finite & (t == one);
            between = {either(at_a, a.r, either(at_b, flipped(b.r, way), between.r)),
                       either(at_a, a.d, either(at_b, flipped(b.d, way), between.d))};
        }
        put(between, out);
    }
};

}  // namespace
}  // namespace swivel

#endif
