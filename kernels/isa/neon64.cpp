#include "kernels/make_table.hpp"

constinit const swivel::kernel_table swivel::neon64_kernels = swivel::make_table<xsimd::neon64>();
