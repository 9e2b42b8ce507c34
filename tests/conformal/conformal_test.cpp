#include "swivel/conformal.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/conformal_errors.hpp"
#include "support/exact.hpp"

namespace swivel::tests {
namespace {

class Conformal : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Conformal, testing::ValuesIn(usable_isas()), isa_name);

constexpr double pi = std::numbers::pi;
constexpr std::size_t n = 3000;

template <class T>
void multiplies() {
    generator g(1);
    conformal_buffer<T> a(n, layout::soa), b(n, layout::soa), out(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i)
        for (int k = 0; k < 16; ++k) {
            a.at(k, i) = static_cast<T>(uniform(g, -2, 2));
            b.at(k, i) = static_cast<T>(uniform(g, -2, 2));
        }
    for (const precision p : both_precisions) {
        ASSERT_EQ(multiply(a.view(), b.view(), out.view(), {.accuracy = p}), status::ok);
        worst w;
        for (std::size_t i = 0; i < n; ++i) {
            const even<double> x = get(a, i), y = get(b, i), got = get(out, i);
            even<long double> left, right;
            std::copy(x.begin(), x.end(), left.begin());
            std::copy(y.begin(), y.end(), right.begin());
            const even<long double> want = times(left, right);
            double e = 0;
            for (std::size_t k = 0; k < 16; ++k)
                e = std::max(e, static_cast<double>(std::fabs(got[k] - want[k])));
            w.see(e / (size_of(x) * size_of(y)));
        }
        w.expect_below(bound<T>(3e-7, 5e-16), "multiply", p, sizeof(T));
    }
}

TEST_P(Conformal, MultiplyIsTheGeometricProduct) {
    multiplies<float>();
    multiplies<double>();
}

TEST_P(Conformal, OneLeavesTheOtherFactorInEveryBit) {
    generator g(2);
    conformal_buffer<float> a(n, layout::soa), one(n, layout::soa), out(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        set(one, i, even<double>{1});
        for (int k = 0; k < 16; ++k) a.at(k, i) = static_cast<float>(uniform(g, -2, 2));
    }
    for (const precision p : both_precisions)
        for (const bool left : {false, true}) {
            ASSERT_EQ(multiply(left ? one.view() : a.view(), left ? a.view() : one.view(), out.view(),
                               {.accuracy = p}),
                      status::ok);
            for (std::size_t i = 0; i < n; ++i)
                for (int k = 0; k < 16; ++k) ASSERT_EQ(out.at(k, i), a.at(k, i));
        }
}

TEST_P(Conformal, ReverseIsTheInverseOfARotor) {
    generator g(3);
    conformal_buffer<double> r(n, layout::soa), back(n, layout::soa), out(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) set(r, i, exact_exp(random_bivector(g)));
    ASSERT_EQ(reverse(r.view(), back.view()), status::ok);
    ASSERT_EQ(multiply(r.view(), back.view(), out.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i)
        ASSERT_LE(error(get(out, i), even<double>{1}), 1e-15 * size_of(get(r, i)) * size_of(get(r, i)));
}

// Each kind of motion does to points what it should, and products do one after the other, right to left.
template <class T>
void moves_points() {
    generator g(4);
    quat_buffer<T> q(n, layout::soa);
    vec3_buffer<T> t(n, layout::soa), points(n, layout::soa), out(n, layout::soa);
    scalar_buffer<T> factor(n, layout::soa);
    motor_buffer<T> m(n, layout::soa);
    conformal_buffer<T> turn(n, layout::soa), shift(n, layout::soa), scale(n, layout::soa),
        both(n, layout::soa), all(n, layout::soa), motor(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        q.set(i, random_rotation<T>(g));
        t.set(i, {T(uniform(g, -5, 5)), T(uniform(g, -5, 5)), T(uniform(g, -5, 5))});
        points.set(i, {T(uniform(g, -10, 10)), T(uniform(g, -10, 10)), T(uniform(g, -10, 10))});
        factor[i] = static_cast<T>(std::exp(uniform(g, -2, 2)));
        const quat<double> r = widen<double>(q.get(i)),
                           d{t.get(i).x / 2., t.get(i).y / 2., t.get(i).z / 2., 0.}, dual = times(d, r);
        set(m, i, std::array<double, 8>{r.x, r.y, r.z, r.w, dual.x, dual.y, dual.z, dual.w});
    }
    ASSERT_EQ(from_rotation(q.view(), turn.view()), status::ok);
    ASSERT_EQ(from_translation(t.view(), shift.view()), status::ok);
    ASSERT_EQ(from_dilation(factor.view(), scale.view()), status::ok);
    ASSERT_EQ(from_motor(m.view(), motor.view()), status::ok);
    worst dilations;
    for (std::size_t i = 0; i < n; ++i) {
        const double f = static_cast<double>(factor[i]), root = std::sqrt(f);
        even<double> want{(1 / root + root) / 2};
        want[10] = (1 / root - root) / 2;
        dilations.see(error(get(scale, i), want));
    }
    dilations.expect_below(bound<T>(1.5e-7, 3e-16), "from_dilation", precision::reproducible, sizeof(T));
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        ASSERT_EQ(multiply(shift.view(), turn.view(), both.view(), o), status::ok);
        ASSERT_EQ(multiply(both.view(), scale.view(), all.view(), o), status::ok);
        worst w, motors;
        const auto check = [&](conformal_buffer<T>& r, bool turns, bool shifts, bool scales) {
            ASSERT_EQ(transform(r.view(), points.view(), out.view(), o), status::ok);
            for (std::size_t i = 0; i < n; ++i) {
                vec3<double> v = widen<double>(points.get(i));
                const double f = scales ? static_cast<double>(factor[i]) : 1;
                const quat<double> by = widen<double>(q.get(i)), at{v.x * f, v.y * f, v.z * f, 0};
                const quat<double> moved = turns ? times(times(by, at), conjugate(by)) : at;
                const vec3<double> s = shifts ? widen<double>(t.get(i)) : vec3<double>{};
                const quat<double> want{moved.x + s.x, moved.y + s.y, moved.z + s.z, 0};
                const quat<double> got{double(out.get(i).x), double(out.get(i).y), double(out.get(i).z), 0};
                w.see(norm(minus(got, want)) / std::max(1.0, norm(want)));
            }
        };
        check(turn, true, false, false);
        check(shift, false, true, false);
        check(scale, false, false, true);
        check(both, true, true, false);
        check(motor, true, true, false);
        check(all, true, true, true);
        w.expect_below(bound<T>(1.5e-6, 3e-15), "transform", p, sizeof(T));
        // The motor's rotor is the product of those of its parts.
        for (std::size_t i = 0; i < n; ++i) motors.see(error(get(motor, i), get(both, i)));
        motors.expect_below(bound<T>(1.5e-7, 4e-16), "from_motor", p, sizeof(T));
    }
}

TEST_P(Conformal, RotorsOfMotionsMovePointsAndComposeFromRightToLeft) {
    moves_points<float>();
    moves_points<double>();
}

TEST_P(Conformal, APointThatGoesToInfinityGivesTheOrigin) {
    // The inversion of space that exchanges the origin and infinity, made even by the reflection of x: e1 e4.
    conformal_buffer<float> r(1, layout::soa);
    vec3_buffer<float> p(1, layout::soa), out(1, layout::soa);
    even<double> inversion{};
    inversion[3] = 1;
    set(r, 0, inversion);
    p.set(0, {0, 0, 0});
    for (const precision accuracy : both_precisions) {
        ASSERT_EQ(transform(r.view(), p.view(), out.view(), {.accuracy = accuracy}), status::ok);
        EXPECT_EQ(out.get(0), (vec3<float>{0, 0, 0}));
    }
    p.set(0, {2, 0, 0});
    ASSERT_EQ(transform(r.view(), p.view(), out.view()), status::ok);
    EXPECT_NEAR(std::fabs(out.get(0).x), 0.5, 1e-6);
}

TEST_P(Conformal, AFactorThatIsNotPositiveCountsAsOne) {
    scalar_buffer<float> f(3, layout::soa);
    conformal_buffer<float> r(3, layout::soa);
    f[0] = 0, f[1] = -2, f[2] = -0.0F;
    ASSERT_EQ(from_dilation(f.view(), r.view()), status::ok);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(get(r, i), even<double>{1});
}

// exp against its series, and square_root, log and power of the result; rotations of up to 5 radians.
template <class T>
void functions() {
    generator g(5);
    bivector_buffer<T> b(n, layout::soa), l(n, layout::soa);
    conformal_buffer<T> r(n, layout::soa), out(n, layout::soa), back(n, layout::soa);
    scalar_buffer<T> unique(n, layout::soa), t(n, layout::soa);
    std::vector<even<double>> want(n), half(n), part(n);
    std::vector<bool> rigid(n);
    for (std::size_t i = 0; i < n; ++i) {
        set(b, i, random_bivector(g));
        const bivector<double> given = get(b, i);
        rigid[i] = given[9] == 0;
        t[i] = static_cast<T>(uniform(g, 0, 1));
        bivector<double> half_of = given, part_of = given;
        for (std::size_t k = 0; k < 10; ++k) {
            half_of[k] *= 0.5;
            part_of[k] *= static_cast<double>(t[i]);
        }
        want[i] = exact_exp(given);
        half[i] = exact_exp(half_of);
        part[i] = exact_exp(part_of);
        set(r, i, want[i]);
    }
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        const auto check = [&](const char* what, const std::vector<even<double>>& expected, double limit) {
            worst w;
            for (std::size_t i = 0; i < n; ++i) w.see(error(get(out, i), expected[i]));
            w.expect_below(limit, what, p, sizeof(T));
        };
        ASSERT_EQ(exp(b.view(), out.view(), o), status::ok);
        check("exp", want, bound<T>(5e-7, 1e-15));
        ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), o), status::ok);
        check("square_root", half, bound<T>(5e-7, 1e-15));
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(unique[i], 1);
        ASSERT_EQ(power(r.view(), t.view(), out.view(), unique.view(), o), status::ok);
        check("power", part, bound<T>(1.2e-6, 2e-15));
        ASSERT_EQ(log(r.view(), l.view(), unique.view(), o), status::ok);
        ASSERT_EQ(exp(l.view(), back.view(), o), status::ok);
        worst all, motions;
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(unique[i], 1);
            const double e = error(get(back, i), get(r, i));
            all.see(e);
            if (rigid[i]) motions.see(e);
        }
        all.expect_below(bound<T>(1.5e-6, 3e-15), "exp(log)", p, sizeof(T));
        motions.expect_below(bound<T>(1.5e-6, 2e-15), "exp(log) of motions", p, sizeof(T));
    }
}

TEST_P(Conformal, ExpLogSquareRootAndPowerOfMotionsUpToFiveRadiansFloat) { functions<float>(); }
TEST_P(Conformal, ExpLogSquareRootAndPowerOfMotionsUpToFiveRadiansDouble) { functions<double>(); }

// Near where there is no unique root either the root is one, or it is said not to be.
template <class T>
void never_silently_wrong() {
    generator g(6);
    conformal_buffer<T> r(n, layout::soa), out(n, layout::soa), back(n, layout::soa);
    bivector_buffer<T> l(n, layout::soa);
    scalar_buffer<T> unique(n, layout::soa), log_unique(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        const double away = std::exp(uniform(g, -30, -1)), x = uniform(g, 0, pi - away);
        const vec3<double> d = random_direction<double>(g);
        const double h = pi - away;
        bivector<double> b = rotation_generator(h * d.x, h * d.y, h * d.z);
        if (i % 4 == 1)
            b = b + translation_generator(uniform(g, -3, 3), uniform(g, -3, 3), uniform(g, -3, 3));
        if (i % 4 == 2) b = b + dilation_generator(uniform(g, -2, 2));
        if (i % 4 == 3) b = {x, 0, 0, 0, 0, 0, 0, pi - x - away, 0, 0};
        // Half of them about another place.
        const even<double> moved = exact_exp(translation_generator(d.y, d.z, 2 * d.x));
        const even<double> rotor = exact_exp(b);
        set(r, i, i % 8 < 4 ? rotor : times(times(moved, rotor), reverse_of(moved)));
    }
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), o), status::ok);
        ASSERT_EQ(log(r.view(), l.view(), log_unique.view(), o), status::ok);
        worst roots, logs;
        std::size_t count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(unique[i], log_unique[i]);
            ASSERT_TRUE(std::isfinite(size_of(get(out, i))) && std::isfinite(size_of(get(l, i))));
            if (unique[i] != 1) continue;
            ++count;
            const even<double> root = get(out, i), given = get(r, i);
            roots.see(error(times(root, root), given));
            logs.see(error(exact_exp(get(l, i)), given));
        }
        EXPECT_GT(count, n / 20);
        EXPECT_LT(count, n);
        // The loss of figures at which uniqueness ends.
        roots.expect_below(bound<T>(5e-3, 5e-4), "root near singular", p, sizeof(T));
        logs.expect_below(bound<T>(5e-3, 5e-4), "log near singular", p, sizeof(T));
    }
}

TEST_P(Conformal, ARootOrLogarithmIsRightOrSaidNotToBeUnique) {
    never_silently_wrong<float>();
    never_silently_wrong<double>();
}

// About places far away: the logarithm is large and its rounding too, but power does without.
template <class T>
void halves_about_far_places() {
    generator g(13);
    conformal_buffer<T> one(n, layout::soa), r(n, layout::soa), out(n, layout::soa);
    scalar_buffer<T> unique(n, layout::soa);
    std::vector<even<double>> want(n);
    for (std::size_t i = 0; i < n; ++i) {
        set(one, i, even<double>{1});
        const bivector<double> turn = random_bivector(g);
        bivector<double> half = turn;
        for (double& x : half) x *= 0.5;
        const vec3<double> d = random_direction<double>(g);
        const double away = std::exp2(uniform(g, 0, 9));
        const even<long double> there =
            exact_exp_long(translation_generator(away * d.x, away * d.y, away * d.z));
        const auto moved = [&](const bivector<double>& b) {
            return times(times(there, exact_exp_long(b)), reverse_of(there));
        };
        const even<long double> rotor = moved(turn), root = moved(half);
        set(r, i, rotor);
        std::copy(root.begin(), root.end(), want[i].begin());
        // Infinity stays where it is, which rounding would spoil.
        for (const int e4 : {3, 6, 8, 11}) r.at(e4 + 1, i) = r.at(e4, i);
    }
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        const auto check = [&](const char* what) {
            worst w;
            for (std::size_t i = 0; i < n; ++i)
                if (unique[i] == 1) w.see(error(get(out, i), want[i]));
            w.expect_below(bound<T>(6e-6, 2e-14), what, p, sizeof(T));
        };
        ASSERT_EQ(power(r.view(), T(0.5), out.view(), unique.view(), o), status::ok);
        check("power about a far place");
        ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), o), status::ok);
        check("square_root about a far place");
        ASSERT_EQ(interpolate(one.view(), r.view(), T(0.5), out.view(), unique.view(), o), status::ok);
        check("interpolate about a far place");
    }
}

TEST_P(Conformal, HalvesOfMotionsAboutFarPlaces) {
    halves_about_far_places<float>();
    halves_about_far_places<double>();
}

// Two turns whose half angles add up to nearly pi, where there is no root: as uncertain as they are near.
template <class T>
void nearly_singular_pairs() {
    generator g(14);
    conformal_buffer<T> r(n, layout::soa), out(n, layout::soa);
    bivector_buffer<T> l(n, layout::soa);
    scalar_buffer<T> unique(n, layout::soa);
    std::vector<even<double>> half(n);
    std::vector<double> away(n);
    for (std::size_t i = 0; i < n; ++i) {
        away[i] = std::exp2(uniform(g, -6, std::log2(pi - 2.5)));
        const double a = uniform(g, pi / 2, 2.4) - away[i] / 2, b = pi - away[i] - a;
        const bivector<double> turns{a, 0, 0, 0, 0, 0, 0, b, 0, 0};
        const vec3<double> d = random_direction<double>(g);
        const even<long double> there = exact_exp_long(translation_generator(d.x, d.y, d.z));
        const auto moved = [&](double part) {
            bivector<double> of = turns;
            for (double& x : of) x *= part;
            return times(times(there, exact_exp_long(of)), reverse_of(there));
        };
        set(r, i, moved(1));
        const even<long double> root = moved(0.5);
        std::copy(root.begin(), root.end(), half[i].begin());
    }
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        worst roots, logs;
        ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), o), status::ok);
        ASSERT_EQ(log(r.view(), l.view(), unique.view(), o), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(unique[i], 1);
            roots.see(error(get(out, i), half[i]) * away[i] * away[i]);
            logs.see(error(exact_exp(get(l, i)), get(r, i)) * away[i] * away[i]);
        }
        roots.expect_below(bound<T>(2e-7, 4e-16), "root of two turns", p, sizeof(T));
        logs.expect_below(bound<T>(2e-7, 4e-16), "exp(log) of two turns", p, sizeof(T));
    }
}

TEST_P(Conformal, TwoTurnsOfNearlyPiAreAsUncertainAsTheyAreNear) {
    nearly_singular_pairs<float>();
    nearly_singular_pairs<double>();
}

// Minus a small motion has no root, and gets that of the motion, which acts alike.
template <class T>
void minus_small_motions() {
    conformal_buffer<T> r(1, layout::soa), plus(1, layout::soa), out(1, layout::soa), root(1, layout::soa);
    scalar_buffer<T> unique(1, layout::soa);
    for (int digits = 1; digits < (sizeof(T) == 4 ? 20 : 48); ++digits)
        for (const bivector<double>& motion : {translation_generator(1, 0, 0), dilation_generator(1),
                                               bivector<double>{0, 0, 0, 1, 0, 0, 0, 0, 0, 0}})
            for (const precision p : both_precisions) {
                bivector<double> small = motion;
                for (double& x : small) x = std::ldexp(x, -digits);
                even<double> rotor = exact_exp(small);
                set(plus, 0, rotor);
                for (double& x : rotor) x = -x;
                set(r, 0, rotor);
                const options o{.accuracy = p};
                ASSERT_EQ(square_root(plus.view(), root.view(), unique.view(), o), status::ok);
                ASSERT_EQ(unique[0], 1);
                ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), o), status::ok);
                ASSERT_EQ(unique[0], 0);
                ASSERT_LE(error(get(out, 0), get(root, 0)), bound<T>(5e-7, 1e-15)) << digits;
            }
}

TEST_P(Conformal, MinusASmallMotionGetsTheRootOfTheMotion) {
    minus_small_motions<float>();
    minus_small_motions<double>();
}

template <class T>
void interpolates() {
    generator g(8);
    conformal_buffer<T> a(n, layout::soa), b(n, layout::soa), out(n, layout::soa);
    scalar_buffer<T> t(n, layout::soa), unique(n, layout::soa);
    std::vector<even<double>> want(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bivector<double> motion = random_bivector(g);
        const even<double> start = exact_exp(random_bivector(g));
        t[i] = static_cast<T>(uniform(g, -0.25, 1.25));
        bivector<double> part = motion;
        for (double& x : part) x *= static_cast<double>(t[i]);
        set(a, i, start);
        set(b, i, times(exact_exp(motion), start));
        want[i] = times(exact_exp(part), start);
    }
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        ASSERT_EQ(interpolate(a.view(), b.view(), t.view(), out.view(), unique.view(), o), status::ok);
        worst w;
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(unique[i], 1);
            w.see(error(get(out, i), want[i]) / size_of(get(a, i)));
        }
        w.expect_below(bound<T>(1e-6, 3e-14), "interpolate", p, sizeof(T));
        for (const T end : {T(0), T(1)}) {
            ASSERT_EQ(interpolate(a.view(), b.view(), end, out.view(), unique.view(), o), status::ok);
            for (std::size_t i = 0; i < n; ++i)
                for (int k = 0; k < 16; ++k) {
                    const T expected = end == 0 ? a.at(k, i) : b.at(k, i);
                    ASSERT_TRUE(p == precision::fast || same_bits(out.at(k, i), expected));
                }
        }
    }
}

TEST_P(Conformal, InterpolateIsAPowerOfTheMotionFromAToB) {
    interpolates<float>();
    interpolates<double>();
}

TEST_P(Conformal, PowersOfZeroAndOneAreExact) {
    generator g(9);
    conformal_buffer<float> r(n, layout::soa), out(n, layout::soa);
    scalar_buffer<float> unique(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) set(r, i, exact_exp(random_bivector(g)));
    for (const precision p : both_precisions) {
        ASSERT_EQ(power(r.view(), 0.0F, out.view(), unique.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(get(out, i), even<double>{1});
    }
    ASSERT_EQ(power(r.view(), 1.0F, out.view(), unique.view(), {.accuracy = precision::reproducible}),
              status::ok);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(get(out, i), get(r, i));
}

TEST_P(Conformal, WhatIsOutOfTheDomainIsSaidNotToBeUnique) {
    conformal_buffer<float> r(2, layout::soa), out(2, layout::soa);
    bivector_buffer<float> l(2, layout::soa);
    scalar_buffer<float> unique(2, layout::soa);
    for (std::size_t i = 0; i < 2; ++i) {
        even<double> far{1};
        far[3] = far[4] = i == 0 ? 1e7 : 3e38;
        set(r, i, far);
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(unique[i], 0);
            EXPECT_EQ(get(out, i), (even<double>{0, 0, 0, 0, 0, -1}));
        }
        ASSERT_EQ(log(r.view(), l.view(), unique.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(unique[i], 0);
    }
}

// 1 + R0 does not cancel: as near as that the root is the half turn about the axis of R.
template <class T>
void near_minus_one(double nearest) {
    conformal_buffer<T> r(1, layout::soa), out(1, layout::soa);
    scalar_buffer<T> unique(1, layout::soa);
    for (double away = 0.1; away > nearest; away /= 2)
        for (const precision p : both_precisions) {
            even<double> turn{-std::cos(away)};
            turn[1] = 0.6 * std::sin(away);
            turn[5] = -0.8 * std::sin(away);
            set(r, 0, turn);
            ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), {.accuracy = p}), status::ok);
            ASSERT_EQ(unique[0], 1) << away;
            const double c = std::cos(away / 2), h = std::sin(away / 2);
            ASSERT_LE(error(get(out, 0), {h, 0.6 * c, 0, 0, 0, -0.8 * c}), bound<T>(2e-7, 4e-16)) << away;
        }
}

TEST_P(Conformal, RotationsNearMinusOneHaveTheirRoot) {
    near_minus_one<float>(0x1p-24);
    near_minus_one<double>(0x1p-239);
}

TEST_P(Conformal, ExpOfWhatIsOutOfTheDomainIsOne) {
    const std::vector<bivector<double>> outside = {rotation_generator(0, 5000, 0), dilation_generator(100),
                                                   translation_generator(1e7, 0, 0),
                                                   translation_generator(3e38, 3e38, 3e38)};
    bivector_buffer<float> b(1, layout::soa);
    conformal_buffer<float> out(1, layout::soa);
    for (const bivector<double>& far : outside)
        for (const precision p : both_precisions) {
            set(b, 0, far);
            ASSERT_EQ(exp(b.view(), out.view(), {.accuracy = p}), status::ok);
            EXPECT_EQ(get(out, 0), even<double>{1});
        }
    set(b, 0, rotation_generator(0, 4000, 0) + dilation_generator(60));
    ASSERT_EQ(exp(b.view(), out.view()), status::ok);
    EXPECT_GT(std::fabs(get(out, 0)[10]), 1e10);
}

}  // namespace
}  // namespace swivel::tests
