#ifndef SWIVEL_KERNELS_ANGLES_TABLES_HPP
#define SWIVEL_KERNELS_ANGLES_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct sincos_kernels : kernel_set<T, precisions> {};
template <class T>
struct atan2_kernels : kernel_set<T, precisions> {};

}  // namespace swivel

#endif
