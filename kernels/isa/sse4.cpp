#include "kernels/make_table.hpp"

constinit const swivel::kernel_table swivel::sse4_kernels = swivel::make_table<xsimd::sse4_1>();
