#ifndef SWIVEL_SRC_REFERENCE_CONFORMAL_HPP
#define SWIVEL_SRC_REFERENCE_CONFORMAL_HPP

// Even elements of the conformal algebra, for one element of a batch. Blades are sets of basis vectors, one
// bit each.

#include <array>

#include "elements.hpp"
#include "scalar.hpp"

namespace swivel::reference {

template <class T>
using even = std::array<T, 16>;
template <class T>
using bivector = std::array<T, 10>;

inline constexpr unsigned blades[16] = {0b00000, 0b00011, 0b00101, 0b01001, 0b10001, 0b00110,
                                        0b01010, 0b10010, 0b01100, 0b10100, 0b11000, 0b01111,
                                        0b10111, 0b11011, 0b11101, 0b11110};
// Where the bivectors and the blades of four vectors begin, and what follows them.
inline constexpr int bivectors = 1, four_vectors = 11, end_of_blades = 16;
inline constexpr int e12 = 1, e13 = 2, e14 = 3, e15 = 4, e23 = 5, e24 = 6, e25 = 7, e34 = 8, e35 = 9,
                     e45 = 10, e1234 = 11, e1235 = 12, e1245 = 13, e1345 = 14, e2345 = 15;

inline int index_of_blade(unsigned set) {
    int k = 0;
    while (blades[k] != set) ++k;
    return k;
}

// The sign that the product of two blades takes: one change for every pair of vectors that has to change
// places, and one where e5, whose square is -1, meets itself.
template <class T>
T sign_of_product(unsigned a, unsigned b) {
    bool negative = (a & b & 0b10000U) != 0;
    for (unsigned i = 0; i < 5; ++i)
        for (unsigned j = 0; j < i; ++j)
            if ((a >> i & 1U) != 0 && (b >> j & 1U) != 0) negative = !negative;
    return negative ? T(-1) : T(1);
}

// Component `out` of the product, from the components [a_first, a_end) of a that meet [b_first, b_end) of b.
// The terms of a component with e5 and without e4 come in the order of those of the one with e4 and without
// e5.
template <class T>
T product_component(int out, const even<T>& a, int a_first, int a_end, const even<T>& b, int b_first,
                    int b_end) {
    const bool exchange = (blades[out] & 0b10000U) != 0 && (blades[out] & 0b01000U) == 0;
    T sum = 0;
    for (unsigned blade : blades) {
        const unsigned e4 = blade >> 3 & 1U, e5 = blade >> 4 & 1U;
        if (exchange) blade = (blade & 0b00111U) | e5 << 3 | e4 << 4;
        const int i = index_of_blade(blade), j = index_of_blade(blade ^ blades[out]);
        if (i < a_first || i >= a_end || j < b_first || j >= b_end) continue;
        sum += sign_of_product<T>(blades[i], blades[j]) *
               (a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)]);
    }
    return sum;
}

template <class T>
even<T> product(const even<T>& a, const even<T>& b) {
    even<T> p;
    for (int k = 0; k < end_of_blades; ++k)
        p[static_cast<std::size_t>(k)] =
            finite_or_nan(product_component(k, a, 0, end_of_blades, b, 0, end_of_blades));
    return p;
}

template <class T>
even<T> reversed(const even<T>& c) {
    even<T> r = c;
    for (int k = bivectors; k < four_vectors; ++k)
        r[static_cast<std::size_t>(k)] = -r[static_cast<std::size_t>(k)];
    return r;
}

template <class T>
even<T> read(const conformal_view<const T>& v, std::size_t i) {
    even<T> c;
    for (std::size_t k = 0; k < 16; ++k) c[k] = *element(v.blade[k], i, v.stride);
    return c;
}

template <class T>
void write(const conformal_view<T>& v, std::size_t i, const even<T>& c) {
    for (std::size_t k = 0; k < 16; ++k) *element(v.blade[k], i, v.stride) = c[k];
}

template <class T>
bivector<T> read(const bivector_view<const T>& v, std::size_t i) {
    bivector<T> b;
    for (std::size_t k = 0; k < 10; ++k) b[k] = *element(v.blade[k], i, v.stride);
    return b;
}

template <class T>
void write(const bivector_view<T>& v, std::size_t i, const bivector<T>& b) {
    for (std::size_t k = 0; k < 10; ++k) *element(v.blade[k], i, v.stride) = b[k];
}

// A NaN where one of the numbers is not finite, otherwise 0.
template <class T, std::size_t N>
T zero_or_nan(const std::array<T, N>& numbers) {
    T sum = 0;
    for (const T a : numbers) sum = T(0) * a + sum;
    return sum;
}

}  // namespace swivel::reference

#endif
