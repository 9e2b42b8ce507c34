// The golden vectors: results of the exact inputs to 40 digits, with the tolerances that come with them.

#include "support/golden.hpp"

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/usable_isas.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class Golden : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Golden, testing::ValuesIn(usable_isas()), isa_name);

struct vector {
    std::string category;
    quat<double> q;
    vec3<double> a;
    double closeness;  // sqrt(w^2 + (a.v)^2) / |q|
    double tc, ts;
    quat<double> swing, reversed;
    bool singular;
};

std::vector<vector> read_golden(const nlohmann::json& section) {
    std::vector<vector> all;
    for (const nlohmann::json& e : section) {
        vector v;
        v.category = e.at("k").get<std::string>();
        const auto a = e.at("a").get<std::array<double, 3>>();
        const auto r = e.at("r").get<std::array<double, 3>>();
        v.q = golden_quat(e.at("q"));
        v.a = {a[0], a[1], a[2]};
        v.closeness = e.at("rt").get<double>();
        v.tc = e.at("tc").get<double>();
        v.ts = e.at("ts").get<double>();
        v.swing = golden_quat(e.at("s"));
        v.reversed = {r[0], r[1], r[2], v.swing.w};
        v.singular = e.value("sing", 0) == 1;
        all.push_back(v);
    }
    return all;
}

// Lengths that the domain of decompose does not contain (decompose.hpp); the axis may have any.
template <class T>
bool in_domain(const quat<double>& q) {
    const double n = norm(q);
    return n == 0 || (n >= (sizeof(T) == 4 ? 0x1p-26 : 0x1p-427) && n < (sizeof(T) == 4 ? 0x1p63 : 0x1p511));
}

template <class T>
bool is_coordinate(const vec3<T>& a, axis& which) {
    if (a == vec3<T>{1, 0, 0}) return which = axis::x, true;
    if (a == vec3<T>{0, 1, 0}) return which = axis::y, true;
    if (a == vec3<T>{0, 0, 1}) return which = axis::z, true;
    return false;
}

template <class T>
void matches(const vector& v, const twist_axis<T>& by, bool coordinate, precision p) {
    using W = wide<T>;
    const double unit_error = rounding_unit<T>;
    for (product order : {product::swing_twist, product::twist_swing}) {
        quat_buffer<T> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
        q.set(0, {T(v.q.x), T(v.q.y), T(v.q.z), T(v.q.w)});
        ASSERT_EQ(decompose(q.view(), by, s.view(), t.view(), {.order = order, .accuracy = p}), status::ok);
        const quat<W> in = widen<W>(q.get(0)), S = widen<W>(s.get(0)), Tw = widen<W>(t.get(0));
        const vec3<W> a = unit(widen<W>(v.a));
        const double length = double(norm(in));
        const quat<W> back = order == product::swing_twist ? times(S, Tw) : times(Tw, S);
        EXPECT_LE(double(norm(minus(back, in))), 16 * unit_error * length) << v.category;
        EXPECT_LE(double(magnitude(norm(Tw) - 1)), 8 * unit_error) << v.category;
        EXPECT_LE(double(magnitude(along(a, S))), 8 * unit_error * length) << v.category;
        EXPECT_GE(double(S.w), 0.0);

        const quat<W> twist_want{v.ts * a.x, v.ts * a.y, v.ts * a.z, v.tc};
        const quat<double> swing_of_order = order == product::swing_twist ? v.swing : v.reversed;
        const quat<W> swing_want = widen<W>(swing_of_order);
        // Elements below the threshold get the stated replacement instead of the mathematical result.
        const double threshold = std::sqrt(sizeof(T) == 4 ? 0x1p-48 : 0x1p-106);
        if (!v.singular && v.closeness < threshold * 1.01) continue;
        const double tolerance = v.singular   ? 0
                                 : coordinate ? 16 * unit_error
                                              : (8 + 2 / v.closeness) * unit_error;
        EXPECT_LE(double(norm(minus(Tw, twist_want))), tolerance) << v.category;
        EXPECT_LE(double(norm(minus(S, swing_want))), tolerance * length) << v.category;
    }
}

template <class T>
void all_vectors() {
    const nlohmann::json section = golden_section("decompose");
    if (section.is_null()) GTEST_SKIP() << "no golden vectors";
    const std::vector<vector> all = read_golden(section);
    ASSERT_GE(all.size(), 100U);
    std::size_t checked = 0;
    for (const vector& v : all) {
        if (!in_domain<T>(v.q)) continue;
        ++checked;
        const vec3<T> a{T(v.a.x), T(v.a.y), T(v.a.z)};
        for (precision p : {precision::fast, precision::reproducible}) {
            axis which;
            const bool coordinate = is_coordinate(a, which);
            if (coordinate) matches<T>(v, which, true, p);
            matches<T>(v, a, coordinate, p);
            vec3_buffer<T> own(1, layout::soa);
            own.set(0, a);
            matches<T>(v, own.view(), false, p);
        }
    }
    // Only scaled quaternions may be outside.
    EXPECT_GE(checked + 10, all.size());
}

TEST_P(Golden, DecomposeFloat) { all_vectors<float>(); }
TEST_P(Golden, DecomposeDouble) { all_vectors<double>(); }

}  // namespace
}  // namespace swivel::tests
