#include "methods_time.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <utility>

#include "../support/memory.hpp"
#include "methods.hpp"
#include "swivel/swivel.hpp"

namespace swivel_bench::methods {

namespace {

constexpr std::size_t n = 1024;
constexpr int rounds = 101, passes = 400;

struct row {
    std::string what;
    std::function<void()> all;
    std::vector<double> seen;
};

// Processor time of all n elements, in ns per element.
double measure(const std::function<void()>& all) {
    const std::clock_t begin = std::clock();
    for (int i = 0; i < passes; ++i) all();
    const std::clock_t end = std::clock();
    return static_cast<double>(end - begin) * (1e9 / CLOCKS_PER_SEC) / (double(n) * passes);
}

// The compiler must not know the axis, or it leaves out what a coordinate axis does not need.
template <class T>
vec3<T> unknown(vec3<T> a) {
    asm volatile("" : "+m"(a));
    return a;
}

template <class T>
struct rotations {
    swivel::quat_view<const T> q;
    swivel::quat_view<T> swing, twist;
};

// Component by component: a copy of a whole quaternion goes by way of the stack with g++ 12, and waits there.
template <class T>
void store(const quat<T>& q, const swivel::quat_view<T>& out, std::size_t i) {
    out.x[i] = q.x;
    out.y[i] = q.y;
    out.z[i] = q.z;
    out.w[i] = q.w;
}

template <class T, class Method>
std::function<void()> loop(const rotations<T>& r, Method method) {
    return [r, method] {
        for (std::size_t i = 0; i < n; ++i) {
            const swing_twist<T> f = method(quat<T>{r.q.x[i], r.q.y[i], r.q.z[i], r.q.w[i]});
            store(f.swing, r.swing, i);
            store(f.twist, r.twist, i);
        }
        asm volatile("" ::: "memory");
    };
}

void expect(swivel::status s) {
    if (s != swivel::status::ok) std::abort();
}

}  // namespace

template <class T>
std::vector<timed> measure_times() {
    workload<T> streams(n, layout::soa);
    const rotations<T> a{streams.rotations(), streams.quaternions(), streams.quaternions()};
    const auto factors = streams.written_factors();

    const vec3<T> z = unknown<T>({0, 0, 1}), oblique = unknown<T>({T(2) / 7, T(-3) / 7, T(6) / 7});
    std::vector<row> rows;
    const auto add_axis = [&](const char* method, auto function) {
        for (const auto& [name, v] : {std::pair("z", z), std::pair("oblique", oblique)}) {
            const vec3<T> by = v;
            rows.push_back({std::string(method) + ", axis " + name,
                            loop(a, [by, function](const quat<T>& p) { return function(p, by); }),
                            {}});
        }
    };
    add_axis("Algorithm 1", [](const quat<T>& p, const vec3<T>& v) { return algorithm_1(p, v); });
    add_axis("direct", [](const quat<T>& p, const vec3<T>& v) { return direct(p, v); });
    rows.push_back({"Huyghe, formulas about z", loop(a, [](const quat<T>& p) { return huyghe(p); }), {}});
    add_axis("Huyghe, projection", [](const quat<T>& p, const vec3<T>& v) { return huyghe(p, v); });
    rows.push_back({"axis-aligned form, z", loop(a, [](const quat<T>& p) { return axis_aligned(p); }), {}});
    const std::string isa = std::string(", ") + swivel::name(swivel::active_isa());
    rows.push_back({"swivel::decompose, axis oblique" + isa,
                    [=] { expect(swivel::decompose(a.q, oblique, a.swing, a.twist)); },
                    {}});
    rows.push_back({"swivel::decompose, compact, z" + isa,
                    [=] { expect(swivel::decompose(a.q, swivel::axis::z, factors)); },
                    {}});

    // All rows in each round, so that noise hits all alike.
    for (int i = 0; i < rounds; ++i)
        for (row& r : rows) r.seen.push_back(measure(r.all));
    std::vector<timed> result;
    for (row& r : rows) {
        std::nth_element(r.seen.begin(), r.seen.begin() + rounds / 2, r.seen.end());
        result.push_back({r.what, r.seen[rounds / 2]});
    }
    return result;
}

template std::vector<timed> measure_times<float>();
template std::vector<timed> measure_times<double>();

}  // namespace swivel_bench::methods
