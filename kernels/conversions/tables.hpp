#ifndef SWIVEL_KERNELS_CONVERSIONS_TABLES_HPP
#define SWIVEL_KERNELS_CONVERSIONS_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct from_axis_angle_kernels : kernel_set<T, axis_forms, precisions> {};
template <class T>
struct to_axis_angle_kernels : kernel_set<T, precisions> {};
template <class T>
struct from_euler_kernels : kernel_set<T, precisions> {};
template <class T>
struct to_euler_kernels : kernel_set<T, precisions> {};
template <class T>
struct from_matrix_kernels : kernel_set<T, precisions> {};
template <class T>
struct to_matrix_kernels : kernel_set<T, precisions> {};

}  // namespace swivel

#endif
