#ifndef SWIVEL_BENCH_SUPPORT_ROW_HPP
#define SWIVEL_BENCH_SUPPORT_ROW_HPP

// Rows are named <op>/<isa or peer>/<layout>/<type>/<n>; on data where nothing moves, <op>/still/...

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include "bench/support/memory.hpp"

namespace swivel_bench {

inline constexpr std::size_t sizes[] = {1, 16, 64, 1024, 16384, 4194304};

std::string row_name(std::string_view op, std::string_view who, layout l, bool is_double, std::size_t n);

// One row. prepare(workload<T>&) takes the streams and returns what is measured: a callable that does all n
// elements once.
template <class T, class Prepare>
void add_row(std::string_view op, std::string_view who, layout l, std::size_t n, Prepare prepare,
             data d = data::ordinary) {
    const auto run = [l, n, prepare, d](benchmark::State& state) {
        workload<T> streams(n, l, d);
        const auto call = prepare(streams);
        for (auto _ : state) {
            call();
            benchmark::ClobberMemory();
        }
        state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
    };
    benchmark::RegisterBenchmark(row_name(op, who, l, std::is_same_v<T, double>, n).c_str(), run);
}

// One for each size.
template <class T, class Prepare>
void add_rows(std::string_view op, std::string_view who, layout l, Prepare prepare) {
    for (const std::size_t n : sizes) add_row<T>(op, who, l, n, prepare);
}

// Those of the library and its reference, of every operation.
void add_library_rows();
// Those of peers.
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

}  // namespace swivel_bench

#endif
