#include "plain_loops.hpp"

template struct swivel_bench::plain<float, swivel_bench::preferred_width>;
template struct swivel_bench::plain<double, swivel_bench::preferred_width>;
