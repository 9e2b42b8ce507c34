#include "kernels/loops/tables.hpp"
#include "kernels/motors/motor_power.hpp"
#include "kernels/motors/tables.hpp"

namespace swivel {

namespace {

struct motor_square_root_variants : deep {
    template <class V, int P>
    using op = motor_square_root_op<precision_index(P), V>;
};

struct motor_log_variants : deep {
    template <class V, int P>
    using op = motor_log_op<precision_index(P), V>;
};

struct motor_exp_variants : deep {
    template <class V, int P>
    using op = motor_exp_op<precision_index(P), V>;
};

struct motor_power_variants : deep {
    template <class V, int P>
    using op = motor_power_op<precision_index(P), V>;
};

struct sclerp_variants : deep {
    template <class V, int LongWay, int P>
    using op = sclerp_op<precision_index(P), LongWay != 0, V>;
};

}  // namespace

template <>
constinit const motor_square_root_kernels<float> kernels_on<motor_square_root_kernels<float>, here>::table =
    table_of<motor_square_root_kernels<float>, float, motor_square_root_variants>();
template <>
constinit const motor_square_root_kernels<double> kernels_on<motor_square_root_kernels<double>, here>::table =
    table_of<motor_square_root_kernels<double>, double, motor_square_root_variants>();

template <>
constinit const motor_log_kernels<float> kernels_on<motor_log_kernels<float>, here>::table =
    table_of<motor_log_kernels<float>, float, motor_log_variants>();
template <>
constinit const motor_log_kernels<double> kernels_on<motor_log_kernels<double>, here>::table =
    table_of<motor_log_kernels<double>, double, motor_log_variants>();

template <>
constinit const motor_exp_kernels<float> kernels_on<motor_exp_kernels<float>, here>::table =
    table_of<motor_exp_kernels<float>, float, motor_exp_variants>();
template <>
constinit const motor_exp_kernels<double> kernels_on<motor_exp_kernels<double>, here>::table =
    table_of<motor_exp_kernels<double>, double, motor_exp_variants>();

template <>
constinit const motor_power_kernels<float> kernels_on<motor_power_kernels<float>, here>::table =
    table_of<motor_power_kernels<float>, float, motor_power_variants>();
template <>
constinit const motor_power_kernels<double> kernels_on<motor_power_kernels<double>, here>::table =
    table_of<motor_power_kernels<double>, double, motor_power_variants>();

template <>
constinit const sclerp_kernels<float> kernels_on<sclerp_kernels<float>, here>::table =
    table_of<sclerp_kernels<float>, float, sclerp_variants>();
template <>
constinit const sclerp_kernels<double> kernels_on<sclerp_kernels<double>, here>::table =
    table_of<sclerp_kernels<double>, double, sclerp_variants>();

}  // namespace swivel
