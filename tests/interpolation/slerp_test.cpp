#include "swivel/slerp.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/interpolation.hpp"
#include "support/usable_isas.hpp"
#include "swivel/nlerp.hpp"

namespace swivel::tests {
namespace {

class Slerp : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Slerp, testing::ValuesIn(usable_isas()), isa_name);
class Nlerp : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Nlerp, testing::ValuesIn(usable_isas()), isa_name);

template <class T>
quat<T> one(bool is_slerp, const quat<T>& a, const quat<T>& b, T t, const options& o) {
    quat_buffer<T> from(1, layout::soa), to(1, layout::soa), out(1, layout::soa);
    from.set(0, a);
    to.set(0, b);
    EXPECT_EQ(is_slerp ? slerp(from.view(), to.view(), t, out.view(), o)
                       : nlerp(from.view(), to.view(), t, out.view(), o),
              status::ok);
    return out.get(0);
}

// The largest distance from the formula, and of the norm from 1, in units of rounding. Pairs at all
// distances, the short way; on the long way those whose direction is known.
template <class T>
struct errors {
    double distance = 0, norm = 0;
};

template <class T>
errors<T> measure(bool is_slerp, bool long_way, precision p) {
    constexpr std::size_t n = 40009;
    generator g(31);
    quat_buffer<T> a(n, layout::soa), b(n, layout::soa), out(n, layout::soa);
    scalar_buffer<T> t(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        a.set(i, random_rotation<T>(g));
        b.set(i, i % 2 == 0 ? random_rotation<T>(g)
                            : neighbour(g, a.get(i), std::ldexp(1.0, -static_cast<int>(i % 50))));
        t[i] = static_cast<T>(uniform(g, -0.25, 1.25));
        if (!long_way && i % 8 == 7) {
            // Where the norm is worst.
            const quat<T> from = a.get(i);
            b.set(i, neighbour<T>(g, {-from.x, -from.y, -from.z, -from.w},
                                  std::ldexp(1.0, -static_cast<int>(i % 25))));
            t[i] = static_cast<T>(uniform(g, 1, 1.25));
        }
    }
    const options o{.accuracy = p, .long_way = long_way};
    const status s = is_slerp ? slerp(a.view(), b.view(), t.view(), out.view(), o)
                              : nlerp(a.view(), b.view(), t.view(), out.view(), o);
    EXPECT_EQ(s, status::ok);
    errors<T> worst;
    for (std::size_t i = 0; i < n; ++i) {
        const auto from = unit_of(a.get(i)), to = on_the_way(from, unit_of(b.get(i)), long_way);
        const long double chord = norm(sum(1.0L, from, 1.0L, to));
        if (long_way && chord < 0.05L) continue;
        const auto want = is_slerp ? exact_slerp(from, to, t[i]) : exact_nlerp(from, to, t[i]);
        const auto got = widen<long double>(out.get(i));
        // What the direction is worth, and for the chord its length.
        const long double scale = is_slerp
                                      ? std::min(1.0L, chord)
                                      : std::min(1.0L, norm(sum(1.0L - t[i], from, (long double)t[i], to)));
        worst.distance = std::max(worst.distance, double(norm(minus(got, want)) * scale) / rounding_unit<T>);
        worst.norm = std::max(worst.norm, double(std::fabs(norm(got) - 1)) / rounding_unit<T>);
    }
    return worst;
}

template <class T>
void expect_within(bool is_slerp, bool long_way, precision p, double distance, double norm) {
    const errors<T> worst = measure<T>(is_slerp, long_way, p);
    EXPECT_LE(worst.distance, distance)
        << (long_way ? "long " : "short ") << static_cast<int>(p) << sizeof(T);
    EXPECT_LE(worst.norm, norm) << (long_way ? "long " : "short ") << static_cast<int>(p) << sizeof(T);
}

TEST_P(Slerp, IsWithinItsBoundsOfTheFormula) {
    for (const bool long_way : {false, true}) {
        expect_within<float>(true, long_way, precision::reproducible, 6, 6.5);
        expect_within<float>(true, long_way, precision::fast, 9, 8);
        expect_within<double>(true, long_way, precision::reproducible, 6, 6.5);
        expect_within<double>(true, long_way, precision::fast, 9, 8);
    }
}

TEST_P(Nlerp, IsWithinItsBoundsOfTheFormula) {
    for (const bool long_way : {false, true}) {
        expect_within<float>(false, long_way, precision::reproducible, 4, 3.5);
        expect_within<float>(false, long_way, precision::fast, 5, 4.5);
        expect_within<double>(false, long_way, precision::reproducible, 4, 3.5);
        expect_within<double>(false, long_way, precision::fast, 5, 4.5);
    }
}

// The bits of the ends, with the sign of the second one's way.
template <class T>
void ends_are_exact(bool is_slerp) {
    generator g(5);
    std::vector<quat<T>> rotations = corner_rotations<T>();
    for (int i = 0; i < 100; ++i) rotations.push_back(random_rotation<T>(g));
    for (const bool long_way : {false, true})
        for (const quat<T>& a : rotations) {
            const quat<T>& b = rotations[g() % rotations.size()];
            const options o{.accuracy = precision::reproducible, .long_way = long_way};
            const auto bits = [](const quat<T>& q) {
                return std::array{std::bit_cast<bits_of<T>>(q.x), std::bit_cast<bits_of<T>>(q.y),
                                  std::bit_cast<bits_of<T>>(q.z), std::bit_cast<bits_of<T>>(q.w)};
            };
            ASSERT_EQ(bits(one<T>(is_slerp, a, b, T(0), o)), bits(a));
            ASSERT_EQ(bits(one<T>(is_slerp, a, b, T(-0.0), o)), bits(a));
            const auto end = bits(one<T>(is_slerp, a, b, T(1), o));
            ASSERT_TRUE(end == bits(b) || end == bits(quat<T>{-b.x, -b.y, -b.z, -b.w}));
        }
}

TEST_P(Slerp, EndsHaveTheBitsOfTheInputInReproducible) {
    ends_are_exact<float>(true);
    ends_are_exact<double>(true);
}
TEST_P(Nlerp, EndsHaveTheBitsOfTheInputInReproducible) {
    ends_are_exact<float>(false);
    ends_are_exact<double>(false);
}

// From a rotation to itself the long way, and to its negative: a full turn about x.
template <class T>
void full_turn(bool is_slerp) {
    const quat<T> a{T(0.5), T(-0.5), T(0.1), T(0.7)};
    for (const precision p : both_precisions)
        for (const T sign : {T(1), T(-1)}) {
            const quat<T> b{sign * a.x, sign * a.y, sign * a.z, sign * a.w};
            const quat<T> half = one<T>(is_slerp, a, b, T(0.5), {.accuracy = p, .long_way = true});
            const quat<T> want = normalized_turn_about_x(a);
            EXPECT_NEAR(half.x, want.x, 4 * rounding_unit<T>);
            EXPECT_NEAR(half.y, want.y, 4 * rounding_unit<T>);
            EXPECT_NEAR(half.z, want.z, 4 * rounding_unit<T>);
            EXPECT_NEAR(half.w, want.w, 4 * rounding_unit<T>);
            const quat<T> still = one<T>(is_slerp, a, b, T(0.5), {.accuracy = p});
            EXPECT_NEAR(still.x * a.w, a.x * still.w, 8 * rounding_unit<T>) << "the short way stays";
        }
}

TEST_P(Slerp, TheLongWayToItselfIsAFullTurnAboutX) {
    full_turn<float>(true);
    full_turn<double>(true);
}
// All of that way, of quaternions of any length.
template <class T>
void whole_full_turn() {
    const exact_quat a = unit_of(quat<T>{T(0.5), T(-0.5), T(0.1), T(0.7)}), middle{a.w, -a.z, a.y, -a.x};
    const int most = sizeof(T) == 4 ? 30 : 250;
    for (const precision p : both_precisions)
        for (const int e : {-most, -most / 2, 0, most})
            for (int k = 0; k <= 16; ++k) {
                const T t = static_cast<T>(k) / 16;
                const quat<T> from{
                    static_cast<T>(std::ldexp(T(0.5), e)), static_cast<T>(std::ldexp(T(-0.5), e)),
                    static_cast<T>(std::ldexp(T(0.1), e)), static_cast<T>(std::ldexp(T(0.7), e))};
                const quat<T> got = one<T>(true, from, from, t, {.accuracy = p, .long_way = true});
                // There the bits of what was given come out.
                if (p == precision::reproducible && (k == 0 || k == 16)) continue;
                const long double angle = 3.14159265358979323846264L * t;
                const exact_quat want = sum(std::cos(angle), a, std::sin(angle), middle);
                EXPECT_LE(double(norm(minus(widen<long double>(got), want))),
                          (p == precision::fast ? 9 : 6) * rounding_unit<T>)
                    << "length 2^" << e << ", t = " << t;
            }
}

TEST_P(Slerp, TheLongWayToItselfIsThatTurnAllAlong) {
    whole_full_turn<float>();
    whole_full_turn<double>();
}
TEST_P(Nlerp, TheLongWayToItselfPassesTheHalfTurnAboutX) {
    full_turn<float>(false);
    full_turn<double>(false);
}

// About z by 90 degrees: a quarter of the way is 22.5 degrees, twice the way 180, and the long way goes
// backwards.
TEST_P(Slerp, MovesAtConstantSpeedAndExtrapolates) {
    const auto about_z = [](double degrees) {
        const double half = degrees * 3.14159265358979323846 / 360;
        return quat<double>{0, 0, std::sin(half), std::cos(half)};
    };
    const quat<double> a = about_z(10), b = about_z(100);
    for (const double t : {-1.0, -0.25, 0.25, 0.5, 2.0, 3.0}) {
        const quat<double> r = one<double>(true, a, b, t, {}), want = about_z(10 + 90 * t);
        EXPECT_NEAR(r.z, want.z, 1e-15);
        EXPECT_NEAR(r.w, want.w, 1e-15);
        const quat<double> l = one<double>(true, a, b, t, {.long_way = true}),
                           want_long = about_z(10 - 270 * t);
        EXPECT_NEAR(l.z, want_long.z, 1e-15);
        EXPECT_NEAR(l.w, want_long.w, 1e-15);
    }
}

TEST_P(Nlerp, GoesThroughTheMiddleOfSlerp) {
    generator g(8);
    for (int i = 0; i < 200; ++i) {
        const quat<double> a = random_rotation<double>(g), b = random_rotation<double>(g);
        const quat<double> s = one<double>(true, a, b, 0.5, {}), n = one<double>(false, a, b, 0.5, {});
        EXPECT_NEAR(s.x, n.x, 1e-15);
        EXPECT_NEAR(s.w, n.w, 1e-15);
    }
}

TEST_P(Slerp, MayBeInPlace) {
    quat_buffer<float> a(37, layout::aos_xyzw), b(37, layout::aos_xyzw), out(37, layout::aos_xyzw);
    generator g(9);
    for (std::size_t i = 0; i < 37; ++i)
        a.set(i, random_rotation<float>(g)), b.set(i, random_rotation<float>(g));
    ASSERT_EQ(slerp(a.view(), b.view(), 0.3F, out.view()), status::ok);
    ASSERT_EQ(slerp(a.view(), b.view(), 0.3F, b.view()), status::ok);
    for (std::size_t i = 0; i < 37; ++i) EXPECT_EQ(b.get(i), out.get(i));
    EXPECT_EQ(slerp(a.view(), b.view(), scalar_view<float>{a.first(0), 37, 1}, b.view()), status::ok);
    EXPECT_EQ(slerp(a.view(), b.view(), scalar_view<float>{b.first(0) + 2, 37, 2}, b.view()),
              status::partial_overlap);
    EXPECT_EQ(slerp(a.view(), b.view(), scalar_view<float>{a.first(0), 36}, b.view()), status::size_mismatch);
}

}  // namespace
}  // namespace swivel::tests
