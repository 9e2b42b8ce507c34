#include "kernels/make_table.hpp"

constinit const swivel::kernel_table swivel::avx512_kernels = swivel::make_table<xsimd::avx512bw>();
