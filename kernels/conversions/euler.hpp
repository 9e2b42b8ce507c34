#ifndef SWIVEL_KERNELS_CONVERSIONS_EULER_HPP
#define SWIVEL_KERNELS_CONVERSIONS_EULER_HPP

// One body serves all orders. The axes i and j are those of the first and second rotation, k is the one that is left;
// the caller permutes the pointers. The third rotation is about k, or in the proper orders about i again. Where i j =
// -k the axis k is turned round, with the angle about it, so that i j = k.

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/constants.hpp"
#include "kernels/loops/streams.hpp"

namespace swivel {
namespace {

// Uniform: 1, or -1 where i j = -k; 1, or -1 for a proper order. Streams in: the angles, first to third. Out: i j k w.
template <precision_index P, class V>
struct from_euler_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<3>;
    using writes = streams<4>;

    V mirror, sign_i, sign_j, sign_k;
    mask_of<V> proper;

    explicit from_euler_op(const T* uniform) noexcept
        : mirror(sign_of(V(uniform[0]))), proper(V(uniform[1]) < V(T(0))) {
        const V zero(T(0)), minus(T(-0.0));
        sign_i = select(proper, zero, mirror);
        sign_j = select(proper, minus, mirror);
        sign_k = select(proper, mirror ^ minus, zero);
    }

    // (ci + si i) (cj + sj j) times (ck + sk k), or for proper orders times (ck + sk i).
    void operator()(const V* in, V* out) const noexcept {
        const V half(T(0.5));
        V si, ci, sj, cj, sk, ck;
        sincos_of<P>(half * in[0], si, ci);
        sincos_of<P>(half * in[1], sj, cj);
        sincos_of<P>(half * in[2], sk, ck);
        const V cc = ci * cj, ss = si * sj, sc = si * cj, cs = ci * sj, turned = sk ^ sign_i;
        out[0] = M::multiply_add(select(proper, cc, cs), turned, sc * ck);
        out[1] = M::negate_multiply_add(select(proper, ss, sc), sk ^ sign_j, cs * ck);
        out[2] = M::multiply_add(select(proper, cs, cc), sk ^ sign_k, ss * (ck ^ mirror));
        out[3] = M::negate_multiply_add(select(proper, sc, ss), turned, cc * ck);
    }
};

// Uniform: 1, or -1 where i j = -k; 1, or -1 for a proper order. Streams in: i j k w. Out: the angles, first to third.
template <precision_index P, class V>
struct to_euler_op {
    using T = scalar_of<V>;
    using C = constants<T>;
    using M = arithmetic<P>;
    using reads = streams<4>;
    using writes = streams<3>;

    V mirror, third_sign;
    mask_of<V> proper;

    explicit to_euler_op(const T* uniform) noexcept
        : mirror(sign_of(V(uniform[0]))), proper(V(uniform[1]) < V(T(0))) {
        third_sign = select(proper, V(T(0)), mirror);
    }

    // With the angles a, b, c of the three rotations, the points
    //   p = (w + j, i + k) = |q| sqrt 2 cos(b/2 - pi/4) (cos, sin)((a + c)/2)
    //   m = (w - j, i - k) = |q| sqrt 2 cos(b/2 + pi/4) (cos, sin)((a - c)/2)
    // have the other angles in them. In a lock one of them is 0, and near it a difference of numbers that are
    // so close that it is exact: the angles are as good there as elsewhere. Of a proper order the points are
    //   p = (w, i) = |q| cos(b/2) (cos, sin)((a + c)/2)
    //   m = (j, k) = |q| sin(b/2) (cos, sin)((a - c)/2)
    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0));
        const V i = in[0], j = in[1], k = in[2] ^ mirror, w = in[3];
        const V px = select(proper, w, w + j), py = select(proper, i, i + k);
        const V mx = select(proper, j, w - j), my = select(proper, k, i - k);
        const V p_squared = M::multiply_add(py, py, px * px), m_squared = M::multiply_add(my, my, mx * mx);
        const V both = p_squared + m_squared;
        const V poison = zero * both;

        // Turned by half a turn where needed, both are in [-pi/2, pi/2].
        const V p_sign = half_plane(py, px), m_sign = half_plane(my, mx);
        V sum = atan2_of<P>(py ^ p_sign, magnitude(px));
        V difference = atan2_of<P>(my ^ m_sign, magnitude(mx));
        const V limit = M::multiply_add(V(C::pole_threshold), both, V(C::pole_floor));
        const mask_of<V> no_difference = m_squared <= limit, no_sum = p_squared <= limit;
        const mask_of<V> locked = no_difference | no_sum;
        difference = select(no_difference, sum, difference);
        sum = select(no_sum, difference, sum);
        const V turned = select(locked, zero, p_sign ^ m_sign);

        const mask_of<V> half_turn = one_signed_like(turned) < zero;
        out[0] = turn(sum + difference, half_turn) + poison;
        out[2] = (turn(sum - difference, half_turn) ^ third_sign) + poison;
        const V two(T(2)), lengths = square_root_of(p_squared) * square_root_of(m_squared);
        const V y = select(proper, two * lengths, two * M::multiply_add(i, k, w * j));
        const V x = select(proper, p_squared - m_squared, lengths);
        out[1] = atan2_of<P>(y, x) + poison;
    }

    // -0 for one of (x, y) and (-x, -y), and 0 for the other; a difference that is 0 has the same sign in
    // both.
    static V half_plane(V y, V x) noexcept { return sign_of(select(x == V(T(0)), y, x)); }

    // By pi, to the other side of 0, which keeps the angle in [-pi, pi]; 0 becomes pi.
    static V turn(V angle, mask_of<V> half_turn) noexcept {
        const V two(T(2)), zero(T(0));
        const V sign = select(angle > zero, zero, V(T(-0.0)));
        const V pi = two * V(C::half_pi), rest = two * V(C::half_pi_rest);
        return select(half_turn, (angle - (pi ^ sign)) - (rest ^ sign), angle);
    }
};

}  // namespace
}  // namespace swivel

#endif
