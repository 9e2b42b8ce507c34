#ifndef SWIVEL_KERNELS_VECTOR3_HPP
#define SWIVEL_KERNELS_VECTOR3_HPP

#include "kernels/rotors/normalize.hpp"

namespace swivel {
namespace {

template <class V>
inline V largest_magnitude(V x, V y, V z) noexcept {
    return larger(larger(magnitude(x), magnitude(y)), magnitude(z));
}

template <class V>
struct vector3 {
    V x, y, z;
};

template <precision_index P, class V>
inline V dot_of(const vector3<V>& a, const vector3<V>& b) noexcept {
    using M = arithmetic<P>;
    return M::multiply_add(a.z, b.z, M::multiply_add(a.y, b.y, a.x * b.x));
}

template <precision_index P, class V>
inline vector3<V> cross_of(const vector3<V>& a, const vector3<V>& b) noexcept {
    using M = arithmetic<P>;
    return {M::negate_multiply_add(a.z, b.y, a.y * b.z), M::negate_multiply_add(a.x, b.z, a.z * b.x),
            M::negate_multiply_add(a.y, b.x, a.x * b.y)};
}

// Times a power of two, so that the squares are in range whatever the length is, from the smallest subnormal
// number on: the largest component comes to 2..4, of subnormal ones in two steps. Zero stays zero; NaN and
// infinity become NaN.
template <class V>
inline vector3<V> in_range(const V* v) noexcept {
    using T = scalar_of<V>;
    using C = constants<T>;
    const V largest = largest_magnitude(v[0], v[1], v[2]);
    const V lift = select(largest < V(C::smallest_normal), V(T(1) / C::rounding), V(T(1)));
    const V scale = reciprocal_power_of_two(largest * lift);
    return {v[0] * lift * scale, v[1] * lift * scale, v[2] * lift * scale};
}

// Divides by the root of a number in the normal range: with quotients, or by way of the reciprocal.
template <precision_index P, class V>
class root_divisor {
public:
    explicit root_divisor(V squared) noexcept {
        if constexpr (P == reproducible_index) {
            root_ = square_root_of(squared);
        } else {
            reciprocal_ = arithmetic<P>::reciprocal_root(squared);
            root_ = squared * reciprocal_;
        }
    }

    V root() const noexcept { return root_; }

    V divide(V a) const noexcept {
        if constexpr (P == reproducible_index)
            return quotient(a, root_);
        else
            return a * reciprocal_;
    }

private:
    V root_, reciprocal_;
};

}  // namespace
}  // namespace swivel

#endif
