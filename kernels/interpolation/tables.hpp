#ifndef SWIVEL_KERNELS_INTERPOLATION_TABLES_HPP
#define SWIVEL_KERNELS_INTERPOLATION_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct slerp_kernels : kernel_set<T, 2, precisions> {};  // the short, the long way

template <class T>
struct nlerp_kernels : kernel_set<T, precisions> {};

template <class T>
struct sterp_kernels : kernel_set<T, 2, 2, precisions> {
};  // one axis for all, one for each element; at constant speed, along the chord

}  // namespace swivel

#endif
