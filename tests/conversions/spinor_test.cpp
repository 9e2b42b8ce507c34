#include "swivel/spinor.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/multivector.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class Spinor : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Spinor, testing::ValuesIn(usable_isas()), isa_name);

struct spinor {
    double a, b, c, d;

    // e31 is -e13.
    multivector whole() const { return {a, 0, 0, b, 0, -d, c, 0}; }
    multivector inverse() const {
        const double n = a * a + b * b + c * c + d * d;
        return {a / n, 0, 0, -b / n, 0, d / n, -c / n, 0};
    }
};

// Formula (3) of the paper.
vec3<double> turned(const spinor& s, const vec3<double>& v) {
    const multivector p = product(product(s.whole(), {0, v.x, v.y, 0, v.z, 0, 0, 0}), s.inverse());
    return {p[1], p[2], p[4]};
}

vec3<double> turned(const quat<double>& q, const vec3<double>& v) {
    const quat<double> p = times(times(q, {v.x, v.y, v.z, 0}), conjugate(q));
    const double n = dot(q, q);
    return {p.x / n, p.y / n, p.z / n};
}

double distance(const vec3<double>& a, const vec3<double>& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

spinor_view<double> spinors(quat_buffer<double>& b) {
    return {b.first(0), b.first(1), b.first(2), b.first(3), b.size(), b.stride()};
}

TEST_P(Spinor, TurnsVectorsAsItsQuaternionDoesAndTheMapWithoutSignsDoesNot) {
    constexpr std::size_t n = 101;
    generator g(1);
    quat_buffer<double> s(n, layout::soa), q(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) s.set(i, random_rotation<double>(g));
    ASSERT_EQ(from_spinor(spinors(s), q.view()), status::ok);
    double nearest = 10;
    for (std::size_t i = 0; i < n; ++i) {
        const spinor in{s.at(0, i), s.at(1, i), s.at(2, i), s.at(3, i)};
        const vec3<double> v = random_direction<double>(g), want = turned(in, v);
        EXPECT_LE(distance(turned(q.get(i), v), want), 1e-14);
        const quat<double> without_signs{in.c, in.d, in.b, in.a};
        EXPECT_LE(distance(turned(conjugate(without_signs), v), want), 1e-14);
        nearest = std::min(nearest, -distance(turned(without_signs, v), want));
    }
    EXPECT_LE(nearest, -1.5);
}

TEST_P(Spinor, ProductsOfSpinorsAreProductsOfQuaternions) {
    constexpr std::size_t n = 50;
    generator g(2);
    quat_buffer<double> s(2 * n, layout::soa), q(2 * n, layout::soa);
    for (std::size_t i = 0; i < 2 * n; ++i) s.set(i, random_rotation<double>(g));
    ASSERT_EQ(from_spinor(spinors(s), q.view()), status::ok);
    for (std::size_t i = 0; i < 2 * n; i += 2) {
        const spinor l{s.at(0, i), s.at(1, i), s.at(2, i), s.at(3, i)};
        const spinor r{s.at(0, i + 1), s.at(1, i + 1), s.at(2, i + 1), s.at(3, i + 1)};
        const multivector p = product(l.whole(), r.whole());
        const quat<double> want{-p[6], p[5], -p[3], p[0]};
        EXPECT_LE(norm(minus(times(q.get(i), q.get(i + 1)), want)), 1e-15);
    }
}

template <class T>
void exact_moves() {
    const std::vector<quat<T>> corners = corner_rotations<T>();
    const std::size_t n = corners.size();
    for (const layout l : all_layouts) {
        quat_buffer<T> q(n, l), s(n, l);
        for (std::size_t i = 0; i < n; ++i) q.set(i, corners[i]);
        const spinor_view<T> view{s.first(0), s.first(1), s.first(2), s.first(3), n, s.stride()};
        ASSERT_EQ(to_spinor(q.view(), view), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_TRUE(same_bits(s.at(0, i), corners[i].w));
            ASSERT_TRUE(same_bits(s.at(1, i), -corners[i].z));
            ASSERT_TRUE(same_bits(s.at(2, i), -corners[i].x));
            ASSERT_TRUE(same_bits(s.at(3, i), -corners[i].y));
        }
        // In place, component for component: c where x was.
        const quat_view<T> v = q.view();
        const spinor_view<T> same{v.w, v.z, v.x, v.y, n, v.stride};
        ASSERT_EQ(to_spinor(v, same), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_TRUE(same_bits(q.at(0, i), -corners[i].x));
            ASSERT_TRUE(same_bits(q.at(3, i), corners[i].w));
        }
        ASSERT_EQ(from_spinor(same, v), status::ok);
        quat_buffer<T> back(n, l);
        ASSERT_EQ(from_spinor(view, back.view()), status::ok);
        for (std::size_t i = 0; i < n; ++i)
            for (int c = 0; c < 4; ++c) {
                const T want[] = {corners[i].x, corners[i].y, corners[i].z, corners[i].w};
                ASSERT_TRUE(same_bits(q.at(c, i), want[c]));
                ASSERT_TRUE(same_bits(back.at(c, i), want[c]));
            }
    }
}

TEST_P(Spinor, ComponentsAreMovedExactlyAndBack) {
    exact_moves<float>();
    exact_moves<double>();
}

}  // namespace
}  // namespace swivel::tests
