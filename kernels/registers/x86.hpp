#ifndef SWIVEL_KERNELS_REGISTERS_X86_HPP
#define SWIVEL_KERNELS_REGISTERS_X86_HPP

// What x86 registers of every width have in common.

#include "kernels/registers/every_isa.hpp"

namespace swivel {
namespace {

// Where the operand of a root or a divisor is a choice of which nothing but one side is used, clang, for which no
// exception flag counts, takes the root or the quotient of the other. Not of what it cannot see through.
template <class V>
inline V chosen(V a) noexcept {
#if defined(__clang__)
    asm("" : "+x"(a.data));
#endif
    return a;
}

template <class V>
inline V square_root_of(V choice) noexcept {
    const V a = chosen(choice);
    return xsimd::sqrt(a);
}

template <class V>
inline V quotient(V a, V divisor) noexcept {
    const V b = chosen(divisor);
    return a / b;
}

}  // namespace
}  // namespace swivel

#endif
