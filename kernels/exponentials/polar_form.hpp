#ifndef SWIVEL_KERNELS_EXPONENTIALS_POLAR_FORM_HPP
#define SWIVEL_KERNELS_EXPONENTIALS_POLAR_FORM_HPP

#include "kernels/vector3.hpp"

namespace swivel {
namespace {

// A quaternion as m d + w with a unit vector d, x where there is no vector part. A w of -0 becomes 0. A NaN
// or an infinity makes m or w NaN, and with it all that is computed from both.
template <precision_index P, class V>
struct polar_form {
    V m, w;
    vector3<V> v;               // the vector part on a scale of its own
    root_divisor<P, V> length;  // of that
    mask_of<V> scalar_only;

    // a d
    void along(V a, V* out) const noexcept {
        const V factor = length.divide(a);
        out[0] = select(scalar_only, a, v.x * factor);
        out[1] = v.y * factor;
        out[2] = v.z * factor;
    }
};

// Of q times by, which is a power of two. Another power of two brings the largest component of the vector
// part to 2..4: its direction counts, however small it is, where w is negative.
template <precision_index P, class V>
inline polar_form<P, V> polar(const V* q, scalar_of<V> by) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    const V zero(T(0)), one(T(1)), exponent_bits(C::infinity);
    // Not down to the smallest number, whose product with the length would be subnormal where there is no vector
    // part.
    const V power = larger(V(C::pole_floor), largest_magnitude(q[0], q[1], q[2])) & exponent_bits;
    const V scale = power ^ exponent_bits;
    const vector3<V> v{q[0] * scale, q[1] * scale, q[2] * scale};
    const V squared = dot_of<P>(v, v);
    const mask_of<V> scalar_only = squared == zero;
    const root_divisor<P, V> length(select(scalar_only, one, squared));
    return {select(scalar_only, zero, length.root() * (V(T(0.5) * by) * power)),
            arithmetic<P>::multiply_add(zero, magnitude(q[3]), V(by) * q[3]), v, length, scalar_only};
}

// Cosine and sine of half of the angle with the sine m >= 0 and the cosine w, times any length: |w| + sqrt(w^2 + m^2)
// and m are in proportion to them, or for negative w to the sine and the cosine. Nothing cancels near -1.
template <precision_index P, class V>
inline void half_of(V m, V w, V& sine, V& cosine) noexcept {
    using M = arithmetic<P>;
    const V floor(constants<scalar_of<V>>::pole_floor), squared = m * m;
    const V sum = root_divisor<P, V>(larger(floor, M::multiply_add(w, w, squared))).root() + magnitude(w);
    const root_divisor<P, V> length(larger(floor, M::multiply_add(sum, sum, squared)));
    const mask_of<V> negative = w < V(scalar_of<V>(0));
    sine = length.divide(select(negative, sum, m));
    cosine = length.divide(select(negative, m, sum));
}

}  // namespace
}  // namespace swivel

#endif
