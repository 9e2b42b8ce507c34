#ifndef SWIVEL_TESTS_SUPPORT_MOTOR_ROOTS_HPP
#define SWIVEL_TESTS_SUPPORT_MOTOR_ROOTS_HPP

// That the square of a motor's root, and the exponential of its logarithm, are the motor; for a few thousand
// motors, and in the slow tests for a million.

#include <gtest/gtest.h>

#include <numbers>

#include "support/motors.hpp"
#include "support/usable_isas.hpp"
#include "swivel/motor.hpp"

namespace swivel::tests {

inline constexpr std::size_t n = 20011;
inline constexpr long double pi = std::numbers::pi_v<long double>;

inline long double size_of(const motion& m) { return norm(m.t); }

// How well the axis is known: near a full turn as badly as the vector part of r is short.
inline long double conditioning(const motion& m) {
    if (m.q.w >= 0) return 1;
    return 1 + pi / std::sqrt(m.q.x * m.q.x + m.q.y * m.q.y + m.q.z * m.q.z);
}

// In the units of T, between two motions in long double.
template <class T>
motor_error exact_distance(const motion& got, const motion& want) {
    const motor_error e = distance(rounded<long double>(got), want, size_of(want));
    constexpr double by = rounding_unit<long double> / rounding_unit<T>;
    return {by * e.real, by * e.dual};
}

template <class T>
struct sampled {
    motor_buffer<T> m{n, layout::soa}, other{n, layout::soa}, out{n, layout::soa}, square{n, layout::soa};
    vec3_buffer<T> b{n, layout::soa}, e{n, layout::soa};
    scalar_buffer<T> t{n, layout::soa};

    explicit sampled(std::uint64_t seed) {
        generator g(seed);
        for (std::size_t i = 0; i < n; ++i) {
            const motion one = any_motion(g);
            m.set(i, rounded<T>(g() % 2 != 0 ? negative(one) : one));
            other.set(i, rounded<T>(i % 3 == 0 ? after(one, any_motion(g)) : any_motion(g)));
            t[i] = static_cast<T>(uniform(g, -0.25, 1.25));
        }
    }
};

// Of half the rotation, near a full turn too.
inline long double cosine_of_half(const motion& m) {
    const long double squared = m.q.x * m.q.x + m.q.y * m.q.y + m.q.z * m.q.z;
    return m.q.w < 0 ? std::sqrt(squared / (2 - 2 * m.q.w)) : std::sqrt((1 + m.q.w) / 2);
}

template <class T>
void square_root_squared_is_the_motor(std::uint64_t seed) {
    sampled<T> w(seed);
    for (const precision p : both_precisions) {
        ASSERT_EQ(square_root(w.m.view(), w.out.view(), {.accuracy = p}), status::ok);
        double real = 0, dual = 0, back = 0, back_dual = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const motion m = motion_of(w.m.get(i)), root = motion_of(w.out.get(i));
            const motor_error e = distance(w.out.get(i), power(m, 0.5L), size_of(m));
            const double c = static_cast<double>(cosine_of_half(m));
            if (c > double(rounding_unit<T>)) {
                real = std::max(real, e.real);
                dual = std::max(dual, e.dual / (1 + 1 / c));
            }
            ASSERT_GE(w.out.get(i).r.w, 0);
            const motor_error f = exact_distance<T>(after(root, root), m);
            back = std::max(back, f.real);
            back_dual = std::max(back_dual, f.dual / (1 + 1 / (c + double(rounding_unit<T>))));
        }
        const bool fast = p == precision::fast;
        EXPECT_LE(real, fast ? 6 : 4);
        EXPECT_LE(dual, 2);
        EXPECT_LE(back, fast ? 8 : 6);
        EXPECT_LE(back_dual, 2.5);
    }
}

// exp in long double by its series, halved until the series is short: no formula of the library takes part.
inline motion exact_exp(const exact_vec3& b, const exact_vec3& e) {
    constexpr int halvings = 12;
    const long double scale = std::ldexp(1.0L, -halvings);
    const exact_quat x{b.x * scale, b.y * scale, b.z * scale, 0}, y{e.x * scale, e.y * scale, e.z * scale, 0};
    exact_quat r{0, 0, 0, 1}, d{0, 0, 0, 0}, term_r = r, term_d = d;
    for (int k = 1; k < 12; ++k) {
        term_d = sum(1.0L / k, times(term_d, x), 1.0L / k, times(term_r, y));
        term_r = sum(1.0L / k, times(term_r, x), 0, x);
        r = sum(1, r, 1, term_r);
        d = sum(1, d, 1, term_d);
    }
    for (int k = 0; k < halvings; ++k) {
        d = sum(1, times(r, d), 1, times(d, r));
        r = times(r, r);
    }
    return motion_of(dual_quaternion<long double>{r, d});
}

template <class T>
void exp_of_log_is_the_motor(std::uint64_t seed) {
    sampled<T> w(seed);
    for (const precision p : both_precisions) {
        ASSERT_EQ(log(w.m.view(), w.b.view(), w.e.view(), {.accuracy = p}), status::ok);
        ASSERT_EQ(exp(w.b.view(), w.e.view(), w.out.view(), {.accuracy = p}), status::ok);
        double real = 0, dual = 0, there_real = 0, there_dual = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const motion m = motion_of(w.m.get(i));
            const exact_vec3 b = widen<long double>(w.b.get(i)), e = widen<long double>(w.e.get(i));
            ASSERT_LE(norm(b), pi * (1 + 4 * rounding_unit<T>));
            const double by = 1 / static_cast<double>(conditioning(m));
            const motor_error f = exact_distance<T>(exact_exp(b, e), m);
            real = std::max(real, f.real);
            dual = std::max(dual, f.dual * by);
            const motor_error there = distance(w.out.get(i), m, size_of(m));
            there_real = std::max(there_real, there.real);
            there_dual = std::max(there_dual, there.dual * by);
        }
        const bool fast = p == precision::fast;
        EXPECT_LE(real, fast ? 13 : 11.5);
        EXPECT_LE(dual, 4);
        EXPECT_LE(there_real, fast ? 20 : 14);
        EXPECT_LE(there_dual, fast ? 7 : 4);
    }
}

}  // namespace swivel::tests

#endif
