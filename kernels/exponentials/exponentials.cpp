#include "kernels/exponentials/exp.hpp"
#include "kernels/exponentials/log.hpp"
#include "kernels/exponentials/power.hpp"
#include "kernels/exponentials/square_root.hpp"
#include "kernels/exponentials/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct square_root_variants : deep {
    template <class V, int P>
    using op = square_root_op<precision_index(P), V>;
};

struct exp_variants : deep {
    template <class V, int P>
    using op = exp_op<precision_index(P), V>;
};

struct log_variants : deep {
    template <class V, int P>
    using op = log_op<precision_index(P), V>;
};

struct power_variants : deep {
    template <class V, int P>
    using op = power_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const square_root_kernels<float> kernels_on<square_root_kernels<float>, here>::table =
    table_of<square_root_kernels<float>, float, square_root_variants>();
template <>
constinit const square_root_kernels<double> kernels_on<square_root_kernels<double>, here>::table =
    table_of<square_root_kernels<double>, double, square_root_variants>();

template <>
constinit const exp_kernels<float> kernels_on<exp_kernels<float>, here>::table =
    table_of<exp_kernels<float>, float, exp_variants>();
template <>
constinit const exp_kernels<double> kernels_on<exp_kernels<double>, here>::table =
    table_of<exp_kernels<double>, double, exp_variants>();

template <>
constinit const log_kernels<float> kernels_on<log_kernels<float>, here>::table =
    table_of<log_kernels<float>, float, log_variants>();
template <>
constinit const log_kernels<double> kernels_on<log_kernels<double>, here>::table =
    table_of<log_kernels<double>, double, log_variants>();

template <>
constinit const power_kernels<float> kernels_on<power_kernels<float>, here>::table =
    table_of<power_kernels<float>, float, power_variants>();
template <>
constinit const power_kernels<double> kernels_on<power_kernels<double>, here>::table =
    table_of<power_kernels<double>, double, power_variants>();

}  // namespace swivel
