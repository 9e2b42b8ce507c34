#include "swivel/axis_angle.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class AxisAngle : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, AxisAngle, testing::ValuesIn(usable_isas()), isa_name);

constexpr axis all_axes[] = {axis::x, axis::y, axis::z};

// The bounds of axis_angle.hpp.
constexpr double from_bound = 3, from_each_bound = 4, from_each_fast_bound = 4.5, axis_bound = 4,
                 angle_bound = 4, angle_fast_bound = 4.5;

template <class T>
constexpr T largest_angle = sizeof(T) == 4 ? T(0x1p14) : T(0x1p21);

template <class T>
vec3<T> direction_of_any_length(generator& g) {
    const vec3<T> a = random_direction<T>(g);
    const T length = static_cast<T>(std::ldexp(uniform(g, 1, 2), static_cast<int>(g() % 200) - 100));
    return {a.x * length, a.y * length, a.z * length};
}

template <class T>
quat<wide<T>> turn_about(const vec3<wide<T>>& a, T radians) {
    using W = wide<T>;
    const W half = W(radians) / 2, s = sine(half);
    return {s * a.x, s * a.y, s * a.z, cosine(half)};
}

template <class T>
void from_is_the_definition() {
    using W = wide<T>;
    constexpr std::size_t n = 20011;
    generator g(1);
    scalar_buffer<T> radians(n, layout::soa);
    vec3_buffer<T> axes(n, layout::soa);
    quat_buffer<T> q(n, layout::soa);
    const T corners[] = {0,
                         T(-0.0),
                         std::numeric_limits<T>::denorm_min(),
                         largest_angle<T>,
                         -largest_angle<T>,
                         T(3.1415926535897932),
                         T(6.2831853071795865)};
    for (std::size_t i = 0; i < n; ++i) {
        const double range = i % 2 == 0 ? 20 : double(largest_angle<T>);
        radians[i] = i < std::size(corners) ? corners[i] : static_cast<T>(uniform(g, -range, range));
        axes.set(i, direction_of_any_length<T>(g));
    }
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        const auto check = [&](const char* form, const auto& axis_of, double bound) {
            double worst = 0;
            for (std::size_t i = 0; i < n; ++i)
                worst = std::max(
                    worst, double(norm(minus(widen<W>(q.get(i)), turn_about<T>(axis_of(i), radians[i])))));
            EXPECT_LE(worst / rounding_unit<T>, bound) << form << name(p);
        };
        for (const axis a : all_axes) {
            ASSERT_EQ(from_axis_angle(a, radians.view(), q.view(), o), status::ok);
            check(
                "coordinate",
                [&](std::size_t) {
                    return vec3<W>{W(a == axis::x), W(a == axis::y), W(a == axis::z)};
                },
                from_bound);
        }
        for (int k = 0; k < 5; ++k) {
            const vec3<T> a = direction_of_any_length<T>(g);
            ASSERT_EQ(from_axis_angle(a, radians.view(), q.view(), o), status::ok);
            check(
                "uniform", [&](std::size_t) { return unit(widen<W>(a)); }, from_bound);
        }
        ASSERT_EQ(from_axis_angle(axes.view(), radians.view(), q.view(), o), status::ok);
        check(
            "per element", [&](std::size_t i) { return unit(widen<W>(axes.get(i))); },
            p == precision::fast ? from_each_fast_bound : from_each_bound);
    }
}

TEST_P(AxisAngle, FromIsSineAndCosineOfHalfTheAngleFloat) { from_is_the_definition<float>(); }
TEST_P(AxisAngle, FromIsSineAndCosineOfHalfTheAngleDouble) { from_is_the_definition<double>(); }

template <class T>
void beyond_the_domain() {
    const T angles[] = {std::nextafter(largest_angle<T>, T(1e30)), T(-1e9), std::numeric_limits<T>::max()};
    scalar_buffer<T> radians(3, layout::soa);
    quat_buffer<T> q(3, layout::soa);
    for (std::size_t i = 0; i < 3; ++i) radians[i] = angles[i];
    for (const precision p : both_precisions) {
        ASSERT_EQ(from_axis_angle(vec3<T>{1, 2, 3}, radians.view(), q.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(q.get(i), (quat<T>{0, 0, 0, 1}));
    }
}

TEST_P(AxisAngle, AnAngleBeyondTheDomainCountsAsZero) {
    beyond_the_domain<float>();
    beyond_the_domain<double>();
}

template <class T>
void degenerate_vectors() {
    const T tiny = std::numeric_limits<T>::denorm_min();
    vec3_buffer<T> axes(4, layout::soa);
    axes.set(0, {0, 0, 0});
    axes.set(1, {T(-0.0), 0, T(-0.0)});
    axes.set(2, {0, -tiny, 0});
    axes.set(3, {3 * tiny, 0, -4 * tiny});
    scalar_buffer<T> radians(4, layout::soa);
    quat_buffer<T> q(4, layout::soa);
    for (std::size_t i = 0; i < 4; ++i) radians[i] = 2;
    const T s = static_cast<T>(std::sin(1.0)), c = static_cast<T>(std::cos(1.0));
    const quat<T> want[] = {{0, 0, 0, 1}, {0, 0, 0, 1}, {0, -s, 0, c}, {T(0.6) * s, 0, T(-0.8) * s, c}};
    for (const precision p : both_precisions) {
        ASSERT_EQ(from_axis_angle(axes.view(), radians.view(), q.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_LE(double(norm(minus(widen<double>(q.get(i)), widen<double>(want[i])))),
                      (i < 2 ? 0 : 6) * rounding_unit<T>)
                << i;
    }
    ASSERT_EQ(from_axis_angle(vec3<T>{0, 0, 0}, radians.view(), q.view()), status::bad_argument);
    ASSERT_EQ(from_axis_angle(static_cast<axis>(3), radians.view(), q.view()), status::bad_argument);
}

TEST_P(AxisAngle, AZeroVectorGivesTheIdentityAndASubnormalOneItsDirection) {
    degenerate_vectors<float>();
    degenerate_vectors<double>();
}

// Rotations of all angles, down to those whose vector is subnormal, of any length.
template <class T>
std::vector<quat<T>> all_rotations(generator& g) {
    std::vector<quat<T>> all;
    for (int i = 0; i < 20000; ++i) all.push_back(random_rotation<T>(g));
    const int smallest = std::numeric_limits<T>::min_exponent;
    for (int e = 0; e >= smallest - 20; --e)
        for (int i = 0; i < 40; ++i) {
            const vec3<T> a = random_direction<T>(g);
            const double s = std::ldexp(uniform(g, 0.5, 1), e), c = i % 2 == 0 ? 1 : -1;
            all.push_back(rounded<T>(a.x * s, a.y * s, a.z * s, c * std::sqrt(1 - s * s)));
        }
    for (int i = 0; i < 4000; ++i) {
        quat<T> q = random_rotation<T>(g);
        const T length = static_cast<T>(std::ldexp(1.0, static_cast<int>(g() % 200) - 80));
        all.push_back({q.x * length, q.y * length, q.z * length, q.w * length});
    }
    return all;
}

template <class T>
void to_is_the_definition() {
    using W = wide<T>;
    generator g(2);
    const std::vector<quat<T>> all = all_rotations<T>(g);
    const std::size_t n = all.size();
    quat_buffer<T> q(n, layout::soa);
    vec3_buffer<T> a(n, layout::soa);
    scalar_buffer<T> radians(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, all[i]);
    for (const precision p : both_precisions) {
        ASSERT_EQ(to_axis_angle(q.view(), a.view(), radians.view(), {.accuracy = p}), status::ok);
        double worst_axis = 0, worst_angle = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const quat<W> in = widen<W>(all[i]);
            const W length = root(in.x * in.x + in.y * in.y + in.z * in.z);
            const vec3<W> got = widen<W>(a.get(i));
            const quat<W> off{got.x - in.x / length, got.y - in.y / length, got.z - in.z / length, 0};
            worst_axis = std::max(worst_axis, double(norm(off)));
            const W angle = 2 * angle_of(length, in.w);
            if (angle < W(std::numeric_limits<T>::min()) / rounding_unit<T>) continue;
            worst_angle = std::max(worst_angle, double(magnitude(W(radians[i]) - angle) / angle));
        }
        EXPECT_LE(worst_axis / rounding_unit<T>, axis_bound) << name(p);
        EXPECT_LE(worst_angle / rounding_unit<T>, p == precision::fast ? angle_fast_bound : angle_bound)
            << name(p);
    }
}

TEST_P(AxisAngle, ToIsTheDefinitionHoweverSmallTheAngleFloat) { to_is_the_definition<float>(); }
TEST_P(AxisAngle, ToIsTheDefinitionHoweverSmallTheAngleDouble) { to_is_the_definition<double>(); }

template <class T>
void no_direction() {
    const T minus_zero = T(-0.0);
    const quat<T> in[] = {{0, 0, 0, 1}, {minus_zero, 0, minus_zero, 1}, {0, 0, 0, -1},
                          {0, 0, 0, 0}, {0, 0, 0, minus_zero},          {0, minus_zero, 0, -5}};
    const double want[] = {0, 0, 2, 0, 2, 2};
    quat_buffer<T> q(6, layout::soa);
    vec3_buffer<T> a(6, layout::soa);
    scalar_buffer<T> radians(6, layout::soa);
    for (std::size_t i = 0; i < 6; ++i) q.set(i, in[i]);
    for (const precision p : both_precisions) {
        ASSERT_EQ(to_axis_angle(q.view(), a.view(), radians.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(a.get(i), (vec3<T>{1, 0, 0})) << i;
            EXPECT_EQ(radians[i], static_cast<T>(want[i] * 3.14159265358979323846)) << i;
        }
    }
}

TEST_P(AxisAngle, WithoutAVectorTheAxisIsXAndTheAngleZeroOrATurn) {
    no_direction<float>();
    no_direction<double>();
}

template <class T>
void round_trip() {
    using W = wide<T>;
    constexpr std::size_t n = 10007;
    generator g(3);
    quat_buffer<T> q(n, layout::soa), back(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        q.set(i, random_rotation<T>(g));
        back.set(i, q.get(i));
    }
    const quat_view<T> v = back.view();
    for (const precision p : both_precisions) {
        for (std::size_t i = 0; i < n; ++i) back.set(i, q.get(i));
        // In place, both ways.
        const vec3_view<T> axes{v.x, v.y, v.z, n};
        const scalar_view<T> radians{v.w, n};
        ASSERT_EQ(to_axis_angle(v, axes, radians, {.accuracy = p}), status::ok);
        ASSERT_EQ(from_axis_angle(axes, radians, v, {.accuracy = p}), status::ok);
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i)
            worst = std::max(worst, double(norm(minus(widen<W>(back.get(i)), widen<W>(q.get(i))))));
        EXPECT_LE(worst / rounding_unit<T>, 14.0);
    }
}

TEST_P(AxisAngle, FromOfToIsTheRotationWithItsSignInPlace) {
    round_trip<float>();
    round_trip<double>();
}

}  // namespace
}  // namespace swivel::tests
