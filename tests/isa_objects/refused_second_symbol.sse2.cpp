// A function beside the table.
#include "table.hpp"

float helper(const float* a) { return *a + *a; }

template <>
const swivel::one_kernels<float> swivel::kernels_on<swivel::one_kernels<float>, swivel::sse2>::table = {
    helper};
