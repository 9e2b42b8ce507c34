// The golden vectors of conformal rotors, with tolerances as the header states them.

#include <gtest/gtest.h>

#include "support/conformal_errors.hpp"
#include "support/golden.hpp"
#include "swivel/conformal.hpp"

namespace swivel::tests {
namespace {

class GoldenConformal : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, GoldenConformal, testing::ValuesIn(usable_isas()), isa_name);

template <class T>
void matches_golden() {
    const nlohmann::json vectors = golden_section("cga");
    if (vectors.is_null()) GTEST_SKIP() << "no golden vectors";
    ASSERT_GE(vectors.size(), 30U);
    conformal_buffer<T> r(1, layout::soa), out(1, layout::soa);
    bivector_buffer<T> b(1, layout::soa), l(1, layout::soa);
    scalar_buffer<T> unique(1, layout::soa);
    for (const precision p : both_precisions) {
        const options o{.accuracy = p};
        worst exps, roots, logs;
        for (const nlohmann::json& e : vectors) {
            const auto B = e.at("B").get<bivector<double>>();
            const auto R = e.at("R").get<even<double>>(), half = e.at("sqrt").get<even<double>>();
            set(b, 0, B);
            set(r, 0, R);
            ASSERT_EQ(exp(b.view(), out.view(), o), status::ok);
            exps.see(error(get(out, 0), R));
            ASSERT_EQ(square_root(r.view(), out.view(), unique.view(), o), status::ok);
            EXPECT_EQ(unique[0], 1) << e.dump();
            roots.see(error(get(out, 0), half));
            ASSERT_EQ(log(r.view(), l.view(), unique.view(), o), status::ok);
            EXPECT_EQ(unique[0], 1) << e.dump();
            logs.see(error(get(l, 0), B));
        }
        exps.expect_below(bound<T>(4e-7, 6e-16), "golden exp", p, sizeof(T));
        roots.expect_below(bound<T>(3e-7, 6e-16), "golden square_root", p, sizeof(T));
        logs.expect_below(bound<T>(4e-7, 1e-15), "golden log", p, sizeof(T));
    }
}

TEST_P(GoldenConformal, ExpSquareRootAndLogFloat) { matches_golden<float>(); }
TEST_P(GoldenConformal, ExpSquareRootAndLogDouble) { matches_golden<double>(); }

}  // namespace
}  // namespace swivel::tests
