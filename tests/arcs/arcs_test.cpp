// shortest_arc and arc_with_twist: what they do to the vectors, and which of all such rotations they are.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class Arcs : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Arcs, testing::ValuesIn(usable_isas()), isa_name);

constexpr product both_products[] = {product::swing_twist, product::twist_swing};
constexpr std::size_t n = 60000;

using exact = long double;

quat<exact> turned(const quat<exact>& q, const vec3<exact>& v) {
    return times(times(q, {v.x, v.y, v.z, 0}), conjugate(q));
}

exact distance(const quat<exact>& a, const vec3<exact>& b) { return norm(minus(a, {b.x, b.y, b.z, 0})); }

// Pairs at any angle: a third evenly distributed, the others parallel or opposite up to any rest; a few
// exactly so. Of any length.
template <class T>
struct pairs {
    vec3_buffer<T> v{n, layout::soa}, w{n, layout::soa};
    scalar_buffer<T> radians{n, layout::soa};
    quat_buffer<T> q{n, layout::soa}, other{n, layout::soa};

    explicit pairs(std::uint64_t seed) {
        constexpr int any_exponent = sizeof(T) == 4 ? 120 : 1000, bits = sizeof(T) == 4 ? 28 : 58;
        generator g(seed);
        const auto below = [&](int limit) { return static_cast<int>(g() % static_cast<unsigned>(limit)); };
        for (std::size_t i = 0; i < n; ++i) {
            const vec3<T> a = random_direction<T>(g);
            vec3<T> b = random_direction<T>(g);
            if (i % 3 != 0) {
                const T side = i % 3 == 1 ? T(1) : T(-1);
                const T part = i % 31 == 0 ? T(0) : static_cast<T>(std::ldexp(1.0, -below(bits)));
                b = {side * a.x + part * b.x, side * a.y + part * b.y, side * a.z + part * b.z};
            }
            const T of_a =
                static_cast<T>(std::ldexp(uniform(g, 1, 2), below(2 * any_exponent) - any_exponent));
            const T of_b = i % 2 == 0 ? of_a : static_cast<T>(uniform(g, 0.5, 2));
            v.set(i, {a.x * of_a, a.y * of_a, a.z * of_a});
            w.set(i, {b.x * of_b, b.y * of_b, b.z * of_b});
            radians[i] = static_cast<T>(uniform(g, -12, 12));
        }
    }

    vec3<exact> from(std::size_t i) { return unit(widen<exact>(v.get(i))); }
    vec3<exact> to(std::size_t i) { return unit(widen<exact>(w.get(i))); }
};

template <class T>
struct errors {
    double turned = 0, norm = 0;

    void add(const quat<T>& q, const vec3<exact>& from, const vec3<exact>& to) {
        const quat<exact> r = widen<exact>(q);
        turned =
            std::max(turned, static_cast<double>(distance(tests::turned(r, from), to)) / rounding_unit<T>);
        norm = std::max(norm, static_cast<double>(magnitude(tests::norm(r) - 1)) / rounding_unit<T>);
    }
};

template <class T>
void arc_turns() {
    pairs<T> s(1);
    for (precision p : both_precisions) {
        ASSERT_EQ(shortest_arc(s.v.view(), s.w.view(), s.q.view(), {.accuracy = p}), status::ok);
        errors<T> worst;
        for (std::size_t i = 0; i < n; ++i) {
            worst.add(s.q.get(i), s.from(i), s.to(i));
            ASSERT_FALSE(std::signbit(s.q.get(i).w)) << i;
        }
        EXPECT_LE(worst.turned, p == precision::fast ? 11 : 7);
        EXPECT_LE(worst.norm, p == precision::fast ? 4 : 3);
    }
}

TEST_P(Arcs, ShortestArcTurnsTheVectorAtEveryAngle) {
    arc_turns<float>();
    arc_turns<double>();
}

// Not just any rotation that does it: up to the noise of the vectors over |n(v) + n(w)|, half the cosine.
template <class T>
void arc_is_shortest() {
    pairs<T> s(2);
    for (precision p : both_precisions) {
        ASSERT_EQ(shortest_arc(s.v.view(), s.w.view(), s.q.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const vec3<exact> a = s.from(i), b = s.to(i);
            const vec3<exact> sum{a.x + b.x, a.y + b.y, a.z + b.z};
            const exact length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
            if (length == 0) continue;
            const vec3<exact> h = unit(sum);
            const quat<exact> want{a.y * h.z - a.z * h.y, a.z * h.x - a.x * h.z, a.x * h.y - a.y * h.x,
                                   a.x * h.x + a.y * h.y + a.z * h.z};
            const double error =
                static_cast<double>(norm(minus(widen<exact>(s.q.get(i)), want)) * length / 2);
            ASSERT_LE(error, (p == precision::fast ? 5 : 4) * rounding_unit<T>) << i;
        }
    }
}

TEST_P(Arcs, ShortestArcHasNoTwist) {
    arc_is_shortest<float>();
    arc_is_shortest<double>();
}

template <class T>
void corners() {
    using limits = std::numeric_limits<T>;
    const T tiny = limits::denorm_min(), huge = limits::max();
    const vec3<T> vectors[] = {{1, 0, 0},
                               {0, 1, 0},
                               {0, 0, 1},
                               {-1, 0, 0},
                               {0, -1, 0},
                               {0, 0, -1},
                               {1, 2, 2},
                               {-1, -2, -2},
                               {tiny, 0, 0},
                               {0, 0, -tiny},
                               {huge, huge, huge},
                               {-huge, -huge, -huge},
                               {T(-0.0), 1, T(-0.0)},
                               {tiny, -tiny, 0},
                               {1, tiny, 0},
                               {-1, 0, tiny}};
    constexpr std::size_t count = std::size(vectors);
    vec3_buffer<T> v(count * count, layout::soa), w(count * count, layout::soa);
    quat_buffer<T> q(count * count, layout::soa), by_reference(count * count, layout::soa);
    for (std::size_t i = 0; i < count * count; ++i) {
        v.set(i, vectors[i / count]);
        w.set(i, vectors[i % count]);
    }
    ASSERT_EQ(reference::shortest_arc(v.view(), w.view(), by_reference.view()), status::ok);
    for (precision p : both_precisions) {
        ASSERT_EQ(shortest_arc(v.view(), w.view(), q.view(), {.accuracy = p}), status::ok);
        errors<T> worst;
        for (std::size_t i = 0; i < count * count; ++i) {
            worst.add(q.get(i), unit(widen<exact>(v.get(i))), unit(widen<exact>(w.get(i))));
            EXPECT_GE(q.get(i).w, 0) << i;
            if (p == precision::fast) continue;
            EXPECT_EQ(q.get(i), by_reference.get(i)) << i;
            if (i / count == i % count) {
                EXPECT_EQ(q.get(i), (quat<T>{0, 0, 0, 1})) << i;
            }
        }
        EXPECT_LE(worst.turned, p == precision::fast ? 11 : 7);
        EXPECT_LE(worst.norm, p == precision::fast ? 4 : 3);
    }
}

TEST_P(Arcs, CoordinateAxesOppositesAndExtremeLengthsAreTurnedRight) {
    corners<float>();
    corners<double>();
}

template <class T>
void zero_vector() {
    vec3_buffer<T> v(3, layout::soa), w(3, layout::soa);
    quat_buffer<T> q(3, layout::soa);
    const vec3<T> none{0, T(-0.0), 0}, some{1, 2, 3};
    v.set(0, none), w.set(0, some);
    v.set(1, some), w.set(1, none);
    v.set(2, none), w.set(2, none);
    const options o{.accuracy = precision::reproducible};
    ASSERT_EQ(shortest_arc(v.view(), w.view(), q.view(), o), status::ok);
    const quat<T> one{0, 0, 0, 1};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(q.get(i), one) << i;
    for (product order : both_products) {
        ASSERT_EQ(
            arc_with_twist(v.view(), w.view(), T(1), q.view(), {.order = order, .accuracy = o.accuracy}),
            status::ok);
        // Only what has an axis is twisted.
        const bool first = order == product::swing_twist;
        EXPECT_EQ(q.get(first ? 0 : 1), one);
        EXPECT_NEAR(q.get(first ? 1 : 0).w, std::cos(0.5), 4 * rounding_unit<T>);
        EXPECT_EQ(q.get(2), one);
    }
}

TEST_P(Arcs, ZeroVectorGivesTheIdentity) {
    zero_vector<float>();
    zero_vector<double>();
}

template <class T>
void twisted_arc_turns() {
    pairs<T> s(3);
    for (precision p : both_precisions)
        for (product order : both_products) {
            const options o{.order = order, .accuracy = p};
            ASSERT_EQ(arc_with_twist(s.v.view(), s.w.view(), s.radians.view(), s.q.view(), o), status::ok);
            errors<T> worst;
            for (std::size_t i = 0; i < n; ++i) worst.add(s.q.get(i), s.from(i), s.to(i));
            EXPECT_LE(worst.turned, p == precision::fast ? 12 : 9);
            EXPECT_LE(worst.norm, p == precision::fast ? 4.5 : 3);
        }
}

TEST_P(Arcs, ArcWithTwistTurnsTheVectorAtEveryAngle) {
    twisted_arc_turns<float>();
    twisted_arc_turns<double>();
}

template <class T>
void both_orders_agree() {
    pairs<T> s(4);
    for (precision p : both_precisions) {
        ASSERT_EQ(arc_with_twist(s.v.view(), s.w.view(), s.radians.view(), s.q.view(),
                                 {.order = product::swing_twist, .accuracy = p}),
                  status::ok);
        ASSERT_EQ(arc_with_twist(s.v.view(), s.w.view(), s.radians.view(), s.other.view(),
                                 {.order = product::twist_swing, .accuracy = p}),
                  status::ok);
        for (std::size_t i = 0; i < n; ++i)
            ASSERT_LE(
                static_cast<double>(norm(minus(widen<exact>(s.q.get(i)), widen<exact>(s.other.get(i))))),
                12 * rounding_unit<T>)
                << i;
    }
}

TEST_P(Arcs, BothOrdersAreTheSameRotation) {
    both_orders_agree<float>();
    both_orders_agree<double>();
}

template <class T>
void decomposition_gives_back() {
    pairs<T> s(5);
    scalar_buffer<T> twist(n, layout::soa);
    quat_buffer<T> arc(n, layout::soa), swing_part(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i)
        s.radians[i] = static_cast<T>(std::remainder(s.radians[i], 4 * 3.14159265358));
    for (precision p : both_precisions) {
        const options o{.accuracy = p};
        ASSERT_EQ(arc_with_twist(s.v.view(), s.w.view(), s.radians.view(), s.q.view(), o), status::ok);
        ASSERT_EQ(twist_angle(s.q.view(), s.v.view(), twist.view(), o), status::ok);
        ASSERT_EQ(shortest_arc(s.v.view(), s.w.view(), arc.view(), o), status::ok);
        ASSERT_EQ(swing(s.q.view(), s.v.view(), swing_part.view(), o), status::ok);
        std::size_t checked = 0;
        for (std::size_t i = 0; i < n; ++i) {
            // Half the swing's cosine: the conditioning of both.
            const vec3<exact> a = s.from(i), b = s.to(i);
            const exact closeness = std::sqrt((1 + a.x * b.x + a.y * b.y + a.z * b.z) / 2);
            if (!(closeness > 0.01L)) continue;
            ++checked;
            const double tolerance = 40 * rounding_unit<T> / static_cast<double>(closeness);
            // At a full turn either sign of it is right.
            const double off =
                std::remainder(static_cast<double>(twist[i]) - static_cast<double>(s.radians[i]),
                               4 * 3.14159265358979323846);
            ASSERT_LE(std::fabs(off), tolerance) << i;
            ASSERT_LE(
                static_cast<double>(norm(minus(widen<exact>(arc.get(i)), widen<exact>(swing_part.get(i))))),
                tolerance)
                << i;
        }
        EXPECT_GT(checked, n / 2);
    }
}

TEST_P(Arcs, DecompositionGivesBackArcAndTwistAngle) {
    decomposition_gives_back<float>();
    decomposition_gives_back<double>();
}

// About the vector itself, right-handed.
TEST_P(Arcs, TwistIsRightHandedByTheAngle) {
    vec3_buffer<double> z(1, layout::soa);
    z.set(0, {0, 0, 2});
    quat_buffer<double> q(1, layout::soa);
    for (product order : both_products) {
        ASSERT_EQ(arc_with_twist(z.view(), z.view(), 1.0, q.view(), {.order = order}), status::ok);
        EXPECT_NEAR(q.get(0).z, std::sin(0.5), 1e-15);
        EXPECT_NEAR(q.get(0).w, std::cos(0.5), 1e-15);
        // A larger angle than can be reduced counts as 0.
        ASSERT_EQ(arc_with_twist(z.view(), z.view(), 1e300, q.view(), {.order = order}), status::ok);
        EXPECT_NEAR(q.get(0).w, 1, 1e-15);
    }
}

// Short of all bits but one or two, and nearly opposite: the axis is what is small in the other vector.
template <class T>
void subnormal_vectors() {
    constexpr T least = std::numeric_limits<T>::denorm_min();
    vec3_buffer<T> v(1, layout::soa), w(1, layout::soa);
    quat_buffer<T> q(1, layout::soa);
    for (const T length : {least, 6 * least, 714 * least, std::numeric_limits<T>::min() / 2})
        for (int digits = 0; digits < (sizeof(T) == 4 ? 140 : 1060); ++digits) {
            v.set(0, {length, 0, 0});
            w.set(0, {-1, std::ldexp(T(1), -digits), std::ldexp(T(-3), -digits)});
            for (const precision p : both_precisions) {
                ASSERT_EQ(shortest_arc(v.view(), w.view(), q.view(), {.accuracy = p}), status::ok);
                errors<T> e;
                e.add(q.get(0), unit(widen<exact>(v.get(0))), unit(widen<exact>(w.get(0))));
                ASSERT_LE(e.turned, p == precision::fast ? 11 : 7) << length << ' ' << digits;
                ASSERT_LE(e.norm, p == precision::fast ? 4 : 3) << length << ' ' << digits;
            }
        }
}

TEST_P(Arcs, SubnormalVectorsTurnLikeAnyOthers) {
    subnormal_vectors<float>();
    subnormal_vectors<double>();
}

}  // namespace
}  // namespace swivel::tests
