// The golden vectors of square_root and shortest_arc.

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/golden.hpp"
#include "support/usable_isas.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class GoldenRoots : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, GoldenRoots, testing::ValuesIn(usable_isas()), isa_name);

template <class T>
void check_root(const nlohmann::json& e, precision p) {
    using W = wide<T>;
    const quat<double> in = golden_quat(e.at("q"));
    quat_buffer<T> q(1, layout::soa), out(1, layout::soa);
    q.set(0, {T(in.x), T(in.y), T(in.z), T(in.w)});
    ASSERT_EQ(square_root(q.view(), out.view(), {.accuracy = p}), status::ok);
    const quat<W> want = widen<W>(golden_quat(e.at("r")));
    EXPECT_LE(double(norm(minus(widen<W>(out.get(0)), want))),
              (p == precision::fast ? 6.5 : 4) * rounding_unit<T>)
        << e.dump();
}

template <class T>
void check_arc(const nlohmann::json& e, precision p) {
    using W = wide<T>;
    const auto v = e.at("v").get<std::array<T, 3>>(), w = e.at("w").get<std::array<T, 3>>();
    vec3_buffer<T> from(1, layout::soa), to(1, layout::soa);
    quat_buffer<T> out(1, layout::soa);
    from.set(0, {v[0], v[1], v[2]});
    to.set(0, {w[0], w[1], w[2]});
    ASSERT_EQ(shortest_arc(from.view(), to.view(), out.view(), {.accuracy = p}), status::ok);
    const quat<W> got = widen<W>(out.get(0));
    const vec3<W> a = unit(widen<W>(from.get(0))), b = unit(widen<W>(to.get(0)));
    const quat<W> turned = times(times(got, {a.x, a.y, a.z, 0}), conjugate(got));
    EXPECT_LE(double(norm(minus(turned, {b.x, b.y, b.z, 0}))),
              (p == precision::fast ? 11 : 7) * rounding_unit<T>)
        << e.dump();
    EXPECT_LE(double(magnitude(norm(got) - 1)), (p == precision::fast ? 4 : 3) * rounding_unit<T>)
        << e.dump();
    // Of opposite vectors there is no more to say.
    if (e.at("r").is_null()) return;
    const double apart = double(norm(quat<W>{a.x + b.x, a.y + b.y, a.z + b.z, 0}));
    EXPECT_LE(double(norm(minus(got, widen<W>(golden_quat(e.at("r")))))), 10 / apart * rounding_unit<T>)
        << e.dump();
}

template <class Check>
void all(const char* section, Check check) {
    const nlohmann::json vectors = golden_section(section);
    if (vectors.is_null()) GTEST_SKIP() << "no golden vectors";
    ASSERT_GE(vectors.size(), 30U);
    for (const nlohmann::json& e : vectors)
        for (const precision p : {precision::fast, precision::reproducible}) check(e, p);
}

TEST_P(GoldenRoots, SquareRoot) {
    all("qsqrt", check_root<float>);
    all("qsqrt", check_root<double>);
}

TEST_P(GoldenRoots, ShortestArc) {
    all("arc", check_arc<float>);
    all("arc", check_arc<double>);
}

}  // namespace
}  // namespace swivel::tests
