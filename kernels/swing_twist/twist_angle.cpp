#include "kernels/swing_twist/twist_angle.hpp"

#include "kernels/loops/tables.hpp"
#include "kernels/swing_twist/tables.hpp"

namespace swivel {

namespace {

struct twist_angle_variants : light {
    template <class V, int Form, int P>
    using op = twist_angle_op<precision_index(P), axis_form<Form, P, V>, V>;
};

}  // namespace

template <>
constinit const twist_angle_kernels<float> kernels_on<twist_angle_kernels<float>, here>::table =
    table_of<twist_angle_kernels<float>, float, twist_angle_variants>();
template <>
constinit const twist_angle_kernels<double> kernels_on<twist_angle_kernels<double>, here>::table =
    table_of<twist_angle_kernels<double>, double, twist_angle_variants>();

}  // namespace swivel
