// The golden vectors of motors: 12 units relative to the size of the translations.

#include <gtest/gtest.h>

#include "support/golden.hpp"
#include "support/motors.hpp"
#include "support/usable_isas.hpp"
#include "swivel/motor.hpp"

namespace swivel::tests {
namespace {

class GoldenMotors : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, GoldenMotors, testing::ValuesIn(usable_isas()), isa_name);

constexpr double bound = 12;

exact_vec3 exact_vector(const nlohmann::json& numbers, std::size_t first = 0) {
    return {numbers.at(first).get<long double>(), numbers.at(first + 1).get<long double>(),
            numbers.at(first + 2).get<long double>()};
}

dual_quaternion<long double> exact_motor(const nlohmann::json& m) {
    const auto quaternion = [&](std::size_t at) {
        const exact_vec3 v = exact_vector(m, at + 1);
        return exact_quat{v.x, v.y, v.z, m.at(at).get<long double>()};
    };
    return {quaternion(0), quaternion(4)};
}

template <class T>
double error(const dual_quaternion<T>& got, const dual_quaternion<long double>& want, long double size) {
    const auto parts = [&](const quat<T>& a, const exact_quat& b) {
        return norm(minus(widen<long double>(a), b));
    };
    return double(std::max(parts(got.r, want.r), parts(got.d, want.d) / size)) / rounding_unit<T>;
}

template <class T>
double error(const vec3<T>& got, const exact_vec3& want, long double size) {
    return double(norm(sum(widen<long double>(got), -1, want)) / size) / rounding_unit<T>;
}

template <class T>
void check(const nlohmann::json& v, precision p) {
    const auto pose = [&](const char* q, const char* t) {
        return motion{unit_of(golden_quat(v.at(q))), exact_vector(v.at(t))};
    };
    const motion m1 = pose("q1", "t1"), m2 = pose("q2", "t2");
    const long double size = std::max({1.0L, norm(m1.t), norm(m2.t)});
    motor_buffer<T> a(1, layout::soa), b(1, layout::soa), out(1, layout::soa);
    vec3_buffer<T> rotational(1, layout::soa), translational(1, layout::soa);
    a.set(0, rounded<T>(m1));
    b.set(0, rounded<T>(m2));
    const options o{.accuracy = p};
    ASSERT_EQ(square_root(a.view(), out.view(), o), status::ok);
    EXPECT_LE(error(out.get(0), exact_motor(v.at("sqrt")), size), bound) << "sqrt " << v.at("k");
    ASSERT_EQ(log(a.view(), rotational.view(), translational.view(), o), status::ok);
    EXPECT_LE(error(rotational.get(0), exact_vector(v.at("log")), 1), bound) << "log " << v.at("k");
    EXPECT_LE(error(translational.get(0), exact_vector(v.at("log"), 3), size), bound) << "log " << v.at("k");
    ASSERT_EQ(exp(rotational.view(), translational.view(), out.view(), o), status::ok);
    EXPECT_LE(error(out.get(0), rounded<long double>(m1), size), bound) << "exp " << v.at("k");
    const T s = v.at("s").get<T>();
    ASSERT_EQ(sclerp(a.view(), b.view(), s, out.view(), o), status::ok);
    EXPECT_LE(error(out.get(0), exact_motor(v.at("sclerp")), size), bound) << "sclerp " << v.at("k");
}

TEST_P(GoldenMotors, RootLogarithmExponentialAndSclerp) {
    const nlohmann::json vectors = golden_section("motor");
    if (vectors.is_null()) GTEST_SKIP() << "no golden vectors";
    ASSERT_GE(vectors.size(), 30U);
    for (const nlohmann::json& v : vectors)
        for (const precision p : {precision::fast, precision::reproducible}) {
            check<float>(v, p);
            check<double>(v, p);
        }
}

}  // namespace
}  // namespace swivel::tests
