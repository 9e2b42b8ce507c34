// swivel_methods [SAMPLES]: error and time of the methods that the paper compares, as the tables of
// bench/methods.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "../../tests/support/exact.hpp"
#include "../../tests/support/rotations.hpp"
#include "methods.hpp"
#include "methods_time.hpp"

namespace {

using namespace swivel::tests;
using swivel::quat;
using swivel::vec3;
namespace methods = swivel_bench::methods;

// An angle, or its distance from pi.
struct swing_angle {
    const char* name;
    double size;
    bool below_pi = false;
};

constexpr swing_angle swing_angles[] = {{"0", 0},
                                        {"2^-20", 0x1p-20},
                                        {"2^-16", 0x1p-16},
                                        {"2^-12", 0x1p-12},
                                        {"2^-8", 0x1p-8},
                                        {"2^-4", 0x1p-4},
                                        {"1", 1},
                                        {"pi/2", 1.5707963267948966},
                                        {"2", 2},
                                        {"pi - 2^-4", 0x1p-4, true},
                                        {"pi - 2^-8", 0x1p-8, true},
                                        {"pi - 2^-12", 0x1p-12, true},
                                        {"pi - 2^-16", 0x1p-16, true},
                                        {"pi - 2^-20", 0x1p-20, true}};

struct half_angle {
    double sine, cosine;
};

// Up to a tenth more or less: the cosine of 2^-8 itself happens to need few digits, which would flatter the
// direct method.
half_angle draw_half(generator& g, const swing_angle& a) {
    const double half = a.size * uniform(g, 0.9, 1.1) / 2;
    if (a.below_pi) return {std::cos(half), std::sin(half)};
    return {std::sin(half), std::cos(half)};
}

// Largest errors in rounding units.
struct errors {
    double swing = 0, twist = 0, recomposition = 0, swing_norm = 0, twist_norm = 0;
    std::size_t samples = 0, nan = 0, other_sign = 0;

    void add(const errors& e) {
        swing = std::max(swing, e.swing);
        twist = std::max(twist, e.twist);
        recomposition = std::max(recomposition, e.recomposition);
        swing_norm = std::max(swing_norm, e.swing_norm);
        twist_norm = std::max(twist_norm, e.twist_norm);
        samples += e.samples;
        nan += e.nan;
        other_sign += e.other_sign;
    }
};

quat<quadruple> normalized(const quat<quadruple>& q) {
    const quadruple n = norm(q);
    return {q.x / n, q.y / n, q.z / n, q.w / n};
}

template <class T>
bool is_nan(const quat<T>& q) {
    return std::isnan(q.x) || std::isnan(q.y) || std::isnan(q.z) || std::isnan(q.w);
}

// The rounding of q makes |q| differ from 1, and one method puts that into S, the other into T. So swing and
// twist are compared as rotations, by their unit quaternions, and the norms on their own.
template <class T>
errors judge(const methods::swing_twist<T>& f, const quat<quadruple>& q, const exact_factors<quadruple>& e) {
    errors r;
    r.samples = 1;
    if (is_nan(f.swing) || is_nan(f.twist)) {
        r.nan = 1;
        return r;
    }
    const auto units = [](quadruple a) { return static_cast<double>(magnitude(a)) / rounding_unit<T>; };
    const quat<quadruple> s = widen<quadruple>(f.swing), t = widen<quadruple>(f.twist);
    quat<quadruple> exact_s = normalized(e.swing), exact_t = e.twist;
    // (-S) (-T) is q as well.
    if (dot(s, exact_s) + dot(t, exact_t) < 0) {
        r.other_sign = 1;
        exact_s = minus({0, 0, 0, 0}, exact_s);
        exact_t = minus({0, 0, 0, 0}, exact_t);
    }
    r.swing = units(norm(minus(normalized(s), exact_s)));
    r.twist = units(norm(minus(normalized(t), exact_t)));
    r.recomposition = units(norm(minus(times(s, t), q)));
    r.swing_norm = units(norm(s) - 1);
    r.twist_norm = units(norm(t) - 1);
    return r;
}

template <class T>
struct sample {
    vec3<T> a;
    quat<T> q;
};

template <class T>
sample<T> sample_about_z(generator& g, const swing_angle& angle) {
    const auto [sine, cosine] = draw_half(g, angle);
    const double half = uniform(g, 0, 6.283185307179586), direction = uniform(g, 0, 6.283185307179586);
    const quat<double> s{sine * std::cos(direction), sine * std::sin(direction), 0, cosine};
    const quat<double> q = times(s, {0, 0, std::sin(half), std::cos(half)});
    return {{0, 0, 1}, rounded<T>(q.x, q.y, q.z, q.w)};
}

template <class T>
sample<T> sample_about_any(generator& g, const swing_angle& angle) {
    const vec3<T> a = random_direction<T>(g);
    const vec3<double> d = unit(widen<double>(a)), other = random_direction<double>(g);
    const vec3<double> p = unit(methods::cross(d, other));
    const auto [sine, cosine] = draw_half(g, angle);
    const double half = uniform(g, 0, 6.283185307179586), t = std::sin(half);
    const quat<double> s{sine * p.x, sine * p.y, sine * p.z, cosine};
    const quat<double> q = times(s, {t * d.x, t * d.y, t * d.z, std::cos(half)});
    return {a, rounded<T>(q.x, q.y, q.z, q.w)};
}

std::string shown(double units) {
    char text[32];
    std::snprintf(text, sizeof text, units < 100 ? "%.1f" : units < 1e5 ? "%.0f" : "%.1e", units);
    return text;
}

std::string percent_nan(const errors& e) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100.0 * double(e.nan) / double(e.samples));
    return text;
}

std::string three(const errors& e) {
    if (e.nan == e.samples) return "NaN";
    return shown(e.swing) + " / " + shown(e.twist) + " / " + shown(e.recomposition);
}

// One table: a row for each angle, a column for each method. draw gives a sample, all what each method makes
// of it.
template <class T, std::size_t count, class Draw, class All>
void error_table(const char* title, const std::array<const char*, count>& names, std::size_t samples,
                 Draw draw, All all) {
    constexpr std::size_t direct = 1;
    std::printf("### %s, units of %s\n\n| swing angle |", title, sizeof(T) == 4 ? "2^-24" : "2^-53");
    for (const char* name : names) std::printf(" %s |", name);
    std::printf(" direct: NaN |\n|---|");
    for (std::size_t i = 0; i <= count; ++i) std::printf("---|");
    std::printf("\n");

    generator g(1);
    std::array<errors, count> of_all{};
    for (const swing_angle& angle : swing_angles) {
        std::array<errors, count> seen{};
        for (std::size_t i = 0; i < samples; ++i) {
            const sample<T> in = draw(g, angle);
            const quat<quadruple> q = widen<quadruple>(in.q);
            const auto exact = factor(q, unit(widen<quadruple>(in.a)), swivel::product::swing_twist);
            const std::array<methods::swing_twist<T>, count> out = all(in);
            for (std::size_t m = 0; m < count; ++m) seen[m].add(judge(out[m], q, exact));
        }
        std::printf("| %s |", angle.name);
        for (const errors& e : seen) std::printf(" %s |", three(e).c_str());
        std::printf(" %s |\n", percent_nan(seen[direct]).c_str());
        std::fflush(stdout);
        for (std::size_t m = 0; m < count; ++m) of_all[m].add(seen[m]);
    }
    std::printf("| largest |");
    for (const errors& e : of_all) std::printf(" %s |", three(e).c_str());
    std::printf(" %s |\n| norms of S / T |", percent_nan(of_all[direct]).c_str());
    for (const errors& e : of_all)
        std::printf(" %s / %s |", shown(e.swing_norm).c_str(), shown(e.twist_norm).c_str());
    std::printf(" |\n\n");

    std::size_t other_sign = 0, other_nan = 0;
    for (std::size_t m = 0; m < count; ++m) {
        other_sign += of_all[m].other_sign;
        if (m != direct) other_nan += of_all[m].nan;
    }
    std::printf(
        "Results with the signs of both factors changed: %zu. NaN from a method other than direct: %zu.\n\n",
        other_sign, other_nan);
}

template <class T>
void error_tables(std::size_t samples) {
    const std::string type = sizeof(T) == 4 ? "float" : "double";
    error_table<T, 4>((type + ", axis z").c_str(), {"Algorithm 1", "direct", "Huyghe", "axis-aligned"},
                      samples, sample_about_z<T>,
                      [](const sample<T>& in) -> std::array<methods::swing_twist<T>, 4> {
                          return {methods::algorithm_1(in.q, in.a), methods::direct(in.q, in.a),
                                  methods::huyghe(in.q), methods::axis_aligned(in.q)};
                      });
    error_table<T, 3>((type + ", any axis").c_str(), {"Algorithm 1", "direct", "Huyghe, projection"}, samples,
                      sample_about_any<T>, [](const sample<T>& in) -> std::array<methods::swing_twist<T>, 3> {
                          return {methods::algorithm_1(in.q, in.a), methods::direct(in.q, in.a),
                                  methods::huyghe(in.q, in.a)};
                      });
}

void time_table() {
    const auto as_float = methods::measure_times<float>(), as_double = methods::measure_times<double>();
    std::printf(
        "### Time, ns per rotation and ratio to Algorithm 1 about z\n\n"
        "| method | float | ratio | double | ratio |\n|---|---|---|---|---|\n");
    for (std::size_t i = 0; i < as_float.size(); ++i)
        std::printf("| %s | %.2f | %.2f | %.2f | %.2f |\n", as_float[i].what.c_str(), as_float[i].nanoseconds,
                    as_float[i].nanoseconds / as_float[0].nanoseconds, as_double[i].nanoseconds,
                    as_double[i].nanoseconds / as_double[0].nanoseconds);
}

}  // namespace

int main(int count, char** arguments) {
    const std::size_t samples = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 20'000;
    if (samples == 0) {
        std::fprintf(stderr, "usage: swivel_methods [SAMPLES]\n");
        return 2;
    }
    std::printf(
        "Compiler %s. Errors: swing / twist / S T against q, the largest of %zu samples for each angle.\n\n",
        SWIVEL_BENCH_COMPILER, samples);
    error_tables<float>(samples);
    error_tables<double>(samples);
    time_table();
}
