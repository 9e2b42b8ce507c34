#include "kernels/loops/tables.hpp"
#include "kernels/motors/motor.hpp"
#include "kernels/motors/tables.hpp"

namespace swivel {

namespace {

struct motor_decompose_variants : light {
    template <class V, int Form, int P>
    using op = motor_decompose_op<precision_index(P), axis_form<Form, P, V>, V>;
};

}  // namespace

template <>
constinit const motor_decompose_kernels<float> kernels_on<motor_decompose_kernels<float>, here>::table =
    table_of<motor_decompose_kernels<float>, float, motor_decompose_variants>();
template <>
constinit const motor_decompose_kernels<double> kernels_on<motor_decompose_kernels<double>, here>::table =
    table_of<motor_decompose_kernels<double>, double, motor_decompose_variants>();

}  // namespace swivel
