#include "swivel/versors.hpp"

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

namespace swivel::tests {
namespace {

namespace tool = swivel::reference;

constexpr double pi = std::numbers::pi;

template <class T>
quat<T> one_root(quat<T> q) {
    const quat_view<T> v{&q.x, &q.y, &q.z, &q.w, 1};
    EXPECT_EQ(tool::square_root(v, v), status::ok);
    return q;
}
template <class T>
quat<T> one_arc(const vec3<T>& a, const vec3<T>& b) {
    quat<T> q{};
    const quat_view<T> v{&q.x, &q.y, &q.z, &q.w, 1};
    EXPECT_EQ(tool::shortest_arc({&a.x, &a.y, &a.z, 1}, {&b.x, &b.y, &b.z, 1}, v), status::ok);
    return q;
}

TEST(Ratio, TurnsTheVectorOfSlideOne) {
    const spinor2<double> s = tool::ratio<double>({1, 1}, {1, 0});
    EXPECT_EQ(s, (spinor2<double>{1, -1}));
    EXPECT_EQ(tool::apply<double>(s, {-1, 2}), (vec2<double>{-3, 1}));
}

TEST(Ratio, IsTheGeometricProductOfOneVectorAndTheInverseOfTheOther) {
    generator g(1);
    for (int i = 0; i < 1000; ++i) {
        const vec2<double> a{uniform(g, -1, 1), uniform(g, -1, 1)}, b{uniform(g, -1, 1), uniform(g, -1, 1)},
            c{uniform(g, -1, 1), uniform(g, -1, 1)};
        const double squared = a.x * a.x + a.y * a.y;
        const multivector m = product({0, b.x, b.y}, {0, a.x / squared, a.y / squared});
        const spinor2<double> s = tool::ratio(b, a);
        EXPECT_LE(distance(m, {s.scalar, 0, 0, s.e12}), 1e-15 * (1 + std::hypot(m[0], m[3])));
        const vec2<double> x = tool::apply(s, c);
        EXPECT_LE(distance(product(m, {0, c.x, c.y}), {0, x.x, x.y}), 1e-15 * (1 + std::hypot(m[0], m[3])));
    }
}

TEST(Ratio, TakesCToWhatIsToItAsBIsToA) {
    generator g(2);
    for (int i = 0; i < 1000; ++i) {
        const double stretch = uniform(g, 0.1, 3), f = uniform(g, -3.1, 3.1), at = uniform(g, -3.1, 3.1);
        const vec2<double> a{2 * std::cos(at), 2 * std::sin(at)},
            b{2 * stretch * std::cos(at + f), 2 * stretch * std::sin(at + f)};
        const spinor2<double> s = tool::ratio(b, a);
        EXPECT_NEAR(s.scalar, stretch * std::cos(f), 2e-15);
        EXPECT_NEAR(s.e12, -stretch * std::sin(f), 2e-15);
        const vec2<double> x = tool::apply<double>(s, {std::cos(5.0), std::sin(5.0)}), y = tool::apply(s, a);
        EXPECT_NEAR(y.x, b.x, 4e-15);
        EXPECT_NEAR(y.y, b.y, 4e-15);
        EXPECT_NEAR(x.x, stretch * std::cos(5 + f), 3e-15);
        EXPECT_NEAR(x.y, stretch * std::sin(5 + f), 3e-15);
    }
}

template <class T>
void ratio_accuracy() {
    using W = wide<T>;
    generator g(3);
    double worst_ratio = 0, worst_apply = 0;
    for (int i = 0; i < 200000; ++i) {
        const vec3<T> p = random_vector<T>(g, -40, 40), r = random_vector<T>(g, -40, 40);
        const vec2<T> a{p.x, p.y}, b{r.x, r.y};
        const W aa = W(a.x) * a.x + W(a.y) * a.y, bb = W(b.x) * b.x + W(b.y) * b.y;
        const spinor2<T> s = tool::ratio(b, a);
        const W scalar = (W(b.x) * a.x + W(b.y) * a.y) / aa, e12 = (W(b.x) * a.y - W(b.y) * a.x) / aa;
        const W off = root((s.scalar - scalar) * (s.scalar - scalar) + (s.e12 - e12) * (s.e12 - e12));
        worst_ratio = std::max(worst_ratio, units<T>(off / root(bb / aa)));

        const spinor2<T> by{p.x, p.z};
        const W ss = W(by.scalar) * by.scalar + W(by.e12) * by.e12;
        const vec2<T> x = tool::apply(by, b);
        const W ex = W(by.scalar) * b.x + W(by.e12) * b.y - x.x,
                ey = W(by.scalar) * b.y - W(by.e12) * b.x - x.y;
        worst_apply = std::max(worst_apply, units<T>(root(ex * ex + ey * ey) / root(ss * bb)));
    }
    EXPECT_LE(worst_ratio, 5);
    EXPECT_LE(worst_apply, 2.5);
}

TEST(Ratio, AndItsApplicationAreWithinTheStatedError) {
    ratio_accuracy<float>();
    ratio_accuracy<double>();
}

template <class T>
void ratio_corners() {
    using limits = std::numeric_limits<T>;
    const T inf = limits::infinity();
    EXPECT_EQ(tool::ratio<T>({3, 4}, {0, 0}), (spinor2<T>{1, 0}));
    EXPECT_EQ(tool::ratio<T>({0, 0}, {0, T(-0.0)}), (spinor2<T>{1, 0}));
    EXPECT_EQ(tool::ratio<T>({0, 0}, {3, 4}), (spinor2<T>{0, 0}));
    EXPECT_EQ(tool::ratio<T>({limits::max(), 0}, {0, limits::denorm_min()}).e12, inf);
    EXPECT_EQ(tool::ratio<T>({limits::denorm_min(), 0}, {0, limits::max()}), (spinor2<T>{0, 0}));
    EXPECT_EQ(tool::apply<T>({limits::max(), limits::max()}, {limits::max(), 0}), (vec2<T>{inf, -inf}));
    EXPECT_EQ(tool::apply<T>({limits::max(), 0}, {limits::denorm_min(), 0}),
              (vec2<T>{limits::max() * limits::denorm_min(), 0}));
    for (const vec3<T>& v : corner_vectors<T>()) {
        const vec2<T> a{v.x, v.y};
        EXPECT_EQ(tool::ratio(a, a), (spinor2<T>{1, 0})) << a.x << ' ' << a.y;
        for (const vec3<T>& w : corner_vectors<T>()) {
            const spinor2<T> s = tool::ratio<T>({w.x, w.y}, a);
            const vec2<T> x = tool::apply<T>({w.x, w.y}, a);
            ASSERT_TRUE(no_nan({s.scalar, s.e12, x.x, x.y})) << v.x << ' ' << v.y << ' ' << w.x << ' ' << w.y;
        }
    }
    for (T bad : bad_numbers<T>)
        for (const vec2<T>& a : {vec2<T>{bad, 1}, vec2<T>{0, bad}, vec2<T>{bad, bad}})
            for (const vec2<T>& b : {vec2<T>{0, 0}, vec2<T>{1, 2}}) {
                for (const spinor2<T>& s : {tool::ratio(a, b), tool::ratio(b, a)})
                    EXPECT_TRUE(all_nan({s.scalar, s.e12}));
                for (const vec2<T>& x : {tool::apply({a.x, a.y}, b), tool::apply({b.x, b.y}, a)})
                    EXPECT_TRUE(all_nan({x.x, x.y}));
            }
}

TEST(Ratio, IsDefinedAtZeroAndAtTheEndsOfTheRangeAndPassesNanOn) {
    ratio_corners<float>();
    ratio_corners<double>();
}

// Reflections

TEST(Reflect, IsTheSandwichOfSlideTwo) {
    generator g(4);
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> v = random_direction<double>(g), a = random_vector<double>(g, -3, 3);
        const double squared = dotted(a, a);
        const multivector inverse = vector_of({a.x / squared, a.y / squared, a.z / squared});
        const multivector m = product(product(vector_of({-a.x, -a.y, -a.z}), vector_of(v)), inverse);
        EXPECT_LE(distance(m, vector_of(tool::reflect(v, a))), 2e-15);
        EXPECT_LE(norm(difference(tool::reflect(tool::reflect(v, a), a), v)), 2e-15);
        const vec3<double> in_plane = crossed(v, a);
        EXPECT_LE(norm(difference(tool::reflect(in_plane, a), in_plane)), 2e-15 * norm(a));
        EXPECT_LE(norm(difference(tool::reflect(a, a), {-a.x, -a.y, -a.z})), 1e-15 * norm(a));
    }
}

template <class T>
void reflect_accuracy() {
    using W = wide<T>;
    generator g(5);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const vec3<T> a = random_vector<T>(g, -40, 40), v = companion(g, a, i);
        const vec3<W> n = widen<W>(a), u = widen<W>(v);
        const W twice = 2 * dotted(u, n) / dotted(n, n);
        const vec3<W> want{u.x - twice * n.x, u.y - twice * n.y, u.z - twice * n.z};
        worst = std::max(worst, units<T>(norm(difference(widen<W>(tool::reflect(v, a)), want)) / norm(u)));
    }
    EXPECT_LE(worst, 12);
}

TEST(Reflect, IsWithinTheStatedError) {
    reflect_accuracy<float>();
    reflect_accuracy<double>();
}

template <class T>
void reflect_corners() {
    using limits = std::numeric_limits<T>;
    const T most = limits::max(), least = limits::denorm_min();
    EXPECT_EQ(tool::reflect<T>({1, 2, 3}, {0, T(-0.0), 0}), (vec3<T>{1, 2, 3}));
    EXPECT_EQ(tool::reflect<T>({1, 2, 3}, {0, least, 0}), (vec3<T>{1, -2, 3}));
    EXPECT_EQ(tool::reflect<T>({1, 2, 3}, {0, 0, -most}), (vec3<T>{1, 2, -3}));
    EXPECT_EQ(tool::reflect<T>({least, most, 0}, {0, 0, 0}), (vec3<T>{least, most, 0}));
    EXPECT_EQ(tool::reflect<T>({least, most, 0}, {0, least, 0}), (vec3<T>{least, -most, 0}));
    EXPECT_EQ(tool::reflect<T>({least, 0, least}, {most, 0, 0}), (vec3<T>{-least, 0, least}));
    EXPECT_EQ(tool::reflect<T>({most, most, 0}, {1, 1, 0}), (vec3<T>{-most, -most, 0}));
    EXPECT_EQ(tool::reflect<T>({most, most, most}, {3, 1, 1}).x, -limits::infinity());
    for (const vec3<T>& v : corner_vectors<T>())
        for (const vec3<T>& a : corner_vectors<T>()) {
            const vec3<T> r = tool::reflect(v, a);
            ASSERT_TRUE(no_nan({r.x, r.y, r.z}));
        }
    for (const vec3<T>& v : {vec3<T>{0, 0, 0}, vec3<T>{1, 2, 3}})
        for (const vec3<T>& a : {vec3<T>{0, 0, 0}, vec3<T>{-1, 0, 2}}) {
            for (const vec3<T>& bad : bad_vectors(v)) {
                const vec3<T> r = tool::reflect(bad, a);
                EXPECT_TRUE(all_nan({r.x, r.y, r.z}));
            }
            for (const vec3<T>& bad : bad_vectors(a)) {
                const vec3<T> r = tool::reflect(v, bad);
                EXPECT_TRUE(all_nan({r.x, r.y, r.z}));
            }
        }
}

TEST(Reflect, IsDefinedForANormalOfZerosAndAtTheEndsOfTheRangeAndPassesNanOn) {
    reflect_corners<float>();
    reflect_corners<double>();
}

TEST(RotationFromReflections, IsOneReflectionAfterTheOther) {
    generator g(6);
    double nearest = 10;
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> a = random_vector<double>(g, -3, 3), b = random_vector<double>(g, -3, 3),
                           v = random_direction<double>(g);
        const multivector want = vector_of(tool::reflect(tool::reflect(v, a), b));
        EXPECT_LE(distance(sandwich(rotor_of(tool::rotation_from_reflections(a, b)), vector_of(v)), want),
                  5e-15);
        const double other_order =
            distance(sandwich(rotor_of(tool::rotation_from_reflections(b, a)), vector_of(v)), want);
        nearest = std::min(nearest, -other_order);
    }
    EXPECT_LE(nearest, -1.5);
}

TEST(RotationFromReflections, TurnsByTwiceTheAngleBetweenTheNormals) {
    generator g(7);
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> axis = random_direction<double>(g), v = random_direction<double>(g);
        const vec3<double> a = unit(crossed(axis, v));
        const double f = uniform(g, -pi, pi);
        const quat<double> q = tool::rotation_from_reflections(a, turned(a, axis, f));
        EXPECT_LE(norm(minus(q, about(axis, 2 * f))), 2e-15);
    }
}

template <class T>
void reflections_accuracy() {
    using W = wide<T>;
    generator g(8);
    double worst = 0, worst_root = 0;
    for (int i = 0; i < 200000; ++i) {
        const vec3<T> a = random_vector<T>(g, -40, 40), b = companion(g, a, i);
        const quat<T> q = tool::rotation_from_reflections(a, b);
        const quat<W> want = normalized(product_of(widen<W>(b), widen<W>(a)));
        worst = std::max(worst, units<T>(norm(minus(widen<W>(q), want))));
        // The root doubles its error near -1, where it is that of the axis.
        if (want.w > W(-0.5))
            worst_root =
                std::max(worst_root, units<T>(norm(minus(widen<W>(one_root(q)), widen<W>(one_arc(a, b))))));
    }
    EXPECT_LE(worst, 3.5);
    EXPECT_LE(worst_root, 6);
}

TEST(RotationFromReflections, IsWithinTheStatedErrorAndItsRootIsTheShortestArc) {
    reflections_accuracy<float>();
    reflections_accuracy<double>();
}

template <class T>
void reflections_corners() {
    const quat<T> one{0, 0, 0, 1}, minus_one{0, 0, 0, -1};
    generator g(9);
    for (int i = 0; i < 1000; ++i) {
        const vec3<T> a = random_vector<T>(g, -100, 100), opposite{-a.x, -a.y, -a.z};
        EXPECT_EQ(tool::rotation_from_reflections(a, a), one);
        EXPECT_EQ(tool::rotation_from_reflections(a, opposite), minus_one);
        EXPECT_EQ(tool::rotation_from_reflections(a, {0, 0, 0}), one);
        EXPECT_EQ(tool::rotation_from_reflections<T>({0, T(-0.0), 0}, a), one);
        EXPECT_EQ(one_arc<T>(a, {0, 0, 0}), one);
    }
    // The roots at opposite vectors: about x, and about an axis perpendicular to a.
    EXPECT_EQ(one_root(tool::rotation_from_reflections<T>({1, 0, 0}, {-1, 0, 0})), (quat<T>{1, 0, 0, 0}));
    EXPECT_EQ(one_arc<T>({1, 0, 0}, {-1, 0, 0}).x, 0);
    for (const vec3<T>& a : corner_vectors<T>())
        for (const vec3<T>& b : corner_vectors<T>()) {
            const quat<T> q = tool::rotation_from_reflections(a, b);
            ASSERT_LE(std::fabs(norm(widen<double>(q)) - 1), 3 * rounding_unit<T>);
        }
    for (const vec3<T>& a : {vec3<T>{0, 0, 0}, vec3<T>{1, 2, 3}})
        for (const vec3<T>& bad : bad_vectors<T>({0, 1, 0}))
            for (const quat<T>& q :
                 {tool::rotation_from_reflections(a, bad), tool::rotation_from_reflections(bad, a)})
                EXPECT_TRUE(all_nan({q.x, q.y, q.z, q.w}));
}

TEST(RotationFromReflections, IsDefinedForZerosAndOppositeVectorsAndPassesNanOn) {
    reflections_corners<float>();
    reflections_corners<double>();
}

}  // namespace
}  // namespace swivel::tests
