#include "kernels/conformal/conformal.hpp"

#include "kernels/conformal/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct conformal_multiply_variants : heavy {
    template <class V, int P>
    using op = conformal_multiply_op<precision_index(P), V>;
};

struct conformal_reverse_variants : heavy {
    template <class V, int>
    using op = conformal_reverse_op<V>;
};

struct conformal_from_motor_variants : heavy {
    template <class V, int>
    using op = conformal_from_motor_op<V>;
};

struct conformal_from_rotation_variants : heavy {
    template <class V, int>
    using op = conformal_from_rotation_op<V>;
};

struct conformal_from_translation_variants : heavy {
    template <class V, int>
    using op = conformal_from_translation_op<V>;
};

struct conformal_from_dilation_variants : heavy {
    template <class V, int>
    using op = conformal_from_dilation_op<V>;
};

struct conformal_transform_variants : heavy {
    template <class V, int P>
    using op = conformal_transform_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const conformal_multiply_kernels<float> kernels_on<conformal_multiply_kernels<float>, here>::table =
    table_of<conformal_multiply_kernels<float>, float, conformal_multiply_variants>();
template <>
constinit const conformal_multiply_kernels<double>
    kernels_on<conformal_multiply_kernels<double>, here>::table =
        table_of<conformal_multiply_kernels<double>, double, conformal_multiply_variants>();

template <>
constinit const conformal_reverse_kernels<float> kernels_on<conformal_reverse_kernels<float>, here>::table =
    table_of<conformal_reverse_kernels<float>, float, conformal_reverse_variants>();
template <>
constinit const conformal_reverse_kernels<double> kernels_on<conformal_reverse_kernels<double>, here>::table =
    table_of<conformal_reverse_kernels<double>, double, conformal_reverse_variants>();

template <>
constinit const conformal_from_motor_kernels<float>
    kernels_on<conformal_from_motor_kernels<float>, here>::table =
        table_of<conformal_from_motor_kernels<float>, float, conformal_from_motor_variants>();
template <>
constinit const conformal_from_motor_kernels<double>
    kernels_on<conformal_from_motor_kernels<double>, here>::table =
        table_of<conformal_from_motor_kernels<double>, double, conformal_from_motor_variants>();

template <>
constinit const conformal_from_rotation_kernels<float>
    kernels_on<conformal_from_rotation_kernels<float>, here>::table =
        table_of<conformal_from_rotation_kernels<float>, float, conformal_from_rotation_variants>();
template <>
constinit const conformal_from_rotation_kernels<double>
    kernels_on<conformal_from_rotation_kernels<double>, here>::table =
        table_of<conformal_from_rotation_kernels<double>, double, conformal_from_rotation_variants>();

template <>
constinit const conformal_from_translation_kernels<float>
    kernels_on<conformal_from_translation_kernels<float>, here>::table =
        table_of<conformal_from_translation_kernels<float>, float, conformal_from_translation_variants>();
template <>
constinit const conformal_from_translation_kernels<double>
    kernels_on<conformal_from_translation_kernels<double>, here>::table =
        table_of<conformal_from_translation_kernels<double>, double, conformal_from_translation_variants>();

template <>
constinit const conformal_from_dilation_kernels<float>
    kernels_on<conformal_from_dilation_kernels<float>, here>::table =
        table_of<conformal_from_dilation_kernels<float>, float, conformal_from_dilation_variants>();
template <>
constinit const conformal_from_dilation_kernels<double>
    kernels_on<conformal_from_dilation_kernels<double>, here>::table =
        table_of<conformal_from_dilation_kernels<double>, double, conformal_from_dilation_variants>();

template <>
constinit const conformal_transform_kernels<float>
    kernels_on<conformal_transform_kernels<float>, here>::table =
        table_of<conformal_transform_kernels<float>, float, conformal_transform_variants>();
template <>
constinit const conformal_transform_kernels<double>
    kernels_on<conformal_transform_kernels<double>, here>::table =
        table_of<conformal_transform_kernels<double>, double, conformal_transform_variants>();

}  // namespace swivel
