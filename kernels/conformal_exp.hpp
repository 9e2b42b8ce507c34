#ifndef SWIVEL_KERNELS_CONFORMAL_EXP_HPP
#define SWIVEL_KERNELS_CONFORMAL_EXP_HPP

#include "atan2.hpp"
#include "conformal_planes.hpp"
#include "hyperbolic.hpp"
#include "sincos.hpp"

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
    sincos_within<P>(x1, sine1, cosine1);
    sincos_within<P>(x2, sine2, cosine2);
    sinhcosh_of<P>(x2, sinh2, cosh2);
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

// log to 10 components; unique is 1 or 0.
template <precision_index P, class V>
[[gnu::noinline]] void conformal_log(const V* r, V* b, V* unique) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    const V zero(T(0)), one(T(1)), half(T(0.5)), bad = zero_or_nan<16>(r);
    V big, small;
    even_parts<V> p;
    find_parts<P>(r, p);
    const regular_rotor<V> c = find_regular(r[0], p);
    const V scalar = c.sign * r[0], g = p.four_squared;
    find_roots<P>((g + g) - p.bivector_squared, g, big, small);
    const mask_of<V> hyperbolic = small < zero;
    const mask_of<V> alike = V(T(4)) * small > big;
    const mask_of<V> tiny = (scalar > zero) & (larger(big, small ^ V(T(-0.0))) < V(C::small_square));

    // Of planes that turn by like angles, the sum and the difference of these.
    const V root = square_root_of(larger(g, zero)), cross = (scalar + scalar) * root;
    const V cos_b = square_root_of(larger(one - small, zero)), cos_a = quotient(scalar, larger(cos_b, half));
    const V y1 = square_root_of(larger(select(alike, cross - p.bivector_squared, big), zero));
    const V y2 = square_root_of(
        larger(select(alike, (p.bivector_squared ^ V(T(-0.0))) - cross, magnitude(small)), zero));
    const V first = ratio(atan2_above<P>(y1, select(alike, scalar - root, cos_a)), y1, one);
    const V angle = atan2_above<P>(y2, select(alike, scalar + root, cos_b));
    const V second = ratio(select(hyperbolic, asinh_of<P>(y2), angle), y2, one);

    const V apart = big - small;
    const V planes = ratio(M::negate_multiply_add(small * cos_a, second, (big * cos_b) * first), apart, one);
    const V plane = c.sign * select(alike, half * (first + second), planes);
    const V difference = select(alike, second - first, M::negate_multiply_add(cos_b, second, cos_a * first));
    const V mixed = select(tiny, M::negate_multiply_add(V(T(2) / T(15)), big + small, V(T(-1) / T(3))),
                           ratio(difference, select(alike, root + root, apart), zero));
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((b[K] = select(c.none, V(1 + K == e23 ? -C::pi : T(0)),
                        M::multiply_add(mixed, p.mixed[K], r[1 + K] * plane)) +
                 bad),
         ...);
    }
    (std::make_integer_sequence<int, 10>());
    *unique = c.unique + bad;
}

// exp(t log r)
template <precision_index P, class V>
inline void conformal_power(const V* r, V t, V bad, V* out, V* unique) noexcept {
    V b[10];
    conformal_log<P>(r, b, unique);
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((b[K] = t * b[K]), ...);
    }
    (std::make_integer_sequence<int, 10>());
    conformal_exp<P>(b, bad, out);
    *unique = *unique + bad;
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
    static constexpr int inputs = 10, quaternions_in = 0;
    static constexpr int outputs = 16, quaternions_out = 0;

    explicit conformal_exp_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept { conformal_exp<P>(in, zero_or_nan<10>(in), out); }
};

// Streams in: 16. Out: 10, and 1 where the logarithm is unique, otherwise 0.
template <precision_index P, class V>
struct conformal_log_op {
    static constexpr int inputs = 16, quaternions_in = 0;
    static constexpr int outputs = 11, quaternions_out = 0;

    explicit conformal_log_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept { conformal_log<P>(in, out, out + 10); }
};

// Streams in: 16, the exponent. Out: 16, and 1 where the power is unique, otherwise 0.
template <precision_index P, class V>
struct conformal_power_op {
    using T = scalar_of<V>;
    static constexpr int inputs = 17, quaternions_in = 0;
    static constexpr int outputs = 17, quaternions_out = 0;

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
    static constexpr int inputs = 33, quaternions_in = 0;
    static constexpr int outputs = 17, quaternions_out = 0;

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
