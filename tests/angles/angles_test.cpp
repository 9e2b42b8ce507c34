#include <gtest/gtest.h>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/atan2.hpp"
#include "swivel/sincos.hpp"

namespace swivel::tests {
namespace {

class Sincos : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Sincos, testing::ValuesIn(usable_isas()), isa_name);
class Atan2 : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Atan2, testing::ValuesIn(usable_isas()), isa_name);

// In units in the last place of the right result.
template <class T>
double units(T got, long double want) {
    const int digits = std::numeric_limits<T>::digits, least = std::numeric_limits<T>::min_exponent;
    const int exponent = want == 0 ? least : std::max(std::ilogb(want) + 1, least);
    return double(std::fabs(got - want) / std::ldexp(1.0L, exponent - digits));
}

template <class T>
constexpr T largest_angle = sizeof(T) == 4 ? T(0x1p13) : T(0x1p20);

// All magnitudes, and next to multiples of pi/2, where sine or cosine is smallest.
// tests/exhaustive_angles_test.cpp tries every float.
template <class T>
void sincos_whole_domain() {
    constexpr std::size_t n = 60013;
    constexpr long double half_pi = 1.57079632679489661923132169163975144L;
    generator g(3);
    scalar_buffer<T> x(n, layout::soa), sine(n, layout::soa), cosine(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        const double wide = uniform(g, -double(largest_angle<T>), double(largest_angle<T>));
        x[i] = i % 3 == 0   ? static_cast<T>(wide)
               : i % 3 == 1 ? static_cast<T>(std::ldexp(wide, -static_cast<int>(i % 60)))
                            : static_cast<T>(std::floor(wide / 2) * half_pi);
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(sincos(x.view(), sine.view(), cosine.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const long double angle = x[i];
            // Beyond the digits of long double near a multiple of pi/2, nothing is known of the right result.
            if (sizeof(T) == 8 && i % 3 == 2) {
                ASSERT_NEAR(double(sine[i] - std::sin(angle)), 0, 1e-15);
                continue;
            }
            ASSERT_LE(units(sine[i], std::sin(angle)), 2.0) << x[i];
            ASSERT_LE(units(cosine[i], std::cos(angle)), 2.0) << x[i];
        }
    }
}

TEST_P(Sincos, IsWithinTwoUnitsOverTheWholeDomain) {
    sincos_whole_domain<float>();
    sincos_whole_domain<double>();
}

template <class T>
void sincos_corners() {
    using limits = std::numeric_limits<T>;
    const T beyond[] = {std::nextafter(largest_angle<T>, limits::infinity()), limits::max(), -limits::max(),
                        T(1e9)};
    for (const precision p : both_precisions) {
        const auto at = [&](T angle) {
            scalar_buffer<T> x(1, layout::soa), sine(1, layout::soa), cosine(1, layout::soa);
            x[0] = angle;
            EXPECT_EQ(sincos(x.view(), sine.view(), cosine.view(), {.accuracy = p}), status::ok);
            return std::pair(sine[0], cosine[0]);
        };
        EXPECT_TRUE(same_bits(at(0).first, T(0)));
        EXPECT_TRUE(same_bits(at(T(-0.0)).first, T(-0.0)));
        EXPECT_EQ(at(T(-0.0)).second, 1);
        EXPECT_EQ(at(limits::denorm_min()).first, limits::denorm_min());
        for (const T angle : beyond) {
            EXPECT_EQ(at(angle).first, 0) << angle;
            EXPECT_EQ(at(angle).second, 1) << angle;
        }
        EXPECT_LE(std::fabs(at(largest_angle<T>).first), 1);
        EXPECT_NE(at(largest_angle<T>).first, 0);
        for (const T bad : {limits::quiet_NaN(), limits::infinity(), -limits::infinity()}) {
            EXPECT_TRUE(std::isnan(at(bad).first));
            EXPECT_TRUE(std::isnan(at(bad).second));
        }
    }
}

TEST_P(Sincos, IsRightAtZeroSubnormalsAndTheEndsOfItsDomain) {
    sincos_corners<float>();
    sincos_corners<double>();
}

template <class T>
void atan2_everywhere() {
    constexpr std::size_t n = 60013;
    generator g(4);
    scalar_buffer<T> y(n, layout::soa), x(n, layout::soa), angle(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        y[i] =
            static_cast<T>(std::ldexp(uniform(g, -2, 2), i % 2 == 0 ? 0 : static_cast<int>(g() % 80) - 40));
        x[i] =
            static_cast<T>(std::ldexp(uniform(g, -2, 2), i % 4 == 0 ? static_cast<int>(g() % 80) - 40 : 0));
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(atan2(y.view(), x.view(), angle.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            const long double want =
                std::atan2(static_cast<long double>(y[i]), static_cast<long double>(x[i]));
            ASSERT_LE(units(angle[i], want), 2.0) << y[i] << ' ' << x[i];
        }
    }
}

TEST_P(Atan2, IsWithinTwoUnitsInAllQuadrants) {
    atan2_everywhere<float>();
    atan2_everywhere<double>();
}

template <class T>
void atan2_corners() {
    using limits = std::numeric_limits<T>;
    const T values[] = {0,       T(-0.0), 1, -1, limits::denorm_min(), -limits::denorm_min(), limits::min(),
                        T(1e30), T(-1e30)};
    for (const precision p : both_precisions)
        for (const T b : values)
            for (const T a : values) {
                scalar_buffer<T> y(1, layout::soa), x(1, layout::soa), angle(1, layout::soa);
                y[0] = b;
                x[0] = a;
                ASSERT_EQ(atan2(y.view(), x.view(), angle.view(), {.accuracy = p}), status::ok);
                const long double want = std::atan2(static_cast<long double>(b), static_cast<long double>(a));
                EXPECT_LE(units(angle[0], want), 2.0) << b << ' ' << a;
                EXPECT_EQ(std::signbit(angle[0]), std::signbit(b)) << b << ' ' << a;
            }
}

TEST_P(Atan2, HasTheSignsAndZerosOfTheStandardFunction) {
    atan2_corners<float>();
    atan2_corners<double>();
}

}  // namespace
}  // namespace swivel::tests
