#ifndef SWIVEL_TESTS_ISA_OBJECTS_TABLE_HPP
#define SWIVEL_TESTS_ISA_OBJECTS_TABLE_HPP

// The table of an operation, as the kernels define it.
namespace swivel {
struct sse2;
template <class T>
struct one_kernels {
    T (*all)(const T*);
};
template <class Kernels, class Isa>
struct kernels_on {
    static const Kernels table;
};
}  // namespace swivel

#endif
