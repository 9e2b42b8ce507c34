#include "swivel/twist_angle.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class TwistAngle : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, TwistAngle, testing::ValuesIn(usable_isas()), isa_name);

constexpr double pi = std::numbers::pi;

template <class T>
T angle_of(const quat<T>& in, const twist_axis<T>& a, options o = {}) {
    quat_buffer<T> q(1, layout::soa);
    scalar_buffer<T> out(1, layout::soa);
    q.set(0, in);
    EXPECT_EQ(twist_angle(q.view(), a, out.view(), o), status::ok);
    return out[0];
}

// Over the whole range and down to the smallest angles, relative to the angle.
template <class T>
void whole_range() {
    constexpr std::size_t n = 60007;
    generator g(1);
    quat_buffer<T> q(n, layout::soa);
    scalar_buffer<T> out(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        double half = uniform(g, -pi, pi);
        if (i % 3 == 1) half = std::ldexp(half, -static_cast<int>(i % 60));
        if (i % 3 == 2) half = (half < 0 ? -pi : pi) + std::ldexp(half, -static_cast<int>(2 + i % 20));
        if (half > pi) half = 2 * pi - half;
        if (half < -pi) half = -2 * pi - half;
        q.set(i, rounded<T>(0, 0, std::sin(half), std::cos(half)));
    }
    for (precision p : both_precisions) {
        ASSERT_EQ(twist_angle(q.view(), axis::z, out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const quat<T> v = q.get(i);
            const long double want =
                2 * std::atan2(static_cast<long double>(v.z), static_cast<long double>(v.w));
            const double bound = (p == precision::reproducible ? 5 : 8) * rounding_unit<T>;
            ASSERT_LE(double(std::fabs(static_cast<long double>(out[i]) - want)),
                      bound * double(std::fabs(want)))
                << v.z << ' ' << v.w;
        }
    }
}

TEST_P(TwistAngle, IsAccurateOverTheWholeRange) {
    whole_range<float>();
    whole_range<double>();
}

TEST_P(TwistAngle, SmallAnglesAreNotLost) {
    for (float angle : {5e-4f, 1e-5f, 1e-20f, 1e-37f}) {
        const float half = angle / 2;
        EXPECT_NEAR(angle_of<float>({half, 0, 0, 1}, axis::x) / angle, 1, 1e-6);
        EXPECT_NEAR(angle_of<float>({-half, 0, 0, 1}, axis::x) / -angle, 1, 1e-6);
    }
}

template <class T>
void bounds_and_zeros() {
    const T two_pi = static_cast<T>(2 * pi), minus = T(-0.0);
    for (precision p : both_precisions) {
        const options o{.accuracy = p}, positive{.accuracy = p, .positive_twist = true};
        for (T x : {T(0), minus})
            for (T z : {T(0), minus}) {
                EXPECT_EQ(angle_of<T>({x, 0, z, 1}, axis::z, o), 0);
                EXPECT_EQ(angle_of<T>({x, 0, z, 1}, axis::z, positive), 0);
                EXPECT_EQ(angle_of<T>({x, 0, z, -1}, axis::z, o), two_pi);
                EXPECT_EQ(angle_of<T>({x, 0, z, -1}, axis::z, positive), 0);
                EXPECT_EQ(angle_of<T>({1, x, z, 0}, axis::z, o), 0) << "pole";
                EXPECT_EQ(angle_of<T>({1, x, z, minus}, axis::z, o), two_pi) << "pole";
                EXPECT_EQ(angle_of<T>({1, x, z, minus}, axis::z, positive), 0) << "pole";
            }
        // Half turns about the axis: the sign bit of w decides which way positive_twist turns.
        EXPECT_EQ(angle_of<T>({0, 0, 1, 0}, axis::z, positive), static_cast<T>(pi));
        EXPECT_EQ(angle_of<T>({0, 0, 1, minus}, axis::z, positive), -static_cast<T>(pi));
        EXPECT_EQ(angle_of<T>({0, 0, -1, 0}, axis::z, positive), -static_cast<T>(pi));
    }
}

TEST_P(TwistAngle, IsExactAtItsBoundsAndForSignedZeros) {
    bounds_and_zeros<float>();
    bounds_and_zeros<double>();
}

template <class T>
void stays_in_range() {
    constexpr std::size_t n = 20011;
    generator g(3);
    quat_buffer<T> q(n, layout::soa);
    scalar_buffer<T> out(n, layout::soa);
    const std::vector<quat<T>> corners = corner_rotations<T>();
    for (std::size_t i = 0; i < n; ++i) {
        quat<T> r = i % 4 == 0 ? corners[i % corners.size()] : random_rotation<T>(g);
        if (i % 4 == 1) r.z = std::ldexp(r.z, -static_cast<int>(i % 80));
        if (i % 4 == 2) r.w = std::ldexp(r.w, -static_cast<int>(i % 80));
        q.set(i, r);
    }
    for (precision p : both_precisions) {
        ASSERT_EQ(twist_angle(q.view(), axis::z, out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_TRUE(out[i] >= -T(2 * pi) && out[i] <= T(2 * pi));
        ASSERT_EQ(twist_angle(q.view(), axis::z, out.view(), {.accuracy = p, .positive_twist = true}),
                  status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_TRUE(out[i] >= -T(pi) && out[i] <= T(pi));
    }
}

TEST_P(TwistAngle, StaysInItsRange) {
    stays_in_range<float>();
    stays_in_range<double>();
}

}  // namespace
}  // namespace swivel::tests
