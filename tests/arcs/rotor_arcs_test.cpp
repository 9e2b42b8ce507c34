#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/exact.hpp"
#include "support/multivector.hpp"
#include "support/rotations.hpp"
#include "support/vectors.hpp"
#include "swivel/reference.hpp"
#include "swivel/versors.hpp"

namespace swivel::tests {
namespace {

namespace tool = swivel::reference;

constexpr double pi = std::numbers::pi;

// exp(sign I f/2) with I = I3 axis.
multivector exponential(const vec3<double>& axis, double f, double sign) {
    return combined(std::cos(f / 2), {1}, sign * std::sin(f / 2), dual(axis));
}

TEST(HalfAngleCosine, IsThatOfTheProductAndSlideSevenHoldsWithTheScalarPartOfThePlanesOnly) {
    generator g(10);
    double misread = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> a1 = random_direction<double>(g), a2 = random_direction<double>(g);
        const double h1 = uniform(g, -pi, pi), h2 = uniform(g, -pi, pi);
        const double exact = times(about(a2, 2 * h2), about(a1, 2 * h1)).w;
        const double between_axes = std::acos(std::clamp(dotted(a1, a2), -1.0, 1.0));
        EXPECT_NEAR(tool::half_angle_cosine(h1, h2, between_axes), exact, 1e-14);
        EXPECT_NEAR(tool::compose_arcs(about(a1, 2 * h1), about(a2, 2 * h2)).rotor.w, exact, 1e-15);
        EXPECT_EQ(tool::half_angle_cosine(h1, h2, between_axes),
                  tool::half_angle_cosine(h2, h1, between_axes));

        const double c_perp = product(dual(a2), dual(a1))[0];
        EXPECT_NEAR(c_perp, -dotted(a1, a2), 1e-15);
        EXPECT_NEAR(std::cos(h1) * std::cos(h2) + std::sin(h1) * std::sin(h2) * c_perp, exact, 1e-14);
        const double between_planes = dotted(a1, a2);
        misread = std::max(misread, std::fabs(std::cos(h1) * std::cos(h2) +
                                              std::sin(h1) * std::sin(h2) * between_planes - exact));
    }
    EXPECT_GT(misread, 1);
}

template <class T>
void cosine_accuracy() {
    generator g(11);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const T f = static_cast<T>(uniform(g, -7, 7)),
                h = i % 3 == 0 ? -f : static_cast<T>(uniform(g, -7, 7)),
                b = i % 3 == 0 ? T(0) : static_cast<T>(uniform(g, -7, 7));
        using L = long double;
        const L want = std::cos(L(f)) * std::cos(L(h)) - std::sin(L(f)) * std::sin(L(h)) * std::cos(L(b));
        const T got = tool::half_angle_cosine(f, h, b);
        ASSERT_LE(std::fabs(got), 1);
        worst = std::max(worst, static_cast<double>(std::fabs(got - want)) / rounding_unit<T>);
    }
    EXPECT_LE(worst, 3);
    for (T bad : bad_numbers<T>) {
        EXPECT_TRUE(std::isnan(tool::half_angle_cosine<T>(bad, 0, 1)));
        EXPECT_TRUE(std::isnan(tool::half_angle_cosine<T>(0, bad, 1)));
        EXPECT_TRUE(std::isnan(tool::half_angle_cosine<T>(0, 0, bad)));
    }
}

TEST(HalfAngleCosine, IsWithinTheStatedErrorAndPassesNanOn) {
    cosine_accuracy<float>();
    cosine_accuracy<double>();
}

TEST(ComposeArcs, GivesTheRotationOfSlideSix) {
    const composed_arcs<double> arcs = tool::compose_arcs(about({1, 0, 0}, pi / 2), about({0, 1, 0}, pi / 2));
    EXPECT_LE(norm(minus(arcs.rotor, {0.5, 0.5, -0.5, 0.5})), 2e-16);
    const double third = 1 / std::sqrt(3.0);
    EXPECT_LE(norm(minus(arcs.rotor, about({third, third, -third}, 2 * pi / 3))), 4e-16);
    EXPECT_NEAR(tool::half_angle_cosine(pi / 4, pi / 4, pi / 2), 0.5, 2e-16);
}

TEST(ComposeArcs, SlideFiveHoldsWithEachAngleAtItsOwnPlane) {
    generator g(12);
    double sign_as_named = 10, angles_exchanged = 10, wrong_order = 10;
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> a = random_direction<double>(g), b = random_direction<double>(g),
                           v = random_direction<double>(g);
        const double f = uniform(g, -pi, pi), h = uniform(g, -pi, pi);
        // exp(-I f/2) turns by f; exp(I f/2), which the text calls the rotor, back.
        const multivector once = vector_of(turned(v, a, f));
        EXPECT_LE(distance(sandwich(exponential(a, f, -1), vector_of(v)), once), 2e-15);
        sign_as_named =
            std::min(sign_as_named, -distance(sandwich(exponential(a, f, 1), vector_of(v)), once));

        const multivector rotor = rotor_of(tool::compose_arcs(about(a, f), about(b, h)).rotor);
        EXPECT_LE(distance(sandwich(rotor, vector_of(v)), vector_of(turned(turned(v, a, f), b, h))), 3e-15);
        EXPECT_LE(distance(product(exponential(b, h, -1), exponential(a, f, -1)), rotor), 1e-15);
        const multivector printed = product(exponential(b, f, -1), exponential(a, h, -1));
        angles_exchanged = std::min(angles_exchanged, -distance(printed, rotor));
        const multivector other = product(exponential(a, f, -1), exponential(b, h, -1));
        wrong_order = std::min(wrong_order, -distance(other, rotor));
    }
    EXPECT_LE(sign_as_named, -1.5);
    EXPECT_LE(angles_exchanged, -1);
    EXPECT_LE(wrong_order, -1);
}

// What is wrong with the arcs, in units: their lengths, the products of their ends, the composite.
template <class T>
struct arc_errors {
    double arcs, rotor;
};

template <class T>
arc_errors<T> errors_of(const quat<T>& first, const quat<T>& second) {
    using W = wide<T>;
    const composed_arcs<T> c = tool::compose_arcs(first, second);
    const quat<W> q = normalized(widen<W>(first)), r = normalized(widen<W>(second)), p = times(r, q);
    const vec3<W> start = widen<W>(c.start), common = widen<W>(c.common), end = widen<W>(c.end);
    W worst = 0;
    for (const vec3<W>& v : {start, common, end}) worst = std::max(worst, magnitude(norm(v) - 1));
    worst = std::max(worst, norm(minus(product_of(common, start), q)));
    worst = std::max(worst, norm(minus(product_of(end, common), r)));
    worst = std::max(worst, norm(minus(product_of(end, start), p)));
    return {units<T>(worst), units<T>(norm(minus(widen<W>(c.rotor), p)))};
}

template <class T>
void arcs_accuracy() {
    generator g(13);
    double worst_arcs = 0, worst_rotor = 0;
    const auto look_at = [&](const quat<T>& q, const quat<T>& r) {
        const arc_errors<T> e = errors_of(q, r);
        worst_arcs = std::max(worst_arcs, e.arcs);
        worst_rotor = std::max(worst_rotor, e.rotor);
    };
    for (int i = 0; i < 50000; ++i) look_at(random_rotation<T>(g), random_rotation<T>(g));
    // About nearly the same axis, by large and small angles, at every distance of the axes.
    for (int i = 0; i < 50000; ++i) {
        const vec3<double> a = random_direction<double>(g), d = random_direction<double>(g);
        const double noise = std::exp2(uniform(g, -60, 0));
        const vec3<double> b = unit(vec3<double>{a.x + noise * d.x, a.y + noise * d.y, a.z + noise * d.z});
        const double f = i % 2 != 0 ? std::exp2(uniform(g, -60, 0)) : uniform(g, -2 * pi, 2 * pi);
        const quat<double> q = about(a, f), r = about(b, uniform(g, -2 * pi, 2 * pi));
        look_at(rounded<T>(q.x, q.y, q.z, q.w), rounded<T>(r.x, r.y, r.z, r.w));
        look_at(rounded<T>(r.x, r.y, r.z, r.w), rounded<T>(q.x, q.y, q.z, q.w));
    }
    for (const quat<T>& q : corner_rotations<T>())
        for (const quat<T>& r : corner_rotations<T>())
            if (norm(widen<double>(q)) > 0 && norm(widen<double>(r)) > 0) look_at(q, r);
    EXPECT_LE(worst_arcs, 10);
    EXPECT_LE(worst_rotor, 3.5);
}

TEST(ComposeArcs, SlidesTheArcsToACommonCornerWithinTheStatedError) {
    arcs_accuracy<float>();
    arcs_accuracy<double>();
}

template <class T>
void arcs_corners() {
    const quat<T> one{0, 0, 0, 1}, minus_one{0, 0, 0, -1}, zero{0, 0, 0, 0};
    for (const quat<T>& nothing : {one, zero}) {
        const composed_arcs<T> c = tool::compose_arcs(nothing, nothing);
        EXPECT_EQ(c.start, c.common);
        EXPECT_EQ(c.end, c.common);
        EXPECT_EQ(c.common, (vec3<T>{0, 1, 0}));
        EXPECT_EQ(c.rotor, one);
    }
    // An arc to the opposite point, and one around the sphere.
    const composed_arcs<T> once = tool::compose_arcs(minus_one, one);
    EXPECT_EQ(once.start, (vec3<T>{-once.end.x, -once.end.y, -once.end.z}));
    EXPECT_EQ(once.rotor, minus_one);
    EXPECT_EQ(tool::rotation_from_reflections(once.start, once.end), minus_one);
    const composed_arcs<T> twice = tool::compose_arcs(minus_one, minus_one);
    EXPECT_EQ(twice.start, twice.end);
    EXPECT_EQ(twice.rotor, one);
    // Beside a rotor without an axis, the plane of the other.
    for (const quat<T>& q : {one, minus_one, zero}) {
        EXPECT_EQ(tool::compose_arcs<T>(q, {0, 0, 1, 0}).common.z, 0);
        EXPECT_EQ(tool::compose_arcs<T>({0, 1, 0, 0}, q).common.y, 0);
    }
    const quat<T> q{T(0.5), T(-0.5), T(0.5), T(0.5)};
    for (const quat<T>& p : {q, one, zero})
        for (const quat<T>& bad : bad_rotations(q))
            for (const composed_arcs<T>& c : {tool::compose_arcs(p, bad), tool::compose_arcs(bad, p)})
                EXPECT_TRUE(all_nan({c.start.x, c.start.y, c.start.z, c.common.x, c.common.y, c.common.z,
                                     c.end.x, c.end.y, c.end.z, c.rotor.x, c.rotor.y, c.rotor.z, c.rotor.w}));
    for (const vec3<T>& v : corner_vectors<T>())
        for (T w : {T(0), std::numeric_limits<T>::max(), std::numeric_limits<T>::denorm_min()})
            for (const composed_arcs<T>& c :
                 {tool::compose_arcs({v.x, v.y, v.z, w}, q), tool::compose_arcs(q, {v.x, v.y, v.z, w})})
                ASSERT_TRUE(no_nan({c.start.x, c.start.y, c.start.z, c.common.x, c.common.y, c.common.z,
                                    c.end.x, c.end.y, c.end.z, c.rotor.x, c.rotor.y, c.rotor.z, c.rotor.w}));
}

TEST(ComposeArcs, IsDefinedWithoutAxesAndPassesNanOn) {
    arcs_corners<float>();
    arcs_corners<double>();
}

// Rotors and quaternions

template <class T>
void same_as_the_batch() {
    for (quat<T> q : corner_rotations<T>()) {
        spinor<T> s{};
        const quat_view<T> v{&q.x, &q.y, &q.z, &q.w, 1};
        const spinor_view<T> u{&s.a, &s.b, &s.c, &s.d, 1};
        ASSERT_EQ(tool::to_spinor(v, u), status::ok);
        EXPECT_EQ(tool::to_spinor(q), s);
        EXPECT_EQ(tool::from_spinor(s), q);
        const quat<T> back = tool::from_spinor(tool::to_spinor(q));
        EXPECT_EQ(std::signbit(back.x), std::signbit(q.x));
        EXPECT_EQ(std::signbit(back.w), std::signbit(q.w));
    }
    for (const quat<T>& bad : bad_rotations<T>({1, 2, 3, 4})) {
        const quat<T> q = tool::from_spinor(tool::to_spinor(bad));
        EXPECT_TRUE(std::isfinite(q.x) == std::isfinite(bad.x) &&
                    std::isfinite(q.y) == std::isfinite(bad.y) &&
                    std::isfinite(q.z) == std::isfinite(bad.z) && std::isfinite(q.w) == std::isfinite(bad.w));
    }
}

TEST(Spinors, AreTheQuaternionsOfTheOperationsForStreams) {
    same_as_the_batch<float>();
    same_as_the_batch<double>();
}

TEST(Spinors, SlideEightHoldsWithAMinusBeforeTheLastBivector) {
    generator g(14);
    double printed = 10;
    for (int i = 0; i < 1000; ++i) {
        const quat<double> q = random_rotation<double>(g), p = random_rotation<double>(g);
        const vec3<double> u{q.x, q.y, q.z}, v{p.x, p.y, p.z}, c = crossed(u, v);
        const multivector whole_q = combined(q.w, {1}, -1, dual(u)),
                          whole_p = combined(p.w, {1}, -1, dual(v));
        const spinor<double> s = tool::to_spinor(q);
        EXPECT_LE(distance(whole_q, {s.a, 0, 0, s.b, 0, -s.d, s.c, 0}), 0);
        const multivector want = product(whole_q, whole_p);
        EXPECT_LE(distance(want, rotor_of(times(q, p))), 1e-15);
        const double scalar = p.w * q.w - dotted(u, v);
        const multivector bivector =
            dual({p.w * u.x + q.w * v.x + c.x, p.w * u.y + q.w * v.y + c.y, p.w * u.z + q.w * v.z + c.z});
        EXPECT_LE(distance(combined(scalar, {1}, -1, bivector), want), 1e-15);
        printed = std::min(printed, -distance(combined(scalar, {1}, 1, bivector), want));
    }
    EXPECT_LE(printed, -1.5);
}

// Of R = exp(B), the sum of <e_i R e_j R~> e_i e_j / 2 over i < j and its negatives.
multivector associated_bivector(const multivector& rotor) {
    multivector f{};
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j) {
            if (i == j) continue;
            multivector ei{}, ej{};
            ei[1U << i] = 1;
            ej[1U << j] = 1;
            const double part = product(ei, sandwich(rotor, ej))[0] / 2;
            f = combined(1, f, part, product(ei, ej));
        }
    return f;
}

TEST(Logarithms, SlideSeventeenHoldsForRotationsWithHalfOfTheBivectorAndTheArcSine) {
    generator g(15);
    double whole = 0, hyperbolic = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> axis = random_direction<double>(g);
        const double f = uniform(g, 0.1, pi / 2);
        const multivector r = exponential(axis, f, -1), b = combined(-f / 2, dual(axis), 0, {});
        const multivector bivector = associated_bivector(r);
        // sinh(2 B) of a bivector whose square is negative.
        EXPECT_LE(distance(bivector, combined(-std::sin(f), dual(axis), 0, {})), 1e-15);
        const double size = std::sqrt(-product(bivector, bivector)[0]);
        const double arc = std::asin(std::min(size, 1.0)) / size, printed = std::asinh(size) / size;
        EXPECT_LE(distance(combined(arc / 2, bivector, 0, {}), b), 1e-7);
        whole = std::max(whole, distance(combined(arc, bivector, 0, {}), b));
        hyperbolic = std::max(hyperbolic, distance(combined(printed / 2, bivector, 0, {}), b));

        vec3<double> log{};
        quat<double> q = about(axis, f);
        const quat_view<double> v{&q.x, &q.y, &q.z, &q.w, 1};
        ASSERT_EQ(tool::log(v, vec3_view<double>{&log.x, &log.y, &log.z, 1}), status::ok);
        EXPECT_LE(distance(combined(-1, dual(log), 0, {}), b), 1e-15);
    }
    EXPECT_GT(whole, 0.7);
    EXPECT_GT(hyperbolic, 0.2);
    // Beyond a right angle the arc sine is that of pi - f.
    const double f = 2.5;
    const multivector bivector = associated_bivector(exponential({0, 0, 1}, f, -1));
    EXPECT_NEAR(std::asin(-bivector[3]), pi - f, 1e-14);
}

TEST(Logarithms, SlideNineteensHyperbolicCosineIsOneForEveryRotation) {
    generator g(16);
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> axis = random_direction<double>(g);
        const double f = uniform(g, 0.1, 3);
        const multivector r = exponential(axis, f, -1), squared = product(r, r);
        multivector bivector = r;
        bivector[0] = 0;
        const multivector s = combined(-2 * r[0], bivector, 0, {});
        EXPECT_LE(distance(s, combined(std::sin(f), dual(axis), 0, {})), 2e-15);
        multivector part = squared;
        part[0] = 0;
        const double ss = product(s, s)[0];
        const double printed = -product(part, combined(1 / ss, s, 0, {}))[0];
        EXPECT_NEAR(printed, 1, 1e-14);
        EXPECT_NEAR(squared[0], std::cos(f), 1e-15);
        EXPECT_GT(std::fabs(printed - std::cos(f)), 0.004);
        // R and -R have the same S, so it cannot tell their logarithms.
        const multivector opposite = combined(-1, r, 0, {});
        bivector = opposite;
        bivector[0] = 0;
        EXPECT_EQ(combined(-2 * opposite[0], bivector, 0, {}), s);
    }
}

}  // namespace
}  // namespace swivel::tests
