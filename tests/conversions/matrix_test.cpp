#include "swivel/matrix.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/reference.hpp"

namespace swivel::tests {
namespace {

class Matrix : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Matrix, testing::ValuesIn(usable_isas()), isa_name);

// The bounds of matrix.hpp.
constexpr double to_bound = 4.5, from_bound = 4;
constexpr double unit_bound(precision p) { return p == precision::fast ? 4 : 3; }

// The elements xx, xy, xz, yx ... zz: the columns are what q makes of the basis vectors.
template <class W>
std::array<W, 9> exact_matrix(const quat<W>& q) {
    const W n = dot(q, q);
    std::array<W, 9> m{};
    for (int column = 0; column < 3; ++column) {
        const quat<W> e{W(column == 0), W(column == 1), W(column == 2), 0};
        const quat<W> turned = times(times(q, e), conjugate(q));
        m[static_cast<std::size_t>(column)] = turned.x / n;
        m[static_cast<std::size_t>(3 + column)] = turned.y / n;
        m[static_cast<std::size_t>(6 + column)] = turned.z / n;
    }
    return m;
}

// Random ones, half turns about any axis and nearly so, turns about coordinate axes, quarter and third turns.
template <class T>
std::vector<quat<T>> all_rotations(generator& g) {
    std::vector<quat<T>> all;
    for (int i = 0; i < 20000; ++i) all.push_back(random_rotation<T>(g));
    for (int e = 0; e > -70; --e)
        for (int i = 0; i < 60; ++i) {
            // Any of the components small.
            const quat<double> q = random_rotation<double>(g);
            const double small = std::ldexp(1.0, e);
            const auto some = [&] { return g() % 2 == 0 ? small : 1; };
            const quat<double> r{q.x * some(), q.y * some(), q.z * some(), q.w * some()};
            const double n = norm(r);
            all.push_back(rounded<T>(r.x / n, r.y / n, r.z / n, r.w / n));
        }
    for (const quat<T>& q : corner_rotations<T>()) {
        const double n = norm(widen<double>(q));
        if (n > 1e-7 && n < 1e10) all.push_back(rounded<T>(q.x / n, q.y / n, q.z / n, q.w / n));
    }
    const T parts[] = {-1, T(-0.0), 0, 1};
    for (const T x : parts)
        for (const T y : parts)
            for (const T z : parts)
                for (const T w : parts) {
                    const double n = std::sqrt(double(x * x + y * y + z * z + w * w));
                    if (n > 0) all.push_back(rounded<T>(x / n, y / n, z / n, w / n));
                }
    return all;
}

template <class T>
void to_is_the_definition() {
    using W = wide<T>;
    generator g(1);
    std::vector<quat<T>> all = all_rotations<T>(g);
    const std::size_t units = all.size();
    for (int e = -49; e < 62; ++e)
        for (int i = 0; i < 50; ++i) {
            const quat<T> q = random_rotation<T>(g);
            const T length = static_cast<T>(std::ldexp(uniform(g, 1, 1.9), e));
            all.push_back({q.x * length, q.y * length, q.z * length, q.w * length});
        }
    const std::size_t n = all.size();
    quat_buffer<T> q(n, layout::soa);
    matrix_buffer<T> m(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, all[i]);
    for (const precision p : both_precisions) {
        ASSERT_EQ(to_matrix(q.view(), m.view(), {.accuracy = p}), status::ok);
        double worst[2] = {0, 0};
        for (std::size_t i = 0; i < n; ++i) {
            const std::array<W, 9> want = exact_matrix(widen<W>(all[i]));
            for (int c = 0; c < 9; ++c)
                worst[i >= units] = std::max(
                    worst[i >= units], double(magnitude(W(m.at(c, i)) - want[static_cast<std::size_t>(c)])));
        }
        EXPECT_LE(worst[0] / rounding_unit<T>, to_bound) << name(p);
        EXPECT_LE(worst[1] / rounding_unit<T>, to_bound) << name(p);
    }
}

TEST_P(Matrix, ToTurnsTheBasisAsTheQuaternionDoesWhateverItsLengthFloat) { to_is_the_definition<float>(); }
TEST_P(Matrix, ToTurnsTheBasisAsTheQuaternionDoesWhateverItsLengthDouble) { to_is_the_definition<double>(); }

template <class T>
void from_is_the_inverse() {
    using W = wide<T>;
    generator g(2);
    const std::vector<quat<T>> all = all_rotations<T>(g);
    const std::size_t n = all.size();
    matrix_buffer<T> m(n, layout::soa);
    quat_buffer<T> q(n, layout::soa), scalar(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        const std::array<W, 9> exact = exact_matrix(widen<W>(all[i]));
        for (int c = 0; c < 9; ++c) m.at(c, i) = static_cast<T>(exact[static_cast<std::size_t>(c)]);
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(from_matrix(m.view(), q.view(), {.accuracy = p}), status::ok);
        double worst = 0, worst_norm = 0;
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_FALSE(std::signbit(q.get(i).w)) << i;
            const quat<W> got = widen<W>(q.get(i)), in = widen<W>(all[i]);
            const W length = norm(in);
            const quat<W> want{in.x / length, in.y / length, in.z / length, in.w / length};
            const quat<W> other{-want.x, -want.y, -want.z, -want.w};
            worst = std::max(worst,
                             double(dot(got, want) > 0 ? norm(minus(got, want)) : norm(minus(got, other))));
            worst_norm = std::max(worst_norm, double(magnitude(norm(got) - 1)));
        }
        EXPECT_LE(worst / rounding_unit<T>, from_bound) << name(p);
        EXPECT_LE(worst_norm / rounding_unit<T>, unit_bound(p)) << name(p);
    }
    // The corners are no part of the test of every operation.
    ASSERT_EQ(reference::from_matrix(m.view(), scalar.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < 4; ++c) ASSERT_TRUE(same_bits(q.at(c, i), scalar.at(c, i))) << i;
}

TEST_P(Matrix, FromFindsEveryRotationHalfTurnsIncludedFloat) { from_is_the_inverse<float>(); }
TEST_P(Matrix, FromFindsEveryRotationHalfTurnsIncludedDouble) { from_is_the_inverse<double>(); }

// At w = 0 both signs have the same w.
template <class T>
void half_turns() {
    const T h = static_cast<T>(0.70710678118654752), s = static_cast<T>(0.57735026918962576);
    // Signs as they are stated: z where zz >= 0, else x where xx > yy, else y is positive.
    const quat<T> axes[] = {{1, 0, 0, 0},
                            {0, 1, 0, 0},
                            {0, 0, 1, 0},
                            {-h, h, 0, 0},
                            {-h, 0, h, 0},
                            {0, -h, h, 0},
                            {T(0.8), T(-0.6), 0, 0},
                            {T(-0.6), T(0.8), 0, 0},
                            {-s, s, s, 0},
                            {s, s, -s, 0}};
    constexpr std::size_t n = std::size(axes);
    quat_buffer<T> in(n, layout::soa), out(n, layout::soa);
    matrix_buffer<T> m(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) in.set(i, axes[i]);
    for (const precision p : both_precisions) {
        ASSERT_EQ(to_matrix(in.view(), m.view(), {.accuracy = p}), status::ok);
        ASSERT_EQ(from_matrix(m.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const quat<T> q = out.get(i);
            EXPECT_EQ(q.w, T(0)) << i;
            EXPECT_FALSE(std::signbit(q.w)) << i;
            const T chosen = m.at(8, i) >= 0 ? q.z : m.at(0, i) > m.at(4, i) ? q.x : q.y;
            EXPECT_GT(chosen, T(0)) << i;
        }
    }
}

TEST_P(Matrix, OfAHalfTurnTheChosenComponentIsPositive) {
    half_turns<float>();
    half_turns<double>();
}

// Elements that are off by up to h.
template <class T>
void not_quite_orthogonal() {
    constexpr std::size_t n = 20000;
    generator g(3);
    matrix_buffer<T> m(n, layout::soa);
    quat_buffer<T> q(n, layout::soa);
    for (const double h : {1e-5, 1e-3, 0.05}) {
        std::vector<quat<double>> want;
        for (std::size_t i = 0; i < n; ++i) {
            want.push_back(random_rotation<double>(g));
            const std::array<double, 9> exact = exact_matrix(want.back());
            for (int c = 0; c < 9; ++c)
                m.at(c, i) = static_cast<T>(exact[static_cast<std::size_t>(c)] + (g() % 2 == 0 ? h : -h));
        }
        for (const precision p : both_precisions) {
            ASSERT_EQ(from_matrix(m.view(), q.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) {
                const quat<double> got = widen<double>(q.get(i));
                const double sign = dot(got, want[i]) > 0 ? 1 : -1;
                const quat<double> by_sign{sign * want[i].x, sign * want[i].y, sign * want[i].z,
                                           sign * want[i].w};
                ASSERT_LE(norm(minus(got, by_sign)), 2.5 * h) << i;
                ASSERT_LE(std::fabs(norm(got) - 1), unit_bound(p) * rounding_unit<T>) << i;
            }
        }
    }
}

TEST_P(Matrix, ErrorsInTheElementsMoveTheResultByTwoAndAHalfTimesAsMuch) {
    not_quite_orthogonal<float>();
    not_quite_orthogonal<double>();
}

// Whatever the matrix: a unit quaternion.
template <class T>
void any_matrix() {
    constexpr std::size_t n = 20000;
    generator g(4);
    matrix_buffer<T> m(n, layout::soa);
    quat_buffer<T> q(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < 9; ++c) {
            const T values[] = {0, T(-0.0), 1, -1, T(0x1p60), static_cast<T>(uniform(g, -2, 2))};
            m.at(c, i) = values[g() % 6];
        }
    for (int c = 0; c < 9; ++c) m.at(c, 0) = 0;
    for (const precision p : both_precisions) {
        ASSERT_EQ(from_matrix(m.view(), q.view(), {.accuracy = p}), status::ok);
        EXPECT_EQ(q.get(0).x, T(0));
        EXPECT_GT(q.get(0).w, T(0));
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_LE(std::fabs(norm(widen<double>(q.get(i))) - 1),
                      std::max(unit_bound(p) * rounding_unit<T>, 4e-16))
                << i;
            ASSERT_FALSE(std::signbit(q.get(i).w));
        }
    }
}

TEST_P(Matrix, FromGivesAUnitQuaternionWhateverTheMatrix) {
    any_matrix<float>();
    any_matrix<double>();
}

template <class T>
void short_quaternions() {
    const T tiny = std::numeric_limits<T>::denorm_min();
    const quat<T> in[] = {{0, 0, 0, 0}, {0, T(-0.0), 0, T(-0.0)}, {tiny, -tiny, tiny, tiny}, {0, 0, 0, 1}};
    quat_buffer<T> q(4, layout::soa);
    matrix_buffer<T> m(4, layout::soa);
    for (std::size_t i = 0; i < 4; ++i) q.set(i, in[i]);
    for (const precision p : both_precisions) {
        ASSERT_EQ(to_matrix(q.view(), m.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 4; ++i)
            for (int c = 0; c < 9; ++c) EXPECT_EQ(m.at(c, i), T(c % 4 == 0)) << i;
    }
}

TEST_P(Matrix, OfAQuaternionThatIsTooShortIsTheUnitMatrix) {
    short_quaternions<float>();
    short_quaternions<double>();
}

TEST_P(Matrix, RowsAndColumnsAreWhatTheViewsSay) {
    // A quarter turn about z: x to y.
    const float h = std::sqrt(0.5F);
    float q[4] = {0, 0, h, h}, rows[9], columns[9];
    ASSERT_EQ(to_matrix(aos_xyzw<const float>(q, 1), aos_rows(rows, 1)), status::ok);
    ASSERT_EQ(to_matrix(aos_xyzw<const float>(q, 1), aos_columns(columns, 1)), status::ok);
    const float want[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(rows[3 * r + c], want[3 * r + c], 1e-6);
            EXPECT_NEAR(columns[3 * c + r], want[3 * r + c], 1e-6);
        }
}

TEST_P(Matrix, TheUnitMatrixIsExactlyTheIdentityInReproducible) {
    const double m[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    double q[4];
    ASSERT_EQ(from_matrix(aos_rows(m, 1), aos_xyzw(q, 1), {.accuracy = precision::reproducible}), status::ok);
    EXPECT_EQ((quat<double>{q[0], q[1], q[2], q[3]}), (quat<double>{0, 0, 0, 1}));
}

template <class T>
void round_trip() {
    using W = wide<T>;
    constexpr std::size_t n = 10007;
    generator g(5);
    quat_buffer<T> q(n, layout::soa), back(n, layout::soa);
    matrix_buffer<T> m(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, random_rotation<T>(g));
    const matrix_view<T> v = m.view();
    const quat_view<T> inside{v.xx, v.yy, v.zz, v.xy, n};
    for (const precision p : both_precisions) {
        // Into and out of streams of the matrix itself.
        for (std::size_t i = 0; i < n; ++i) {
            m.at(0, i) = q.at(0, i);
            m.at(4, i) = q.at(1, i);
            m.at(8, i) = q.at(2, i);
            m.at(1, i) = q.at(3, i);
        }
        ASSERT_EQ(to_matrix(inside, v, {.accuracy = p}), status::ok);
        ASSERT_EQ(from_matrix(v, inside, {.accuracy = p}), status::ok);
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const quat<W> got{m.at(0, i), m.at(4, i), m.at(8, i), m.at(1, i)}, in = widen<W>(q.get(i));
            const quat<W> want = in.w < 0 ? quat<W>{-in.x, -in.y, -in.z, -in.w} : in;
            worst = std::max(worst, double(norm(minus(got, want))));
        }
        EXPECT_LE(worst / rounding_unit<T>, 8.0);
    }
}

TEST_P(Matrix, FromOfToIsTheRotationWithPositiveWInPlace) {
    round_trip<float>();
    round_trip<double>();
}

}  // namespace
}  // namespace swivel::tests
