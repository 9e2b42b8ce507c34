#ifndef SWIVEL_SRC_CONFORMAL_REFERENCE_HPP
#define SWIVEL_SRC_CONFORMAL_REFERENCE_HPP

// Even elements of the conformal algebra, for one element of a batch. Blades are sets of basis vectors, one
// bit each.

#include <array>

#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"

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

constexpr int index_of_blade(unsigned set) {
    int k = 0;
    while (blades[k] != set) ++k;
    return k;
}

// Whether the product of two blades changes its sign: once for every pair of vectors that has to change
// places, and once where e5, whose square is -1, meets itself.
constexpr bool changes_sign(unsigned a, unsigned b) {
    bool changes = (a & b & 0b10000U) != 0;
    for (unsigned i = 0; i < 5; ++i)
        for (unsigned j = 0; j < i; ++j)
            if ((a >> i & 1U) != 0 && (b >> j & 1U) != 0) changes = !changes;
    return changes;
}

// The terms of each component of a product. Those of a component with e5 and without e4 come in the order of
// those of the one with e4 and without e5.
struct term {
    int left, right;
    bool minus;
};

inline constexpr auto terms = [] {
    std::array<std::array<term, 16>, 16> all{};
    for (std::size_t out = 0; out < 16; ++out) {
        const bool exchange = (blades[out] & 0b11000U) == 0b10000U;
        for (std::size_t k = 0; k < 16; ++k) {
            unsigned left = blades[k];
            if (exchange) left = (left & 0b00111U) | (left >> 4 & 1U) << 3 | (left >> 3 & 1U) << 4;
            const unsigned right = left ^ blades[out];
            all[out][k] = {index_of_blade(left), index_of_blade(right), changes_sign(left, right)};
        }
    }
    return all;
}();

// Component `out` of the product, from the components [a_first, a_end) of a that meet [b_first, b_end) of b.
template <class T>
T product_component(int out, const even<T>& a, int a_first, int a_end, const even<T>& b, int b_first,
                    int b_end) {
    T sum = 0;
    for (const term& t : terms[static_cast<std::size_t>(out)]) {
        if (t.left < a_first || t.left >= a_end || t.right < b_first || t.right >= b_end) continue;
        const T product = a[static_cast<std::size_t>(t.left)] * b[static_cast<std::size_t>(t.right)];
        sum = t.minus ? sum - product : sum + product;
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

}  // namespace swivel::reference

#endif
