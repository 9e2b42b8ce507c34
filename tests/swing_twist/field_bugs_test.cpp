// Bugs that well-known implementations of swing and twist have, and that this one must not have: each test is
// the input at which one of them goes wrong.

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class FieldBugs : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, FieldBugs, testing::ValuesIn(usable_isas()), isa_name);

constexpr axis all_axes[] = {axis::x, axis::y, axis::z};

struct both {
    quat<float> swing, twist;
};

both factors_of(const quat<float>& in, const twist_axis<float>& a, options o = {}) {
    quat_buffer<float> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
    q.set(0, in);
    EXPECT_EQ(decompose(q.view(), a, s.view(), t.view(), o), status::ok);
    return {s.get(0), t.get(0)};
}

float twist_degrees(const quat<float>& in, axis a, options o = {}) {
    quat_buffer<float> q(1, layout::soa);
    scalar_buffer<float> r(1, layout::soa);
    q.set(0, in);
    EXPECT_EQ(twist_angle(q.view(), a, r.view(), o), status::ok);
    return r[0] * 57.29577951f;
}

TEST_P(FieldBugs, IdentityIsNotAHalfTurnTwist) {
    for (axis a : all_axes) {
        const both f = factors_of({0, 0, 0, 1}, a);
        EXPECT_NEAR(f.twist.w, 1, 1e-6);
        EXPECT_NEAR(f.swing.w, 1, 1e-6);
    }
}

TEST_P(FieldBugs, PoleIsNotNanNorZero) {
    for (axis a : all_axes) {
        float v[3] = {0, 0, 0};
        v[(static_cast<int>(a) + 1) % 3] = 1;
        const both f = factors_of({v[0], v[1], v[2], 0}, a);
        EXPECT_NEAR(norm(widen<double>(f.twist)), 1, 1e-6);
        EXPECT_NEAR(norm(widen<double>(f.swing)), 1, 1e-6);
    }
}

TEST_P(FieldBugs, NanEndsNoLoopAndIsNotSwallowed) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (axis a : all_axes)
        for (int c = 0; c < 4; ++c) {
            float v[4] = {0.5f, 0.5f, 0.5f, 0.5f};
            v[c] = nan;
            const both f = factors_of({v[0], v[1], v[2], v[3]}, a);
            EXPECT_TRUE(std::isnan(f.twist.w)) << c;
            EXPECT_TRUE(std::isnan(f.swing.w)) << c;
        }
}

TEST_P(FieldBugs, TinyComponentsGiveAUnitTwist) {
    for (float tiny : {1e-10f, 1e-19f, 1e-20f, 1e-22f, 1e-30f, 1e-38f, 1e-45f})
        for (axis a : all_axes)
            for (float sign : {1.0f, -1.0f}) {
                float v[3] = {0.6f, 0.6f, 0.6f};
                v[static_cast<int>(a)] = sign * tiny;
                const both f = factors_of({v[0], v[1], v[2], tiny}, a);
                EXPECT_NEAR(norm(widen<double>(f.twist)), 1, 1e-6) << tiny;
            }
}

TEST_P(FieldBugs, NoSignJumpWhereAComponentPassesZero) {
    const both a = factors_of({1e-6f, 0.1f, 0.1f, 0.99f}, axis::x),
               b = factors_of({-1e-6f, 0.1f, 0.1f, 0.99f}, axis::x);
    EXPECT_NEAR(a.twist.w, b.twist.w, 1e-6);
    EXPECT_NEAR(a.twist.x, b.twist.x, 1e-5);
    EXPECT_NEAR(norm(minus(widen<double>(a.swing), widen<double>(b.swing))), 0, 1e-5);
}

TEST_P(FieldBugs, SmallTwistIsNotLostInAnAcos) {
    EXPECT_NEAR(twist_degrees({0, 0, 1e-4f, 1}, axis::z), 2e-4 * 57.29577951, 1e-8);
}

TEST_P(FieldBugs, NegativeZeroIsNot360Degrees) {
    EXPECT_EQ(twist_degrees({0, 0, -0.0f, 1}, axis::z), 0);
    EXPECT_EQ(twist_degrees({-0.0f, -0.0f, -0.0f, -1}, axis::z, {.positive_twist = true}), 0);
    EXPECT_EQ(twist_degrees({0.6f, 0.8f, -0.0f, -0.0f}, axis::z, {.positive_twist = true}), 0);
}

// Swing and twist of one element agree on whether it is at the pole.
TEST_P(FieldBugs, OneThresholdServesSwingAndTwist) {
    for (int e = 1; e < 60; ++e) {
        const float r = std::ldexp(1.0f, -e);
        const quat<float> q{0.6f, 0.8f, r, -r};
        const both f = factors_of(q, axis::z);
        quat_buffer<float> in(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
        in.set(0, q);
        ASSERT_EQ(swing(in.view(), axis::z, s.view()), status::ok);
        ASSERT_EQ(twist(in.view(), axis::z, t.view()), status::ok);
        EXPECT_EQ(s.get(0), f.swing);
        EXPECT_EQ(t.get(0), f.twist);
        const quat<double> back = times(widen<double>(f.swing), widen<double>(f.twist));
        EXPECT_LE(norm(minus(back, widen<double>(q))), 10 * 0x1p-24) << e;
    }
}

TEST_P(FieldBugs, HalfWeightTwistDoesNotShrinkWithSwingNorPop) {
    for (int degrees = 0; degrees < 175; degrees += 5) {
        const float half = static_cast<float>(degrees) * 0.00872664626f, k = 0.70710678f;
        // 90 degrees of twist about z, then a swing about x.
        const quat<float> q{std::sin(half) * k, -std::sin(half) * k, std::cos(half) * k, std::cos(half) * k};
        const float half_weight = twist_degrees(q, axis::z) / 2;
        EXPECT_NEAR(half_weight, 45, 1e-3) << degrees;
    }
}

TEST_P(FieldBugs, ProductOfTheFactorsIsTheInputInTheOrderAskedFor) {
    generator g(1);
    for (int i = 0; i < 200; ++i) {
        const quat<float> q = random_rotation<float>(g);
        const both st = factors_of(q, axis::y), ts = factors_of(q, axis::y, {.order = product::twist_swing});
        EXPECT_LE(norm(minus(times(widen<double>(st.swing), widen<double>(st.twist)), widen<double>(q))),
                  6e-7);
        EXPECT_LE(norm(minus(times(widen<double>(ts.twist), widen<double>(ts.swing)), widen<double>(q))),
                  6e-7);
    }
}

// An axis along no coordinate axis still gives a swing without any part along it.
TEST_P(FieldBugs, SwingIsPerpendicularToAnObliqueAxis) {
    generator g(2);
    const vec3<float> a{1, 0.2f, -0.7f};
    const vec3<double> axis = unit(widen<double>(a));
    for (int i = 0; i < 200; ++i) {
        const both f = factors_of(random_rotation<float>(g), a);
        EXPECT_LE(std::fabs(along(axis, widen<double>(f.swing))), 4 * 0x1p-24);
    }
}

}  // namespace
}  // namespace swivel::tests
