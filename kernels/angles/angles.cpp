#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/angles/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct sincos_variants : light {
    template <class V, int P>
    using op = sincos_op<precision_index(P), V>;
};

struct atan2_variants : light {
    template <class V, int P>
    using op = atan2_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const sincos_kernels<float> kernels_on<sincos_kernels<float>, here>::table =
    table_of<sincos_kernels<float>, float, sincos_variants>();
template <>
constinit const sincos_kernels<double> kernels_on<sincos_kernels<double>, here>::table =
    table_of<sincos_kernels<double>, double, sincos_variants>();

template <>
constinit const atan2_kernels<float> kernels_on<atan2_kernels<float>, here>::table =
    table_of<atan2_kernels<float>, float, atan2_variants>();
template <>
constinit const atan2_kernels<double> kernels_on<atan2_kernels<double>, here>::table =
    table_of<atan2_kernels<double>, double, atan2_variants>();

}  // namespace swivel
