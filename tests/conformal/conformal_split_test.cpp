// split: the parts of bivectors, and where they are not unique.

#include <gtest/gtest.h>

#include "support/conformal_errors.hpp"
#include "swivel/conformal.hpp"

namespace swivel::tests {
namespace {

class ConformalSplit : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, ConformalSplit, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 3000;

bivector<double> product_with_itself(const bivector<double>& a, const bivector<double>& b, bool commutator) {
    // The four-vector part of a^2, or the bivector part of a b.
    const even<double> p = times(as_even(a), as_even(b));
    bivector<double> out{};
    for (std::size_t k = 0; k < (commutator ? 10U : 5U); ++k) out[k] = p[(commutator ? 1U : 11U) + k];
    return out;
}

template <class T>
void splits() {
    generator g(7);
    bivector_buffer<T> b(n, layout::soa), first(n, layout::soa), second(n, layout::soa);
    scalar_buffer<T> unique(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        bivector<double> any;
        for (double& x : any) x = uniform(g, -1, 1);
        set(b, i, i % 2 == 0 ? any : random_bivector(g));
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(split(b.view(), first.view(), second.view(), unique.view(), {.accuracy = p}), status::ok);
        worst sums, rest;
        for (std::size_t i = 0; i < n; ++i) {
            if (unique[i] == 0) {
                // A small turn beside a long translation.
                const bivector<double> given = get(b, i);
                const double turn = given[0] * given[0] + given[1] * given[1] + given[4] * given[4];
                ASSERT_LE(turn, bound<T>(0x1p-15, 0x1p-39) * size_of(given) * size_of(given));
                continue;
            }
            const bivector<double> whole = get(b, i), one = get(first, i), other = get(second, i);
            sums.see(error(one + other, whole));
            const even<double> square_1 = times(as_even(one), as_even(one)),
                               square_2 = times(as_even(other), as_even(other));
            EXPECT_LE(square_1[0], square_2[0] + 1e-5);
            const double size = size_of(whole), apart = (square_2[0] - square_1[0]) / (size * size);
            rest.see(size_of(product_with_itself(one, other, true)) / (size * size) * apart);
            rest.see(size_of(product_with_itself(one, one, false)) / (size * size) * apart);
            rest.see(size_of(product_with_itself(other, other, false)) / (size * size) * apart);
        }
        sums.expect_below(bound<T>(1.2e-7, 3e-16), "split, sum", p, sizeof(T));
        rest.expect_below(bound<T>(6e-7, 1.5e-15), "split, simple and commuting", p, sizeof(T));
    }
}

TEST_P(ConformalSplit, GivesSimplePartsThatCommuteAndAddUp) {
    splits<float>();
    splits<double>();
}

// Two turns by nearly the same angle, in planes of all directions: the nearer, the worse, in proportion.
template <class T>
void splits_nearly_equal_turns() {
    generator g(11);
    bivector_buffer<T> b(n, layout::soa), first(n, layout::soa), second(n, layout::soa);
    scalar_buffer<T> unique(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        // The sum of two that turn all planes alike, the one to the left, the other to the right.
        const vec3<double> l = random_direction<double>(g), r = random_direction<double>(g);
        const double s = std::exp2(-uniform(g, 1, bound<T>(14, 38)));
        const auto both = [&](double x, double y) { return std::array<double, 2>{x + s * y, x - s * y}; };
        const std::array<double, 2> p = both(l.x, r.x), q = both(l.y, r.y), o = both(l.z, r.z);
        set(b, i, bivector<double>{p[0], q[0], o[0], 0, o[1], -q[1], 0, p[1], 0, 0});
    }
    for (const precision accuracy : both_precisions) {
        ASSERT_EQ(split(b.view(), first.view(), second.view(), unique.view(), {.accuracy = accuracy}),
                  status::ok);
        worst rest;
        std::size_t count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (unique[i] == 0) continue;
            ++count;
            const bivector<double> whole = get(b, i), one = get(first, i), other = get(second, i);
            const double size = size_of(whole) * size_of(whole);
            // (a^2 - b^2) / |B|^2 from the parts that turn to the left and to the right.
            const double left = std::hypot(whole[0] + whole[7], whole[1] - whole[5], whole[2] + whole[4]);
            const double right = std::hypot(whole[0] - whole[7], whole[1] + whole[5], whole[2] - whole[4]);
            const double apart = left * right / size;
            rest.see(size_of(product_with_itself(one, one, false)) / size * apart);
            rest.see(size_of(product_with_itself(other, other, false)) / size * apart);
            rest.see(size_of(product_with_itself(one, other, true)) / size * apart);
        }
        EXPECT_GT(count, n * 3 / 4);
        rest.expect_below(bound<T>(6e-7, 1.5e-15), "split of turns by nearly the same angle", accuracy,
                          sizeof(T));
    }
}

TEST_P(ConformalSplit, OfNearlyEqualTurnsIsAsGoodAsTheyDiffer) {
    splits_nearly_equal_turns<float>();
    splits_nearly_equal_turns<double>();
}

// Of bivectors of any length, in the same bits but for the exponent.
template <class T>
void split_scales() {
    generator g(12);
    bivector_buffer<T> b(n, layout::soa), first(n, layout::soa), second(n, layout::soa);
    bivector_buffer<T> scaled(n, layout::soa), first_scaled(n, layout::soa), second_scaled(n, layout::soa);
    scalar_buffer<T> unique(n, layout::soa), unique_scaled(n, layout::soa);
    constexpr int most = sizeof(T) == 4 ? 100 : 900;
    std::vector<int> exponents(n);
    for (std::size_t i = 0; i < n; ++i) {
        set(b, i, random_bivector(g));
        exponents[i] = static_cast<int>(g() % (2 * most)) - most;
        for (int k = 0; k < 10; ++k) scaled.at(k, i) = std::ldexp(b.at(k, i), exponents[i]);
    }
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        ASSERT_EQ(split(b.view(), first.view(), second.view(), unique.view(), o), status::ok);
        ASSERT_EQ(split(scaled.view(), first_scaled.view(), second_scaled.view(), unique_scaled.view(), o),
                  status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(unique_scaled[i], unique[i]);
            // Components that are nearly 0 beside the others may become subnormal numbers.
            const T tiny = std::ldexp(std::numeric_limits<T>::min(), 30);
            for (int k = 0; k < 10; ++k) {
                const T want = std::ldexp(first.at(k, i), exponents[i]);
                ASSERT_TRUE(std::fabs(want) <= tiny || first_scaled.at(k, i) == want) << exponents[i];
            }
        }
    }
}

TEST_P(ConformalSplit, IsTheSameAtEveryLength) {
    split_scales<float>();
    split_scales<double>();
}

TEST_P(ConformalSplit, SaysWhereThePartsAreNotUnique) {
    const std::vector<bivector<double>> corners = {{},
                                                   translation_generator(1, -2, 3),
                                                   {1, 0, 0, 0, 0, 0, 0, 1, 0, 0},
                                                   {0.5, 0, 0, 0, 0, 0, 0, -0.5, 0, 0}};
    for (const bivector<double>& corner : corners)
        for (const precision p : both_precisions) {
            bivector_buffer<double> b(1, layout::soa), first(1, layout::soa), second(1, layout::soa);
            scalar_buffer<double> unique(1, layout::soa);
            set(b, 0, corner);
            ASSERT_EQ(split(b.view(), first.view(), second.view(), unique.view(), {.accuracy = p}),
                      status::ok);
            EXPECT_EQ(unique[0], 0);
            EXPECT_EQ(get(first, 0), corner);
            EXPECT_EQ(get(second, 0), bivector<double>{});
        }
}

}  // namespace
}  // namespace swivel::tests
