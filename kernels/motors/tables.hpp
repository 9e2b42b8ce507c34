#ifndef SWIVEL_KERNELS_MOTORS_TABLES_HPP
#define SWIVEL_KERNELS_MOTORS_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct motor_multiply_kernels : kernel_set<T, precisions> {};
template <class T>
struct motor_conjugate_kernels : kernel_set<T, 1> {};
template <class T>
struct motor_normalize_kernels : kernel_set<T, precisions> {};
template <class T>
struct from_rotation_translation_kernels : kernel_set<T, precisions> {};
template <class T>
struct to_rotation_translation_kernels : kernel_set<T, precisions> {};
template <class T>
struct motor_transform_kernels : kernel_set<T, precisions> {};
template <class T>
struct motor_blend_kernels : kernel_set<T, precisions> {};
template <class T>
struct motor_compose_kernels : kernel_set<T, precisions> {};

template <class T>
struct motor_decompose_kernels : kernel_set<T, axis_forms, precisions> {};

template <class T>
struct motor_square_root_kernels : kernel_set<T, precisions> {};
template <class T>
struct motor_log_kernels : kernel_set<T, precisions> {};
template <class T>
struct motor_exp_kernels : kernel_set<T, precisions> {};
template <class T>
struct motor_power_kernels : kernel_set<T, precisions> {};
template <class T>
struct sclerp_kernels : kernel_set<T, 2, precisions> {};  // the short, the long way

}  // namespace swivel

#endif
