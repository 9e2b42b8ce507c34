#ifndef SWIVEL_TESTS_SUPPORT_CONFORMAL_HPP
#define SWIVEL_TESTS_SUPPORT_CONFORMAL_HPP

// The conformal algebra for judging results: products from the rules of the basis vectors, exp from its
// series.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/rotations.hpp"

namespace swivel::tests {

template <class W>
using even = std::array<W, 16>;
template <class W>
using bivector = std::array<W, 10>;

// The vectors of each blade, in order.
inline constexpr std::array<std::array<int, 4>, 16> blade_vectors = {{{},
                                                                      {1, 2},
                                                                      {1, 3},
                                                                      {1, 4},
                                                                      {1, 5},
                                                                      {2, 3},
                                                                      {2, 4},
                                                                      {2, 5},
                                                                      {3, 4},
                                                                      {3, 5},
                                                                      {4, 5},
                                                                      {1, 2, 3, 4},
                                                                      {1, 2, 3, 5},
                                                                      {1, 2, 4, 5},
                                                                      {1, 3, 4, 5},
                                                                      {2, 3, 4, 5}}};

struct signed_blade {
    std::size_t place;
    int sign;
};

// One vector after the other is brought to its place, and cancelled where it meets itself.
inline signed_blade blade_product(std::size_t a, std::size_t b) {
    std::vector<int> v;
    for (const std::size_t k : {a, b})
        for (const int e : blade_vectors[k])
            if (e != 0) v.push_back(e);
    int sign = 1;
    for (std::size_t end = v.size(); end > 1; --end)
        for (std::size_t i = 0; i + 1 < end; ++i)
            if (v[i] > v[i + 1]) {
                std::swap(v[i], v[i + 1]);
                sign = -sign;
            }
    std::array<int, 4> left{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (i + 1 < v.size() && v[i] == v[i + 1]) {
            if (v[i] == 5) sign = -sign;
            ++i;
        } else {
            left[count++] = v[i];
        }
    }
    std::size_t place = 0;
    while (blade_vectors[place] != left) ++place;
    return {place, sign};
}

template <class W>
even<W> times(const even<W>& a, const even<W>& b) {
    static const auto table = [] {
        std::array<std::array<signed_blade, 16>, 16> t{};
        for (std::size_t i = 0; i < 16; ++i)
            for (std::size_t j = 0; j < 16; ++j) t[i][j] = blade_product(i, j);
        return t;
    }();
    even<W> p{};
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t j = 0; j < 16; ++j) p[table[i][j].place] += W(table[i][j].sign) * (a[i] * b[j]);
    return p;
}

template <class W>
even<W> reverse_of(even<W> a) {
    for (std::size_t k = 1; k <= 10; ++k) a[k] = -a[k];
    return a;
}

template <class W>
even<W> as_even(const bivector<W>& b) {
    even<W> e{};
    for (std::size_t k = 0; k < 10; ++k) e[k + 1] = b[k];
    return e;
}

// By Taylor's series of a 2^-10th part and ten squarings, in long double.
inline even<long double> exact_exp_long(const bivector<double>& b) {
    even<long double> x{}, term{}, sum{};
    for (std::size_t k = 0; k < 10; ++k) x[k + 1] = static_cast<long double>(b[k]) / 1024;
    term[0] = sum[0] = 1;
    for (int n = 1; n < 16; ++n) {
        term = times(term, x);
        for (std::size_t k = 0; k < 16; ++k) sum[k] += term[k] /= n;
    }
    for (int n = 0; n < 10; ++n) sum = times(sum, sum);
    return sum;
}

inline even<double> exact_exp(const bivector<double>& b) {
    const even<long double> e = exact_exp_long(b);
    even<double> r{};
    for (std::size_t k = 0; k < 16; ++k) r[k] = static_cast<double>(e[k]);
    return r;
}

template <class W>
double size_of(const W& a) {
    double s = 0;
    for (const auto x : a) s += static_cast<double>(x * x);
    return std::sqrt(s);
}

// Generators: of a rotation by twice that angle, of a translation, of a dilation, and a sum.
inline bivector<double> rotation_generator(double x, double y, double z) {
    return {-z, y, 0, 0, -x, 0, 0, 0, 0, 0};
}
inline bivector<double> translation_generator(double x, double y, double z) {
    return {0, 0, -x / 2, -x / 2, 0, -y / 2, -y / 2, -z / 2, -z / 2, 0};
}
inline bivector<double> dilation_generator(double l) { return {0, 0, 0, 0, 0, 0, 0, 0, 0, l / 2}; }
inline bivector<double> operator+(bivector<double> a, const bivector<double>& b) {
    for (std::size_t k = 0; k < 10; ++k) a[k] += b[k];
    return a;
}

// A rotation about an axis with half angles up to 2.5; every other one with a translation up to 5, every
// fourth with a dilation by up to e^2.
inline bivector<double> random_bivector(generator& g) {
    const vec3<double> n = random_direction<double>(g);
    const double h = uniform(g, 0, 2.5);
    bivector<double> b = rotation_generator(h * n.x, h * n.y, h * n.z);
    const std::uint64_t kind = g() % 4;
    if (kind >= 2) b = b + translation_generator(uniform(g, -5, 5), uniform(g, -5, 5), uniform(g, -5, 5));
    if (kind == 3) b = b + dilation_generator(uniform(g, -2, 2));
    return b;
}

// Where an implementation goes wrong first: nothing, translations, dilations, rotations by pi and 2 pi, the
// same with a translation, a dilation or a boost, like turns in two planes, and such whose angles add up to
// pi.
inline std::vector<bivector<double>> corner_bivectors() {
    constexpr double pi = std::numbers::pi;
    const auto turn = [](double a) { return rotation_generator(0, 0, a); };
    std::vector<bivector<double>> all = {
        {},
        translation_generator(1, -2, 3),
        translation_generator(0, 0, 1000),
        dilation_generator(1.5),
        dilation_generator(-3),
        turn(pi / 2),
        turn(pi),
        turn(pi) + translation_generator(0, 0, 2),
        turn(pi) + dilation_generator(1),
        turn(1) + translation_generator(0, 0, 2),
        turn(1e-4) + translation_generator(0, 0, 2),
        turn(pi - 1e-4),
        {0, 0, 0, 0.75, 0, 0, 0.5, 0, 0.25, 0},
        {0, 0, 0.5, -0.5, 0, 0, 0, 0, 0, 0},
    };
    const double pairs[][2] = {{1, 1},           {1, -1},        {0.5, 1},         {1, pi - 1},
                               {pi / 2, pi / 2}, {1, -(pi - 1)}, {1, 1.0000001},   {0, pi},
                               {2, 1},           {1e-4, 1e-4},   {pi / 4, pi / 4}, {1e-12, -1e-12}};
    for (const auto& p : pairs) all.push_back({p[0], 0, 0, 0, 0, 0, 0, p[1], 0, 0});
    return all;
}

}  // namespace swivel::tests

#endif
