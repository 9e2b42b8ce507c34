// The golden vectors of slerp and sterp.

#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/golden.hpp"
#include "support/usable_isas.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {
namespace {

class GoldenInterpolation : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, GoldenInterpolation, testing::ValuesIn(usable_isas()), isa_name);

template <class T>
void check(const nlohmann::json& e, bool is_sterp, precision p) {
    quat_buffer<T> a(1, layout::soa), b(1, layout::soa), out(1, layout::soa);
    const quat<double> from = golden_quat(e.at("a")), to = golden_quat(e.at("b"));
    const T t = e.at("t").get<T>();
    // At the ends reproducible gives the input itself, which is not of length 1.
    const bool end = p == precision::reproducible && (t == 0 || t == 1);
    const quat<double> want = end ? (t == 0 ? from : to) : golden_quat(e.at("r"));
    a.set(0, {T(from.x), T(from.y), T(from.z), T(from.w)});
    b.set(0, {T(to.x), T(to.y), T(to.z), T(to.w)});
    if (is_sterp) {
        const auto ax = e.at("ax").get<std::array<T, 3>>();
        ASSERT_EQ(sterp(a.view(), b.view(), vec3<T>{ax[0], ax[1], ax[2]}, t, out.view(), {.accuracy = p}),
                  status::ok);
    } else {
        ASSERT_EQ(slerp(a.view(), b.view(), t, out.view(), {.accuracy = p}), status::ok);
    }
    const quat<double> got = widen<double>(out.get(0));
    const double same = norm(minus(got, want)),
                 negative = norm(minus(got, {-want.x, -want.y, -want.z, -want.w}));
    // The sign belongs to the result, but for the ends, which are +-b.
    const double error = t == 1 ? std::min(same, negative) : same;
    EXPECT_LE(error, (p == precision::reproducible ? 8 : 16) * rounding_unit<T>) << e.dump();
}

void all(const char* section, bool is_sterp) {
    const nlohmann::json vectors = golden_section(section);
    if (vectors.is_null()) GTEST_SKIP() << "no golden vectors";
    ASSERT_GE(vectors.size(), 30U);
    for (const nlohmann::json& e : vectors)
        for (const precision p : {precision::fast, precision::reproducible}) {
            check<float>(e, is_sterp, p);
            check<double>(e, is_sterp, p);
        }
}

TEST_P(GoldenInterpolation, Slerp) { all("slerp", false); }
TEST_P(GoldenInterpolation, Sterp) { all("sterp", true); }

}  // namespace
}  // namespace swivel::tests
