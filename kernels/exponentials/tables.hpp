#ifndef SWIVEL_KERNELS_EXPONENTIALS_TABLES_HPP
#define SWIVEL_KERNELS_EXPONENTIALS_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct square_root_kernels : kernel_set<T, precisions> {};
template <class T>
struct exp_kernels : kernel_set<T, precisions> {};
template <class T>
struct log_kernels : kernel_set<T, precisions> {};
template <class T>
struct power_kernels : kernel_set<T, precisions> {};

}  // namespace swivel

#endif
