#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/exact.hpp"
#include "support/interpolation.hpp"
#include "support/rotations.hpp"
#include "support/vectors.hpp"
#include "swivel/reference.hpp"
#include "swivel/versors.hpp"

namespace swivel::tests {
namespace {

namespace tool = swivel::reference;

template <class T>
quat<T> one_power(quat<T> q, T t) {
    const quat_view<T> v{&q.x, &q.y, &q.z, &q.w, 1};
    EXPECT_EQ(tool::power(v, parameter<T>(t), v), status::ok);
    return q;
}
// Of a product of as many roots as T has bits, in units.
template <class T>
constexpr double rounding_of_roots = sizeof(T) == 4 ? 8 : 11;

template <class T>
void halving_accuracy() {
    using L = long double;
    constexpr int digits = std::numeric_limits<T>::digits;
    generator g(17);
    double worst = 0, worst_power = 0;
    for (int i = 0; i < 20000; ++i) {
        const quat<T> q = random_rotation<T>(g);
        const T t = static_cast<T>(uniform(g, 0, 1));
        const exact_quat want = power(unit_of(q), L(t));
        const L log = std::atan2(std::hypot(L(q.x), L(q.y), L(q.z)), L(q.w));
        const L bits = std::ldexp(log, -digits - 1);
        const exact_quat got = widen<L>(tool::power_by_halving(q, t)), by_log = widen<L>(one_power(q, t));
        worst = std::max(worst, static_cast<double>(norm(minus(got, want)) - bits) / rounding_unit<T>);
        worst_power =
            std::max(worst_power, static_cast<double>(norm(minus(got, by_log)) - bits) / rounding_unit<T>);
    }
    EXPECT_LE(worst, rounding_of_roots<T>);
    EXPECT_LE(worst_power, 12);
}

TEST(PowerByHalving, WithAllBitsIsPowerToRounding) {
    halving_accuracy<float>();
    halving_accuracy<double>();
}

template <class T>
void error_by_bits() {
    using L = long double;
    constexpr int digits = std::numeric_limits<T>::digits;
    generator g(18);
    for (int bits = 0; bits <= digits + 6; ++bits) {
        L largest = 0;  // as a part of the bound
        for (int i = 0; i < 400; ++i) {
            const quat<T> q = random_rotation<T>(g);
            const T t = static_cast<T>(uniform(g, 0, 1));
            const L log = std::atan2(std::hypot(L(q.x), L(q.y), L(q.z)), L(q.w));
            const L bound = std::ldexp(log, -bits - 1);
            const exact_quat got = widen<L>(tool::power_by_halving(q, t, bits));
            const L error = norm(minus(got, power(unit_of(q), L(t))));
            ASSERT_LE(error, bound + L(rounding_of_roots<T> * rounding_unit<T>)) << bits;
            largest = std::max(largest, error / bound);
        }
        // Reached, as long as it is more than the rounding: each bit halves the error and no more.
        if (bits < digits - 6) {
            ASSERT_GE(largest, L(0.9)) << bits;
            ASSERT_LE(largest, L(1.1)) << bits;
        }
    }
}

TEST(PowerByHalving, HalvesItsErrorWithEachBit) {
    error_by_bits<float>();
    error_by_bits<double>();
}

template <class T>
void halving_corners() {
    const quat<T> one{0, 0, 0, 1}, minus_one{0, 0, 0, -1}, half_turn{1, 0, 0, 0};
    const T limit = std::numeric_limits<T>::max();
    EXPECT_EQ(tool::power_by_halving<T>(minus_one, T(0.5)), half_turn);
    for (T t : {T(0.125), T(0.25), T(0.3), T(0.75), T(0.99)}) {
        const quat<T> got = tool::power_by_halving(minus_one, t), by_log = one_power(minus_one, t);
        EXPECT_LE(norm(minus(widen<double>(got), widen<double>(by_log))), 10 * rounding_unit<T>);
        EXPECT_EQ(tool::power_by_halving(one, t), one);
        EXPECT_EQ(tool::power_by_halving<T>({0, 0, 0, 0}, t), one);
    }
    generator g(19);
    for (int i = 0; i < 1000; ++i) {
        const quat<T> q = random_rotation<T>(g), twice{2 * q.x, 2 * q.y, 2 * q.z, 2 * q.w};
        const T t = static_cast<T>(uniform(g, 0, 1));
        EXPECT_EQ(tool::power_by_halving(q, t), tool::power_by_halving(twice, t));
        for (T none : {T(0), T(-0.0), T(-1), -limit}) EXPECT_EQ(tool::power_by_halving(q, none), one);
        const quat<T> whole = tool::power_by_halving(q, T(1));
        EXPECT_LE(norm(minus(widen<long double>(whole), unit_of(q))), 3 * rounding_unit<T>);
        for (T all : {T(1.5), limit}) EXPECT_EQ(tool::power_by_halving(q, all), whole);
        EXPECT_EQ(tool::power_by_halving(q, t, -3), tool::power_by_halving(q, t, 0));
        EXPECT_EQ(tool::power_by_halving(q, t, 1000), tool::power_by_halving(q, t, 62));
        // Of one bit, a single root.
        const quat<T> half = tool::power_by_halving(q, T(0.5), 1);
        EXPECT_LE(norm(minus(widen<long double>(half), power(unit_of(q), 0.5L))), 5 * rounding_unit<T>);
    }
    const quat<T> q{T(0.5), T(-0.5), T(0.5), T(0.5)};
    for (T t : {T(0), T(0.3), T(1)}) {
        for (const quat<T>& bad : bad_rotations(q)) {
            const quat<T> p = tool::power_by_halving(bad, t), a = tool::interpolate_by_halving(bad, q, t),
                          b = tool::interpolate_by_halving(q, bad, t);
            EXPECT_TRUE(all_nan({p.x, p.y, p.z, p.w, a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w}));
        }
        for (const quat<T>& a : corner_rotations<T>()) {
            const quat<T> p = tool::power_by_halving(a, t), r = tool::interpolate_by_halving(a, q, t);
            ASSERT_LE(std::fabs(norm(widen<double>(p)) - 1), 3 * rounding_unit<T>);
            ASSERT_LE(std::fabs(norm(widen<double>(r)) - 1), 3 * rounding_unit<T>);
        }
    }
    for (T bad : bad_numbers<T>) {
        const quat<T> p = tool::power_by_halving(q, bad), r = tool::interpolate_by_halving(q, one, bad);
        EXPECT_TRUE(all_nan({p.x, p.y, p.z, p.w, r.x, r.y, r.z, r.w}));
    }
}

TEST(PowerByHalving, IsDefinedAtMinusOneAndOutsideOfTheUnitIntervalAndPassesNanOn) {
    halving_corners<float>();
    halving_corners<double>();
}

template <class T>
void halving_and_slerp() {
    using L = long double;
    constexpr int digits = std::numeric_limits<T>::digits;
    generator g(20);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const quat<T> a = random_rotation<T>(g), b = random_rotation<T>(g);
        const T t = static_cast<T>(i == 0 ? 0 : i == 1 ? 1 : uniform(g, 0, 1));
        const exact_quat from = unit_of(a), to = on_the_way(from, unit_of(b), false);
        const exact_quat got = widen<L>(tool::interpolate_by_halving(a, b, t)),
                         want = exact_slerp(from, to, L(t));
        const L bits = std::ldexp(std::acos(std::min(dot(from, to), L(1))), -digits - 1);
        worst = std::max(worst, static_cast<double>(norm(minus(got, want)) - bits) / rounding_unit<T>);
    }
    EXPECT_LE(worst, sizeof(T) == 4 ? 9 : 12);
    // From q to -q there is nothing to do.
    const quat<T> q{T(0.5), T(-0.5), T(0.5), T(0.5)};
    EXPECT_EQ(tool::interpolate_by_halving<T>(q, {-q.x, -q.y, -q.z, -q.w}, T(0.3)), q);
}

TEST(InterpolateByHalving, IsSlerpByTheShortWay) {
    halving_and_slerp<float>();
    halving_and_slerp<double>();
}

}  // namespace
}  // namespace swivel::tests
