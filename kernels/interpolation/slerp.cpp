#include "kernels/interpolation/slerp.hpp"

#include "kernels/interpolation/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct slerp_variants : deep {
    template <class V, int LongWay, int P>
    using op = slerp_op<precision_index(P), LongWay != 0, V>;
};

}  // namespace

template <>
constinit const slerp_kernels<float> kernels_on<slerp_kernels<float>, here>::table =
    table_of<slerp_kernels<float>, float, slerp_variants>();
template <>
constinit const slerp_kernels<double> kernels_on<slerp_kernels<double>, here>::table =
    table_of<slerp_kernels<double>, double, slerp_variants>();

}  // namespace swivel
