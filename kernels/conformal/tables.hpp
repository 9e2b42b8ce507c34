#ifndef SWIVEL_KERNELS_CONFORMAL_TABLES_HPP
#define SWIVEL_KERNELS_CONFORMAL_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct conformal_multiply_kernels : kernel_set<T, precisions> {};
template <class T>
struct conformal_reverse_kernels : kernel_set<T, 1> {};
template <class T>
struct conformal_from_motor_kernels : kernel_set<T, 1> {};
template <class T>
struct conformal_from_rotation_kernels : kernel_set<T, 1> {};
template <class T>
struct conformal_from_translation_kernels : kernel_set<T, 1> {};
template <class T>
struct conformal_from_dilation_kernels : kernel_set<T, 1> {};
template <class T>
struct conformal_transform_kernels : kernel_set<T, precisions> {};

template <class T>
struct conformal_square_root_kernels : kernel_set<T, precisions> {};
template <class T>
struct conformal_exp_kernels : kernel_set<T, precisions> {};
template <class T>
struct conformal_log_kernels : kernel_set<T, precisions> {};
template <class T>
struct conformal_power_kernels : kernel_set<T, precisions> {};
template <class T>
struct conformal_interpolate_kernels : kernel_set<T, precisions> {};
template <class T>
struct conformal_split_kernels : kernel_set<T, precisions> {};

}  // namespace swivel

#endif
