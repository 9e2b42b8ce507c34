#ifndef SWIVEL_TESTS_SUPPORT_CONFORMAL_ERRORS_HPP
#define SWIVEL_TESTS_SUPPORT_CONFORMAL_ERRORS_HPP

// Conformal rotors and bivectors of buffers, and how far they are from what they should be.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "support/buffers.hpp"
#include "support/conformal.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {

// The bound of a header: for float and for double.
template <class T>
double bound(double f, double d) {
    return sizeof(T) == 4 ? f : d;
}

template <class T>
even<double> get(conformal_buffer<T>& b, std::size_t i) {
    even<double> e;
    for (int k = 0; k < 16; ++k) e[static_cast<std::size_t>(k)] = static_cast<double>(b.at(k, i));
    return e;
}

template <class T>
bivector<double> get(bivector_buffer<T>& b, std::size_t i) {
    bivector<double> e;
    for (int k = 0; k < 10; ++k) e[static_cast<std::size_t>(k)] = static_cast<double>(b.at(k, i));
    return e;
}

template <class Buffer, class W>
void set(Buffer& b, std::size_t i, const W& values) {
    using T = std::remove_reference_t<decltype(b.at(0, 0))>;
    for (std::size_t k = 0; k < values.size(); ++k) b.at(static_cast<int>(k), i) = static_cast<T>(values[k]);
}

// The largest difference of components, by the length of what is expected where that is larger than 1.
template <class A>
double error(const A& got, const A& want) {
    double largest = 0;
    for (std::size_t k = 0; k < got.size(); ++k) {
        if (!std::isfinite(got[k])) return HUGE_VAL;
        largest = std::max(largest, std::fabs(static_cast<double>(got[k] - want[k])));
    }
    return largest / std::max(1.0, size_of(want));
}

// The worst of many, for the message and for the figures of the header.
struct worst {
    double value = 0;
    void see(double e) { value = std::max(value, e); }
    void expect_below(double limit, const char* what, precision p, std::size_t bytes) const {
        EXPECT_LE(value, limit) << what << ' ' << name(p) << ' ' << bytes;
        if (std::getenv("SWIVEL_SHOW_ERRORS") != nullptr)
            std::printf("%s %s f%zu: %.2g of %.2g\n", what, name(p), 8 * bytes, value, limit);
    }
};

}  // namespace swivel::tests

#endif
