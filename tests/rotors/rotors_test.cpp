// multiply, conjugate, normalize, rotate, dot, and align_signs with a neighbour for each element.

#include <gtest/gtest.h>

#include <functional>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "support/vectors.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class Algebra : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Algebra, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 60013;

// Every fourth element a corner, the others random rotations.
template <class T>
void fill(quat_buffer<T>& q, generator& g) {
    const std::vector<quat<T>> corners = corner_rotations<T>();
    for (std::size_t i = 0; i < q.size(); ++i)
        q.set(i, i % 4 == 3 ? corners[g() % corners.size()] : random_rotation<T>(g));
}

// Errors as multiples of the rounding unit, beside the largest that the header states.
template <class T>
void expect_within(double bound, const std::function<double(std::size_t)>& error) {
    double worst = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double e = error(i) / rounding_unit<T>;
        ASSERT_FALSE(std::isnan(e)) << "element " << i;
        if (e > worst) worst = e, at = i;
    }
    EXPECT_LE(worst, bound) << "element " << at;
}

// A result so small may have been rounded to a subnormal number.
template <class T>
constexpr double smallest = double(std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon()) * 4;

template <class T>
void multiply_is_accurate() {
    using W = wide<T>;
    generator g(1);
    quat_buffer<T> a(n, layout::soa), b(n, layout::soa), out(n, layout::soa);
    fill(a, g);
    fill(b, g);
    for (precision p : both_precisions) {
        ASSERT_EQ(multiply(a.view(), b.view(), out.view(), {.accuracy = p}), status::ok);
        expect_within<T>(3.5, [&](std::size_t i) {
            const quat<W> l = widen<W>(a.get(i)), r = widen<W>(b.get(i));
            const W size = norm(l) * norm(r);
            return double(norm(minus(widen<W>(out.get(i)), times(l, r))) / (size + W(smallest<T>)));
        });
    }
}

TEST_P(Algebra, MultiplyIsTheHamiltonProduct) {
    multiply_is_accurate<float>();
    multiply_is_accurate<double>();
}

TEST_P(Algebra, MultiplyByTheIdentityIsExact) {
    generator g(2);
    quat_buffer<float> one(n, layout::soa), q(n, layout::soa), out(n, layout::soa);
    fill(q, g);
    for (std::size_t i = 0; i < n; ++i) one.set(i, {0, 0, 0, 1});
    for (precision p : both_precisions) {
        ASSERT_EQ(multiply(one.view(), q.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(out.get(i), q.get(i));
        ASSERT_EQ(multiply(q.view(), one.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(out.get(i), q.get(i));
    }
}

TEST_P(Algebra, MultiplyHasTheBitsOfComposeInBothPrecisions) {
    generator g(3);
    quat_buffer<float> a(n, layout::soa), b(n, layout::soa), out(n, layout::soa), composed(n, layout::soa);
    fill(a, g);
    fill(b, g);
    for (precision p : both_precisions) {
        ASSERT_EQ(multiply(a.view(), b.view(), out.view(), {.accuracy = p}), status::ok);
        ASSERT_EQ(compose(a.view(), b.view(), composed.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(out.get(i), composed.get(i));
    }
}

template <class T>
void conjugate_changes_signs() {
    using limits = std::numeric_limits<T>;
    generator g(4);
    quat_buffer<T> q(n, layout::soa), out(n, layout::soa);
    fill(q, g);
    const T special[] = {T(0),
                         T(-0.0),
                         limits::denorm_min(),
                         limits::max(),
                         limits::infinity(),
                         -limits::infinity(),
                         limits::quiet_NaN()};
    for (std::size_t i = 0; i < 200; ++i)
        q.set(i, {special[g() % 7], special[g() % 7], special[g() % 7], special[g() % 7]});
    for (precision p : both_precisions) {
        ASSERT_EQ(conjugate(q.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i)
            for (int c = 0; c < 4; ++c) {
                const bits_of<T> sign = std::bit_cast<bits_of<T>>(T(-0.0));
                ASSERT_EQ(std::bit_cast<bits_of<T>>(out.at(c, i)),
                          std::bit_cast<bits_of<T>>(q.at(c, i)) ^ (c < 3 ? sign : bits_of<T>(0)));
            }
    }
}

TEST_P(Algebra, ConjugateExchangesThreeSignBitsWhateverTheNumber) {
    conjugate_changes_signs<float>();
    conjugate_changes_signs<double>();
}

template <class T>
void conjugate_is_inverse() {
    using W = wide<T>;
    generator g(5);
    quat_buffer<T> q(n, layout::soa), inverse(n, layout::soa), out(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, random_rotation<T>(g));
    ASSERT_EQ(conjugate(q.view(), inverse.view()), status::ok);
    ASSERT_EQ(multiply(q.view(), inverse.view(), out.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i)
        ASSERT_LE(double(norm(minus(widen<W>(out.get(i)), quat<W>{0, 0, 0, 1}))), 7 * rounding_unit<T>);
}

TEST_P(Algebra, ConjugateIsTheInverseOfAUnitQuaternion) {
    conjugate_is_inverse<float>();
    conjugate_is_inverse<double>();
}

// Components of every magnitude that there is, alone and together.
template <class T>
void normalize_is_accurate(precision p, double length_bound, double bound) {
    using W = wide<T>;
    using limits = std::numeric_limits<T>;
    generator g(6);
    quat_buffer<T> q(n, layout::soa), out(n, layout::soa);
    const int lowest = limits::min_exponent - limits::digits, range = limits::max_exponent - 1 - lowest;
    const T special[] = {limits::denorm_min(), limits::min(), limits::max(), -limits::max(), T(1), T(0)};
    for (std::size_t i = 0; i < n; ++i) {
        const quat<T> r = random_rotation<T>(g);
        const int k = lowest + static_cast<int>(g() % static_cast<unsigned>(range + 1));
        const auto any = [&] { return special[g() % 6]; };
        if (i % 4 == 0)
            q.set(i, r);
        else if (i % 4 == 3)
            q.set(i, {any(), any(), any(), any()});
        else
            q.set(i, {std::ldexp(r.x, k), std::ldexp(r.y, k), std::ldexp(r.z, k), std::ldexp(r.w, k)});
    }
    ASSERT_EQ(normalize(q.view(), out.view(), {.accuracy = p}), status::ok);
    expect_within<T>(length_bound,
                     [&](std::size_t i) { return double(magnitude(norm(widen<W>(out.get(i))) - 1)); });
    expect_within<T>(bound, [&](std::size_t i) {
        const quat<W> in = widen<W>(q.get(i));
        const W size = norm(in);
        const quat<W> want =
            size == 0 ? quat<W>{0, 0, 0, 1} : quat<W>{in.x / size, in.y / size, in.z / size, in.w / size};
        return double(norm(minus(widen<W>(out.get(i)), want)));
    });
}

TEST_P(Algebra, NormalizeIsAccurateFromTheSmallestSubnormalToTheLargestNumber) {
    normalize_is_accurate<float>(precision::reproducible, 3, 3);
    normalize_is_accurate<double>(precision::reproducible, 3, 3);
    normalize_is_accurate<float>(precision::fast, 4.5, 4.5);
    normalize_is_accurate<double>(precision::fast, 4.5, 4.5);
}

template <class T>
void zero_becomes_identity() {
    constexpr std::size_t all = 16;
    quat_buffer<T> q(all, layout::soa), out(all, layout::soa);
    const auto zero = [](std::size_t i, int bit) { return (i >> bit) % 2 != 0 ? T(-0.0) : T(0); };
    for (std::size_t i = 0; i < all; ++i) q.set(i, {zero(i, 0), zero(i, 1), zero(i, 2), zero(i, 3)});
    for (precision p : both_precisions) {
        ASSERT_EQ(normalize(q.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < all; ++i) {
            ASSERT_EQ(out.get(i), (quat<T>{0, 0, 0, 1}));
            for (int c = 0; c < 3; ++c) ASSERT_TRUE(same_bits(out.at(c, i), q.at(c, i)));
        }
    }
}

TEST_P(Algebra, NormalizeOfZeroIsTheIdentityWithItsZerosKept) {
    zero_becomes_identity<float>();
    zero_becomes_identity<double>();
}

TEST_P(Algebra, NormalizeLeavesTheIdentityExactlyInReproducible) {
    quat_buffer<float> q(2, layout::soa), out(2, layout::soa);
    q.set(0, {0, 0, 0, 1});
    q.set(1, {0, 0, 0, -1});
    ASSERT_EQ(normalize(q.view(), out.view(), {.accuracy = precision::reproducible}), status::ok);
    for (std::size_t i = 0; i < 2; ++i) ASSERT_EQ(out.get(i), q.get(i));
}

// The formula of rotate.hpp.
template <class W>
vec3<W> turned(const quat<W>& q, const vec3<W>& v) {
    const quat<W> t{2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z), 2 * (q.x * v.y - q.y * v.x), 0};
    return {v.x + q.w * t.x + (q.y * t.z - q.z * t.y), v.y + q.w * t.y + (q.z * t.x - q.x * t.z),
            v.z + q.w * t.z + (q.x * t.y - q.y * t.x)};
}

template <class T>
void rotate_is_accurate(double bound) {
    using W = wide<T>;
    generator g(7);
    quat_buffer<T> q(n, layout::soa);
    vec3_buffer<T> v(n, layout::soa), out(n, layout::soa);
    const std::vector<quat<T>> corners = corner_rotations<T>();
    for (std::size_t i = 0; i < n; ++i) {
        // Of the corners, those of unit length.
        const quat<T> corner = corners[g() % corners.size()];
        const bool is_unit = std::fabs(double(dot(widen<W>(corner), widen<W>(corner))) - 1) < 1e-6;
        q.set(i, i % 4 == 3 && is_unit ? corner : random_rotation<T>(g));
        v.set(i, random_vector<T>(g, -30, 30));
    }
    for (precision p : both_precisions) {
        ASSERT_EQ(rotate(q.view(), v.view(), out.view(), {.accuracy = p}), status::ok);
        expect_within<T>(bound, [&](std::size_t i) {
            const vec3<W> in = widen<W>(v.get(i)), want = turned(widen<W>(q.get(i)), in);
            return double(norm(difference(widen<W>(out.get(i)), want)) / norm(in));
        });
    }
}

TEST_P(Algebra, RotateIsAccurateForVectorsOfAnyLength) {
    rotate_is_accurate<float>(9);
    rotate_is_accurate<double>(9);
}

// q v q* of q / |q|, which is not quite q: its components are rounded.
TEST_P(Algebra, RotateIsTheProductWithTheConjugateOnBothSides) {
    generator g(8);
    quat_buffer<float> q(n, layout::soa);
    vec3_buffer<float> v(n, layout::soa), out(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        q.set(i, random_rotation<float>(g));
        v.set(i, random_direction<float>(g));
    }
    ASSERT_EQ(rotate(q.view(), v.view(), out.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        const quat<double> r = widen<double>(q.get(i));
        const vec3<double> in = widen<double>(v.get(i));
        const quat<double> want = times(times(r, quat<double>{in.x, in.y, in.z, 0}), tests::conjugate(r));
        const double s = dot(r, r);
        const vec3<double> unit_want{want.x / s, want.y / s, want.z / s};
        ASSERT_LE(norm(difference(widen<double>(out.get(i)), unit_want)), 10 * rounding_unit<float>);
    }
}

TEST_P(Algebra, RotateByTheIdentityIsExact) {
    constexpr std::size_t count = 1000;
    generator g(9);
    vec3_buffer<double> v(count, layout::soa), out(count, layout::soa);
    for (std::size_t i = 0; i < count; ++i) v.set(i, random_vector<double>(g, -30, 30));
    for (precision p : both_precisions)
        for (double w : {1.0, -1.0}) {
            ASSERT_EQ(rotate(quat<double>{0, 0, 0, w}, v.view(), out.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(out.get(i), v.get(i));
        }
}

// A quarter turn about z takes x to y: the rotation is active.
TEST_P(Algebra, RotateTurnsXToYByAQuarterTurnAboutZ) {
    const float h = 0.70710678F;
    vec3_buffer<float> v(1, layout::soa), out(1, layout::soa);
    v.set(0, {3, 0, 0});
    ASSERT_EQ(rotate(quat<float>{0, 0, h, h}, v.view(), out.view()), status::ok);
    EXPECT_NEAR(out.get(0).x, 0, 1e-6);
    EXPECT_NEAR(out.get(0).y, 3, 1e-6);
    EXPECT_EQ(out.get(0).z, 0);
}

// Twice as long, the turn away from v is four times as far.
TEST_P(Algebra, RotateByALongerQuaternionScalesTheWayFromTheVector) {
    quat_buffer<double> q(1, layout::soa);
    vec3_buffer<double> v(1, layout::soa), out(1, layout::soa);
    v.set(0, {1, 0, 0});
    q.set(0, {0, 0, 2 * std::sqrt(0.5), 2 * std::sqrt(0.5)});
    ASSERT_EQ(rotate(q.view(), v.view(), out.view()), status::ok);
    EXPECT_NEAR(out.get(0).x, -3, 1e-14);
    EXPECT_NEAR(out.get(0).y, 4, 1e-14);
}

template <class T>
void one_for_all_is_each() {
    generator g(10);
    constexpr std::size_t count = 1031;
    for (layout l : all_layouts) {
        quat_buffer<T> q(count, layout::soa);
        vec3_buffer<T> v(count, l), out(count, l), want(count, l);
        const quat<T> one = random_rotation<T>(g);
        for (std::size_t i = 0; i < count; ++i) {
            q.set(i, one);
            v.set(i, random_vector<T>(g, -30, 30));
        }
        for (precision p : both_precisions) {
            ASSERT_EQ(rotate(one, v.view(), out.view(), {.accuracy = p}), status::ok);
            ASSERT_EQ(rotate(q.view(), v.view(), want.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(out.get(i), want.get(i)) << name(l);
        }
    }
}

TEST_P(Algebra, RotateByOneForAllHasTheBitsOfOneForEach) {
    one_for_all_is_each<float>();
    one_for_all_is_each<double>();
}

TEST_P(Algebra, RotateByOneWithANanMakesEveryElementNan) {
    vec3_buffer<float> v(21, layout::soa), out(21, layout::soa);
    for (std::size_t i = 0; i < v.size(); ++i) v.set(i, {0, 0, 0});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const quat<float>& q : {quat<float>{nan, 0, 0, 1}, {0, nan, 0, 1}, {0, 0, nan, 1}, {0, 0, 0, nan}}) {
        ASSERT_EQ(rotate(q, v.view(), out.view()), status::ok);
        for (std::size_t i = 0; i < v.size(); ++i)
            for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isnan(out.at(c, i)));
    }
}

template <class T>
void dot_is_accurate(double bound) {
    using W = wide<T>;
    generator g(11);
    quat_buffer<T> a(n, layout::soa), b(n, layout::soa);
    scalar_buffer<T> out(n, layout::soa);
    fill(a, g);
    fill(b, g);
    for (std::size_t i = 0; i < n; i += 2) {
        // Nearly perpendicular, where a figure relative to the product itself would not hold.
        const quat<T> q = a.get(i);
        b.set(i, {-q.w, q.z, -q.y, q.x});
    }
    for (precision p : both_precisions) {
        ASSERT_EQ(dot(a.view(), b.view(), out.view(), {.accuracy = p}), status::ok);
        expect_within<T>(bound, [&](std::size_t i) {
            const quat<W> l = widen<W>(a.get(i)), r = widen<W>(b.get(i));
            const W size = norm(l) * norm(r);
            return double(magnitude(W(out[i]) - tests::dot(l, r)) / (size + W(smallest<T>)));
        });
    }
}

TEST_P(Algebra, DotIsAccurateRelativeToBothLengths) {
    dot_is_accurate<float>(3.5);
    dot_is_accurate<double>(3.5);
}

TEST_P(Algebra, DotWithTheIdentityIsTheScalarPartExactly) {
    generator g(12);
    quat_buffer<double> q(n, layout::soa), one(n, layout::soa);
    scalar_buffer<double> out(n, layout::soa);
    fill(q, g);
    for (std::size_t i = 0; i < n; ++i) one.set(i, {0, 0, 0, 1});
    for (precision p : both_precisions) {
        ASSERT_EQ(dot(q.view(), one.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(out[i], q.get(i).w);
    }
}

// The result is q or -q in bits, and never in the other hemisphere; between them at most the error of the
// product.
template <class T>
void align_picks_the_hemisphere() {
    using W = wide<T>;
    generator g(13);
    quat_buffer<T> q(n, layout::soa), neighbour(n, layout::soa), out(n, layout::soa), twice(n, layout::soa);
    fill(q, g);
    fill(neighbour, g);
    for (precision p : both_precisions) {
        ASSERT_EQ(align_signs(q.view(), neighbour.view(), out.view(), {.accuracy = p}), status::ok);
        ASSERT_EQ(align_signs(out.view(), neighbour.view(), twice.view(), {.accuracy = p}), status::ok);
        std::size_t turned_over = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const quat<T> in = q.get(i), got = out.get(i);
            const bool kept = same_bits(got.x, in.x) && same_bits(got.y, in.y) && same_bits(got.z, in.z) &&
                              same_bits(got.w, in.w);
            const bool flipped = same_bits(got.x, -in.x) && same_bits(got.y, -in.y) &&
                                 same_bits(got.z, -in.z) && same_bits(got.w, -in.w);
            ASSERT_TRUE(kept || flipped) << i;
            turned_over += flipped;
            const quat<W> a = widen<W>(got), b = widen<W>(neighbour.get(i));
            ASSERT_GE(double(tests::dot(a, b)), -3.5 * rounding_unit<T> * double(norm(a) * norm(b))) << i;
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(same_bits(twice.at(c, i), out.at(c, i))) << i;
        }
        ASSERT_GT(turned_over, n / 3);
        ASSERT_LT(turned_over, 2 * n / 3);
    }
}

TEST_P(Algebra, AlignSignsGivesTheOneOnTheSideOfTheNeighbour) {
    align_picks_the_hemisphere<float>();
    align_picks_the_hemisphere<double>();
}

template <class T>
void perpendicular_stays() {
    const T zero(0), minus_zero(-0.0), least = std::numeric_limits<T>::denorm_min();
    struct pair {
        quat<T> q, neighbour;
    };
    const pair pairs[] = {
        {{0, 0, 0, -1}, {1, 0, 0, 0}},
        {{zero, zero, zero, T(-1)}, {T(-1), zero, zero, minus_zero}},
        {{T(-1), T(-1), 0, 0}, {T(1), T(-1), 0, 0}},
        {{minus_zero, zero, minus_zero, zero}, {T(0.5), T(0.5), T(0.5), T(0.5)}},
        {{T(-0.5), T(0.5), T(-0.5), T(0.5)}, {minus_zero, zero, zero, minus_zero}},
        // Underflows to -0.
        {{0, 0, 0, -least}, {0, 0, 0, least}},
    };
    quat_buffer<T> q(std::size(pairs), layout::soa), neighbour(std::size(pairs), layout::soa),
        out(std::size(pairs), layout::soa);
    for (std::size_t i = 0; i < q.size(); ++i) {
        q.set(i, pairs[i].q);
        neighbour.set(i, pairs[i].neighbour);
    }
    for (precision p : both_precisions) {
        ASSERT_EQ(align_signs(q.view(), neighbour.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < q.size(); ++i)
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(same_bits(out.at(c, i), q.at(c, i))) << i;
    }
}

TEST_P(Algebra, AlignSignsLeavesAPerpendicularElementAsItIs) {
    perpendicular_stays<float>();
    perpendicular_stays<double>();
}

TEST_P(Algebra, InPlaceInAnyPairingGivesTheSameBits) {
    constexpr std::size_t count = 67;
    generator g(14);
    for (precision p : both_precisions) {
        const options o{.accuracy = p};
        quat_buffer<float> a(count, layout::soa), b(count, layout::soa), want(count, layout::soa);
        vec3_buffer<float> v(count, layout::soa), turned_want(count, layout::soa);
        fill(a, g);
        fill(b, g);
        for (std::size_t i = 0; i < count; ++i) v.set(i, random_vector<float>(g, -30, 30));
        const auto same = [&](const quat_view<const float>& got, const char* what) {
            for (std::size_t i = 0; i < count; ++i)
                ASSERT_EQ((quat<float>{got.x[i], got.y[i], got.z[i], got.w[i]}), want.get(i)) << what << i;
        };
        const quat_view<float> q = b.view(), rolled = soa(q.w, q.x, q.y, q.z, count);
        ASSERT_EQ(rotate(a.view(), v.view(), turned_want.view(), o), status::ok);
        ASSERT_EQ(rotate(a.view(), v.view(), v.view(), o), status::ok);
        for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(v.get(i), turned_want.get(i));

        ASSERT_EQ(multiply(a.view(), q, want.view(), o), status::ok);
        ASSERT_EQ(multiply(a.view(), q, rolled, o), status::ok);
        same(rolled, "multiply ");
        ASSERT_EQ(align_signs(a.view(), q, want.view(), o), status::ok);
        ASSERT_EQ(align_signs(a.view(), q, rolled, o), status::ok);
        same(rolled, "align_signs ");
        ASSERT_EQ(normalize(q, want.view(), o), status::ok);
        ASSERT_EQ(normalize(q, rolled, o), status::ok);
        same(rolled, "normalize ");
        ASSERT_EQ(conjugate(q, want.view(), o), status::ok);
        ASSERT_EQ(conjugate(q, rolled, o), status::ok);
        same(rolled, "conjugate ");
        scalar_buffer<float> product(count, layout::soa);
        ASSERT_EQ(dot(a.view(), q, product.view(), o), status::ok);
        ASSERT_EQ(dot(a.view(), q, scalar_view<float>{q.y, count}, o), status::ok);
        for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(q.y[i], product[i]);
    }
}

}  // namespace
}  // namespace swivel::tests
