// Root, logarithm, exponential and powers of motors, and sclerp, against Chasles' screws in long double.

#include <gtest/gtest.h>

#include <array>

#include "support/motor_roots.hpp"
#include "support/usable_isas.hpp"
#include "swivel/motor.hpp"

namespace swivel::tests {
namespace {

class MotorPower : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, MotorPower, testing::ValuesIn(usable_isas()), isa_name);

TEST_P(MotorPower, SquareRootSquaredIsTheMotorFloat) { square_root_squared_is_the_motor<float>(1); }
TEST_P(MotorPower, SquareRootSquaredIsTheMotorDouble) { square_root_squared_is_the_motor<double>(1); }

template <class T>
void exp_is_the_series() {
    sampled<T> w(2);
    generator g(3);
    for (std::size_t i = 0; i < n; ++i) {
        const auto any = [&](double largest) {
            const double s =
                i % 3 == 0 ? std::ldexp(1.0, -static_cast<int>(g() % 80)) : uniform(g, 0, largest);
            const vec3<double> a = random_direction<double>(g);
            return vec3<T>{static_cast<T>(s * a.x), static_cast<T>(s * a.y), static_cast<T>(s * a.z)};
        };
        w.b.set(i, any(3.14159));
        w.e.set(i, any(4));
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(exp(w.b.view(), w.e.view(), w.out.view(), {.accuracy = p}), status::ok);
        double real = 0, dual = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const exact_vec3 e = widen<long double>(w.e.get(i));
            const motor_error f =
                distance(w.out.get(i), exact_exp(widen<long double>(w.b.get(i)), e), norm(e));
            real = std::max(real, f.real);
            dual = std::max(dual, f.dual);
        }
        EXPECT_LE(real, p == precision::fast ? 12 : 7.5);
        EXPECT_LE(dual, p == precision::fast ? 11 : 8);
    }
}

TEST_P(MotorPower, ExpIsTheSeriesFloat) { exp_is_the_series<float>(); }
TEST_P(MotorPower, ExpIsTheSeriesDouble) { exp_is_the_series<double>(); }

TEST_P(MotorPower, ExpOfLogIsTheMotorFloat) { exp_of_log_is_the_motor<float>(4); }
TEST_P(MotorPower, ExpOfLogIsTheMotorDouble) { exp_of_log_is_the_motor<double>(4); }

template <class T>
void power_goes_along_the_screw() {
    sampled<T> w(5);
    for (const precision p : both_precisions) {
        ASSERT_EQ(power(w.m.view(), w.t.view(), w.out.view(), {.accuracy = p}), status::ok);
        double real = 0, dual = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const motion m = motion_of(w.m.get(i));
            const long double by = conditioning(m);
            if (by > 1e6L) continue;  // poles have a test of their own
            const motor_error f = distance(w.out.get(i), power(m, w.t[i]), size_of(m));
            real = std::max(real, f.real / double(std::max(by - 1, 1.0L)));
            dual = std::max(dual, f.dual / double(by));
        }
        EXPECT_LE(real, p == precision::fast ? 7.5 : 6);
        EXPECT_LE(dual, 4);
    }
    ASSERT_EQ(power(w.m.view(), T(1), w.out.view(), {.accuracy = precision::reproducible}), status::ok);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(w.out.get(i), w.m.get(i));
    ASSERT_EQ(power(w.m.view(), T(0), w.out.view(), {.accuracy = precision::reproducible}), status::ok);
    for (std::size_t i = 0; i < n; ++i)
        ASSERT_EQ(w.out.get(i), (dual_quaternion<T>{{0, 0, 0, 1}, {0, 0, 0, 0}}));
}

TEST_P(MotorPower, PowerGoesAlongTheScrewFloat) { power_goes_along_the_screw<float>(); }
TEST_P(MotorPower, PowerGoesAlongTheScrewDouble) { power_goes_along_the_screw<double>(); }

template <class T>
void sclerp_goes_along_the_screw(bool long_way) {
    sampled<T> w(6);
    for (const precision p : both_precisions) {
        const options o{.accuracy = p, .long_way = long_way};
        ASSERT_EQ(sclerp(w.m.view(), w.other.view(), w.t.view(), w.out.view(), o), status::ok);
        double real = 0, dual = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const motion a = motion_of(w.m.get(i));
            motion between = after(inverse(a), motion_of(w.other.get(i)));
            // The way is chosen by a sign that rounding may turn.
            if (std::fabs(between.q.w) < 1e-4L) continue;
            if ((between.q.w < 0) != long_way) between = negative(between);
            const long double by = conditioning(between),
                              size = std::max(size_of(a), size_of(between)) + size_of(between);
            if (by > 1e4L) continue;
            const motor_error f = distance(w.out.get(i), after(a, power(between, w.t[i])), size);
            real = std::max(real, f.real / double(by));
            dual = std::max(dual, f.dual / double(by * by));
        }
        EXPECT_LE(real, p == precision::fast ? 6.5 : 5);
        EXPECT_LE(dual, 4);
    }
    const options o{.accuracy = precision::reproducible, .long_way = long_way};
    ASSERT_EQ(sclerp(w.m.view(), w.other.view(), T(0), w.out.view(), o), status::ok);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(w.out.get(i), w.m.get(i));
    ASSERT_EQ(sclerp(w.m.view(), w.other.view(), T(1), w.out.view(), o), status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        const dual_quaternion<T> end = w.out.get(i), b = w.other.get(i);
        const dual_quaternion<T> other{{-b.r.x, -b.r.y, -b.r.z, -b.r.w}, {-b.d.x, -b.d.y, -b.d.z, -b.d.w}};
        ASSERT_TRUE(end == b || end == other);
    }
}

TEST_P(MotorPower, SclerpGoesAlongTheScrewAndEndsInBitsFloat) { sclerp_goes_along_the_screw<float>(false); }
TEST_P(MotorPower, SclerpGoesAlongTheScrewAndEndsInBitsDouble) { sclerp_goes_along_the_screw<double>(false); }
TEST_P(MotorPower, SclerpGoesTheLongWayFloat) { sclerp_goes_along_the_screw<float>(true); }
TEST_P(MotorPower, SclerpGoesTheLongWayDouble) { sclerp_goes_along_the_screw<double>(true); }

// -1 and minus a translation: the root is half a turn about the translation, and log and exp are one
// another's inverse.
template <class T>
void minus_a_translation() {
    const vec3<T> translations[] = {
        {0, 0, 0}, {0, 0, 2}, {T(0.6), T(-0.8), 0}, {T(-1e-6), T(2e-6), T(2e-6)}, {T(300), T(100), T(-700)}};
    constexpr std::size_t count = std::size(translations);
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        motor_buffer<T> m(count, layout::soa), root(count, layout::soa), again(count, layout::soa);
        vec3_buffer<T> b(count, layout::soa), e(count, layout::soa);
        for (std::size_t i = 0; i < count; ++i) {
            const vec3<T> t = translations[i];
            m.set(i, {{0, 0, 0, -1}, {-t.x / 2, -t.y / 2, -t.z / 2, 0}});
        }
        ASSERT_EQ(square_root(m.view(), root.view(), o), status::ok);
        ASSERT_EQ(multiply(root.view(), root.view(), again.view(), o), status::ok);
        const auto expect_same = [&](const char* what, double real) {
            for (std::size_t i = 0; i < count; ++i) {
                const motion want = motion_of(m.get(i));
                const motor_error f = distance(again.get(i), want, size_of(want));
                EXPECT_LE(f.real, real) << what << i;
                EXPECT_LE(f.dual, 8) << what << i;
            }
        };
        expect_same("root ", 8);
        const motor_error about_x = distance(root.get(0), {{1, 0, 0, 0}, {0, 0, 0}}, 0);
        EXPECT_LE(about_x.real, p == precision::fast ? 4 : 0);
        EXPECT_EQ(about_x.dual, 0);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(root.get(i).r.w, 0);
        ASSERT_EQ(log(m.view(), b.view(), e.view(), o), status::ok);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_NEAR(double(norm(widen<long double>(b.get(i)))), double(pi), 8 * rounding_unit<T>);
        ASSERT_EQ(exp(b.view(), e.view(), again.view(), o), status::ok);
        expect_same("log ", p == precision::fast ? 20 : 14);
        ASSERT_EQ(power(m.view(), T(0.5), again.view(), o), status::ok);
        ASSERT_EQ(multiply(again.view(), again.view(), again.view(), o), status::ok);
        expect_same("power ", 8);
    }
}

TEST_P(MotorPower, MinusATranslationIsAScrewAboutIt) {
    minus_a_translation<float>();
    minus_a_translation<double>();
}

template <class T>
void bad_component_at_minus_one() {
    for (const precision p : both_precisions)
        for (std::size_t component = 0; component < 8; ++component)
            for (const T bad : bad_numbers<T>) {
                std::array<T, 8> c{0, 0, 0, -1, 0, 1, 2, 0};
                c[component] = bad;
                motor_buffer<T> m(1, layout::soa), out(1, layout::soa);
                vec3_buffer<T> b(1, layout::soa), e(1, layout::soa);
                m.set(0, {{c[0], c[1], c[2], c[3]}, {c[4], c[5], c[6], c[7]}});
                const options o{.accuracy = p};
                const auto expect_nan = [&](const char* what) {
                    const dual_quaternion<T> d = out.get(0);
                    EXPECT_TRUE(all_nan({d.r.x, d.r.y, d.r.z, d.r.w, d.d.x, d.d.y, d.d.z, d.d.w}))
                        << what << component << ' ' << bad;
                };
                ASSERT_EQ(square_root(m.view(), out.view(), o), status::ok);
                expect_nan("root ");
                ASSERT_EQ(power(m.view(), T(0.5), out.view(), o), status::ok);
                expect_nan("power ");
                ASSERT_EQ(log(m.view(), b.view(), e.view(), o), status::ok);
                EXPECT_TRUE(all_nan({b.get(0).x, b.get(0).y, b.get(0).z})) << component << ' ' << bad;
                EXPECT_TRUE(all_nan({e.get(0).x, e.get(0).y, e.get(0).z})) << component << ' ' << bad;
            }
}

TEST_P(MotorPower, NaNAndInfinityShowBesideARealPartOfMinusOne) {
    bad_component_at_minus_one<float>();
    bad_component_at_minus_one<double>();
}

// Root, logarithm and power of the identity and of a pure translation, exactly.
TEST_P(MotorPower, ATranslationIsNothingSpecial) {
    motor_buffer<double> m(2, layout::soa), out(2, layout::soa);
    vec3_buffer<double> b(2, layout::soa), e(2, layout::soa);
    m.set(0, {{0, 0, 0, 1}, {0, 0, 0, 0}});
    m.set(1, {{0, 0, 0, 1}, {1, -2, 4, 0}});
    const options o{.accuracy = precision::reproducible};
    ASSERT_EQ(square_root(m.view(), out.view(), o), status::ok);
    EXPECT_EQ(out.get(0), m.get(0));
    EXPECT_EQ(out.get(1), (dual_quaternion<double>{{0, 0, 0, 1}, {0.5, -1, 2, 0}}));
    ASSERT_EQ(log(m.view(), b.view(), e.view(), o), status::ok);
    EXPECT_EQ(b.get(0), (vec3<double>{0, 0, 0}));
    EXPECT_EQ(e.get(0), (vec3<double>{0, 0, 0}));
    EXPECT_EQ(b.get(1), (vec3<double>{0, 0, 0}));
    EXPECT_EQ(e.get(1), (vec3<double>{1, -2, 4}));
    ASSERT_EQ(exp(b.view(), e.view(), out.view(), o), status::ok);
    EXPECT_EQ(out.get(0), m.get(0));
    EXPECT_EQ(out.get(1), m.get(1));
    ASSERT_EQ(power(m.view(), -0.5, out.view(), o), status::ok);
    EXPECT_EQ(out.get(1), (dual_quaternion<double>{{0, 0, 0, 1}, {-0.5, 1, -2, 0}}));
    ASSERT_EQ(sclerp(motor_view<const double>(m.view()), m.view(), 0.25, out.view(), o), status::ok);
    EXPECT_EQ(out.get(1), m.get(1));
}

// A door about a hinge: its free edge stays on the circle, at equal steps.
TEST_P(MotorPower, SclerpOfADoorKeepsTheHinge) {
    const exact_vec3 hinge{2, 1, 0}, edge{3, 1, 0};
    const auto door = [&](long double half) {
        const exact_quat q{0, 0, std::sin(half), std::cos(half)};
        return motion{q, sum(hinge, -1, rotated(q, hinge))};
    };
    motor_buffer<double> a(1, layout::soa), b(1, layout::soa), out(1, layout::soa);
    a.set(0, rounded<double>(door(0)));
    b.set(0, rounded<double>(door(0.7L)));
    for (const double t : {0.0, 0.2, 0.5, 0.8, 1.0, 1.5, -1.0}) {
        ASSERT_EQ(sclerp(a.view(), b.view(), t, out.view()), status::ok);
        const motion m = motion_of(out.get(0));
        EXPECT_LE(double(norm(sum(moved(m, hinge), -1, hinge))), 2e-15);
        const exact_vec3 arm = sum(moved(m, edge), -1, hinge);
        EXPECT_NEAR(double(std::atan2(arm.y, arm.x)), 1.4 * t, 2e-15);
        EXPECT_NEAR(double(norm(arm)), 1, 2e-15);
    }
}

// A rotation by more than largest_angle counts as none; nothing that is finite becomes anything else.
TEST_P(MotorPower, AnAngleBeyondTheDomainCountsAsZero) {
    vec3_buffer<float> b(1, layout::soa), e(1, layout::soa);
    motor_buffer<float> out(1, layout::soa);
    b.set(0, {3e38F, 0, 1});
    e.set(0, {1, 2, 3});
    for (const precision p : both_precisions) {
        ASSERT_EQ(exp(b.view(), e.view(), out.view(), {.accuracy = p}), status::ok);
        EXPECT_EQ(out.get(0).r, (quat<float>{0, 0, 0, 1}));
        EXPECT_NEAR(out.get(0).d.y, 2, 1e-6);
    }
}

}  // namespace
}  // namespace swivel::tests
