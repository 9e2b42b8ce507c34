#include "plain_loops.hpp"

template struct swivel_bench::plain<float, swivel_bench::widest>;
template struct swivel_bench::plain<double, swivel_bench::widest>;
