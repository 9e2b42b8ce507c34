#include "swivel/compose.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/decompose.hpp"

namespace swivel::tests {
namespace {

class Compose : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Compose, testing::ValuesIn(usable_isas()), isa_name);

constexpr product both_products[] = {product::swing_twist, product::twist_swing};
constexpr axis all_axes[] = {axis::x, axis::y, axis::z};

template <class T>
void is_the_hamilton_product() {
    using W = wide<T>;
    constexpr std::size_t n = 10007;
    generator g(1);
    quat_buffer<T> s(n, layout::soa), t(n, layout::soa), q(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        s.set(i, random_rotation<T>(g));
        t.set(i, random_rotation<T>(g));
    }
    for (precision p : both_precisions)
        for (product order : both_products) {
            ASSERT_EQ(compose(s.view(), t.view(), q.view(), {.order = order, .accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) {
                const quat<W> l = widen<W>(s.get(i)), r = widen<W>(t.get(i));
                const quat<W> want = order == product::swing_twist ? times(l, r) : times(r, l);
                ASSERT_LE(double(norm(minus(widen<W>(q.get(i)), want))), 4 * rounding_unit<T>) << i;
            }
        }
}

TEST_P(Compose, IsTheHamiltonProductInBothOrders) {
    is_the_hamilton_product<float>();
    is_the_hamilton_product<double>();
}

template <class T>
void compact_is_the_product() {
    using W = wide<T>;
    constexpr std::size_t n = 10007;
    generator g(2);
    factor_buffer<T> f(n);
    quat_buffer<T> q(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        const quat<T> s = random_rotation<T>(g);
        const double half = uniform(g, -3.2, 3.2);
        f.set(i, {s.x, s.y, s.w, static_cast<T>(std::sin(half)), static_cast<T>(std::cos(half))});
    }
    for (precision p : both_precisions)
        for (product order : both_products)
            for (axis a : all_axes) {
                ASSERT_EQ(compose(f.view(), a, q.view(), {.order = order, .accuracy = p}), status::ok);
                const int A = static_cast<int>(a), B = (A + 1) % 3, C = (A + 2) % 3;
                for (std::size_t i = 0; i < n; ++i) {
                    const factors<T> in = f.get(i);
                    W s[4] = {0, 0, 0, W(in.sc)}, t[4] = {0, 0, 0, W(in.tc)};
                    s[B] = in.s1;
                    s[C] = in.s2;
                    t[A] = in.ts;
                    const quat<W> l{s[0], s[1], s[2], s[3]}, r{t[0], t[1], t[2], t[3]};
                    const quat<W> want = order == product::swing_twist ? times(l, r) : times(r, l);
                    ASSERT_LE(double(norm(minus(widen<W>(q.get(i)), want))), 4 * rounding_unit<T>) << i;
                }
            }
}

TEST_P(Compose, CompactFormIsTheProductAboutEachAxis) {
    compact_is_the_product<float>();
    compact_is_the_product<double>();
}

TEST_P(Compose, IdentityLeavesTheOtherFactorExactly) {
    constexpr std::size_t n = 101;
    generator g(3);
    quat_buffer<float> one(n, layout::soa), f(n, layout::soa), q(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        one.set(i, {0, 0, 0, 1});
        f.set(i, random_rotation<float>(g));
    }
    for (precision p : both_precisions)
        for (product order : both_products) {
            ASSERT_EQ(compose(one.view(), f.view(), q.view(), {.order = order, .accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(q.get(i), f.get(i));
            ASSERT_EQ(compose(f.view(), one.view(), q.view(), {.order = order, .accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(q.get(i), f.get(i));
        }
}

// With the signs kept, q itself comes back, not -q: at the pole, with w = -0, everywhere.
template <class T>
void signs_restore() {
    using W = wide<T>;
    const std::vector<quat<T>> corners = corner_rotations<T>();
    const std::size_t n = 1000;
    generator g(4);
    quat_buffer<T> q(n, layout::soa), s(n, layout::soa), t(n, layout::soa), back(n, layout::soa);
    factor_buffer<T> f(n);
    scalar_buffer<T> signs(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, i < 30 ? corners[i] : random_rotation<T>(g));
    for (precision p : both_precisions)
        for (product order : both_products)
            for (axis a : all_axes) {
                const options o{.order = order, .accuracy = p};
                const auto check = [&](const char* form) {
                    for (std::size_t i = 0; i < n; ++i)
                        ASSERT_LE(double(norm(minus(widen<W>(back.get(i)), widen<W>(q.get(i))))),
                                  14 * rounding_unit<T>)
                            << form << ' ' << i;
                };
                ASSERT_EQ(decompose(q.view(), a, s.view(), t.view(), signs.view(), o), status::ok);
                for (std::size_t i = 0; i < n; ++i) {
                    ASSERT_FALSE(std::signbit(t.get(i).w));
                    ASSERT_EQ(signs[i], std::copysign(T(1), q.get(i).w));
                }
                ASSERT_EQ(compose(s.view(), t.view(), signs.view(), back.view(), o), status::ok);
                check("full");
                ASSERT_EQ(decompose(q.view(), a, f.view(), signs.view(), o), status::ok);
                ASSERT_EQ(compose(f.view(), a, signs.view(), back.view(), o), status::ok);
                check("compact");
            }
}

TEST_P(Compose, KeptSignsRestoreTheInputAndNotItsNegative) {
    signs_restore<float>();
    signs_restore<double>();
}

// A filter turns the positive twist by up to 300 degrees, past 180, where its w becomes negative. The
// restored quaternion is that of the same filter on the twist with its own sign.
template <class T>
void filter_past_half_turn() {
    using W = wide<T>;
    constexpr std::size_t n = 1200;
    generator g(5);
    quat_buffer<T> q(n, layout::soa), back(n, layout::soa);
    factor_buffer<T> f(n), plain(n);
    scalar_buffer<T> signs(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, random_rotation<T>(g));
    for (axis a : all_axes) {
        ASSERT_EQ(decompose(q.view(), a, f.view(), signs.view(), {}), status::ok);
        ASSERT_EQ(decompose(q.view(), a, plain.view(), {}), status::ok);
        const auto turn = [](factors<T> in, double half) {
            const double c = std::cos(half), s = std::sin(half);
            const double tc = in.tc * c - in.ts * s, ts = in.ts * c + in.tc * s;
            in.tc = static_cast<T>(tc);
            in.ts = static_cast<T>(ts);
            return in;
        };
        std::size_t past = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double half = (static_cast<double>(i % 11) - 5) * 0.5236;
            f.set(i, turn(f.get(i), half));
            plain.set(i, turn(plain.get(i), half));
            past += f.get(i).tc < 0;
        }
        ASSERT_GT(past, n / 5);
        quat_buffer<T> want(n, layout::soa);
        ASSERT_EQ(compose(plain.view(), a, want.view(), {}), status::ok);
        ASSERT_EQ(compose(f.view(), a, signs.view(), back.view(), {}), status::ok);
        for (std::size_t i = 0; i < n; ++i)
            ASSERT_LE(double(norm(minus(widen<W>(back.get(i)), widen<W>(want.get(i))))), 8 * rounding_unit<T>)
                << i;
    }
}

TEST_P(Compose, TwistPushedPast180DegreesByAFilterIsRestoredRight) {
    filter_past_half_turn<float>();
    filter_past_half_turn<double>();
}

}  // namespace
}  // namespace swivel::tests
