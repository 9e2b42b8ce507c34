#include "swivel/angle_between.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class AngleBetween : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, AngleBetween, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 40013;

template <class T>
quat<T> minus(const quat<T>& q) {
    return {-q.x, -q.y, -q.z, -q.w};
}

template <class T>
quat<T> times(const quat<T>& q, double by) {
    return rounded<T>(q.x * by, q.y * by, q.z * by, q.w * by);
}

template <class T>
long double exact_angle(const quat<T>& a, const quat<T>& b) {
    using W = wide<T>;
    const quat<W> between = tests::times(conjugate(widen<W>(a)), widen<W>(b));
    const W sine = norm(vec3<W>{between.x, between.y, between.z});
    return 2 * static_cast<long double>(angle_of(sine, magnitude(between.w)));
}

// b at a given angle from a, on either side of the sphere.
template <class T>
quat<T> at_angle(generator& g, const quat<T>& a, double angle) {
    const vec3<double> u = random_direction<double>(g);
    const double s = std::sin(angle / 2), sign = g() % 2 == 0 ? 1 : -1;
    const quat<double> turn{sign * s * u.x, sign * s * u.y, sign * s * u.z, sign * std::cos(angle / 2)};
    const quat<double> b = tests::times(quat<double>{a.x, a.y, a.z, a.w}, turn);
    return rounded<T>(b.x, b.y, b.z, b.w);
}

template <class T>
struct pairs {
    quat_buffer<T> a{n, layout::soa}, b{n, layout::soa};
    scalar_buffer<T> angle{n, layout::soa};

    void set(std::size_t i, const quat<T>& from, const quat<T>& to) {
        a.set(i, from);
        b.set(i, to);
    }
    void measure(precision p) {
        ASSERT_EQ(angle_between(a.view(), b.view(), angle.view(), {.accuracy = p}), status::ok);
    }
};

// |error| <= relative angle + absolute, in units of the rounding.
template <class T>
void expect_within(pairs<T>& all, double relative, double absolute) {
    for (const precision p : both_precisions) {
        all.measure(p);
        double worst = 0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const long double exact = exact_angle(all.a.get(i), all.b.get(i));
            const double off = static_cast<double>(std::fabs(all.angle[i] - exact));
            const double error = off / rounding_unit<T> / (relative * static_cast<double>(exact) + absolute);
            if (!(error <= worst)) worst = error, at = i;
        }
        EXPECT_LE(worst, 1) << name(p) << ", element " << at << ": " << all.angle[at] << " for "
                            << exact_angle(all.a.get(at), all.b.get(at));
    }
}

template <class T>
void is_the_angle_at_every_distance() {
    generator g(3);
    pairs<T> all;
    const int steps = sizeof(T) == 4 ? 22 : 50;
    for (std::size_t i = 0; i < n; ++i) {
        // A few a little longer than the other.
        const quat<T> a = times(random_rotation<T>(g), i % 16 < 4 ? 1 + 0x1p-12 : 1);
        const double size =
            std::ldexp(uniform(g, 0.5, 1), -static_cast<int>(i / 4 % static_cast<std::size_t>(steps)));
        const double angles[] = {3.14159 * size, 3.141592653589793 - size, uniform(g, 0, 3.14159), 0};
        all.set(i, a, i % 4 == 3 ? random_rotation<T>(g) : at_angle(g, a, angles[i % 4]));
    }
    expect_within(all, 7.5, 0x1p-9);
}

TEST_P(AngleBetween, IsWithinItsBoundAtEveryDistanceFloat) { is_the_angle_at_every_distance<float>(); }
TEST_P(AngleBetween, IsWithinItsBoundAtEveryDistanceDouble) { is_the_angle_at_every_distance<double>(); }

template <class T>
void any_lengths() {
    generator g(4);
    pairs<T> all;
    const int most = sizeof(T) == 4 ? 29 : 249;
    const auto length = [&] {
        return std::ldexp(uniform(g, 1, 2), static_cast<int>(g() % static_cast<unsigned>(2 * most)) - most);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const quat<T> a = random_rotation<T>(g);
        const double small = std::ldexp(1.0, -static_cast<int>(i % 60));
        const quat<T> b = at_angle(g, a, i % 2 == 0 ? uniform(g, 0, 3.14) : small);
        const double of_a = length(), of_b = length();
        all.set(i, times(a, of_a), times(b, of_b));
    }
    expect_within(all, 0, 9);
}

TEST_P(AngleBetween, OfAnyLengthsIsWithinItsBoundFloat) { any_lengths<float>(); }
TEST_P(AngleBetween, OfAnyLengthsIsWithinItsBoundDouble) { any_lengths<double>(); }

template <class T>
void same_is_zero() {
    generator g(5);
    pairs<T> all;
    for (std::size_t i = 0; i < n; ++i) {
        const quat<T> q = times(random_rotation<T>(g), uniform(g, 0.001, 1000));
        all.set(i, q, i % 2 == 0 ? q : minus(q));
    }
    for (const precision p : both_precisions) {
        all.measure(p);
        for (std::size_t i = 0; i < n; ++i) ASSERT_TRUE(same_bits(all.angle[i], T(0))) << i;
    }
}

TEST_P(AngleBetween, OfTheSameRotationIsZeroFloat) { same_is_zero<float>(); }
TEST_P(AngleBetween, OfTheSameRotationIsZeroDouble) { same_is_zero<double>(); }

template <class T>
void sign_and_order() {
    generator g(6);
    pairs<T> all, turned, exchanged;
    for (std::size_t i = 0; i < n; ++i) {
        const quat<T> a = random_rotation<T>(g), b = random_rotation<T>(g);
        all.set(i, a, b);
        turned.set(i, i % 2 == 0 ? minus(a) : a, i % 2 == 0 ? b : minus(b));
        exchanged.set(i, b, a);
    }
    for (const precision p : both_precisions) {
        all.measure(p);
        turned.measure(p);
        exchanged.measure(p);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(all.angle[i], turned.angle[i]) << i;
            ASSERT_LE(std::fabs(all.angle[i] - exchanged.angle[i]), 8 * 3.2 * rounding_unit<T>) << i;
            ASSERT_GE(all.angle[i], 0);
            ASSERT_LE(all.angle[i], T(3.14159265358979323846));
        }
    }
}

TEST_P(AngleBetween, IsThatOfMinusQAndOfTheWayBackFloat) { sign_and_order<float>(); }
TEST_P(AngleBetween, IsThatOfMinusQAndOfTheWayBackDouble) { sign_and_order<double>(); }

TEST_P(AngleBetween, OfHalfTurnsAndZeroQuaternions) {
    const float pi = 3.14159265358979323846F;
    quat_buffer<float> a(6, layout::aos_xyzw), b(6, layout::aos_xyzw);
    scalar_buffer<float> angle(6, layout::soa);
    const quat<float> one{0, 0, 0, 1}, x{1, 0, 0, 0}, y{0, 1, 0, 0}, none{0, 0, 0, 0};
    const quat<float> from[] = {one, x, x, none, one, none}, to[] = {x, y, one, one, none, none};
    const float expected[] = {pi, pi, pi, 0, 0, 0};
    for (std::size_t i = 0; i < 6; ++i) {
        a.set(i, from[i]);
        b.set(i, to[i]);
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(angle_between(a.view(), b.view(), angle.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(angle[i], expected[i]) << i;
    }
}

}  // namespace
}  // namespace swivel::tests
