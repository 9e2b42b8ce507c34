#include "swivel/sterp.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support/buffers.hpp"
#include "support/interpolation.hpp"
#include "support/usable_isas.hpp"
#include "support/vectors.hpp"

namespace swivel::tests {
namespace {

class Sterp : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Sterp, testing::ValuesIn(usable_isas()), isa_name);

// S^s T^t a by powers of the factors of b a*; the axis in the world, at a. closeness is the distance from the
// pole.
exact_quat exact_sterp(const exact_quat& a, exact_quat b, const exact_vec3& axis, long double s,
                       long double t, const options& o, long double& closeness) {
    exact_quat d = times(b, conjugate(a));
    if ((d.w < 0) != o.long_way) d = sum(-1, d, 0, d);
    const exact_factors<long double> f = factor(d, axis, product::swing_twist);
    // Near a full twist it is the sign of a small number that says which way round.
    const long double sine = along(axis, f.twist);
    closeness = o.long_way && f.twist.w < 0 ? std::min(f.closeness, std::fabs(sine)) : f.closeness;
    if (o.motion == flavour::slerp) {
        // The twist by its own angle, which may be past 180 degrees.
        const long double half = std::atan2(sine, f.twist.w);
        const exact_quat twist{std::sin(t * half) * axis.x, std::sin(t * half) * axis.y,
                               std::sin(t * half) * axis.z, std::cos(t * half)};
        return times(times(power(f.swing, s), twist), a);
    }
    const exact_quat one{0, 0, 0, 1};
    return times(times(exact_nlerp(one, f.swing, s), exact_nlerp(one, f.twist, t)), a);
}

template <class T>
struct errors {
    double distance = 0, norm = 0;
};

// Where the errors count: the distance divided by 1 + 1/closeness, as the header states them.
template <class T>
errors<T> measure(options o, bool own_axis) {
    constexpr std::size_t n = 20011;
    generator g(77);
    quat_buffer<T> a(n, layout::soa), b(n, layout::soa), out(n, layout::soa);
    scalar_buffer<T> s(n, layout::soa), t(n, layout::soa);
    vec3_buffer<T> axes(n, layout::soa);
    const vec3<T> for_all{T(0.36), T(-0.48), T(0.8)};
    for (std::size_t i = 0; i < n; ++i) {
        a.set(i, random_rotation<T>(g));
        b.set(i, i % 2 == 0 ? random_rotation<T>(g)
                            : neighbour(g, a.get(i), std::ldexp(1.0, -static_cast<int>(i % 40))));
        s[i] = static_cast<T>(uniform(g, -0.25, 1.25));
        t[i] = static_cast<T>(uniform(g, -0.25, 1.25));
        axes.set(i, random_direction<T>(g));
    }
    const twist_axis<T> axis = own_axis ? twist_axis<T>(axes.view()) : twist_axis<T>(for_all);
    EXPECT_EQ(sterp(a.view(), b.view(), axis, s.view(), t.view(), out.view(), o), status::ok);
    errors<T> worst;
    for (std::size_t i = 0; i < n; ++i) {
        const auto from = unit_of(a.get(i)), to = unit_of(b.get(i));
        exact_vec3 l = unit(widen<long double>(own_axis ? axes.get(i) : for_all));
        if (o.axis_frame == frame::body) l = rotated(from, l);
        // The way is chosen by a sign that rounding may turn.
        if (std::fabs(tests::dot(from, to)) < 0.001L) continue;
        long double closeness = 1;
        const exact_quat want = exact_sterp(from, to, l, s[i], t[i], o, closeness);
        if (closeness < 0.001L) continue;
        const auto got = widen<long double>(out.get(i));
        worst.distance =
            std::max(worst.distance, double(norm(minus(got, want)) / (2 + 1 / closeness)) / rounding_unit<T>);
        worst.norm = std::max(worst.norm, double(std::fabs(norm(got) - 1)) / rounding_unit<T>);
    }
    return worst;
}

template <class T>
void expect_within(precision p, double distance, double norm) {
    for (const bool long_way : {false, true})
        for (const frame in : {frame::world, frame::body})
            for (const flavour motion : {flavour::slerp, flavour::nlerp})
                for (const bool own_axis : {false, true}) {
                    if (motion == flavour::nlerp && long_way) continue;
                    const options o{.accuracy = p, .long_way = long_way, .axis_frame = in, .motion = motion};
                    const errors<T> worst = measure<T>(o, own_axis);
                    const std::string what =
                        std::string(long_way ? "long" : "short") + (in == frame::body ? " body" : "") +
                        (motion == flavour::nlerp ? " nlerp" : "") + (own_axis ? " own axis" : "");
                    EXPECT_LE(worst.distance, long_way ? 1.5 * distance : distance) << what;
                    EXPECT_LE(worst.norm, norm) << what;
                }
}

TEST_P(Sterp, IsWithinItsBoundsOfTheFormulaReproducible) {
    expect_within<float>(precision::reproducible, 2, 2.8);
    expect_within<double>(precision::reproducible, 2, 2.8);
}
TEST_P(Sterp, IsWithinItsBoundsOfTheFormulaFast) {
    expect_within<float>(precision::fast, 2.4, 4);
    expect_within<double>(precision::fast, 2.4, 4);
}

template <class T>
quat<T> one(const quat<T>& a, const quat<T>& b, const twist_axis<T>& axis, T s, T t, const options& o) {
    quat_buffer<T> from(1, layout::soa), to(1, layout::soa), out(1, layout::soa);
    from.set(0, a);
    to.set(0, b);
    EXPECT_EQ(sterp(from.view(), to.view(), axis, s, t, out.view(), o), status::ok);
    return out.get(0);
}

template <class T>
void ends_are_exact() {
    generator g(5);
    std::vector<quat<T>> rotations = corner_rotations<T>();
    for (int i = 0; i < 100; ++i) rotations.push_back(random_rotation<T>(g));
    const auto bits = [](const quat<T>& q) {
        return std::array{std::bit_cast<bits_of<T>>(q.x), std::bit_cast<bits_of<T>>(q.y),
                          std::bit_cast<bits_of<T>>(q.z), std::bit_cast<bits_of<T>>(q.w)};
    };
    for (const frame in : {frame::world, frame::body})
        for (const flavour motion : {flavour::slerp, flavour::nlerp})
            for (const quat<T>& a : rotations) {
                const quat<T>& b = rotations[g() % rotations.size()];
                const options o{.accuracy = precision::reproducible, .axis_frame = in, .motion = motion};
                ASSERT_EQ(bits(one<T>(a, b, axis::y, T(0), T(0), o)), bits(a));
                const auto end = bits(one<T>(a, b, axis::y, T(1), T(1), o));
                ASSERT_TRUE(end == bits(b) || end == bits(quat<T>{-b.x, -b.y, -b.z, -b.w}));
            }
}

TEST_P(Sterp, EndsHaveTheBitsOfTheInputInReproducible) {
    ends_are_exact<float>();
    ends_are_exact<double>();
}

// The tip of the axis on its way from a to b: on the great circle, in equal steps. That of slerp is neither.
TEST_P(Sterp, TheTipFollowsTheGreatCircleAtConstantSpeed) {
    generator g(13);
    double largest_of_slerp = 0;
    for (int round = 0; round < 200; ++round) {
        const quat<double> a = random_rotation<double>(g), b = random_rotation<double>(g);
        const vec3<double> body = random_direction<double>(g);
        const exact_vec3 l = unit(widen<long double>(body));
        const exact_vec3 start = rotated(unit_of(a), l), end = rotated(unit_of(b), l);
        const exact_vec3 normal = unit(crossed(start, end));
        const long double whole = std::atan2(norm(crossed(start, end)), dotted(start, end));
        if (whole < 0.1L || whole > 3.0L) continue;
        for (const double t : {0.125, 0.25, 0.5, 0.75, 0.9}) {
            const quat<double> q = one<double>(a, b, body, t, t, {.axis_frame = frame::body});
            const exact_vec3 tip = rotated(unit_of(q), l);
            EXPECT_NEAR(double(dotted(tip, normal)), 0, 1e-14);
            EXPECT_NEAR(double(std::acos(dotted(tip, start)) / whole), t, 1e-13);
            const exact_vec3 other =
                rotated(exact_slerp(unit_of(a), on_the_way(unit_of(a), unit_of(b), false), t), l);
            largest_of_slerp = std::max(largest_of_slerp, double(std::fabs(dotted(other, normal))));
        }
    }
    EXPECT_GT(largest_of_slerp, 0.3) << "slerp is expected to leave the circle, or this test cannot fail";
}

// The post prints T^t S^t, and its correction T^t S^t a; with S from S T neither ends at b, and S^t T^t lacks
// a.
TEST_P(Sterp, IsTheOneCompositionThatEndsAtB) {
    generator g(14);
    const quat<double> a = random_rotation<double>(g), b = random_rotation<double>(g);
    const exact_vec3 z{0, 0, 1};
    const exact_quat from = unit_of(a), to = on_the_way(from, unit_of(b), false);
    const exact_factors<long double> f = factor(times(to, conjugate(from)), z, product::swing_twist);
    const quat<double> q = one<double>(a, b, axis::z, std::nextafter(1.0, 0.0), 1.0, {});
    const auto distance = [&](const exact_quat& r) { return double(norm(minus(r, to))); };
    EXPECT_LT(distance(widen<long double>(q)), 1e-14);
    EXPECT_LT(distance(times(times(f.swing, f.twist), from)), 1e-14);
    EXPECT_GT(distance(times(f.twist, f.swing)), 0.1);
    EXPECT_GT(distance(times(times(f.twist, f.swing), from)), 0.1);
    EXPECT_GT(distance(times(f.swing, f.twist)), 0.1);
}

TEST_P(Sterp, SwingAloneLeavesTheTwistAndTwistAloneTheAxis) {
    generator g(15);
    for (int round = 0; round < 100; ++round) {
        const quat<double> a = random_rotation<double>(g), b = random_rotation<double>(g);
        const vec3<double> body{0.6, 0, 0.8};
        const exact_vec3 l{0.6L, 0, 0.8L};
        const options o{.axis_frame = frame::body};
        const exact_vec3 start = rotated(unit_of(a), unit(l)), end = rotated(unit_of(b), unit(l));
        const exact_vec3 twisted = rotated(unit_of(one<double>(a, b, body, 0, 1, o)), unit(l));
        const exact_vec3 swung = rotated(unit_of(one<double>(a, b, body, 1, 0, o)), unit(l));
        EXPECT_NEAR(double(dotted(twisted, start)), 1, 1e-14);
        EXPECT_NEAR(double(dotted(swung, end)), 1, 1e-14);
    }
}

TEST_P(Sterp, IsTheSameInTheWorldAndInTheBody) {
    generator g(16);
    for (int round = 0; round < 100; ++round) {
        const quat<double> a = random_rotation<double>(g), b = random_rotation<double>(g);
        const vec3<double> body = random_direction<double>(g);
        const exact_vec3 world = rotated(unit_of(a), widen<long double>(body));
        const quat<double> q = one<double>(a, b, body, 0.3, 0.6, {.axis_frame = frame::body});
        const vec3<double> in_world{double(world.x), double(world.y), double(world.z)};
        const quat<double> r = one<double>(a, b, in_world, 0.3, 0.6, {});
        if (std::fabs(tests::dot(unit_of(a), unit_of(b))) < 1e-3L) continue;
        EXPECT_NEAR(double(norm(minus(unit_of(q), unit_of(r)))), 0, 1e-13);
    }
}

// A quarter of a turn about the axis, and on the long way three quarters the other way round.
TEST_P(Sterp, TheLongWayTwistsTheOtherWayRoundAndSwingsAlike) {
    const double h = std::sqrt(0.5);
    const quat<double> a{0, 0, 0, 1}, b{0, 0, h, h};
    const quat<double> half = one<double>(a, b, axis::z, 0.5, 0.5, {.long_way = true});
    EXPECT_NEAR(half.z, -std::sin(0.75 * 1.5707963267948966), 1e-15);
    EXPECT_NEAR(half.w, std::cos(0.75 * 1.5707963267948966), 1e-15);
    const quat<double> swing{h, 0, 0, h};
    const quat<double> s = one<double>(a, swing, axis::z, 1, 0, {}),
                       l = one<double>(a, swing, axis::z, 1, 0, {.long_way = true});
    EXPECT_NEAR(s.x, l.x, 1e-15);
    EXPECT_NEAR(s.w, l.w, 1e-15);
}

// At the pole all of the turn is swing; b is reached there too.
TEST_P(Sterp, AtThePoleAllIsSwing) {
    for (const precision p : both_precisions) {
        const quat<float> a{0, 0, 0, 1}, b{0.6F, 0.8F, 0, 0};
        const quat<float> half = one<float>(a, b, axis::z, 0.5F, 0.5F, {.accuracy = p});
        EXPECT_NEAR(half.x, 0.6F * std::sqrt(0.5F), 2e-7F);
        EXPECT_NEAR(half.y, 0.8F * std::sqrt(0.5F), 2e-7F);
        EXPECT_NEAR(half.z, 0, 1e-7F);
        EXPECT_NEAR(half.w, std::sqrt(0.5F), 2e-7F);
    }
}

TEST_P(Sterp, RefusesWhatDecomposeRefuses) {
    quat_buffer<float> a(3, layout::soa), b(3, layout::soa), out(3, layout::soa);
    EXPECT_EQ(sterp(a.view(), b.view(), vec3<float>{0, 0, 0}, 0.5F, out.view()), status::bad_argument);
    EXPECT_EQ(sterp(a.view(), b.view(), static_cast<axis>(7), 0.5F, out.view()), status::bad_argument);
    EXPECT_EQ(sterp(a.view(), b.view(), axis::x, 0.5F, out.view(), {.motion = static_cast<flavour>(9)}),
              status::bad_argument);
    EXPECT_EQ(sterp(a.view(), b.view(), axis::x, 0.5F, out.view(), {.pole_threshold = 2}),
              status::bad_argument);
    for (float v : out.memory()) EXPECT_EQ(v, untouched<float>);
}

}  // namespace
}  // namespace swivel::tests
