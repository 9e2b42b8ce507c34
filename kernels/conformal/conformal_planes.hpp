#ifndef SWIVEL_KERNELS_CONFORMAL_CONFORMAL_PLANES_HPP
#define SWIVEL_KERNELS_CONFORMAL_CONFORMAL_PLANES_HPP

// What the functions of conformal rotors and bivectors share. Each bivector is the sum of two that commute, a
// A + b B with unit squares: planes of rotation, or for B of a boost or null. A rotor is cos a cos b + sin a
// cos b A + cos a sin b B + sin a sin b A B. The functions find the squares, sums and products of sines that
// they need without the planes, which are not unique where a and b are alike.

#include "kernels/conformal/conformal.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/rotors/normalize.hpp"

namespace swivel {
namespace {

// Of a bivector r and a part f of four vectors that commutes with it.
template <class V>
struct even_parts {
    V bivector_squared, four_squared;  // scalar parts
    V bivector_size, four_size;        // sums of the squares of the components
    V mixed[10];                       // the bivector part of r f
};

template <precision_index P, int First, int End, class V>
inline V size_of(const V* r) noexcept {
    V sum(scalar_of<V>(0));
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((sum = arithmetic<P>::multiply_add(r[First + K], r[First + K], sum)), ...);
    }
    (std::make_integer_sequence<int, End - First>());
    return sum;
}

// sum - a^2
template <precision_index P, class V>
inline V less_square(V a, V sum) noexcept {
    return arithmetic<P>::negate_multiply_add(a, a, sum);
}

// The scalar part of the square of the bivector.
template <precision_index P, class V>
inline V bivector_square(const V* r) noexcept {
    using M = arithmetic<P>;
    // Of what is null nothing is left, as e4 and e5 come in differences.
    V s = (r[e15] - r[e14]) * (r[e15] + r[e14]);
    s = M::multiply_add(r[e25] - r[e24], r[e25] + r[e24], s);
    s = M::multiply_add(r[e35] - r[e34], r[e35] + r[e34], s);
    s = M::multiply_add(r[e45], r[e45], s);
    return less_square<P>(r[e23], less_square<P>(r[e13], less_square<P>(r[e12], s)));
}

template <precision_index P, class V>
inline void find_parts(const V* r, even_parts<V>& p) noexcept {
    p.bivector_squared = bivector_square<P>(r);
    const V g = (r[e1234] - r[e1235]) * (r[e1234] + r[e1235]);
    p.four_squared = less_square<P>(r[e2345], less_square<P>(r[e1345], less_square<P>(r[e1245], g)));
    p.bivector_size = size_of<P, first_bivector, first_four_vector>(r);
    p.four_size = size_of<P, first_four_vector, no_more_blades>(r);
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((p.mixed[K] = product_component<P, K + first_bivector, bivector_grade, four_vector_grade>(r, r)),
         ...);
    }
    (std::make_integer_sequence<int, 10>());
}

// Puts the bivector into r, and the part of four vectors of half of its square; the scalar stays.
template <precision_index P, class V>
inline void put_with_half_square(const V* b, V* r) noexcept {
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((r[first_bivector + K] = b[K]), ...);
    }
    (std::make_integer_sequence<int, 10>());
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((r[first_four_vector + K] =
              V(scalar_of<V>(0.5)) *
              product_component<P, first_four_vector + K, bivector_grade, bivector_grade>(r, r)),
         ...);
    }
    (std::make_integer_sequence<int, 5>());
}

// p >= q with p + q = sum and p q = product; p >= 0.
template <precision_index P, class V>
inline void find_roots(V sum, V product, V& p, V& q) noexcept {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    const V zero(T(0)), minus(T(-0.0));
    const V size = magnitude(sum);
    // Its square would be subnormal.
    const mask_of<V> tiny = size < V(constants<T>::root_of_smallest_normal);
    const V part = select(tiny, zero, sum);
    const V root = square_root_of(larger(M::negate_multiply_add(V(T(4)), product, part * part), zero));
    const V big = V(T(0.5)) * (size + select(tiny, larger(size, root), root));
    const V other = quotient(product, larger(big, V(constants<T>::pole_floor)));
    const mask_of<V> positive = sum >= zero;
    p = select(positive, big, larger(other ^ minus, zero));
    q = select(positive, select(other > big, big, other), big ^ minus);
}

// a / b, or `other` where not m: nothing is divided there.
template <class V>
inline V quotient_or(mask_of<V> m, V a, V b, V other) noexcept {
    return select(m, quotient(a, select(m, b, V(scalar_of<V>(1)))), other);
}

// a / b, or `limit` where b is as good as 0.
template <class V>
inline V ratio(V a, V b, V limit) noexcept {
    return quotient_or(b > V(constants<scalar_of<V>>::pole_floor), a, b, limit);
}

// k = 2 cos(a/2) cos(b/2) and n = cos a + cos b of a rotor, squared, and whether they are more than rounding:
// where either is 0, there is more than one root and logarithm, or none.
template <class V>
struct half_cosines {
    V k_squared, n_squared;
    mask_of<V> regular;
};

template <class V>
inline half_cosines<V> half_cosines_of(V scalar, const even_parts<V>& p, V bivector_size,
                                       V four_size) noexcept {
    using T = scalar_of<V>;
    const V zero(T(0)), one(T(1)), noise(constants<T>::noise);
    const mask_of<V> positive = scalar >= zero;
    const V less = select(positive, one, one - scalar);
    // 1 + scalar, without cancellation.
    const V above = select(positive, one + scalar, quotient(p.four_squared - p.bivector_squared, less));
    const V share = select(positive, zero, quotient(bivector_size, less));
    // Nothing where its square counts for nothing, and would with the noise be subnormal.
    const V large = select(magnitude(above) < V(constants<T>::root_of_pole_floor), zero, above);
    const V n_squared = large * large - p.four_squared;
    const V n = square_root_of(larger(n_squared, zero));
    const V k_squared = quotient_or(above < zero, p.four_squared ^ V(T(-0.0)), n - above, above + n);
    const V size = magnitude(large), sum = (size + share) * size + four_size;
    return {k_squared, n_squared,
            (n_squared > noise * sum + V(constants<T>::pole_floor)) &
                (k_squared > noise * select(positive, zero, bivector_size))};
}

// Of R, or of -R where R has no root of its own but -R does: the sign is that which makes R what it is of.
// `none` where neither has one, where R is -1, and outside of the domain.
template <class V>
struct regular_rotor {
    V sign, unique, k_squared, n_squared;
    mask_of<V> none;
};

template <class V>
inline regular_rotor<V> find_regular(V scalar, const even_parts<V>& p) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    const V zero(T(0)), one(T(1)), noise(C::noise);
    // But for rotations about an axis through the origin, which are exact in relation to their size, the
    // components have the rounding of 1.
    const mask_of<V> origin =
        (p.bivector_size + p.bivector_squared <= noise * p.bivector_size) & (p.four_size == zero);
    const V bivector_size = p.bivector_size + select(origin, zero, square_root_of(p.bivector_size));
    const V four_size = p.four_size + select(origin, zero, square_root_of(p.four_size) + noise);
    const half_cosines<V> own = half_cosines_of(scalar, p, bivector_size, four_size);
    const half_cosines<V> other = half_cosines_of(scalar ^ V(T(-0.0)), p, bivector_size, four_size);
    const V size = p.bivector_size + p.four_size;
    const V limit(C::largest_blade * C::largest_blade);
    const mask_of<V> inside = scalar * scalar + size <= limit;
    const mask_of<V> found = own.regular | (other.regular & (size > V(T(16) * C::pole_threshold)));
    return {select(own.regular, one, V(T(-1))), select(own.regular & inside, one, zero),
            select(own.regular, own.k_squared, other.k_squared),
            select(own.regular, own.n_squared, other.n_squared), ~(inside & found)};
}

// Streams in: 16. Out: 16, and 1 where the root is unique, otherwise 0.
template <precision_index P, class V>
struct conformal_square_root_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<16>;
    using writes = streams<16, 1>;

    explicit conformal_square_root_op(const T*) noexcept {}

    [[gnu::noinline]] void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), bad = zero_or_nan<16>(in);
        even_parts<V> p;
        find_parts<P>(in, p);
        const regular_rotor<V> c = find_regular(in[0], p);
        const V one(T(1)), k = square_root_of(select(c.none, one, c.k_squared)), twice = k + k;
        const V mixed = quotient(one, square_root_of(select(c.none, one, c.n_squared)) * twice);
        const V four = quotient(c.sign, twice), plane = c.sign * (c.k_squared * mixed);
        out[0] = select(c.none, zero, V(T(0.5)) * k) + bad;
        [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
            ((out[1 + K] = select(c.none, V(T(1 + K == e23 ? -1 : 0)),
                                  M::negate_multiply_add(mixed, p.mixed[K], in[1 + K] * plane)) +
                           bad),
             ...);
        }
        (std::make_integer_sequence<int, 10>());
        [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
            ((out[first_four_vector + K] = select(c.none, zero, four * in[first_four_vector + K]) + bad),
             ...);
        }
        (std::make_integer_sequence<int, 5>());
        out[16] = c.unique + bad;
    }
};

// Streams in: 10. Out: 10 of the first part, 10 of the second, and 1 where they are unique, otherwise 0.
template <precision_index P, class V>
struct conformal_split_op {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    using reads = streams<10>;
    using writes = streams<10, 10, 1>;

    explicit conformal_split_op(const T*) noexcept {}

    [[gnu::noinline]] void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), half(T(0.5)), bad = zero_or_nan<10>(in);
        // Of any length: the largest component is brought to 2..4.
        V largest = zero, scaled[10];
        [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
            ((largest = larger(largest, magnitude(in[K]))), ...);
        }
        (std::make_integer_sequence<int, 10>());
        const V scale = reciprocal_power_of_two(select(largest == zero, V(T(1)), largest)),
                back = quotient(V(T(1)), scale);
        [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
            ((scaled[K] = in[K] * scale), ...);
        }
        (std::make_integer_sequence<int, 10>());

        V r[16], big, small;
        even_parts<V> p;
        r[0] = zero;
        put_with_half_square<P>(scaled, r);
        find_parts<P>(r, p);
        find_roots<P>(p.bivector_squared ^ V(T(-0.0)), p.four_squared, big, small);

        // Of angles that are alike, from (a + b)(A + B) and (a - b)(A - B): the difference of the squares is lost in
        // their rounding long before a - b is.
        const mask_of<V> alike = V(T(4)) * small > big;
        const V over_root = ratio(V(T(1)), square_root_of(larger(p.four_squared, zero)), zero);
        V sums[16], differences[16];
        [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
            ((sums[1 + K] = M::negate_multiply_add(over_root, p.mixed[K], r[1 + K])), ...);
            ((differences[1 + K] = M::multiply_add(over_root, p.mixed[K], r[1 + K])), ...);
        }
        (std::make_integer_sequence<int, 10>());
        const V sum = square_root_of(larger(bivector_square<P>(sums) * V(T(-0.5)), zero));
        const V difference = square_root_of(larger(bivector_square<P>(differences) * V(T(-0.5)), zero));
        const V a = half * (sum + difference), half_a = half * a;
        const V of_sums = ratio(half_a, sum, zero), of_differences = ratio(half_a, difference, zero);

        const V apart = select(alike, sum * difference, big - small);
        const mask_of<V> unique = apart > V(C::noise) * p.bivector_size;
        const V over = select(unique, apart, V(T(1)));
        [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
            ((out[K] = select(unique,
                              back * select(alike,
                                            M::multiply_add(of_sums, sums[1 + K],
                                                            of_differences * differences[1 + K]),
                                            quotient(M::multiply_add(big, r[1 + K], p.mixed[K]), over)),
                              in[K]) +
                       bad),
             ...);
            ((out[10 + K] = in[K] - out[K]), ...);
        }
        (std::make_integer_sequence<int, 10>());
        out[20] = select(unique, V(T(1)), zero) + bad;
    }
};

}  // namespace
}  // namespace swivel

#endif
