#ifndef SWIVEL_KERNELS_ROTORS_TABLES_HPP
#define SWIVEL_KERNELS_ROTORS_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct conjugate_kernels : kernel_set<T, 1> {};
template <class T>
struct normalize_kernels : kernel_set<T, precisions> {};
template <class T>
struct rotate_kernels : kernel_set<T, precisions> {};
template <class T>
struct rotate_by_one_kernels : kernel_set<T, precisions> {};
template <class T>
struct dot_kernels : kernel_set<T, precisions> {};
template <class T>
struct angle_between_kernels : kernel_set<T, precisions> {};
template <class T>
struct align_signs_kernels : kernel_set<T, precisions> {};

}  // namespace swivel

#endif
