#ifndef SWIVEL_BENCH_METHODS_METHODS_TIME_HPP
#define SWIVEL_BENCH_METHODS_METHODS_TIME_HPP

#include <string>
#include <vector>

namespace swivel_bench::methods {

struct timed {
    std::string what;
    double nanoseconds;  // per rotation, median
};

// Each method over the same 1,024 rotations, evenly distributed, and the library's batch calls over them.
// Algorithm 1 about z is the first.
template <class T>
std::vector<timed> measure_times();

}  // namespace swivel_bench::methods

#endif
