#ifndef SWIVEL_KERNELS_ARCS_TABLES_HPP
#define SWIVEL_KERNELS_ARCS_TABLES_HPP

#include "kernels/kernel.hpp"

namespace swivel {

template <class T>
struct shortest_arc_kernels : kernel_set<T, precisions> {};
template <class T>
struct arc_with_twist_kernels : kernel_set<T, 2, precisions> {};  // the twist after, before the arc

}  // namespace swivel

#endif
