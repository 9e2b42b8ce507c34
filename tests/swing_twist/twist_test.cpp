#include "swivel/twist.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class Twist : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Twist, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 5003;

template <class T>
void is_a_projection() {
    using W = wide<T>;
    generator g(1);
    quat_buffer<T> q(n, layout::soa), t(n, layout::soa), again(n, layout::soa), of_conjugate(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, random_rotation<T>(g));
    const vec3<T> a{2, -1, 3};
    for (precision p : {precision::fast, precision::reproducible}) {
        const options o{.accuracy = p};
        ASSERT_EQ(twist(q.view(), a, t.view(), o), status::ok);
        ASSERT_EQ(twist(t.view(), a, again.view(), o), status::ok);
        quat_buffer<T> conjugated(n, layout::soa);
        for (std::size_t i = 0; i < n; ++i) {
            const quat<T> v = q.get(i);
            conjugated.set(i, {-v.x, -v.y, -v.z, v.w});
        }
        ASSERT_EQ(twist(conjugated.view(), a, of_conjugate.view(), o), status::ok);
        const vec3<W> axis = unit(widen<W>(a));
        for (std::size_t i = 0; i < n; ++i) {
            const quat<W> T1 = widen<W>(t.get(i)), in = widen<W>(q.get(i));
            ASSERT_LE(double(norm(minus(widen<W>(again.get(i)), T1))), 8 * rounding_unit<T>)
                << "idempotent " << i;
            ASSERT_EQ(of_conjugate.get(i), (quat<T>{-t.get(i).x, -t.get(i).y, -t.get(i).z, t.get(i).w}));
            // Of all unit quaternions about the axis, the one closest to q: <q, T> = sqrt(w^2 + (a.v)^2).
            const W u = along(axis, in);
            ASSERT_NEAR(double(dot(in, T1)), double(root(in.w * in.w + u * u)), 8 * rounding_unit<T>) << i;
        }
    }
}

TEST_P(Twist, IsTheProjectionOnTheAxis) {
    is_a_projection<float>();
    is_a_projection<double>();
}

TEST_P(Twist, IsTheSameInBothProducts) {
    generator g(2);
    quat_buffer<float> q(n, layout::soa), a(n, layout::soa), b(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, random_rotation<float>(g));
    for (const twist_axis<float>& by : {twist_axis<float>(axis::x), twist_axis<float>(axis::y)}) {
        const options o{.order = product::twist_swing, .accuracy = precision::reproducible};
        ASSERT_EQ(twist(q.view(), by, a.view(), {.accuracy = precision::reproducible}), status::ok);
        ASSERT_EQ(twist(q.view(), by, b.view(), o), status::ok);
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(a.get(i), b.get(i));
    }
}

// A filter that scales the twist of a swung joint: half of a 90 degree twist is 45 degrees whatever the
// swing, and the angle passes 90 degrees without a jump.
TEST_P(Twist, DoesNotDependOnTheSwing) {
    quat_buffer<double> q(1, layout::soa), t(1, layout::soa);
    for (int degrees = 0; degrees <= 178; ++degrees) {
        const double swing = degrees * 0.017453292519943295, half_twist = 0.7853981633974483;
        const quat<double> S{std::sin(swing / 2), 0, 0, std::cos(swing / 2)};
        const quat<double> T0{0, 0, std::sin(half_twist), std::cos(half_twist)};
        q.set(0, times(S, T0));
        ASSERT_EQ(twist(q.view(), axis::z, t.view()), status::ok);
        const double angle = 2 * std::atan2(t.get(0).z, t.get(0).w) * 57.29577951308232;
        ASSERT_NEAR(angle, 90, 1e-11) << degrees;
    }
}

}  // namespace
}  // namespace swivel::tests
