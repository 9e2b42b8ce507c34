// square_root, exp, log and power against their definitions.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class Exponentials : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Exponentials, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 40000;

// Eleven bits more than double, and a range in which no square of one underflows.
using exact = long double;
const exact pi = std::acos(exact(-1));

exact length(const quat<exact>& q) { return std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z); }

// d sin f + cos f, d the unit vector along the vector part of q, or x.
quat<exact> turned(const quat<exact>& q, exact f) {
    const exact m = length(q), s = std::sin(f) / m;
    if (m == 0) return {std::sin(f), 0, 0, std::cos(f)};
    return {q.x * s, q.y * s, q.z * s, std::cos(f)};
}

exact angle(const quat<exact>& q) { return std::atan2(length(q), q.w); }

template <class T>
double units(exact error) {
    return static_cast<double>(error) / rounding_unit<T>;
}

// Unit quaternions: half of them evenly distributed, the others with a vector part or a scalar part of any
// size down to the smallest; a third of all times a power of two or so.
template <class T>
quat<T> any_quaternion(generator& g, std::size_t i) {
    constexpr int smallest = sizeof(T) == 4 ? 148 : 1070, largest = sizeof(T) == 4 ? 90 : 900;
    const auto below = [&](int limit) { return static_cast<int>(g() % static_cast<unsigned>(limit)); };
    quat<T> q = random_rotation<T>(g);
    if (i % 2 != 0) {
        const double small = std::ldexp(uniform(g, 0.5, 1), i % 4 == 1 ? -below(30) : -below(smallest));
        const double rest = std::sqrt(1 - small * small);
        const double v = i % 8 < 4 ? small : rest, w = i % 8 < 4 ? rest : small;
        const vec3<double> d = random_direction<double>(g);
        q = rounded<T>(d.x * v, d.y * v, d.z * v, g() % 2 != 0 ? w : -w);
    }
    if (i % 3 == 0) {
        const T scale = static_cast<T>(std::ldexp(uniform(g, 1, 2), below(2 * largest) - largest));
        q = {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
    }
    return q;
}

template <class T>
struct sampled {
    quat_buffer<T> q{n, layout::soa}, out{n, layout::soa};
    vec3_buffer<T> b{n, layout::soa};
    scalar_buffer<T> t{n, layout::soa};

    explicit sampled(std::uint64_t seed) {
        generator g(seed);
        for (std::size_t i = 0; i < n; ++i) {
            q.set(i, any_quaternion<T>(g, i));
            t[i] = static_cast<T>(uniform(g, -1, 1));
        }
    }
};

template <class T>
double error(const quat<T>& got, const quat<exact>& want) {
    return units<T>(norm(minus(widen<exact>(got), want)));
}

template <class T>
double error(const vec3<T>& got, const quat<exact>& want) {
    return units<T>(length({got.x - want.x, got.y - want.y, got.z - want.z, 0}));
}

template <class T>
void root_is_half_of_the_angle() {
    sampled<T> s(1);
    for (precision p : both_precisions) {
        ASSERT_EQ(square_root(s.q.view(), s.out.view(), {.accuracy = p}), status::ok);
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const quat<exact> q = widen<exact>(s.q.get(i));
            worst = std::max(worst, error(s.out.get(i), turned(q, angle(q) / 2)));
            ASSERT_GE(s.out.get(i).w, 0) << i;
        }
        EXPECT_LE(worst, p == precision::fast ? 6.5 : 4);
    }
}

TEST_P(Exponentials, SquareRootIsHalfOfTheAngleOfAnyLength) {
    root_is_half_of_the_angle<float>();
    root_is_half_of_the_angle<double>();
}

template <class T>
void log_is_the_angle_along_the_axis() {
    sampled<T> s(2);
    for (precision p : both_precisions) {
        ASSERT_EQ(log(s.q.view(), s.b.view(), {.accuracy = p}), status::ok);
        double absolute = 0, relative = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const quat<exact> q = widen<exact>(s.q.get(i));
            const exact m = length(q), f = angle(q);
            if (m == 0) continue;
            const double e = error(s.b.get(i), {q.x / m * f, q.y / m * f, q.z / m * f, 0});
            absolute = std::max(absolute, e / static_cast<double>(std::max(exact(1), f)));
            // What is not subnormal itself.
            if (m >= 4 * std::numeric_limits<T>::min() && f >= std::numeric_limits<T>::min())
                relative = std::max(relative, e / static_cast<double>(f));
        }
        EXPECT_LE(absolute, p == precision::fast ? 6 : 4.5);
        EXPECT_LE(relative, p == precision::fast ? 7.5 : 4.5);
    }
}

TEST_P(Exponentials, LogIsTheAngleAlongTheAxisOfAnyLength) {
    log_is_the_angle_along_the_axis<float>();
    log_is_the_angle_along_the_axis<double>();
}

template <class T>
void exp_is_the_rotation() {
    generator g(3);
    vec3_buffer<T> b(n, layout::soa);
    quat_buffer<T> q(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        const double largest = sizeof(T) == 4 ? 8191 : 1048575;
        const double size = i % 3 == 0   ? uniform(g, 0, 3.15)
                            : i % 3 == 1 ? std::ldexp(3.14, -static_cast<int>(g() % 120))
                                         : uniform(g, 0, i % 2 == 0 ? largest : 30);
        const vec3<double> d = random_direction<double>(g);
        b.set(i, {static_cast<T>(d.x * size), static_cast<T>(d.y * size), static_cast<T>(d.z * size)});
    }
    for (precision p : both_precisions) {
        ASSERT_EQ(exp(b.view(), q.view(), {.accuracy = p}), status::ok);
        double principal = 0, beyond = 0, relative = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const vec3<T> v = b.get(i);
            const quat<exact> in{v.x, v.y, v.z, 0};
            const exact f = length(in);
            const quat<exact> want = turned(in, f);
            const double e = error(q.get(i), want);
            if (f <= 3.15L)
                principal = std::max(principal, e);
            else
                beyond = std::max(beyond, e / static_cast<double>(1 + f));
            const vec3<T> part{q.get(i).x, q.get(i).y, q.get(i).z};
            if (f < 0.5L && f > std::numeric_limits<T>::min())
                relative = std::max(relative, error(part, want) / static_cast<double>(f));
        }
        EXPECT_LE(principal, p == precision::fast ? 12 : 7);
        EXPECT_LE(beyond, p == precision::fast ? 5 : 2.5);
        EXPECT_LE(relative, p == precision::fast ? 7.5 : 3);
    }
}

TEST_P(Exponentials, ExpIsTheRotationAtAnySize) {
    exp_is_the_rotation<float>();
    exp_is_the_rotation<double>();
}

template <class T>
void power_is_the_multiple_of_the_angle() {
    sampled<T> s(4);
    for (const double scale : {1.0, 40.0}) {
        for (std::size_t i = 0; i < n; ++i) s.t[i] = static_cast<T>(scale * s.t[i]);
        for (precision p : both_precisions) {
            ASSERT_EQ(power(s.q.view(), s.t.view(), s.out.view(), {.accuracy = p}), status::ok);
            double worst = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const quat<exact> q = widen<exact>(s.q.get(i));
                worst = std::max(worst, error(s.out.get(i), turned(q, s.t[i] * angle(q))));
            }
            EXPECT_LE(worst, (p == precision::fast ? 7 : 6) * scale);
        }
    }
}

TEST_P(Exponentials, PowerIsTheMultipleOfTheAngleOfAnyLength) {
    power_is_the_multiple_of_the_angle<float>();
    power_is_the_multiple_of_the_angle<double>();
}

template <class T>
void one_exponent_for_all() {
    sampled<T> s(5);
    quat_buffer<T> each(n, layout::soa);
    for (precision p : both_precisions)
        for (const T t : {T(0), T(0.25), T(1), T(-3)}) {
            for (std::size_t i = 0; i < n; ++i) s.t[i] = t;
            ASSERT_EQ(power(s.q.view(), t, s.out.view(), {.accuracy = p}), status::ok);
            ASSERT_EQ(power(s.q.view(), s.t.view(), each.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) {
                ASSERT_EQ(s.out.get(i), each.get(i));
                if (t == 0) {
                    ASSERT_EQ(s.out.get(i), (quat<T>{0, 0, 0, 1}));
                }
                if (t == 1 && p == precision::reproducible) {
                    ASSERT_EQ(s.out.get(i), s.q.get(i));
                }
            }
        }
}

TEST_P(Exponentials, PowerByZeroIsTheIdentityAndByOneEveryBitInReproducible) {
    one_exponent_for_all<float>();
    one_exponent_for_all<double>();
}

// The corners of the headers, in both precisions and in the reference.
template <class T>
void corners() {
    using limits = std::numeric_limits<T>;
    const T tiny = limits::denorm_min(), huge = limits::max(), half_turn = static_cast<T>(pi);
    constexpr std::size_t count = 16;
    quat_buffer<T> q(count, layout::soa), root(count, layout::soa), part(count, layout::soa),
        back(count, layout::soa);
    vec3_buffer<T> b(count, layout::soa);
    const quat<T> in[count] = {{0, 0, 0, 1},
                               {T(-0.0), T(-0.0), T(-0.0), 1},
                               {0, 0, 0, -1},
                               {T(-0.0), 0, T(-0.0), -1},
                               {0, 0, 0, 0},
                               {0, 0, 0, T(-0.0)},
                               {0, tiny, 0, -1},
                               {0, tiny, 0, 1},
                               {0, -tiny, 0, T(-0.0)},
                               {tiny, 0, tiny, -tiny},
                               {0, 0, 0, -huge},
                               {huge, huge, huge, -huge},
                               {0, 0, 1, 0},
                               {0, 0, -1, T(-0.0)},
                               {0, 0, limits::min(), -huge},
                               {0, 0, 0, tiny}};
    for (std::size_t i = 0; i < count; ++i) q.set(i, in[i]);
    for (int arithmetic = 0; arithmetic < 3; ++arithmetic) {
        SCOPED_TRACE(arithmetic);
        const options o{.accuracy = arithmetic == 0 ? precision::fast : precision::reproducible};
        const bool by_reference = arithmetic == 2;
        ASSERT_EQ(by_reference ? reference::square_root(q.view(), root.view())
                               : square_root(q.view(), root.view(), o),
                  status::ok);
        ASSERT_EQ(by_reference ? reference::log(q.view(), b.view()) : log(q.view(), b.view(), o), status::ok);
        ASSERT_EQ(by_reference ? reference::exp(b.view(), back.view()) : exp(b.view(), back.view(), o),
                  status::ok);
        ASSERT_EQ(by_reference ? reference::power(q.view(), T(0.5), part.view())
                               : power(q.view(), T(0.5), part.view(), o),
                  status::ok);
        const quat<T> roots[count] = {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 0}, {1, 0, 0, 0},
                                      {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 0, 1}};
        const vec3<T> logs[count] = {{0, 0, 0}, {0, 0, 0}, {half_turn, 0, 0}, {half_turn, 0, 0},
                                     {0, 0, 0}, {0, 0, 0}, {0, half_turn, 0}, {0, tiny, 0}};
        const double few = 8 * rounding_unit<T>;
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_LE(static_cast<double>(norm(minus(widen<exact>(root.get(i)), widen<exact>(roots[i])))),
                      few)
                << i;
            EXPECT_LE(static_cast<double>(norm(minus(widen<exact>(part.get(i)), widen<exact>(roots[i])))),
                      few)
                << i;
            EXPECT_NEAR(b.get(i).x, logs[i].x, few);
            EXPECT_NEAR(b.get(i).y, logs[i].y, few);
            EXPECT_NEAR(b.get(i).z, logs[i].z, few);
        }
        EXPECT_EQ(b.get(0), (vec3<T>{0, 0, 0}));
        EXPECT_GT(b.get(7).y, 0);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_LE(static_cast<double>(magnitude(norm(widen<exact>(root.get(i))) - 1)), few) << i;
            EXPECT_LE(static_cast<double>(magnitude(norm(widen<exact>(part.get(i))) - 1)), few) << i;
            EXPECT_FALSE(std::isnan(b.get(i).x + b.get(i).y + b.get(i).z)) << i;
            const exact size = norm(widen<exact>(in[i]));
            const quat<exact> unit{in[i].x / size, in[i].y / size, in[i].z / size, in[i].w / size};
            if (size >= std::ldexp(1.0L, sizeof(T) == 4 ? -100 : -960) && size < limits::max() / 2) {
                EXPECT_LE(error(back.get(i), unit), 12) << i;
            }
        }
    }
}

TEST_P(Exponentials, CornersAreThoseOfTheHeaders) {
    corners<float>();
    corners<double>();
}

template <class T>
void no_vector_part_stays_exact() {
    quat_buffer<T> q(1, layout::soa), out(1, layout::soa);
    vec3_buffer<T> b(1, layout::soa);
    const options o{.accuracy = precision::reproducible};
    q.set(0, {0, 0, 0, 1});
    b.set(0, {0, 0, 0});
    ASSERT_EQ(square_root(q.view(), out.view(), o), status::ok);
    EXPECT_EQ(out.get(0), q.get(0));
    ASSERT_EQ(exp(b.view(), out.view(), o), status::ok);
    EXPECT_EQ(out.get(0), q.get(0));
    q.set(0, {0, 0, 0, -1});
    ASSERT_EQ(square_root(q.view(), out.view(), o), status::ok);
    EXPECT_EQ(out.get(0), (quat<T>{1, 0, 0, 0}));
    ASSERT_EQ(log(q.view(), b.view(), o), status::ok);
    EXPECT_EQ(b.get(0), (vec3<T>{static_cast<T>(pi), 0, 0}));
}

TEST_P(Exponentials, IdentityAndMinusOneAreExactInReproducible) {
    no_vector_part_stays_exact<float>();
    no_vector_part_stays_exact<double>();
}

// Vectors and exponents without a sensible angle give the identity, not a NaN.
template <class T>
void beyond_the_largest_angle() {
    using limits = std::numeric_limits<T>;
    const quat<T> one{0, 0, 0, 1};
    vec3_buffer<T> b(4, layout::soa);
    quat_buffer<T> q(4, layout::soa), out(4, layout::soa);
    b.set(0, {limits::max(), limits::max(), limits::max()});
    b.set(1, {0, -limits::max(), 0});
    b.set(2, {T(2e9), 0, 0});
    b.set(3, {sizeof(T) == 4 ? T(8200) : T(1048600), 0, 0});
    for (std::size_t i = 0; i < 4; ++i) q.set(i, {0, 0, T(0.6), T(-0.8)});
    for (precision p : both_precisions) {
        ASSERT_EQ(exp(b.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(out.get(i), one) << i;
        for (const T t : {limits::max(), -limits::max(), T(1e9)}) {
            ASSERT_EQ(power(q.view(), t, out.view(), {.accuracy = p}), status::ok);
            EXPECT_EQ(out.get(0), one);
        }
    }
}

TEST_P(Exponentials, AngleBeyondTheLargestGivesTheIdentity) {
    beyond_the_largest_angle<float>();
    beyond_the_largest_angle<double>();
}

template <class T>
void they_belong_together() {
    sampled<T> s(6);
    quat_buffer<T> other(n, layout::soa);
    for (precision p : both_precisions) {
        const options o{.accuracy = p};
        const double tolerance = (p == precision::fast ? 40 : 24) * rounding_unit<T>;
        ASSERT_EQ(log(s.q.view(), s.b.view(), o), status::ok);
        ASSERT_EQ(exp(s.b.view(), s.out.view(), o), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const quat<exact> q = widen<exact>(s.q.get(i)), unit = turned(q, angle(q));
            ASSERT_LE(static_cast<double>(norm(minus(widen<exact>(s.out.get(i)), unit))), tolerance) << i;
        }
        // The square of the root, in place of q.
        ASSERT_EQ(square_root(s.out.view(), other.view(), o), status::ok);
        ASSERT_EQ(compose(other.view(), other.view(), other.view(), o), status::ok);
        for (std::size_t i = 0; i < n; ++i)
            ASSERT_LE(
                static_cast<double>(norm(minus(widen<exact>(s.out.get(i)), widen<exact>(other.get(i))))),
                tolerance)
                << i;
    }
}

TEST_P(Exponentials, ExpUndoesLogAndTheRootSquaredIsTheRotation) {
    they_belong_together<float>();
    they_belong_together<double>();
}

template <class T>
void in_place() {
    for (layout l : all_layouts)
        for (precision p : both_precisions) {
            constexpr std::size_t size = 67;
            generator g(7);
            quat_buffer<T> q(size, l), want(size, l), work(size, l);
            for (std::size_t i = 0; i < size; ++i) q.set(i, random_rotation<T>(g));
            for (const bool root : {false, true}) {
                for (std::size_t i = 0; i < size; ++i) work.set(i, q.get(i));
                const options o{.accuracy = p};
                ASSERT_EQ(
                    root ? square_root(q.view(), want.view(), o) : power(q.view(), T(0.3), want.view(), o),
                    status::ok);
                ASSERT_EQ(root ? square_root(work.view(), work.view(), o)
                               : power(work.view(), T(0.3), work.view(), o),
                          status::ok);
                for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(work.get(i), want.get(i));
            }
            // A vector in the streams of a quaternion, as soa.
            if (l != layout::soa) continue;
            const quat_view<T> v = work.view();
            vec3_buffer<T> b(size, l);
            ASSERT_EQ(log(work.view(), b.view(), {.accuracy = p}), status::ok);
            ASSERT_EQ(log(v, soa(v.x, v.y, v.z, size), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < size; ++i)
                ASSERT_EQ(b.get(i), (vec3<T>{work.get(i).x, work.get(i).y, work.get(i).z}));
        }
}

TEST_P(Exponentials, MayBeDoneInPlace) {
    in_place<float>();
    in_place<double>();
}

}  // namespace
}  // namespace swivel::tests
