#include "kernels/swing_twist/twist.hpp"

#include "kernels/loops/tables.hpp"
#include "kernels/swing_twist/tables.hpp"

namespace swivel {

namespace {

struct twist_variants : light {
    template <class V, int Form, int P>
    using op = twist_op<axis_form<Form, P, V>, V>;
};

}  // namespace

template <>
constinit const twist_kernels<float> kernels_on<twist_kernels<float>, here>::table =
    table_of<twist_kernels<float>, float, twist_variants>();
template <>
constinit const twist_kernels<double> kernels_on<twist_kernels<double>, here>::table =
    table_of<twist_kernels<double>, double, twist_variants>();

}  // namespace swivel
