#include <benchmark/benchmark.h>

#include "bench/support/row.hpp"
#include "swivel/version.hpp"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::AddCustomContext("swivel", swivel::version());
    benchmark::AddCustomContext("compiler", SWIVEL_BENCH_COMPILER);
    benchmark::AddCustomContext("plain_compiler", SWIVEL_BENCH_PLAIN_COMPILER);
    swivel_bench::add_library_rows();
    swivel_bench::add_decompose_rows();
    swivel_bench::add_twist_rows();
    swivel_bench::add_swing_rows();
    swivel_bench::add_twist_angle_rows();
    swivel_bench::add_compose_rows();
    swivel_bench::add_interpolation_rows();
    swivel_bench::add_rotors_rows();
    swivel_bench::add_exponentials_rows();
    swivel_bench::add_arcs_rows();
    swivel_bench::add_conversions_rows();
    swivel_bench::add_motors_rows();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
