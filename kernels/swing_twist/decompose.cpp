#include "kernels/swing_twist/decompose.hpp"

#include "kernels/loops/tables.hpp"
#include "kernels/swing_twist/tables.hpp"

namespace swivel {

namespace {

// Signs are kept now and then only.
struct decompose_variants : light {
    template <int Form, int Keeps, int P>
    static constexpr bool is_light = Keeps == 0;

    template <class V, int Form, int Keeps, int P>
    using op = decompose_op<axis_form<Form, P, V>, Keeps != 0, V>;
};

struct decompose_compact_variants : light {
    template <int Keeps, int P>
    static constexpr bool is_light = Keeps == 0;

    template <class V, int Keeps, int P>
    using op = decompose_compact_op<axis_form<coordinate_index, P, V>, Keeps != 0, V>;
};

}  // namespace

template <>
constinit const decompose_kernels<float> kernels_on<decompose_kernels<float>, here>::table =
    table_of<decompose_kernels<float>, float, decompose_variants>();
template <>
constinit const decompose_kernels<double> kernels_on<decompose_kernels<double>, here>::table =
    table_of<decompose_kernels<double>, double, decompose_variants>();

template <>
constinit const decompose_compact_kernels<float> kernels_on<decompose_compact_kernels<float>, here>::table =
    table_of<decompose_compact_kernels<float>, float, decompose_compact_variants>();
template <>
constinit const decompose_compact_kernels<double> kernels_on<decompose_compact_kernels<double>, here>::table =
    table_of<decompose_compact_kernels<double>, double, decompose_compact_variants>();

}  // namespace swivel
