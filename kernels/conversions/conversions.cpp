#include "kernels/conversions/axis_angle.hpp"
#include "kernels/conversions/euler.hpp"
#include "kernels/conversions/matrix.hpp"
#include "kernels/conversions/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct from_axis_angle_variants : heavy {
    template <class V, int Form, int P>
    using op = from_axis_angle_op<Form, precision_index(P), V>;
};

struct to_axis_angle_variants : heavy {
    template <class V, int P>
    using op = to_axis_angle_op<precision_index(P), V>;
};

struct from_euler_variants : heavy {
    template <class V, int P>
    using op = from_euler_op<precision_index(P), V>;
};

struct to_euler_variants : heavy {
    template <class V, int P>
    using op = to_euler_op<precision_index(P), V>;
};

struct from_matrix_variants : heavy {
    template <class V, int P>
    using op = from_matrix_op<precision_index(P), V>;
};

struct to_matrix_variants : heavy {
    template <class V, int P>
    using op = to_matrix_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const from_axis_angle_kernels<float> kernels_on<from_axis_angle_kernels<float>, here>::table =
    table_of<from_axis_angle_kernels<float>, float, from_axis_angle_variants>();
template <>
constinit const from_axis_angle_kernels<double> kernels_on<from_axis_angle_kernels<double>, here>::table =
    table_of<from_axis_angle_kernels<double>, double, from_axis_angle_variants>();

template <>
constinit const to_axis_angle_kernels<float> kernels_on<to_axis_angle_kernels<float>, here>::table =
    table_of<to_axis_angle_kernels<float>, float, to_axis_angle_variants>();
template <>
constinit const to_axis_angle_kernels<double> kernels_on<to_axis_angle_kernels<double>, here>::table =
    table_of<to_axis_angle_kernels<double>, double, to_axis_angle_variants>();

template <>
constinit const from_euler_kernels<float> kernels_on<from_euler_kernels<float>, here>::table =
    table_of<from_euler_kernels<float>, float, from_euler_variants>();
template <>
constinit const from_euler_kernels<double> kernels_on<from_euler_kernels<double>, here>::table =
    table_of<from_euler_kernels<double>, double, from_euler_variants>();

template <>
constinit const to_euler_kernels<float> kernels_on<to_euler_kernels<float>, here>::table =
    table_of<to_euler_kernels<float>, float, to_euler_variants>();
template <>
constinit const to_euler_kernels<double> kernels_on<to_euler_kernels<double>, here>::table =
    table_of<to_euler_kernels<double>, double, to_euler_variants>();

template <>
constinit const from_matrix_kernels<float> kernels_on<from_matrix_kernels<float>, here>::table =
    table_of<from_matrix_kernels<float>, float, from_matrix_variants>();
template <>
constinit const from_matrix_kernels<double> kernels_on<from_matrix_kernels<double>, here>::table =
    table_of<from_matrix_kernels<double>, double, from_matrix_variants>();

template <>
constinit const to_matrix_kernels<float> kernels_on<to_matrix_kernels<float>, here>::table =
    table_of<to_matrix_kernels<float>, float, to_matrix_variants>();
template <>
constinit const to_matrix_kernels<double> kernels_on<to_matrix_kernels<double>, here>::table =
    table_of<to_matrix_kernels<double>, double, to_matrix_variants>();

}  // namespace swivel
