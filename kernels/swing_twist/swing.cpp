#include "kernels/swing_twist/swing.hpp"

#include "kernels/loops/tables.hpp"
#include "kernels/swing_twist/tables.hpp"

namespace swivel {

namespace {

struct swing_variants : light {
    template <class V, int Form, int P>
    using op = swing_op<axis_form<Form, P, V>, V>;
};

}  // namespace

template <>
constinit const swing_kernels<float> kernels_on<swing_kernels<float>, here>::table =
    table_of<swing_kernels<float>, float, swing_variants>();
template <>
constinit const swing_kernels<double> kernels_on<swing_kernels<double>, here>::table =
    table_of<swing_kernels<double>, double, swing_variants>();

}  // namespace swivel
