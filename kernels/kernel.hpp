#ifndef SWIVEL_KERNELS_KERNEL_HPP
#define SWIVEL_KERNELS_KERNEL_HPP

// The interface between src/ (baseline flags) and the kernels of one ISA: plain data and function pointers, no
// inline function that could be emitted with the wrong instructions. Which kernels there are, each family says in
// its tables.hpp.

#include <cstddef>
#include <type_traits>

namespace swivel {

inline constexpr int most_inputs = 33, most_outputs = 21, most_groups = 5;

// One call of a kernel: the streams of every view (a group), in the order that the kernel takes, and a few
// numbers that are the same for all elements. Which stream is which, and which numbers, is said where the
// kernel is defined.
template <class T>
struct batch {
    const T* in[most_inputs];
    T* out[most_outputs];
    // Of each group, the distance from one element to the next. A scalar that is the same for all elements has
    // stride 0, and repeated_bytes of it in memory.
    std::ptrdiff_t in_stride[most_groups], out_stride[most_groups];
    T uniform[7];
    std::size_t size;
};

// Two registers of the widest ISA.
inline constexpr std::size_t repeated_bytes = 128;

template <class T>
using kernel = void (*)(const batch<T>&) noexcept;

// The kernel for streams that are all contiguous (or one number repeated), and the one for any strides.
template <class T>
struct loops {
    kernel<T> contiguous, any;
};

// The kernels of one operation: as many as there are combinations of that many variants, the last fastest.
template <class T, int... Variants>
struct kernel_set {
    loops<T> all[(1 * ... * Variants)];
};

// The kernels of an operation on an ISA: an explicit specialisation for each, and the only external symbols of
// the kernels. (g++ 12 gives specialisations of a plain variable template no symbol.)
template <class Kernels, class Isa>
struct kernels_on {
    static const Kernels table;
};

enum precision_index { fast_index, reproducible_index, precisions };
enum axis_form_index { coordinate_index, uniform_index, per_element_index, axis_forms };

}  // namespace swivel

#endif
