// The table of another ISA.
#include "table.hpp"

namespace swivel {
struct avx2;
}
static float product(const float* a) { return a[0] * a[1]; }

template <>
const swivel::one_kernels<float> swivel::kernels_on<swivel::one_kernels<float>, swivel::avx2>::table = {
    product};
