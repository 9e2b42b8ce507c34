#include "kernels/make_table.hpp"

constinit const swivel::kernel_table swivel::sse2_kernels = swivel::make_table<xsimd::sse2>();
