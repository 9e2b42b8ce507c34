#ifndef SWIVEL_KERNELS_CONVERSIONS_MATRIX_HPP
#define SWIVEL_KERNELS_CONVERSIONS_MATRIX_HPP

#include "kernels/constants.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/quat.hpp"

namespace swivel {
namespace {

// Streams in: the elements xx xy xz yx yy yz zx zy zz. Out: x y z w.
template <precision_index P, class V>
struct from_matrix_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<9>;
    using writes = streams<4>;

    explicit from_matrix_op(const T*) noexcept {}

    // The columns of 4 q q^T are linear in the matrix; one whose diagonal element is at least 1, and with it
    // its length at least 2, gives q by its direction. The signs of the diagonal say which.
    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1)), minus(T(-0.0));
        const V xx = in[0], yy = in[4], zz = in[8];
        const mask_of<V> lower = zz < zero;
        const mask_of<V> x_or_y = yy < xx;
        const mask_of<V> z_not_w = xx < (yy ^ minus);

        // t = 1 +- xx +- yy +- zz: two signs are negative for x, y and z, none for w.
        const V sign_x = select(lower, select(x_or_y, zero, minus), select(z_not_w, minus, zero));
        const V sign_y = select(lower, select(x_or_y, minus, zero), select(z_not_w, minus, zero));
        const V t = ((xx ^ sign_x) + (yy ^ sign_y)) + (magnitude(zz) + one);

        const V dx = in[7] - in[5], dy = in[2] - in[6], dz = in[3] - in[1];
        const V sx = in[7] + in[5], sy = in[2] + in[6], sz = in[3] + in[1];
        const rotor<V> c{
            pick(lower, x_or_y, z_not_w, t, sz, sy, dx), pick(lower, x_or_y, z_not_w, sz, t, sx, dy),
            pick(lower, x_or_y, z_not_w, sy, sx, t, dz), pick(lower, x_or_y, z_not_w, dx, dy, dz, t)};
        const V squared = nan_for_infinity<M>(dot_of<P>(c, c));
        const V sign = select(c.w < zero, minus, zero);
        if constexpr (P == reproducible_index) {
            const V root = square_root_of(squared);
            out[0] = quotient(c.x, root) ^ sign;
            out[1] = quotient(c.y, root) ^ sign;
            out[2] = quotient(c.z, root) ^ sign;
            out[3] = magnitude(quotient(c.w, root));
        } else {
            const V reciprocal = M::reciprocal_root(squared);
            const V turned = reciprocal ^ sign;
            out[0] = c.x * turned;
            out[1] = c.y * turned;
            out[2] = c.z * turned;
            out[3] = magnitude(c.w * reciprocal);
        }
    }

    static V pick(mask_of<V> lower, mask_of<V> x_or_y, mask_of<V> z_not_w, V x, V y, V z, V w) noexcept {
        return select(lower, select(x_or_y, x, y), select(z_not_w, z, w));
    }
};

// Streams in: x y z w. Out: the elements xx xy xz yx yy yz zx zy zz.
template <precision_index P, class V>
struct to_matrix_op {
    using T = scalar_of<V>;
    using M = arithmetic<P>;
    using reads = streams<4>;
    using writes = streams<9>;

    explicit to_matrix_op(const T*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        const V zero(T(0)), one(T(1)), floor(constants<T>::pole_floor);
        const V x = in[0], y = in[1], z = in[2], w = in[3];
        // Quotients of the difference and the sum of two parts of |q|^2: what is wrong with the parts goes
        // into both. That leaves half the error of 1 - s (y^2 + z^2).
        const V y2 = y * y, z2 = z * z, w2 = w * w;
        const V wx = M::multiply_add(x, x, w2), yz = y2 + z2;
        const V wy = y2 + w2, xz = M::multiply_add(x, x, z2);
        const V wz = z2 + w2, xy = M::multiply_add(x, x, y2);
        const V squared = nan_for_infinity<M>(wx + yz);
        const mask_of<V> regular = not_less_equal(squared, floor);
        const V reciprocal = select(regular, quotient(one, select(regular, squared, one)), zero);
        const V least = select(regular, zero, one);
        out[0] = M::multiply_add(wx - yz, reciprocal, least);
        out[4] = M::multiply_add(wy - xz, reciprocal, least);
        out[8] = M::multiply_add(wz - xy, reciprocal, least);
        const V scale = reciprocal + reciprocal;
        const V X = scale * x, Y = scale * y, Z = scale * z;
        out[1] = M::negate_multiply_add(Z, w, X * y);
        out[3] = M::multiply_add(Z, w, X * y);
        out[2] = M::multiply_add(Y, w, X * z);
        out[6] = M::negate_multiply_add(Y, w, X * z);
        out[5] = M::negate_multiply_add(X, w, Y * z);
        out[7] = M::multiply_add(X, w, Y * z);
    }
};

}  // namespace
}  // namespace swivel

#endif
