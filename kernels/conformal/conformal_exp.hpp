#ifndef SWIVEL_KERNELS_CONFORMAL_CONFORMAL_EXP_HPP
#define SWIVEL_KERNELS_CONFORMAL_CONFORMAL_EXP_HPP

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/conformal/conformal_planes.hpp"
#include "kernels/conformal/hyperbolic.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// exp of 10 components; `bad` is 0, or NaN where the element is to be NaN.
template <precision_index P, class V>
[[gnu::noinline]] void conformal_exp(const V* b, V bad, V* out) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V zero(T(0)), one(T(1)), half(T(0.5));
    V r[16], big, small;
    even_parts<V> p;
    r[0] = zero;
    put_with_half_square<P>(b, r);
    find_parts<P>(r, p);
    const V sum = p.bivector_squared ^ V(T(-0.0));
    find_roots<P>(sum, p.four_squared, big, small);
    const mask_of<V> outside = not_less_equal(p.bivector_size, V(C::largest_blade * C::largest_blade)) |
                               (big > V(T(0.25) * C::largest_angle * C::largest_angle)) |
                               ((small ^ V(T(-0.0))) > V(C::largest_boost * C::largest_boost));
    const mask_of<V> hyperbolic = small < zero;
    const mask_of<V> alike = V(T(4)) * small > big;
    const mask_of<V> tiny = larger(big, small ^ V(T(-0.0))) < V(C::small_square);

    // Of planes that turn by like angles, the sum and the difference of these. The product is no larger than
    // half of the sum, as of two squares.
    const V half_sum = half * sum, product_root = square_root_of(larger(p.four_squared, zero));
    const V root = select(product_root > half_sum, half_sum, product_root), twice = root + root;
    const V x1 = select(outside, zero, square_root_of(select(alike, sum + twice, big)));
    const V x2 =
        select(outside, zero, square_root_of(select(alike, larger(sum - twice, zero), magnitude(small))));
    V sine1, cosine1, sine2, cosine2, sinh2, cosh2;
    sincos_within<P, true>(x1, sine1, cosine1);
    sincos_within<P, true>(x2, sine2, cosine2);
    sinhcosh_of<P>(select(hyperbolic, x2, zero), sinh2, cosh2);
    sine2 = select(hyperbolic, sinh2, sine2);
    cosine2 = select(hyperbolic, cosh2, cosine2);
    const V z1 = ratio(sine1, x1, one), z2 = ratio(sine2, x2, one);

    const V apart = big - small, x = z1 * cosine2, y = cosine1 * z2, step = select(alike, twice, apart);
    const V plane =
        select(alike, half * (z1 + z2), ratio(M::negate_multiply_add(small, y, big * x), apart, one));
    const V mixed = select(tiny, M::negate_multiply_add(V(T(1) / T(30)), big + small, V(T(1) / T(3))),
                           ratio(select(alike, z2 - z1, x - y), step, zero));
    const V scalar = select(alike, half * (cosine1 + cosine2), cosine1 * cosine2);
    const V four = select(tiny, M::negate_multiply_add(V(T(1) / T(6)), big + small, one),
                          select(alike, ratio(cosine2 - cosine1, step, zero), z1 * z2));
    out[0] = select(outside, one, scalar) + bad;
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[1 + K] = select(outside, zero, M::multiply_add(mixed, p.mixed[K], r[1 + K] * plane)) + bad),
         ...);
    }
    (std::make_integer_sequence<int, 10>());
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[first_four_vector + K] = select(outside, zero, four * r[first_four_vector + K]) + bad), ...);
    }
    (std::make_integer_sequence<int, 5>());
}

// The angles a and b of a rotor, or where these are alike a + b and a - b, and their sines; b of a boost is its
// length. `big` and `small` are the squares of the sines of a and b, `root` the product of the sines.
template <class V>
struct rotor_angles {
    regular_rotor<V> of;
    V scalar, big, small, root, cos_a, cos_b, sine_1, sine_2, angle_1, angle_2;
    mask_of<V> hyperbolic, alike;
};

template <precision_index P, class V>
inline rotor_angles<V> find_angles(V r0, const even_parts<V>& p) noexcept {
    using T = scalar_of<V>;
    const V zero(T(0)), one(T(1)), half(T(0.5)), g = p.four_squared;
    rotor_angles<V> s;
    s.of = find_regular(r0, p);
    s.scalar = s.of.sign * r0;
    find_roots<P>((g + g) - p.bivector_squared, g, s.big, s.small);
    s.hyperbolic = s.small < zero;
    s.alike = V(T(4)) * s.small > s.big;
    s.root = square_root_of(larger(g, zero));
    s.cos_b = square_root_of(larger(one - s.small, zero));
    s.cos_a = quotient(s.scalar, larger(s.cos_b, half));
    const V cross = (s.scalar + s.scalar) * s.root;
    s.sine_1 = square_root_of(larger(select(s.alike, cross - p.bivector_squared, s.big), zero));
    s.sine_2 = square_root_of(
        larger(select(s.alike, (p.bivector_squared ^ V(T(-0.0))) - cross, magnitude(s.small)), zero));
    s.angle_1 = atan2_above<P>(s.sine_1, select(s.alike, s.scalar - s.root, s.cos_a));
    s.angle_2 = select(s.hyperbolic, asinh_of<P>(s.sine_2),
                       atan2_above<P>(s.sine_2, select(s.alike, s.scalar + s.root, s.cos_b)));
    return s;
}

// What the bivector of a rotor and `mixed` count in one with the same planes, whose coefficients of A and B are `first`
// and `second` times those sines. `limit` is that of both where the planes vanish, `series` what `mixed` counts where
// they are `tiny`.
template <precision_index P, class V>
inline void find_coefficients(const rotor_angles<V>& s, V first, V second, V limit, mask_of<V> tiny, V series,
                              V& plane, V& mixed) noexcept {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    const V apart = s.big - s.small;
    const V planes =
        ratio(M::negate_multiply_add(s.small * s.cos_a, second, (s.big * s.cos_b) * first), apart, limit);
    const V difference = M::negate_multiply_add(s.cos_b, second, s.cos_a * first);
    plane = s.of.sign * select(s.alike, V(T(0.5)) * (first + second), planes);
    mixed = select(
        tiny, series,
        ratio(select(s.alike, second - first, difference), select(s.alike, s.root + s.root, apart), V(T(0))));
}

// log to 10 components; unique is 1 or 0.
template <precision_index P, class V>
[[gnu::noinline]] void conformal_log(const V* r, V* b, V* unique) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V zero(T(0)), one(T(1)), bad = zero_or_nan<16>(r);
    even_parts<V> p;
    find_parts<P>(r, p);
    const rotor_angles<V> s = find_angles<P>(r[0], p);
    const mask_of<V> tiny = (s.scalar > zero) & (larger(s.big, s.small ^ V(T(-0.0))) < V(C::small_square));
    V plane, mixed;
    find_coefficients<P>(s, ratio(s.angle_1, s.sine_1, one), ratio(s.angle_2, s.sine_2, one), one, tiny,
                         M::negate_multiply_add(V(T(2) / T(15)), s.big + s.small, V(T(-1) / T(3))), plane,
                         mixed);
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((b[K] = select(s.of.none, V(1 + K == e23 ? -C::pi : T(0)),
                        M::multiply_add(mixed, p.mixed[K], r[1 + K] * plane)) +
                 bad),
         ...);
    }
    (std::make_integer_sequence<int, 10>());
    *unique = s.of.unique + bad;
}

// exp(t log R), without the logarithm: that of a motion about a far place is large and its rounding too.
template <precision_index P, class V>
[[gnu::noinline]] void conformal_power(const V* r, V t, V bad, V* out, V* unique) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V zero(T(0)), one(T(1)), half(T(0.5)), largest(C::largest_angle);
    even_parts<V> p;
    find_parts<P>(r, p);
    const rotor_angles<V> s = find_angles<P>(r[0], p);
    const V x1 = t * select(s.of.none, V(C::pi), s.angle_1);
    const V x2 = t * select(s.of.none, zero, s.angle_2), length = magnitude(x2);
    const mask_of<V> outside =
        (magnitude(x1) > largest) | (length > largest) | (s.hyperbolic & (length > V(C::largest_boost)));
    V sine_1, cosine_1, sine_2, cosine_2, sinh, cosh;
    sincos_within<P, true>(select(outside, zero, x1), sine_1, cosine_1);
    sincos_within<P, true>(select(outside, zero, x2), sine_2, cosine_2);
    sinhcosh_of<P>(select(outside | ~s.hyperbolic, zero, length), sinh, cosh);
    sine_2 = select(s.hyperbolic, sinh ^ sign_of(x2), sine_2);
    cosine_2 = select(s.hyperbolic, cosh, cosine_2);

    const V square = t * t, sum = s.big + s.small;
    const mask_of<V> tiny =
        (s.scalar > zero) & (larger(s.big, s.small ^ V(T(-0.0))) * larger(one, square) < V(C::small_square));
    const V series =
        (t * (square - one)) * M::multiply_add(sum, (V(T(4)) - square) * V(T(1) / T(30)), V(T(1) / T(3)));
    const V z1 = ratio(sine_1, s.sine_1, t), z2 = ratio(sine_2, s.sine_2, t);
    V plane, mixed;
    find_coefficients<P>(s, select(s.alike, z1, z1 * cosine_2), select(s.alike, z2, cosine_1 * z2), t, tiny,
                         series, plane, mixed);
    const V scalar = select(s.alike, half * (cosine_1 + cosine_2), cosine_1 * cosine_2);
    const V regular_four = select(s.alike, ratio(half * (cosine_2 - cosine_1), s.root, zero), z1 * z2);
    const V four =
        s.of.sign *
        select(tiny, square * M::multiply_add((one - square) * sum, V(T(1) / T(6)), one), regular_four);
    out[0] = select(outside, one, select(s.of.none, cosine_1, scalar)) + bad;
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[1 + K] = select(outside, zero,
                              select(s.of.none, 1 + K == e23 ? sine_1 ^ V(T(-0.0)) : zero,
                                     M::multiply_add(mixed, p.mixed[K], r[1 + K] * plane))) +
                       bad),
         ...);
    }
    (std::make_integer_sequence<int, 10>());
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[first_four_vector + K] =
              select(s.of.none | outside, zero, four * r[first_four_vector + K]) + bad),
         ...);
    }
    (std::make_integer_sequence<int, 5>());
    *unique = s.of.unique + bad;
}

// The components as they are where m.
template <class V>
inline void replace(mask_of<V> m, const V* by, V* out) noexcept {
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[K] = select(m, by[K], out[K])), ...);
    }
    (std::make_integer_sequence<int, no_more_blades>());
}

// Streams in: 10. Out: 16.
template <precision_index P, class V>
struct conformal_exp_op {
    using reads = streams<10>;
    using writes = streams<16>;

    explicit conformal_exp_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept { conformal_exp<P>(in, zero_or_nan<10>(in), out); }
};

// Streams in: 16. Out: 10, and 1 where the logarithm is unique, otherwise 0.
template <precision_index P, class V>
struct conformal_log_op {
    using reads = streams<16>;
    using writes = streams<10, 1>;

    explicit conformal_log_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept { conformal_log<P>(in, out, out + 10); }
};

// Streams in: 16, the exponent. Out: 16, and 1 where the power is unique, otherwise 0.
template <precision_index P, class V>
struct conformal_power_op {
    using T = scalar_of<V>;
    using reads = streams<16, 1>;
    using writes = streams<16, 1>;

    explicit conformal_power_op(const T*) noexcept {}

    [[gnu::noinline]] void operator()(const V* in, V* out) const noexcept {
        const V bad = zero_or_nan<16>(in) + V(T(0)) * in[16];
        conformal_power<P>(in, in[16], bad, out, out + 16);
        if constexpr (P == reproducible_index) replace(bad + in[16] == V(T(1)), in, out);
    }
};

// (b a~)^t a. Streams in: 16 of a, 16 of b, t. Out: 16, and 1 where it is unique, otherwise 0.
template <precision_index P, class V>
struct conformal_interpolate_op {
    using T = scalar_of<V>;
    using reads = streams<16, 16, 1>;
    using writes = streams<16, 1>;

    explicit conformal_interpolate_op(const T*) noexcept {}

    [[gnu::noinline]] void operator()(const V* in, V* out) const noexcept {
        const V bad = (zero_or_nan<16>(in) + zero_or_nan<16>(in + 16)) + V(T(0)) * in[32];
        V back[16], motion[16];
        conformal_reverse(in, back);
        conformal_product<P>(in + 16, back, motion);
        conformal_power<P>(motion, in[32], bad, back, out + 16);
        conformal_product<P>(back, in, out);
        if constexpr (P == reproducible_index) {
            replace(bad + in[32] == V(T(0)), in, out);
            replace(bad + in[32] == V(T(1)), in + 16, out);
        }
    }
};

}  // namespace
}  // namespace swivel

#endif
