#ifndef SWIVEL_KERNELS_SWING_TWIST_AXIS_FORM_HPP
#define SWIVEL_KERNELS_SWING_TWIST_AXIS_FORM_HPP

// The projection of a quaternion on its twist axis, for the three ways in which an axis can be given.
// decompose, twist, swing and twist_angle are written once over these forms.
//
// One body serves both products: exchanging x and y of everything (of the components B and C that are
// perpendicular to a coordinate axis) is a reflection, and turns q = S T into q = T R. The caller exchanges
// the pointers. The same way one coordinate form serves x, y and z, which are cyclic names (B, C; A) for one
// another.

#include "kernels/loops/streams.hpp"
#include "kernels/rotors/normalize.hpp"

namespace swivel {
namespace {

// T = cosine + sine a, a unit quaternion whatever the length of q.
template <class V>
struct half_twist {
    V cosine, sine;
};

// The pole is handled here and nowhere else: its elements get the twist copysign(1, w), and all that follows
// is computed from the masked pair. A NaN or an infinity anywhere in q makes norm_squared times 0, and with
// it the pair, NaN. What the root is at the pole does not matter; the masks drop it.
template <precision_index P, class V>
inline half_twist<V> half_twist_of(V w, V u, V t, V norm_squared, V threshold) noexcept {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    const V limit = M::multiply_add(threshold, norm_squared, V(constants<T>::pole_floor));
    const V t_or_nan = M::multiply_add(V(T(0)), norm_squared, t);
    const mask_of<V> regular = not_less_equal(t_or_nan, limit);
    if constexpr (P == reproducible_index) {
        // Two quotients, not one reciprocal: the rounding of a reciprocal would go into every norm.
        const V root = square_root_of(t_or_nan);
        return {select(regular, quotient(w, root), one_signed_like(w)),
                select(regular, quotient(u, root), V(T(0)))};
    } else {
        const V scale = M::reciprocal_root(t_or_nan);
        return {product_or(regular, w, scale, one_signed_like(w)), product_or_zero(regular, u, scale)};
    }
}

// Streams in: B C A w. Uniform: the threshold. Components out in the same order.
template <precision_index P, class V>
struct coordinate_form {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<4>;

    struct element {
        V b, c, a, w;
        V norm_squared;
    };

    V threshold;

    explicit coordinate_form(const T* uniform) noexcept : threshold(uniform[0]) {}

    void read(const V* in, element& q, half_twist<V>& h) const noexcept {
        const V b = in[0], c = in[1], a = in[2], w = in[3];
        const V t = M::multiply_add(a, a, w * w);
        // Both orders of b and c must give the same bits where the arithmetic is not fused.
        const V norm_squared =
            M::fuses ? M::multiply_add(c, c, M::multiply_add(b, b, t)) : (b * b + c * c) + t;
        h = half_twist_of<P>(w, a, t, norm_squared, threshold);
        q = {b, c, a, w, norm_squared};
    }

    static void swing(const element& q, const half_twist<V>& h, V* out) noexcept {
        swing_compact(q, h, out[0], out[1], out[3]);
        out[2] = zero_or_nan(q);
    }

    static void swing_compact(const element& q, const half_twist<V>& h, V& s1, V& s2, V& sc) noexcept {
        s1 = M::negate_multiply_add(h.sine, q.c, h.cosine * q.b);
        s2 = M::multiply_add(h.sine, q.b, h.cosine * q.c);
        sc = M::multiply_add(h.sine, q.a, h.cosine * q.w);
    }

    static void twist(const element& q, const half_twist<V>& h, V* out) noexcept {
        out[0] = out[1] = zero_or_nan(q);
        out[2] = h.sine;
        out[3] = h.cosine;
    }

    // A component that is 0 by construction is no place for a NaN to vanish in.
    static V zero_or_nan(const element& q) noexcept { return V(T(0)) * q.norm_squared; }
};

// Streams in: x y z w, components out in the same order. Derived forms say where the axis comes from.
template <precision_index P, class V>
struct vector_form {
    using T = scalar_of<V>;
    using M = arithmetic<P>;

    // Flat, and filled in rather than returned: gcc 12 keeps others in memory.
    struct element {
        V x, y, z, w, u, ax, ay, az;
    };

    V threshold;

    void project(const V* in, V ax, V ay, V az, V excess, element& q, half_twist<V>& h) const noexcept {
        const V x = in[0], y = in[1], z = in[2], w = in[3];
        const V u = M::multiply_add(az, z, M::multiply_add(ay, y, ax * x));
        const V w_squared = w * w;
        V t;
        if constexpr (M::fuses)
            t = M::multiply_add(u, u, w_squared);
        else
            t = u * u + (w_squared + excess * (u * u));
        // As above: x and y may be exchanged.
        const V norm_squared =
            M::fuses ? M::multiply_add(z, z, M::multiply_add(y, y, M::multiply_add(x, x, w_squared)))
                     : ((x * x + y * y) + z * z) + w_squared;
        h = half_twist_of<P>(w, u, t, norm_squared, threshold);
        q = {x, y, z, w, u, ax, ay, az};
    }

    // S = q T* = (c w + d u, c v - c u a + d a x v). The part c u of v along the axis is written without d,
    // so that it is taken out at the pole too.
    static void swing(const element& q, const half_twist<V>& h, V* out) noexcept {
        const V tx = h.sine * q.ax, ty = h.sine * q.ay, tz = h.sine * q.az;
        out[0] = swing_component(q.x, q.ax, ty, q.z, tz, q.y, h, q.u);
        out[1] = swing_component(q.y, q.ay, tz, q.x, tx, q.z, h, q.u);
        out[2] = swing_component(q.z, q.az, tx, q.y, ty, q.x, h, q.u);
        // T.q is c w + d u, but free of the rounding of u.
        if constexpr (P == fast_index)
            out[3] = M::multiply_add(h.sine, q.u, h.cosine * q.w);
        else
            out[3] = h.cosine * q.w + ((tx * q.x + ty * q.y) + tz * q.z);
    }

    // c (v - u a) + (p q - r s), the last being one component of d a x v. Unfused, c v - (c u) a rounds less.
    static V swing_component(V v, V a, V p, V q, V r, V s, const half_twist<V>& h, V u) noexcept {
        if constexpr (M::fuses) {
            const V perpendicular = h.cosine * M::negate_multiply_add(u, a, v);
            return M::negate_multiply_add(r, s, M::multiply_add(p, q, perpendicular));
        } else {
            return (h.cosine * v - h.cosine * u * a) + (p * q - r * s);
        }
    }

    static void twist(const element& q, const half_twist<V>& h, V* out) noexcept {
        out[0] = h.sine * q.ax;
        out[1] = h.sine * q.ay;
        out[2] = h.sine * q.az;
        out[3] = h.cosine;
    }
};

// Uniform: the threshold, the unit axis, and |a|^2 - 1, what its rounding left over. That is taken out of the
// norms, except where the arithmetic is fused and has room for it in its figures.
template <precision_index P, class V>
struct uniform_form : vector_form<P, V> {
    using base = vector_form<P, V>;
    using reads = streams<4>;

    V ax, ay, az, excess;

    explicit uniform_form(const scalar_of<V>* uniform) noexcept
        : base{V(uniform[0])}, ax(uniform[1]), ay(uniform[2]), az(uniform[3]), excess(uniform[4]) {}

    void read(const V* in, typename base::element& q, half_twist<V>& h) const noexcept {
        base::project(in, ax, ay, az, excess, q, h);
    }
};

template <class V>
struct unit_vector {
    V x, y, z;
};

// Streams in, after those of the quaternion: the axis x y z, of any length.
template <precision_index P, class V>
struct per_element_form : vector_form<P, V> {
    using base = vector_form<P, V>;
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<4, 3>;

    explicit per_element_form(const T* uniform) noexcept : base{V(uniform[0])} {}

    void read(const V* in, typename base::element& q, half_twist<V>& h) const noexcept {
        const unit_vector<V> a = normalized(in[4], in[5], in[6]);
        base::project(in, a.x, a.y, a.z, V(T(0)), q, h);
    }

    static unit_vector<V> normalized(V x, V y, V z) noexcept {
        to_unit_length<P>(x, y, z);
        return {x, y, z};
    }
};

// The form of an index, in the precision of another.
template <int Form, int P, class V>
struct chosen_form;
template <int P, class V>
struct chosen_form<coordinate_index, P, V> {
    using type = coordinate_form<precision_index(P), V>;
};
template <int P, class V>
struct chosen_form<uniform_index, P, V> {
    using type = uniform_form<precision_index(P), V>;
};
template <int P, class V>
struct chosen_form<per_element_index, P, V> {
    using type = per_element_form<precision_index(P), V>;
};
template <int Form, int P, class V>
using axis_form = typename chosen_form<Form, P, V>::type;

}  // namespace
}  // namespace swivel

#endif
