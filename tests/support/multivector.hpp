#ifndef SWIVEL_TESTS_SUPPORT_MULTIVECTOR_HPP
#define SWIVEL_TESTS_SUPPORT_MULTIVECTOR_HPP

#include <array>
#include <bit>
#include <cmath>

#include "swivel/types.hpp"

namespace swivel::tests {

// A multivector of Cl(3, 0): bit k of an index says whether the basis vector e(k + 1) is in the blade, the
// vectors in ascending order.
using multivector = std::array<double, 8>;

inline multivector product(const multivector& l, const multivector& r) {
    multivector p{};
    for (unsigned i = 0; i < 8; ++i)
        for (unsigned j = 0; j < 8; ++j) {
            // Exchanges that bring the vectors of both blades in order; equal ones then make 1.
            int exchanges = 0;
            for (unsigned above = i >> 1U; above != 0; above >>= 1U) exchanges += std::popcount(above & j);
            p[i ^ j] += (exchanges % 2 == 0 ? 1 : -1) * l[i] * r[j];
        }
    return p;
}

inline multivector vector_of(const vec3<double>& v) { return {0, v.x, v.y, 0, v.z, 0, 0, 0}; }

// I3 v
inline multivector dual(const vec3<double>& v) { return {0, 0, 0, v.z, 0, -v.y, v.x, 0}; }

inline multivector combined(double s, const multivector& a, double t, const multivector& b) {
    multivector c;
    for (unsigned i = 0; i < 8; ++i) c[i] = s * a[i] + t * b[i];
    return c;
}

// w - I3 (x, y, z)
inline multivector rotor_of(const quat<double>& q) { return combined(q.w, {1}, -1, dual({q.x, q.y, q.z})); }

inline double distance(const multivector& a, const multivector& b) {
    double sum = 0;
    for (unsigned i = 0; i < 8; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

inline multivector reverse(const multivector& m) {
    return {m[0], m[1], m[2], -m[3], m[4], -m[5], -m[6], -m[7]};
}

inline multivector sandwich(const multivector& rotor, const multivector& x) {
    return product(product(rotor, x), reverse(rotor));
}

}  // namespace swivel::tests

#endif
