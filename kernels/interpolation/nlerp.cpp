#include "kernels/interpolation/nlerp.hpp"

#include "kernels/interpolation/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct nlerp_variants : light {
    template <class V, int P>
    using op = nlerp_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const nlerp_kernels<float> kernels_on<nlerp_kernels<float>, here>::table =
    table_of<nlerp_kernels<float>, float, nlerp_variants>();
template <>
constinit const nlerp_kernels<double> kernels_on<nlerp_kernels<double>, here>::table =
    table_of<nlerp_kernels<double>, double, nlerp_variants>();

}  // namespace swivel
