// Nothing wrong but that it comes twice, or with AVX instructions where they do not belong.
#include "table.hpp"

static float product(const float* a) { return a[0] * a[1]; }

template <>
const swivel::one_kernels<float> swivel::kernels_on<swivel::one_kernels<float>, swivel::sse2>::table = {
    product};
