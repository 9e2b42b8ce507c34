// Roots, logarithms and powers of every kind of conformal motion.

#include <gtest/gtest.h>

#include <numbers>

#include "support/conformal_errors.hpp"
#include "swivel/conformal.hpp"

namespace swivel::tests {
namespace {

constexpr double pi = std::numbers::pi;

// What the recipes of the literature do in each of these cases, ours do right.
struct motion_case {
    const char* name;
    bivector<double> generator;
    int sign;     // of the exponential of it
    bool unique;  // whether that has one root
    bool half_turn = false;
};

const motion_case cases[] = {
    {"Identity", {}, 1, true},
    {"Rotation", rotation_generator(0.5, -1, 0.7), 1, true},
    {"Translation", translation_generator(1, 2, -3), 1, true},
    {"Motor", rotation_generator(0, 0, 1) + translation_generator(1, 2, -3), 1, true},
    {"Dilation", dilation_generator(1.3), 1, true},
    {"Transversion", {0, 0, 0.5, -0.5, 0, 0.25, -0.25, 0, 0, 0}, 1, true},
    {"Boost", {0, 0, 0, 0.75, 0, 0, 0.5, 0, 0.25, 0}, 1, true},
    {"Loxodromic", rotation_generator(0, 1.2, 0.4) + dilation_generator(-0.8), 1, true},
    {"DoubleElliptic", {1.1, 0, 0, 0, 0, 0, 0, 0.4, 0, 0}, 1, true},
    {"Isoclinic", {0.8, 0, 0, 0, 0, 0, 0, 0.8, 0, 0}, 1, true},
    {"LoxodromicByPi", rotation_generator(0, 0, pi / 2) + dilation_generator(0.5), 1, true},
    {"DoubleEllipticBeyondPi", {2, 0, 0, 0, 0, 0, 0, 2, 0, 0}, 1, true},
    {"RotationOfSixRadians", rotation_generator(0, 3, 0), 1, true},
    {"MinusOne", {}, -1, false, true},
    {"MinusTranslation", translation_generator(1, 2, -3), -1, false},
    {"MinusDilation", dilation_generator(1.3), -1, false},
    {"MinusBoost", {0, 0, 0, 0.75, 0, 0, 0.5, 0, 0.25, 0}, -1, false},
    {"DoubleEllipticOfPi", {1, 0, 0, 0, 0, 0, 0, pi - 1, 0, 0}, 1, false},
    {"TwoRightAngles", {pi / 2, 0, 0, 0, 0, 0, 0, pi / 2, 0, 0}, 1, false, true},
};

class ConformalCases : public testing::TestWithParam<motion_case> {};
INSTANTIATE_TEST_SUITE_P(Motions, ConformalCases, testing::ValuesIn(cases),
                         [](const testing::TestParamInfo<motion_case>& i) { return i.param.name; });

template <class T>
void check_case(const motion_case& c) {
    conformal_buffer<T> r(1, layout::soa), root(1, layout::soa), part(1, layout::soa);
    bivector_buffer<T> l(1, layout::soa);
    scalar_buffer<T> unique(1, layout::soa), log_unique(1, layout::soa), power_unique(1, layout::soa);
    even<double> rotor = exact_exp(c.generator);
    for (double& x : rotor) x *= c.sign;
    set(r, 0, rotor);
    const even<double> given = get(r, 0);
    const double limit = bound<T>(1e-5, 2e-14);
    for (const isa which : usable_isas())
        for (const precision p : both_precisions) {
            ASSERT_EQ(set_active_isa(which), status::ok);
            const options o{.accuracy = p};
            ASSERT_EQ(square_root(r.view(), root.view(), unique.view(), o), status::ok);
            ASSERT_EQ(log(r.view(), l.view(), log_unique.view(), o), status::ok);
            ASSERT_EQ(power(r.view(), T(0.5), part.view(), power_unique.view(), o), status::ok);
            EXPECT_EQ(unique[0], c.unique ? 1 : 0);
            EXPECT_EQ(log_unique[0], unique[0]);
            EXPECT_EQ(power_unique[0], unique[0]);
            const even<double> h = get(root, 0);
            EXPECT_LE(error(get(part, 0), h), limit);
            even<double> square = times(h, h), back = exact_exp(get(l, 0)), want = given;
            if (!c.unique) {
                // That of -R, which acts alike; where there is none either, and for R = -1, the half turn
                // -e23.
                if (c.half_turn) {
                    EXPECT_LE(error(h, even<double>{0, 0, 0, 0, 0, -1}), 0.0);
                    EXPECT_LE(error(get(l, 0), {0, 0, 0, 0, -pi, 0, 0, 0, 0, 0}), bound<T>(1e-7, 2e-16));
                    want = {-1};
                } else {
                    for (double& x : want) x = -x;
                }
            }
            EXPECT_LE(error(square, want), limit);
            EXPECT_LE(error(back, want), limit);
        }
}

TEST_P(ConformalCases, HaveRootsAndLogarithmsOrSayThatTheyHaveNone) {
    const isa before = active_isa();
    check_case<float>(GetParam());
    check_case<double>(GetParam());
    ASSERT_EQ(set_active_isa(before), status::ok);
}

}  // namespace
}  // namespace swivel::tests
