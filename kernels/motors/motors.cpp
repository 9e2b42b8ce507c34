#include "kernels/loops/tables.hpp"
#include "kernels/motors/motor.hpp"
#include "kernels/motors/tables.hpp"

namespace swivel {

namespace {

struct motor_multiply_variants : light {
    template <class V, int P>
    using op = motor_multiply_op<precision_index(P), V>;
};

struct motor_conjugate_variants : light {
    template <class V, int>
    using op = motor_conjugate_op<V>;
};

struct motor_normalize_variants : light {
    template <class V, int P>
    using op = motor_normalize_op<precision_index(P), V>;
};

struct from_rotation_translation_variants : light {
    template <class V, int P>
    using op = from_rotation_translation_op<precision_index(P), V>;
};

struct to_rotation_translation_variants : light {
    template <class V, int P>
    using op = to_rotation_translation_op<precision_index(P), V>;
};

struct motor_transform_variants : light {
    template <class V, int P>
    using op = motor_transform_op<precision_index(P), V>;
};

struct motor_blend_variants : light {
    template <class V, int P>
    using op = motor_blend_op<precision_index(P), V>;
};

struct motor_compose_variants : light {
    template <class V, int P>
    using op = motor_compose_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const motor_multiply_kernels<float> kernels_on<motor_multiply_kernels<float>, here>::table =
    table_of<motor_multiply_kernels<float>, float, motor_multiply_variants>();
template <>
constinit const motor_multiply_kernels<double> kernels_on<motor_multiply_kernels<double>, here>::table =
    table_of<motor_multiply_kernels<double>, double, motor_multiply_variants>();

template <>
constinit const motor_conjugate_kernels<float> kernels_on<motor_conjugate_kernels<float>, here>::table =
    table_of<motor_conjugate_kernels<float>, float, motor_conjugate_variants>();
template <>
constinit const motor_conjugate_kernels<double> kernels_on<motor_conjugate_kernels<double>, here>::table =
    table_of<motor_conjugate_kernels<double>, double, motor_conjugate_variants>();

template <>
constinit const motor_normalize_kernels<float> kernels_on<motor_normalize_kernels<float>, here>::table =
    table_of<motor_normalize_kernels<float>, float, motor_normalize_variants>();
template <>
constinit const motor_normalize_kernels<double> kernels_on<motor_normalize_kernels<double>, here>::table =
    table_of<motor_normalize_kernels<double>, double, motor_normalize_variants>();

template <>
constinit const from_rotation_translation_kernels<float>
    kernels_on<from_rotation_translation_kernels<float>, here>::table =
        table_of<from_rotation_translation_kernels<float>, float, from_rotation_translation_variants>();
template <>
constinit const from_rotation_translation_kernels<double>
    kernels_on<from_rotation_translation_kernels<double>, here>::table =
        table_of<from_rotation_translation_kernels<double>, double, from_rotation_translation_variants>();

template <>
constinit const to_rotation_translation_kernels<float>
    kernels_on<to_rotation_translation_kernels<float>, here>::table =
        table_of<to_rotation_translation_kernels<float>, float, to_rotation_translation_variants>();
template <>
constinit const to_rotation_translation_kernels<double>
    kernels_on<to_rotation_translation_kernels<double>, here>::table =
        table_of<to_rotation_translation_kernels<double>, double, to_rotation_translation_variants>();

template <>
constinit const motor_transform_kernels<float> kernels_on<motor_transform_kernels<float>, here>::table =
    table_of<motor_transform_kernels<float>, float, motor_transform_variants>();
template <>
constinit const motor_transform_kernels<double> kernels_on<motor_transform_kernels<double>, here>::table =
    table_of<motor_transform_kernels<double>, double, motor_transform_variants>();

template <>
constinit const motor_blend_kernels<float> kernels_on<motor_blend_kernels<float>, here>::table =
    table_of<motor_blend_kernels<float>, float, motor_blend_variants>();
template <>
constinit const motor_blend_kernels<double> kernels_on<motor_blend_kernels<double>, here>::table =
    table_of<motor_blend_kernels<double>, double, motor_blend_variants>();

template <>
constinit const motor_compose_kernels<float> kernels_on<motor_compose_kernels<float>, here>::table =
    table_of<motor_compose_kernels<float>, float, motor_compose_variants>();
template <>
constinit const motor_compose_kernels<double> kernels_on<motor_compose_kernels<double>, here>::table =
    table_of<motor_compose_kernels<double>, double, motor_compose_variants>();

}  // namespace swivel
