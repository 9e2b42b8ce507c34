#ifndef SWIVEL_BENCH_SUPPORT_ROW_HPP
#define SWIVEL_BENCH_SUPPORT_ROW_HPP

// Rows are named <op>/<isa or peer>/<layout>/<type>/<n>.

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "memory.hpp"
#include "swivel/swivel.hpp"

namespace swivel_bench {

inline constexpr std::size_t sizes[] = {1, 16, 64, 1024, 16384, 4194304};

std::string row_name(std::string_view op, std::string_view who, layout l, bool is_double, std::size_t n);

const std::vector<swivel::isa>& usable_isas();

// One row for each size. prepare(workload<T>&) takes the streams and returns what is measured: a callable
// that does all n elements once.
template <class T, class Prepare>
void add_rows(std::string_view op, std::string_view who, layout l, Prepare prepare) {
    for (const std::size_t n : sizes) {
        const auto run = [l, n, prepare](benchmark::State& state) {
            workload<T> streams(n, l);
            const auto call = prepare(streams);
            for (auto _ : state) {
                call();
                benchmark::ClobberMemory();
            }
            state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
        };
        benchmark::RegisterBenchmark(row_name(op, who, l, std::is_same_v<T, double>, n).c_str(), run);
    }
}

// The rows of the library: each usable ISA, layout, type and precision. prepare(workload<T>&, options) as
// above, with a callable that returns a status.
template <class T, class Prepare>
void add_library_rows(std::string_view op, Prepare prepare) {
    for (const swivel::isa which : usable_isas())
        for (const layout l : {layout::soa, layout::aos})
            for (const swivel::precision p : {swivel::precision::fast, swivel::precision::reproducible}) {
                std::string full_op(op);
                if (p == swivel::precision::reproducible) full_op += "_reproducible";
                add_rows<T>(full_op, swivel::name(which), l, [which, p, prepare](workload<T>& streams) {
                    if (swivel::set_active_isa(which) != swivel::status::ok) std::abort();
                    swivel::options o;
                    o.accuracy = p;
                    const auto call = prepare(streams, o);
                    if (call() != swivel::status::ok) std::abort();
                    return [call] {
                        auto result = call();
                        benchmark::DoNotOptimize(result);
                    };
                });
            }
}

// Each file adds its own rows.
void add_decompose_rows();
void add_twist_rows();
void add_swing_rows();
void add_twist_angle_rows();
void add_compose_rows();
void add_interpolation_rows();
void add_rotors_rows();
void add_exponentials_rows();
void add_arcs_rows();
void add_conversions_rows();
void add_motors_rows();
void add_conformal_rows();

}  // namespace swivel_bench

#endif
