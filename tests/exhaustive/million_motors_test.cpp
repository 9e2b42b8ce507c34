// Roots and logarithms of a million motors: slow, so it is in the program of the slow tests.

#include "support/motor_roots.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class MillionMotors : public per_isa {};
// One that fuses; the others have the few thousand motors of motor_power_test.cpp.
INSTANTIATE_TEST_SUITE_P(Isa, MillionMotors, testing::Values(usable_isas().back()), isa_name);

constexpr std::uint64_t rounds = 1000000 / n + 1;

TEST_P(MillionMotors, SquareRootSquaredIsTheMotor) {
    for (std::uint64_t seed = 100; seed < 100 + rounds; ++seed) {
        square_root_squared_is_the_motor<float>(seed);
        square_root_squared_is_the_motor<double>(seed);
    }
}

TEST_P(MillionMotors, ExpOfLogIsTheMotor) {
    for (std::uint64_t seed = 200; seed < 200 + rounds; ++seed) {
        exp_of_log_is_the_motor<float>(seed);
        exp_of_log_is_the_motor<double>(seed);
    }
}

}  // namespace
}  // namespace swivel::tests
