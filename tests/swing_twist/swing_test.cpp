#include "swivel/swing.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class Swing : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Swing, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 5003;

template <class W>
vec3<W> rotate(const quat<W>& q, const vec3<W>& v) {
    const quat<W> r = times(times(q, {v.x, v.y, v.z, 0}), conjugate(q));
    return {r.x, r.y, r.z};
}

template <class W>
W distance(const vec3<W>& a, const vec3<W>& b) {
    return root((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

// q = S T: S takes the axis where q takes it. q = T R: R takes to the axis what q takes there.
template <class T>
void moves_the_axis_as_q_does() {
    using W = wide<T>;
    generator g(1);
    quat_buffer<T> q(n, layout::soa), s(n, layout::soa);
    const vec3<T> a{1, -2, 2};
    const vec3<W> axis = unit(widen<W>(a));
    for (std::size_t i = 0; i < n; ++i)
        q.set(i, i % 2 == 0 ? random_rotation<T>(g)
                            : near_pole<T>(g, a, std::ldexp(1.0, -static_cast<int>(i % 20))));
    for (precision p : {precision::fast, precision::reproducible}) {
        ASSERT_EQ(swing(q.view(), a, s.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const quat<W> in = widen<W>(q.get(i)), S = widen<W>(s.get(i));
            ASSERT_LE(double(distance(rotate(S, axis), rotate(in, axis))), 40 * rounding_unit<T>) << i;
        }
        ASSERT_EQ(swing(q.view(), a, s.view(), {.order = product::twist_swing, .accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const quat<W> in = widen<W>(q.get(i)), R = widen<W>(s.get(i));
            ASSERT_LE(double(distance(rotate(conjugate(R), axis), rotate(conjugate(in), axis))),
                      40 * rounding_unit<T>)
                << i;
        }
    }
}

TEST_P(Swing, MovesTheAxisAsTheInputDoes) {
    moves_the_axis_as_q_does<float>();
    moves_the_axis_as_q_does<double>();
}

TEST_P(Swing, OfATwistIsTheIdentity) {
    quat_buffer<double> q(n, layout::soa), s(n, layout::soa);
    generator g(2);
    const vec3<double> a = unit(vec3<double>{3, 4, 12});
    for (std::size_t i = 0; i < n; ++i) {
        const double half = uniform(g, -3.1, 3.1), k = std::sin(half);
        q.set(i, {a.x * k, a.y * k, a.z * k, std::cos(half)});
    }
    ASSERT_EQ(swing(q.view(), a, s.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i)
        ASSERT_LE(norm(minus(s.get(i), quat<double>{0, 0, 0, 1})), 16 * rounding_unit<double>) << i;
}

TEST_P(Swing, PositiveTwistMakesNoDifference) {
    quat_buffer<float> q(n, layout::soa), a(n, layout::soa), b(n, layout::soa);
    generator g(3);
    for (std::size_t i = 0; i < n; ++i) q.set(i, random_rotation<float>(g));
    ASSERT_EQ(swing(q.view(), axis::y, a.view(), {}), status::ok);
    ASSERT_EQ(swing(q.view(), axis::y, b.view(), {.positive_twist = true}), status::ok);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(a.get(i), b.get(i));
}

}  // namespace
}  // namespace swivel::tests
