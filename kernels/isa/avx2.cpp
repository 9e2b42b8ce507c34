#include "kernels/make_table.hpp"

constinit const swivel::kernel_table swivel::avx2_kernels = swivel::make_table<xsimd::fma3<xsimd::avx2>>();
