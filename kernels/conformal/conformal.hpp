#ifndef SWIVEL_KERNELS_CONFORMAL_CONFORMAL_HPP
#define SWIVEL_KERNELS_CONFORMAL_CONFORMAL_HPP

// Even elements of the conformal algebra in registers, 16 components in the order of conformal_view. The
// operations are functions of their own, not inlined: the loop over whole registers and the one of the tail,
// and the operations that are made of others, call the same code.

#include <utility>

#include "kernels/constants.hpp"
#include "kernels/kernel.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

// Blades as sets of basis vectors, a bit each.
inline constexpr unsigned blade_sets[16] = {0, 3, 5, 9, 17, 6, 10, 18, 12, 20, 24, 15, 23, 27, 29, 30};
inline constexpr int first_bivector = 1, first_four_vector = 11, no_more_blades = 16;
// Places of components.
inline constexpr int e12 = 1, e13 = 2, e14 = 3, e15 = 4, e23 = 5, e24 = 6, e25 = 7, e34 = 8, e35 = 9,
                     e45 = 10, e1234 = 11, e1235 = 12, e1245 = 13, e1345 = 14, e2345 = 15;

constexpr int place_of(unsigned set) noexcept {
    int k = 0;
    while (k < no_more_blades && blade_sets[k] != set) ++k;
    return k;
}

// Whether the product of two blades is minus the blade of the vectors that only one of them has.
constexpr bool negative_product(unsigned a, unsigned b) noexcept {
    int changes = static_cast<int>((a & b) >> 4);
    for (unsigned higher = a >> 1; higher != 0; higher >>= 1) changes += __builtin_popcount(higher & b);
    return changes % 2 != 0;
}

// The components of one grade, or of all.
template <int First, int End>
struct grades {
    static constexpr bool has(int place) noexcept { return place >= First && place < End; }
};
using all_grades = grades<0, no_more_blades>;
using bivector_grade = grades<first_bivector, first_four_vector>;
using four_vector_grade = grades<first_four_vector, no_more_blades>;

template <precision_index P, int Out, class A, class B, int I, class V>
inline void add_product(V& sum, const V* a, const V* b) noexcept {
    using M = arithmetic<P>;
    constexpr unsigned set = blade_sets[I] ^ blade_sets[Out];
    constexpr int J = place_of(set);
    if constexpr (A::has(I) && B::has(J)) {
        if constexpr (negative_product(blade_sets[I], set))
            sum = M::negate_multiply_add(a[I], b[J], sum);
        else
            sum = M::multiply_add(a[I], b[J], sum);
    }
}

// Where the blade is with e4 and e5 exchanged.
constexpr int place_of_exchanged(int place) noexcept {
    const unsigned set = blade_sets[place];
    return place_of((set & 7U) | (set >> 1 & 8U) | (set << 1 & 16U));
}

// Component Out of the product of the part A of a and the part B of b. The terms of a component with e5 come
// in the order of those of its like with e4: where the two are equal, as in everything that leaves infinity
// where it is, they are equal in every bit, and their difference is exactly 0.
template <precision_index P, int Out, class A, class B, class V>
inline V product_component(const V* a, const V* b) noexcept {
    constexpr bool exchanged = (blade_sets[Out] & 24U) == 16U;
    V sum(scalar_of<V>(0));
    [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
        (add_product < P, Out, A, B, exchanged ? place_of_exchanged(I) : I > (sum, a, b), ...);
    }
    (std::make_integer_sequence<int, no_more_blades>());
    return sum;
}

// The geometric product.
template <precision_index P, class V>
[[gnu::noinline]] void conformal_product(const V* a, const V* b, V* out) noexcept {
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[K] = nan_for_infinity<arithmetic<P>>(product_component<P, K, all_grades, all_grades>(a, b))),
         ...);
    }
    (std::make_integer_sequence<int, no_more_blades>());
}

template <class V>
inline void conformal_reverse(const V* c, V* out) noexcept {
    const V minus(scalar_of<V>(-0.0));
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[K] = bivector_grade::has(K) ? c[K] ^ minus : c[K]), ...);
    }
    (std::make_integer_sequence<int, no_more_blades>());
}

// Streams in: 16 of a, 16 of b. Out: 16.
template <precision_index P, class V>
struct conformal_multiply_op {
    using reads = streams<16, 16>;
    using writes = streams<16>;

    explicit conformal_multiply_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept { conformal_product<P>(in, in + 16, out); }
};

// Streams in: 16. Out: 16.
template <class V>
struct conformal_reverse_op {
    using reads = streams<16>;
    using writes = streams<16>;

    explicit conformal_reverse_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept { conformal_reverse(in, out); }
};

template <class V>
inline void fill_with(V value, V* out) noexcept {
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        ((out[K] = value), ...);
    }
    (std::make_integer_sequence<int, no_more_blades>());
}

// The rotor w - I3 (x, y, z) and the part of ni = e4 + e5, - (dx, dy, dz) ni - dw I3 ni. Streams in: x y z w
// dx dy dz dw. Out: 16.
template <class V>
struct conformal_from_motor_op {
    using reads = streams<8>;
    using writes = streams<16>;

    explicit conformal_from_motor_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V bad = zero_or_nan<8>(in);
        fill_with(bad, out);
        out[0] = bad + in[3];
        out[e12] = bad - in[2];
        out[e13] = bad + in[1];
        out[e23] = bad - in[0];
        out[e14] = out[e15] = bad - in[4];
        out[e24] = out[e25] = bad - in[5];
        out[e34] = out[e35] = bad - in[6];
        out[e1234] = out[e1235] = bad - in[7];
    }
};

// Streams in: x y z w. Out: 16.
template <class V>
struct conformal_from_rotation_op {
    using reads = streams<4>;
    using writes = streams<16>;

    explicit conformal_from_rotation_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V bad = zero_or_nan<4>(in);
        fill_with(bad, out);
        out[0] = bad + in[3];
        out[e12] = bad - in[2];
        out[e13] = bad + in[1];
        out[e23] = bad - in[0];
    }
};

// Streams in: x y z of the translation. Out: 16.
template <class V>
struct conformal_from_translation_op {
    using reads = streams<3>;
    using writes = streams<16>;

    explicit conformal_from_translation_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V bad = zero_or_nan<3>(in), half(scalar_of<V>(0.5));
        fill_with(bad, out);
        out[0] = bad + V(scalar_of<V>(1));
        out[e14] = out[e15] = bad - half * in[0];
        out[e24] = out[e25] = bad - half * in[1];
        out[e34] = out[e35] = bad - half * in[2];
    }
};

// cosh(L/2) + sinh(L/2) e45 with the factor exp(-L). Streams in: the factor. Out: 16.
template <class V>
struct conformal_from_dilation_op {
    using reads = streams<1>;
    using writes = streams<16>;

    explicit conformal_from_dilation_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        using T = scalar_of<V>;
        const V one(T(1)), half(T(0.5)), bad = zero_or_nan<1>(in);
        const V factor = select(in[0] > V(T(0)), in[0], one), root = square_root_of(factor);
        fill_with(bad, out);
        out[0] = half * (root + quotient(one, root)) + bad;
        out[e45] = half * quotient(one - factor, root) + bad;
    }
};

// A rotor as a fraction (A p + b) / (c p + D) of the point p, where A and D are quaternions and b and c are
// vectors with a part of I3: what multiplies 1 and e45, ni, and no. Quick, and since the point is not
// squared, right far from the origin. Streams in: 16 of the rotor, x y z of the point. Out: x y z.
template <precision_index P, class V>
struct conformal_transform_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<16, 3>;
    using writes = streams<3>;

    explicit conformal_transform_op(const T*) noexcept {}

    [[gnu::noinline]] void operator()(const V* in, V* out) const noexcept {
        const V x = in[16], y = in[17], z = in[18], minus(T(-0.0));
        const auto axpy = [](V a, V b, V c) { return M::multiply_add(a, b, c); };
        const auto less = [](V a, V b, V c) { return M::negate_multiply_add(a, b, c); };
        // x y z of a quaternion are - e23, + e13, - e12.
        const V aw = in[0] - in[e45], ax = in[e2345] - in[e23], ay = in[e13] - in[e1345],
                az = in[e1245] - in[e12];
        const V dw = in[0] + in[e45], dx = (in[e2345] + in[e23]) ^ minus, dy = in[e13] + in[e1345],
                dz = (in[e1245] + in[e12]) ^ minus;
        const V bx = in[e14] + in[e15], by = in[e24] + in[e25], bz = in[e34] + in[e35];
        const V cx = in[e14] - in[e15], cy = in[e24] - in[e25], cz = in[e34] - in[e35];
        const V bt = in[e1234] + in[e1235], ct = in[e1234] - in[e1235];

        const V nx = less(az, y, axpy(ay, z, axpy(aw, x, minus ^ bx)));
        const V ny = less(ax, z, axpy(az, x, axpy(aw, y, minus ^ by)));
        const V nz = less(ay, x, axpy(ax, y, axpy(aw, z, minus ^ bz)));
        const V nt = less(az, z, less(ay, y, less(ax, x, minus ^ bt)));
        const V qw = axpy(cz, z, axpy(cy, y, axpy(cx, x, dw)));
        const V qx = less(ct, x, axpy(cz, y, less(cy, z, dx)));
        const V qy = less(ct, y, axpy(cx, z, less(cz, x, dy)));
        const V qz = less(ct, z, axpy(cy, x, less(cx, y, dz)));

        const V bad = zero_or_nan<19>(in);
        const V weight = axpy(qw, qw, axpy(qz, qz, axpy(qy, qy, qx * qx)));
        const V scale = quotient(V(T(1)), larger(V(constants<T>::pole_floor), weight)) + bad;
        out[0] = scale * less(qz, ny, axpy(qy, nz, less(nt, qx, qw * nx)));
        out[1] = scale * less(qx, nz, axpy(qz, nx, less(nt, qy, qw * ny)));
        out[2] = scale * less(qy, nx, axpy(qx, ny, less(nt, qz, qw * nz)));
    }
};

}  // namespace
}  // namespace swivel

#endif
