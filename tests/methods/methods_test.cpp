#include "../../bench/methods/methods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "swivel/reference.hpp"

namespace swivel::tests {
namespace {

namespace methods = swivel_bench::methods;

constexpr int n = 2000;

template <class T>
constexpr vec3<T> z_axis{0, 0, 1};

template <class T>
using factors_of = methods::swing_twist<T>;

template <class T>
struct named {
    const char* name;
    factors_of<T> factors;
};

template <class T>
std::vector<named<T>> all_about_z(const quat<T>& q) {
    return {{"Algorithm 1", methods::algorithm_1(q, z_axis<T>)},
            {"direct", methods::direct(q, z_axis<T>)},
            {"Huyghe", methods::huyghe(q)},
            {"Huyghe, projection", methods::huyghe(q, z_axis<T>)},
            {"axis-aligned", methods::axis_aligned(q)}};
}

template <class T>
std::vector<named<T>> all_about(const vec3<T>& a, const quat<T>& q) {
    return {{"Algorithm 1", methods::algorithm_1(q, a)},
            {"direct", methods::direct(q, a)},
            {"Huyghe, projection", methods::huyghe(q, a)}};
}

// |a - b| in rounding units.
template <class T, class W = wide<T>>
double distance(const quat<T>& a, const quat<W>& b) {
    return double(norm(minus(widen<W>(a), b))) / rounding_unit<T>;
}

template <class T>
bool has_nan(const factors_of<T>& f) {
    const quat<T>&s = f.swing, &t = f.twist;
    return std::isnan(s.x + s.y + s.z + s.w) || std::isnan(t.x + t.y + t.z + t.w);
}

// A rotation whose swing from z is by an angle within a tenth of `size`, or as far from pi.
template <class T>
quat<T> swung(generator& g, double size, bool below_pi) {
    const double half = size * uniform(g, 0.9, 1.1) / 2, direction = uniform(g, 0, 6.283185307179586),
                 twist = uniform(g, 0, 6.283185307179586);
    const double sine = below_pi ? std::cos(half) : std::sin(half),
                 cosine = below_pi ? std::sin(half) : std::cos(half);
    const quat<double> s{sine * std::cos(direction), sine * std::sin(direction), 0, cosine};
    const quat<double> q = times(s, {0, 0, std::sin(twist), std::cos(twist)});
    return rounded<T>(q.x, q.y, q.z, q.w);
}

template <class T>
void all_recompose() {
    using W = wide<T>;
    generator g(1);
    for (int i = 0; i < n; ++i) {
        const quat<T> q = random_rotation<T>(g);
        std::vector<named<T>> results = all_about_z(q);
        for (const named<T>& m : all_about(random_direction<T>(g), q)) results.push_back(m);
        for (const named<T>& m : results)
            ASSERT_LE(distance(q, times(widen<W>(m.factors.swing), widen<W>(m.factors.twist))), 8)
                << m.name << " " << i;
    }
}

TEST(Methods, AllRecomposeToTheInput) {
    all_recompose<float>();
    all_recompose<double>();
}

template <class T>
void agree_with_reference() {
    using W = wide<T>;
    generator g(2);
    quat_buffer<T> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
    const auto near = [&](const named<T>& m, int i) {
        ASSERT_LE(distance(m.factors.swing, widen<W>(s.get(0))), 16) << m.name << " " << i;
        ASSERT_LE(distance(m.factors.twist, widen<W>(t.get(0))), 16) << m.name << " " << i;
    };
    for (int i = 0; i < n; ++i) {
        // Swings from 0.5 to 2.1.
        q.set(0, swung<T>(g, uniform(g, 0.6, 1.9), false));
        ASSERT_EQ(reference::decompose(q.view(), axis::z, s.view(), t.view()), status::ok);
        for (const named<T>& m : all_about_z(q.get(0))) near(m, i);
        const vec3<T> a = random_direction<T>(g);
        q.set(0, random_rotation<T>(g));
        ASSERT_EQ(reference::decompose(q.view(), a, s.view(), t.view()), status::ok);
        if (s.get(0).w < T(0.5) || s.get(0).w > T(0.97)) continue;
        for (const named<T>& m : all_about(a, q.get(0))) near(m, i);
    }
}

TEST(Methods, AllAgreeWithTheReferenceAwayFromSwingsZeroAndPi) {
    agree_with_reference<float>();
    agree_with_reference<double>();
}

template <class T>
void direct_loses_digits(double size, bool below_pi) {
    using W = wide<T>;
    generator g(3);
    double worst_direct = 0, worst_algorithm_1 = 0;
    for (int i = 0; i < n; ++i) {
        const quat<T> q = swung<T>(g, size, below_pi);
        const exact_factors<W> exact = factor(widen<W>(q), widen<W>(z_axis<T>), product::swing_twist);
        const factors_of<T> d = methods::direct(q, z_axis<T>), a = methods::algorithm_1(q, z_axis<T>);
        if (!has_nan(d))
            worst_direct =
                std::max({worst_direct, distance(d.swing, exact.swing), distance(d.twist, exact.twist)});
        worst_algorithm_1 =
            std::max({worst_algorithm_1, distance(a.swing, exact.swing), distance(a.twist, exact.twist)});
    }
    EXPECT_GE(worst_direct, 500);
    EXPECT_LE(worst_algorithm_1, 5);
}

TEST(Methods, DirectLosesDigitsOfSmallSwingsAndAlgorithm1DoesNot) {
    direct_loses_digits<float>(0x1p-12, false);
    direct_loses_digits<double>(0x1p-12, false);
    direct_loses_digits<double>(0x1p-20, false);
}

TEST(Methods, DirectLosesDigitsNextToPiAndAlgorithm1DoesNot) {
    direct_loses_digits<float>(0x1p-12, true);
    direct_loses_digits<float>(0x1p-20, true);
    direct_loses_digits<double>(0x1p-12, true);
    direct_loses_digits<double>(0x1p-20, true);
}

// Half of 2^-16 is 128 units: nothing of the swing is left.
TEST(Methods, DirectGivesNoSwingForSmallSwingsInFloat) {
    generator g(4);
    for (int i = 0; i < n; ++i) {
        const quat<float> s = methods::direct(swung<float>(g, 0x1p-16, false), z_axis<float>).swing;
        EXPECT_EQ(s, (quat<float>{0, 0, 0, 1}));
    }
}

template <class T>
void nothing_at_the_ends() {
    const T h = static_cast<T>(0.70710678118654752);
    for (const quat<T>& q : {quat<T>{0, 0, 0, 1}, quat<T>{0, 0, h, h}}) {
        EXPECT_TRUE(has_nan(methods::direct(q, z_axis<T>)));
        EXPECT_FALSE(has_nan(methods::algorithm_1(q, z_axis<T>)));
        EXPECT_FALSE(has_nan(methods::huyghe(q)));
        EXPECT_FALSE(has_nan(methods::axis_aligned(q)));
    }
    for (const quat<T>& q : {quat<T>{1, 0, 0, 0}, quat<T>{0, 1, 0, 0}}) {
        EXPECT_TRUE(has_nan(methods::direct(q, z_axis<T>)));
        EXPECT_TRUE(has_nan(methods::algorithm_1(q, z_axis<T>)));
        EXPECT_TRUE(has_nan(methods::huyghe(q)));
        EXPECT_TRUE(has_nan(methods::huyghe(q, z_axis<T>)));
        EXPECT_EQ(methods::axis_aligned(q).swing, q);
        EXPECT_EQ(methods::axis_aligned(q).twist, (quat<T>{0, 0, 0, 1}));
    }
}

TEST(Methods, OnlyDirectHasNoAnswerAtSwingZeroAndOnlyAxisAlignedHasOneAtPi) {
    nothing_at_the_ends<float>();
    nothing_at_the_ends<double>();
}

// All but the component of the swing along z: Huyghe's is 0, that of Algorithm 1 a difference of two equal
// products.
template <class T>
void same_about_z() {
    generator g(5);
    for (int i = 0; i < n; ++i) {
        const quat<T> q = random_rotation<T>(g);
        const factors_of<T> a = methods::algorithm_1(q, z_axis<T>), h = methods::huyghe(q);
        ASSERT_EQ(a.twist, h.twist) << i;
        ASSERT_EQ((quat<T>{a.swing.x, a.swing.y, 0, a.swing.w}), h.swing) << i;
        ASSERT_LE(double(std::fabs(a.swing.z)), 2 * rounding_unit<T>) << i;
    }
}

TEST(Methods, HuyghesFormulasAboutZAreThoseOfAlgorithm1InEveryBit) {
    same_about_z<float>();
    same_about_z<double>();
}

template <class T>
void same_about_any_axis() {
    using W = wide<T>;
    generator g(6);
    for (int i = 0; i < n; ++i) {
        const quat<T> q = random_rotation<T>(g);
        const vec3<T> axis = random_direction<T>(g);
        const factors_of<T> a = methods::algorithm_1(q, axis), h = methods::huyghe(q, axis);
        ASSERT_LE(distance(a.swing, widen<W>(h.swing)), 8) << i;
        ASSERT_LE(distance(a.twist, widen<W>(h.twist)), 8) << i;
    }
}

TEST(Methods, HuyghesProjectionIsAlgorithm1ToRounding) {
    same_about_any_axis<float>();
    same_about_any_axis<double>();
}

template <class T>
void any_length() {
    generator g(7);
    for (int i = 0; i < n; ++i) {
        const quat<T> q = random_rotation<T>(g);
        const vec3<T> a = random_direction<T>(g);
        const factors_of<T> f = methods::algorithm_1(q, a);
        // Powers of two change no bit.
        for (const T length : {T(0x1p-10), T(0x1p10)}) {
            const factors_of<T> scaled =
                methods::algorithm_1(q, vec3<T>{a.x * length, a.y * length, a.z * length});
            ASSERT_EQ(scaled.swing, f.swing) << i;
            ASSERT_EQ(scaled.twist, f.twist) << i;
        }
    }
}

TEST(Methods, Algorithm1TakesAnAxisOfAnyLength) {
    any_length<float>();
    any_length<double>();
}

TEST(Methods, TheTwistPrintedForDirectIsAboutTheRotatedAxis) {
    generator g(8);
    for (int i = 0; i < n; ++i) {
        const quat<double> q = random_rotation<double>(g);
        const vec3<double> a = random_direction<double>(g);
        const quat<double> swing = methods::direct(q, a).swing;
        if (swing.w < 0.1 || swing.w > 0.99) continue;
        const quat<double> printed = times(q, conjugate(swing));
        const vec3<double> v{printed.x, printed.y, printed.z}, b = methods::rotated(q, a);
        const auto length = [](const vec3<double>& c) { return std::sqrt(methods::dot(c, c)); };
        ASSERT_LE(length(methods::cross(v, b)), 1e-13) << i;
        ASSERT_GE(length(methods::cross(v, a)), 0.1 * length(v)) << i;
    }
}

}  // namespace
}  // namespace swivel::tests
