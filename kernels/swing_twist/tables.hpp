#ifndef SWIVEL_KERNELS_SWING_TWIST_TABLES_HPP
#define SWIVEL_KERNELS_SWING_TWIST_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct decompose_kernels : kernel_set<T, axis_forms, 2, precisions> {};  // whether signs are kept
template <class T>
struct decompose_compact_kernels : kernel_set<T, 2, precisions> {};  // whether signs are kept

template <class T>
struct twist_kernels : kernel_set<T, axis_forms, precisions> {};

template <class T>
struct swing_kernels : kernel_set<T, axis_forms, precisions> {};

template <class T>
struct twist_angle_kernels : kernel_set<T, axis_forms, precisions> {};

template <class T>
struct compose_kernels : kernel_set<T, 2, precisions> {};  // whether signs are given
template <class T>
struct compose_compact_kernels : kernel_set<T, 2, precisions> {};  // whether signs are given

}  // namespace swivel

#endif
