// Operations that take quaternions of any length, over all lengths that their headers state: a power of two is exact,
// so nothing may come out but what comes out at length 1.

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "support/interpolation.hpp"
#include "support/operations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class Lengths : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Lengths, testing::ValuesIn(usable_isas()), isa_name);

// Exponents of the shortest and the longest.
struct range {
    int low, high;
};

struct domain {
    const char* operation;  // and all of its forms
    range of_float, of_double;
    bool keeps_length = false;  // of the swing, which is as long as the quaternion
};

constexpr domain domains[] = {
    {"slerp", {-30, 30}, {-250, 250}},          {"nlerp", {-30, 30}, {-250, 250}},
    {"sterp", {-13, 15}, {-120, 120}},          {"decompose", {-26, 62}, {-427, 510}, true},
    {"swing", {-26, 62}, {-427, 510}, true},    {"twist", {-26, 62}, {-427, 510}},
    {"twist_angle", {-26, 62}, {-427, 510}},    {"log", {-100, 125}, {-960, 1021}},
    {"power", {-100, 125}, {-960, 1021}},       {"square_root", {-100, 126}, {-960, 1022}},
    {"normalize", {-100, 126}, {-960, 1022}},   {"to_axis_angle", {-100, 125}, {-960, 1021}},
    {"to_matrix", {-49, 62}, {-479, 510}},      {"to_euler", {-24, 61}, {-400, 509}},
    {"motor_normalize", {-60, 59}, {-500, 499}}};

const domain* domain_of(std::string_view name) {
    const std::string_view stem = name.substr(0, name.find('/'));
    for (const domain& d : domains)
        if (stem == d.operation) return &d;
    return nullptr;
}

// Pairs at every distance, and rotations at every distance from the poles of the axes.
template <class T>
void fill(workspace<T>& w, generator& g) {
    w.fill(g);
    const int steps = sizeof(T) == 4 ? 20 : 45;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const double distance = std::ldexp(1.0, -static_cast<int>(i / 8 % static_cast<std::size_t>(steps)));
        quat<T> a = random_rotation<T>(g), b = random_rotation<T>(g);
        if (i % 8 == 1) a = near_pole(g, vec3<T>{0, 0, 1}, distance);
        if (i % 8 == 2) a = near_pole(g, vec3<T>{1, 0, 0}, distance);
        if (i % 8 == 3) a = near_pole(g, w.axis_for_all, distance);
        if (i % 8 == 4) a = near_pole(g, w.axes.get(i), distance);
        if (i % 8 == 5) b = a;
        if (i % 8 == 6) b = neighbour(g, a, distance);
        if (i % 8 == 7) b = neighbour<T>(g, {-a.x, -a.y, -a.z, -a.w}, distance);
        w.q.set(i, a);
        w.swing_in.set(i, b);
        // From b to this it is near the pole, too.
        w.twist_in.set(i, i % 8 >= 1 && i % 8 <= 4 ? times(a, b) : a);
        w.motors_in.set(i, random_motor<T>(g, 3));
        w.parameters_in[i] = i % 3 == 0 ? T(0.5) : static_cast<T>(uniform(g, -0.25, 1.25));
        w.other_parameters_in[i] = static_cast<T>(uniform(g, -0.25, 1.25));
    }
}

template <class T>
void scale(any_buffer<T>& b, std::size_t i, T by) {
    for (int c = 0; c < b.components(); ++c) b.at(c, i) *= by;
}

template <class T>
void same_at_all_lengths() {
    constexpr std::size_t n = 480;
    for (const operation<T>& op : all_operations<T>()) {
        const domain* d = domain_of(op.name);
        if (d == nullptr) continue;
        const range r = sizeof(T) == 4 ? d->of_float : d->of_double;
        // The shortest of all, the longest of all, and any beside any.
        for (const int which : {0, 1, 2}) {
            workspace<T> unit(n, layout::soa), scaled(n, layout::soa);
            generator g(41), again(41), lengths(42);
            fill(unit, g);
            fill(scaled, again);
            std::vector<T> by(n);
            const auto length = [&] {
                const auto count = static_cast<unsigned long long>(r.high - r.low + 1);
                const int e = which == 0   ? r.low
                              : which == 1 ? r.high
                                           : r.low + static_cast<int>(lengths() % count);
                return static_cast<T>(std::ldexp(1.0, e));
            };
            for (std::size_t i = 0; i < n; ++i) {
                by[i] = length();
                scale(scaled.q, i, by[i]);
                scale(scaled.swing_in, i, length());
                scale(scaled.twist_in, i, length());
                scale(scaled.motors_in, i, length());
            }
            for (const precision p : both_precisions) {
                ASSERT_EQ(op.run(unit, p), status::ok) << op.name;
                ASSERT_EQ(op.run(scaled, p), status::ok) << op.name;
                std::size_t worst = 0;
                double largest = 0;
                for (std::size_t i = 0; i < n; ++i) {
                    if (d->keeps_length) {
                        scale(scaled.swing, i, 1 / by[i]);
                        for (int c = 0; c < 3; ++c) scaled.factors_out.at(c, i) *= 1 / by[i];
                    }
                    const std::vector<T> want = op.outputs(unit, i), got = op.outputs(scaled, i);
                    for (std::size_t k = 0; k < want.size(); ++k) {
                        const double off =
                            double(std::fabs(got[k] - want[k])) / std::max(1.0, double(std::fabs(want[k])));
                        if (!(off <= largest)) {
                            largest = off;
                            worst = i;
                        }
                    }
                }
                EXPECT_LE(largest / rounding_unit<T>, 2)
                    << op.name << ' ' << name(p) << ", element " << worst << " of length " << by[worst];
            }
        }
    }
}

TEST_P(Lengths, OfTheDomainGiveWhatLengthOneGivesFloat) { same_at_all_lengths<float>(); }
TEST_P(Lengths, OfTheDomainGiveWhatLengthOneGivesDouble) { same_at_all_lengths<double>(); }

}  // namespace
}  // namespace swivel::tests
