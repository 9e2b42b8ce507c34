#ifndef SWIVEL_KERNELS_ROTORS_ROTATE_HPP
#define SWIVEL_KERNELS_ROTORS_ROTATE_HPP

#include "kernels/kernel.hpp"
#include "kernels/loops/streams.hpp"
#include "kernels/registers/ops.hpp"

namespace swivel {
namespace {

// v + w t + u x t with t = 2 u x v and q = (u, w).
template <precision_index P, class V>
inline void rotated(V x, V y, V z, V w, const V* v, V* out) noexcept {
    using M = arithmetic<P>;
    const V vx = v[0], vy = v[1], vz = v[2];
    V tx = M::negate_multiply_add(z, vy, y * vz);
    V ty = M::negate_multiply_add(x, vz, z * vx);
    V tz = M::negate_multiply_add(y, vx, x * vy);
    tx = tx + tx;
    ty = ty + ty;
    tz = tz + tz;
    // The sum of the turns before v, which is the largest.
    const V sx = M::multiply_add(w, tx, M::negate_multiply_add(z, ty, y * tz));
    const V sy = M::multiply_add(w, ty, M::negate_multiply_add(x, tz, z * tx));
    const V sz = M::multiply_add(w, tz, M::negate_multiply_add(y, tx, x * ty));
    out[0] = nan_for_infinity<M>(vx + sx);
    out[1] = nan_for_infinity<M>(vy + sy);
    out[2] = nan_for_infinity<M>(vz + sz);
}

// Streams in: q x y z w, v x y z. Out: x y z.
template <precision_index P, class V>
struct rotate_op {
    using reads = streams<4, 3>;
    using writes = streams<3>;

    explicit rotate_op(const scalar_of<V>*) noexcept {}

    void operator()(const V* in, V* out) const noexcept {
        rotated<P>(in[0], in[1], in[2], in[3], in + 4, out);
    }
};

// Streams in: v x y z. Uniform: q x y z w. Out: x y z.
template <precision_index P, class V>
struct rotate_by_one_op {
    using reads = streams<3>;
    using writes = streams<3>;

    V x, y, z, w;

    explicit rotate_by_one_op(const scalar_of<V>* uniform) noexcept
        : x(uniform[0]), y(uniform[1]), z(uniform[2]), w(uniform[3]) {}

    void operator()(const V* in, V* out) const noexcept { rotated<P>(x, y, z, w, in, out); }
};

}  // namespace
}  // namespace swivel

#endif
