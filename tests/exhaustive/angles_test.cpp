// Every float there is: slow, so it has a program of its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <thread>
#include <vector>

#include "support/usable_isas.hpp"
#include "swivel/atan2.hpp"
#include "swivel/sincos.hpp"

namespace swivel::tests {
namespace {

constexpr std::size_t block = 4096;

std::uint32_t bits(float a) { return std::bit_cast<std::uint32_t>(a); }

// In units in the last place of the right result.
double error(float got, double want) {
    const int exponent = std::max(std::ilogb(want), -126);
    return std::fabs(static_cast<double>(got) - want) / std::ldexp(1.0, exponent - 23);
}

// Calls body(first bits, count) for blocks of the floats from 0 to `last`, on all processors, and gives the
// largest of what it returns.
template <class Body>
double largest_over_floats(float last, Body body) {
    const std::uint64_t count = bits(last) + 1ULL,
                        threads = std::max(1U, std::thread::hardware_concurrency());
    std::vector<double> largest(threads, 0.0);
    std::vector<std::thread> pool;
    for (std::uint64_t t = 0; t < threads; ++t)
        pool.emplace_back([&, t] {
            for (std::uint64_t first = t * block; first < count; first += threads * block)
                largest[t] = std::max(largest[t], body(static_cast<std::uint32_t>(first),
                                                       std::min<std::uint64_t>(block, count - first)));
        });
    for (std::thread& t : pool) t.join();
    return *std::max_element(largest.begin(), largest.end());
}

double sincos_error(precision p) {
    return largest_over_floats(0x1p13f, [p](std::uint32_t first, std::size_t n) {
        float x[block], sine[block], cosine[block], minus_sine[block], same_cosine[block];
        for (std::size_t i = 0; i < n; ++i)
            x[i] = std::bit_cast<float>(static_cast<std::uint32_t>(first + i));
        const options o{.accuracy = p};
        status s = sincos(scalar_view<const float>{x, n}, scalar_view<float>{sine, n},
                          scalar_view<float>{cosine, n}, o);
        for (std::size_t i = 0; i < n; ++i) x[i] = -x[i];
        if (s == status::ok)
            s = sincos(scalar_view<const float>{x, n}, scalar_view<float>{minus_sine, n},
                       scalar_view<float>{same_cosine, n}, o);
        double worst = s == status::ok ? 0 : INFINITY;
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = -x[i];
            if (bits(sine[i]) != bits(-minus_sine[i]) || bits(cosine[i]) != bits(same_cosine[i]))
                worst = INFINITY;
            if (angle == 0) continue;
            worst = std::max({worst, error(sine[i], std::sin(angle)), error(cosine[i], std::cos(angle))});
        }
        return worst;
    });
}

double atan2_error(precision p) {
    return largest_over_floats(0x1p126f, [p](std::uint32_t first, std::size_t n) {
        float y[block], x[block], angle[block];
        for (std::size_t i = 0; i < n; ++i)
            y[i] = std::bit_cast<float>(static_cast<std::uint32_t>(first + i));
        double worst = 0;
        for (const float side : {1.0F, -1.0F}) {
            std::fill_n(x, n, side);
            const status s = atan2(scalar_view<const float>{y, n}, scalar_view<const float>{x, n},
                                   scalar_view<float>{angle, n}, options{.accuracy = p});
            if (s != status::ok) return static_cast<double>(INFINITY);
            for (std::size_t i = 0; i < n; ++i)
                if (y[i] != 0)
                    worst = std::max(worst, error(angle[i], std::atan2(static_cast<double>(y[i]),
                                                                       static_cast<double>(x[i]))));
        }
        return worst;
    });
}

class ExhaustiveAngles : public per_isa {};
// The results of `reproducible` are the same on all ISAs, those of `fast` on all that fuse; one of each will
// do.
INSTANTIATE_TEST_SUITE_P(Isa, ExhaustiveAngles, testing::Values(usable_isas().back()), isa_name);

TEST_P(ExhaustiveAngles, SincosOfEveryFloatIsWithinTwoUnits) {
    for (const precision p : {precision::reproducible, precision::fast}) {
        const double worst = sincos_error(p);
        EXPECT_LE(worst, 2.0);
        RecordProperty(p == precision::fast ? "fast" : "reproducible", std::to_string(worst));
        std::printf("%s: %.3f\n", p == precision::fast ? "fast" : "reproducible", worst);
    }
}

TEST_P(ExhaustiveAngles, Atan2OfEveryFloatAndOneIsWithinTwoUnits) {
    for (const precision p : {precision::reproducible, precision::fast}) {
        const double worst = atan2_error(p);
        EXPECT_LE(worst, 2.0);
        std::printf("%s: %.3f\n", p == precision::fast ? "fast" : "reproducible", worst);
    }
}

}  // namespace
}  // namespace swivel::tests
