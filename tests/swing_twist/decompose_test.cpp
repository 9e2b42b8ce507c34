// What decompose gives, measured against the formula in wider arithmetic. Tolerances are those of the
// headers.

#include "swivel/decompose.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/compose.hpp"

namespace swivel::tests {
namespace {

class Decompose : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Decompose, testing::ValuesIn(usable_isas()), isa_name);

constexpr product both_products[] = {product::swing_twist, product::twist_swing};
constexpr axis all_axes[] = {axis::x, axis::y, axis::z};

template <class T>
vec3<T> direction(axis a) {
    return {T(a == axis::x), T(a == axis::y), T(a == axis::z)};
}

// Random rotations, and rotations at every distance from the pole of the axis down to the threshold and
// below.
template <class T>
void fill(quat_buffer<T>& q, const vec3<T>& a, std::uint64_t seed) {
    generator g(seed);
    const int deepest = sizeof(T) == 4 ? 40 : 70;
    for (std::size_t i = 0; i < q.size(); ++i)
        q.set(i, i % 2 == 0
                     ? random_rotation<T>(g)
                     : near_pole<T>(g, a, std::ldexp(uniform(g, 0.5, 1), -static_cast<int>(i) % deepest)));
}

// In rounding units, the figures of decompose.hpp.
struct bounds {
    double twist_norm, swing_norm, recomposition, axial;
};

bounds stated(precision p) { return p == precision::reproducible ? bounds{4, 4, 8, 3} : bounds{5, 5, 10, 3}; }

bounds stated_for_own_axis(precision p) {
    return p == precision::reproducible ? bounds{4.5, 5.5, 9.5, 3.5} : bounds{7, 7.5, 13, 5};
}

template <class T>
void check_invariants(const quat<T>& q, const quat<T>& s, const quat<T>& t, const vec3<wide<T>>& a,
                      product order, const bounds& bound) {
    using W = wide<T>;
    const double unit = rounding_unit<T>;
    const quat<W> in = widen<W>(q), swing = widen<W>(s), twist = widen<W>(t);
    const double length = double(norm(in));
    const quat<W> product_of = order == product::swing_twist ? times(swing, twist) : times(twist, swing);
    ASSERT_LE(double(magnitude(norm(twist) - 1)), bound.twist_norm * unit);
    ASSERT_LE(double(magnitude(norm(swing) - norm(in))), bound.swing_norm * unit * length);
    ASSERT_LE(double(norm(minus(product_of, in))), bound.recomposition * unit * length);
    ASSERT_LE(double(magnitude(along(a, swing))), bound.axial * unit * length);
    ASSERT_GE(double(swing.w), 0.0);
}

template <class T>
void check_invariants(quat_buffer<T>& q, quat_buffer<T>& s, quat_buffer<T>& t, const vec3<wide<T>>& a,
                      product order, const bounds& bound) {
    for (std::size_t i = 0; i < q.size(); ++i) {
        SCOPED_TRACE(i);
        check_invariants<T>(q.get(i), s.get(i), t.get(i), a, order, bound);
        if (testing::Test::HasFatalFailure()) return;
    }
}

template <class T>
void recomposes() {
    constexpr std::size_t n = 20011;
    for (precision p : both_precisions)
        for (product order : both_products) {
            quat_buffer<T> q(n, layout::soa), s(n, layout::soa), t(n, layout::soa);
            const options o{.order = order, .accuracy = p};
            for (axis a : all_axes) {
                fill(q, direction<T>(a), 1);
                ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), o), status::ok);
                check_invariants<T>(q, s, t, widen<wide<T>>(direction<T>(a)), order, stated(p));
            }
            generator g(2);
            for (int k = 0; k < 3; ++k) {
                vec3<T> a = random_direction<T>(g);
                a = {a.x * 5, a.y * 5, a.z * 5};
                fill(q, a, 3);
                ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), o), status::ok);
                check_invariants<T>(q, s, t, unit(widen<wide<T>>(a)), order, stated(p));
            }
        }
}

TEST_P(Decompose, RecomposesToInputWithUnitTwistAndPerpendicularSwingFloat) { recomposes<float>(); }
TEST_P(Decompose, RecomposesToInputWithUnitTwistAndPerpendicularSwingDouble) { recomposes<double>(); }

template <class T>
void follows_each_axis() {
    constexpr std::size_t n = 4099;
    for (precision p : both_precisions)
        for (product order : both_products) {
            quat_buffer<T> q(n, layout::soa), s(n, layout::soa), t(n, layout::soa);
            vec3_buffer<T> axes(n, layout::soa);
            generator g(4);
            for (std::size_t i = 0; i < n; ++i) {
                const vec3<T> d = random_direction<T>(g);
                // Down to subnormal lengths and up to the largest.
                const int most = std::numeric_limits<T>::max_exponent - 2,
                          least = std::numeric_limits<T>::min_exponent;
                const int e = static_cast<int>(g() % static_cast<std::uint64_t>(most - least)) + least;
                axes.set(i, {std::ldexp(d.x, e), std::ldexp(d.y, e), std::ldexp(d.z, e)});
                q.set(i, near_pole<T>(g, d, uniform(g, 0.01, 1)));
            }
            ASSERT_EQ(decompose(q.view(), axes.view(), s.view(), t.view(), {.order = order, .accuracy = p}),
                      status::ok);
            using W = wide<T>;
            for (std::size_t i = 0; i < n; ++i) {
                const vec3<W> a = unit(widen<W>(axes.get(i)));
                const auto want = factor(widen<W>(q.get(i)), a, order);
                const double tolerance = (12 + 4 / double(want.closeness)) * rounding_unit<T>;
                ASSERT_LE(double(norm(minus(widen<W>(t.get(i)), want.twist))), tolerance) << i;
                ASSERT_LE(double(norm(minus(widen<W>(s.get(i)), want.swing))), tolerance) << i;
                check_invariants<T>(q.get(i), s.get(i), t.get(i), a, order, stated_for_own_axis(p));
            }
        }
}

TEST_P(Decompose, FollowsTheAxisOfEachElementOfAnyLength) {
    follows_each_axis<float>();
    follows_each_axis<double>();
}

// Condition does not enter about a coordinate axis: flat error at every distance from the pole above the
// threshold.
template <class T>
void coordinate_axis_is_accurate_at_every_distance() {
    using W = wide<T>;
    const int deepest = sizeof(T) == 4 ? 23 : 52;
    constexpr std::size_t per_distance = 101;
    const std::size_t n = per_distance * static_cast<std::size_t>(deepest + 1);
    for (precision p : both_precisions)
        for (product order : both_products)
            for (axis a : all_axes) {
                quat_buffer<T> q(n, layout::soa), s(n, layout::soa), t(n, layout::soa);
                generator g(7);
                for (std::size_t i = 0; i < n; ++i)
                    q.set(i, near_pole<T>(g, direction<T>(a),
                                          std::ldexp(1.0, -static_cast<int>(i / per_distance))));
                ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), {.order = order, .accuracy = p}),
                          status::ok);
                const double bound = (p == precision::reproducible ? 4 : 6) * rounding_unit<T>;
                for (std::size_t i = 0; i < n; ++i) {
                    const auto want = factor(widen<W>(q.get(i)), widen<W>(direction<T>(a)), order);
                    ASSERT_LE(double(norm(minus(widen<W>(t.get(i)), want.twist))), bound) << i;
                    ASSERT_LE(double(norm(minus(widen<W>(s.get(i)), want.swing))), bound) << i;
                }
            }
}

TEST_P(Decompose, IsAccurateAtEveryDistanceFromThePoleOfACoordinateAxis) {
    coordinate_axis_is_accurate_at_every_distance<float>();
    coordinate_axis_is_accurate_at_every_distance<double>();
}

// Lengths other than 1, over the domain that the header states.
template <class T>
void any_length() {
    using W = wide<T>;
    const int least = sizeof(T) == 4 ? -26 : -427, most = sizeof(T) == 4 ? 62 : 510;
    const std::size_t n = static_cast<std::size_t>(most - least) * 8;
    for (precision p : both_precisions)
        for (product order : both_products) {
            quat_buffer<T> q(n, layout::soa), s(n, layout::soa), t(n, layout::soa);
            generator g(9);
            const vec3<T> a{1, 2, -2};
            for (std::size_t i = 0; i < n; ++i) {
                const quat<T> r = i % 2 == 0
                                      ? random_rotation<T>(g)
                                      : near_pole<T>(g, a, std::ldexp(1.0, -static_cast<int>(g() % 30)));
                const int e = least + 1 + static_cast<int>(i / 8);
                q.set(i, {std::ldexp(r.x, e), std::ldexp(r.y, e), std::ldexp(r.z, e), std::ldexp(r.w, e)});
            }
            ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), {.order = order, .accuracy = p}),
                      status::ok);
            check_invariants<T>(q, s, t, unit(widen<W>(a)), order, stated(p));
            ASSERT_EQ(decompose(q.view(), axis::y, s.view(), t.view(), {.order = order, .accuracy = p}),
                      status::ok);
            check_invariants<T>(q, s, t, {0, 1, 0}, order, stated(p));
        }
}

TEST_P(Decompose, TakesQuaternionsOfAnyLengthInTheDomain) {
    any_length<float>();
    any_length<double>();
}

TEST_P(Decompose, LargerThanTheDomainIsNanAndNotAWrongRotation) {
    quat_buffer<float> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
    q.set(0, {1e30f, 2e30f, 3e30f, 4e30f});
    for (precision p : both_precisions) {
        ASSERT_EQ(decompose(q.view(), axis::z, s.view(), t.view(), {.accuracy = p}), status::ok);
        EXPECT_TRUE(std::isnan(t.get(0).w));
        EXPECT_TRUE(std::isnan(s.get(0).w));
    }
}

template <class T>
void identity_is_exact() {
    quat_buffer<T> q(5, layout::soa), s(5, layout::soa), t(5, layout::soa);
    for (std::size_t i = 0; i < 5; ++i) q.set(i, {0, 0, 0, 1});
    for (const twist_axis<T>& a :
         {twist_axis<T>(axis::x), twist_axis<T>(axis::z), twist_axis<T>(vec3<T>{1, 2, 3})}) {
        ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), {.accuracy = precision::reproducible}),
                  status::ok);
        EXPECT_EQ(s.get(3), (quat<T>{0, 0, 0, 1}));
        EXPECT_EQ(t.get(3), (quat<T>{0, 0, 0, 1}));
    }
}

TEST_P(Decompose, IdentityIsExactInReproducible) {
    identity_is_exact<float>();
    identity_is_exact<double>();
}

// S(-q) = S(q) and T(-q) = -T(q), in bits, the pole and -0 included.
template <class T>
void both_signs() {
    const std::vector<quat<T>> corners = corner_rotations<T>();
    generator g(13);
    std::vector<quat<T>> all = corners;
    for (int i = 0; i < 500; ++i) all.push_back(random_rotation<T>(g));
    const std::size_t n = all.size();
    for (precision p : both_precisions)
        for (const twist_axis<T>& a : {twist_axis<T>(axis::x), twist_axis<T>(axis::y), twist_axis<T>(axis::z),
                                       twist_axis<T>(vec3<T>{3, -1, 2})}) {
            quat_buffer<T> q(n, layout::soa), m(n, layout::soa), s(n, layout::soa), t(n, layout::soa),
                ms(n, layout::soa), mt(n, layout::soa);
            for (std::size_t i = 0; i < n; ++i) {
                q.set(i, all[i]);
                m.set(i, {-all[i].x, -all[i].y, -all[i].z, -all[i].w});
            }
            ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), {.accuracy = p}), status::ok);
            ASSERT_EQ(decompose(m.view(), a, ms.view(), mt.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) {
                // Equal as numbers: a component that is 0 may differ in its sign.
                const quat<T> twist = mt.get(i), negated{-twist.x, -twist.y, -twist.z, -twist.w};
                ASSERT_EQ(s.get(i), ms.get(i)) << i;
                ASSERT_EQ(t.get(i), negated) << i;
            }
        }
}

TEST_P(Decompose, NegatedInputHasTheSameSwingAndTheNegatedTwist) {
    both_signs<float>();
    both_signs<double>();
}

// The contract of the pole, in full.
template <class T>
void pole() {
    const T h = static_cast<T>(0.6), k = static_cast<T>(0.8), tiny = sizeof(T) == 4 ? T(0x1p-30) : T(0x1p-60);
    struct pole_case {
        quat<T> q;
        T sign;
    };
    const pole_case cases[] = {
        {{h, k, 0, 0}, 1},       {{h, k, 0, T(-0.0)}, -1},    {{h, k, T(-0.0), 0}, 1},
        {{h, k, tiny, tiny}, 1}, {{h, k, -tiny, tiny}, 1},    {{h, k, tiny, -tiny}, -1},
        {{h, k, -tiny, 0}, 1},   {{h, k, tiny, T(-0.0)}, -1}, {{-h, k, 0, -tiny}, -1},
        {{0, 0, 0, 0}, 1},       {{0, 0, 0, T(-0.0)}, -1}};
    for (precision p : both_precisions)
        for (product order : both_products)
            for (const twist_axis<T>& a : {twist_axis<T>(axis::z), twist_axis<T>(vec3<T>{0, 0, 7})})
                for (const pole_case& c : cases) {
                    quat_buffer<T> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
                    q.set(0, c.q);
                    ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), {.order = order, .accuracy = p}),
                              status::ok);
                    EXPECT_EQ(t.get(0), (quat<T>{0, 0, 0, c.sign}));
                    EXPECT_EQ(s.get(0), (quat<T>{c.sign * c.q.x, c.sign * c.q.y, 0, std::fabs(c.q.w)}));
                }
}

TEST_P(Decompose, PoleHasTheTwistSignOfWAndTheSwingPerpendicular) {
    pole<float>();
    pole<double>();
}

TEST_P(Decompose, ThresholdIsRelativeToTheLength) {
    for (precision p : both_precisions)
        for (float length : {1.0f, 0x1p-20f, 0x1p20f}) {
            quat_buffer<float> q(2, layout::soa), s(2, layout::soa), t(2, layout::soa);
            q.set(0, {length, 0, 0x1p-12f * length, 0x1.1p-12f * length});
            q.set(1, {length, 0, 0x1p-10f * length, 0x1.1p-10f * length});
            const options o{.accuracy = p, .pole_threshold = 0x1p-22};
            ASSERT_EQ(decompose(q.view(), axis::z, s.view(), t.view(), o), status::ok);
            EXPECT_EQ(t.get(0), (quat<float>{0, 0, 0, 1}));
            EXPECT_NE(t.get(1), (quat<float>{0, 0, 0, 1}));
            // At a larger threshold S T moves away from q by the part along the axis, and no more.
            EXPECT_EQ(s.get(0), (quat<float>{length, 0, 0, 0x1.1p-12f * length}));
        }
}

TEST_P(Decompose, ElementExactlyAtTheThresholdIsAtThePole) {
    quat_buffer<float> q(2, layout::soa), s(2, layout::soa), t(2, layout::soa);
    // w^2 + z^2 = 2^-10 and x^2 + y^2 = 1 - 2^-10: |q|^2 is 1 in the kernels' arithmetic.
    q.set(0, {0.75f, std::sqrt(1.0f - 0.5625f - 0x1p-10f), 0, 0x1p-5f});
    q.set(1, {0.75f, std::sqrt(1.0f - 0.5625f - 0x1p-10f), 0, 0x1.01p-5f});
    for (precision p : both_precisions) {
        const options o{.accuracy = p, .pole_threshold = 0x1.00001p-10};
        ASSERT_EQ(decompose(q.view(), axis::z, s.view(), t.view(), o), status::ok);
        EXPECT_EQ(t.get(0).w, 1.0f);
        EXPECT_EQ(s.get(0).w, 0x1p-5f);
        EXPECT_GT(norm(widen<double>(s.get(1))), 0.9);
    }
}

TEST_P(Decompose, ThresholdZeroKeepsTheTwistDownToUnderflow) {
    quat_buffer<float> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
    q.set(0, {0.6f, 0.8f, 0x1p-48f, 0x1p-48f});
    for (precision p : both_precisions) {
        ASSERT_EQ(decompose(q.view(), axis::z, s.view(), t.view(), {.accuracy = p, .pole_threshold = 0}),
                  status::ok);
        EXPECT_NEAR(t.get(0).z, std::sqrt(0.5), 4e-7);
        EXPECT_NEAR(t.get(0).w, std::sqrt(0.5), 4e-7);
    }
    q.set(0, {0.6f, 0.8f, 0x1p-60f, 0x1p-60f});
    ASSERT_EQ(decompose(q.view(), axis::z, s.view(), t.view(), {.pole_threshold = 0}), status::ok);
    EXPECT_EQ(t.get(0), (quat<float>{0, 0, 0, 1}));
}

template <class T>
void positive_twist_has_clear_sign() {
    const std::vector<quat<T>> corners = corner_rotations<T>();
    const std::size_t n = corners.size() * 2;
    generator g(19);
    quat_buffer<T> q(n, layout::soa), s(n, layout::soa), t(n, layout::soa), s0(n, layout::soa),
        t0(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, i % 2 == 0 ? corners[i / 2] : random_rotation<T>(g));
    for (precision p : both_precisions)
        for (const twist_axis<T>& a : {twist_axis<T>(axis::y), twist_axis<T>(vec3<T>{1, 1, -1})}) {
            ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), {.accuracy = p, .positive_twist = true}),
                      status::ok);
            ASSERT_EQ(decompose(q.view(), a, s0.view(), t0.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) {
                ASSERT_FALSE(std::signbit(t.get(i).w)) << i;
                ASSERT_EQ(s.get(i), s0.get(i)) << i;
                const quat<T> u = t0.get(i);
                const T sign = std::signbit(q.get(i).w) ? T(-1) : T(1);
                ASSERT_EQ(t.get(i), (quat<T>{sign * u.x, sign * u.y, sign * u.z, sign * u.w})) << i;
            }
        }
}

TEST_P(Decompose, PositiveTwistClearsTheSignAndKeepsTheSwing) {
    positive_twist_has_clear_sign<float>();
    positive_twist_has_clear_sign<double>();
}

TEST_P(Decompose, CompactFormIsTheFullFormWithoutItsZeros) {
    constexpr std::size_t n = 1000;
    for (product order : both_products)
        for (axis a : all_axes) {
            quat_buffer<double> q(n, layout::soa), s(n, layout::soa), t(n, layout::soa);
            factor_buffer<double> f(n);
            fill(q, direction<double>(a), 21);
            const options o{.order = order, .accuracy = precision::reproducible};
            ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), o), status::ok);
            ASSERT_EQ(decompose(q.view(), a, f.view(), o), status::ok);
            const int A = static_cast<int>(a), B = (A + 1) % 3, C = (A + 2) % 3;
            for (std::size_t i = 0; i < n; ++i) {
                ASSERT_EQ(f.get(i),
                          (factors<double>{s.at(B, i), s.at(C, i), s.at(3, i), t.at(A, i), t.at(3, i)}));
                ASSERT_EQ(s.at(A, i), 0);
                ASSERT_EQ(t.at(B, i), 0);
                ASSERT_EQ(t.at(C, i), 0);
            }
        }
}

}  // namespace
}  // namespace swivel::tests
