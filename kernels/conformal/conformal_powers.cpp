#include "kernels/conformal/conformal_exp.hpp"
#include "kernels/conformal/conformal_planes.hpp"
#include "kernels/conformal/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct conformal_square_root_variants : heavy {
    template <class V, int P>
    using op = conformal_square_root_op<precision_index(P), V>;
};

struct conformal_exp_variants : heavy {
    template <class V, int P>
    using op = conformal_exp_op<precision_index(P), V>;
};

struct conformal_log_variants : heavy {
    template <class V, int P>
    using op = conformal_log_op<precision_index(P), V>;
};

struct conformal_power_variants : heavy {
    template <class V, int P>
    using op = conformal_power_op<precision_index(P), V>;
};

struct conformal_interpolate_variants : heavy {
    template <class V, int P>
    using op = conformal_interpolate_op<precision_index(P), V>;
};

struct conformal_split_variants : heavy {
    template <class V, int P>
    using op = conformal_split_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const conformal_square_root_kernels<float>
    kernels_on<conformal_square_root_kernels<float>, here>::table =
        table_of<conformal_square_root_kernels<float>, float, conformal_square_root_variants>();
template <>
constinit const conformal_square_root_kernels<double>
    kernels_on<conformal_square_root_kernels<double>, here>::table =
        table_of<conformal_square_root_kernels<double>, double, conformal_square_root_variants>();

template <>
constinit const conformal_exp_kernels<float> kernels_on<conformal_exp_kernels<float>, here>::table =
    table_of<conformal_exp_kernels<float>, float, conformal_exp_variants>();
template <>
constinit const conformal_exp_kernels<double> kernels_on<conformal_exp_kernels<double>, here>::table =
    table_of<conformal_exp_kernels<double>, double, conformal_exp_variants>();

template <>
constinit const conformal_log_kernels<float> kernels_on<conformal_log_kernels<float>, here>::table =
    table_of<conformal_log_kernels<float>, float, conformal_log_variants>();
template <>
constinit const conformal_log_kernels<double> kernels_on<conformal_log_kernels<double>, here>::table =
    table_of<conformal_log_kernels<double>, double, conformal_log_variants>();

template <>
constinit const conformal_power_kernels<float> kernels_on<conformal_power_kernels<float>, here>::table =
    table_of<conformal_power_kernels<float>, float, conformal_power_variants>();
template <>
constinit const conformal_power_kernels<double> kernels_on<conformal_power_kernels<double>, here>::table =
    table_of<conformal_power_kernels<double>, double, conformal_power_variants>();

template <>
constinit const conformal_interpolate_kernels<float>
    kernels_on<conformal_interpolate_kernels<float>, here>::table =
        table_of<conformal_interpolate_kernels<float>, float, conformal_interpolate_variants>();
template <>
constinit const conformal_interpolate_kernels<double>
    kernels_on<conformal_interpolate_kernels<double>, here>::table =
        table_of<conformal_interpolate_kernels<double>, double, conformal_interpolate_variants>();

template <>
constinit const conformal_split_kernels<float> kernels_on<conformal_split_kernels<float>, here>::table =
    table_of<conformal_split_kernels<float>, float, conformal_split_variants>();
template <>
constinit const conformal_split_kernels<double> kernels_on<conformal_split_kernels<double>, here>::table =
    table_of<conformal_split_kernels<double>, double, conformal_split_variants>();

}  // namespace swivel
