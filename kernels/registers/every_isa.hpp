#ifndef SWIVEL_KERNELS_REGISTERS_EVERY_ISA_HPP
#define SWIVEL_KERNELS_REGISTERS_EVERY_ISA_HPP

// What is the same on every ISA. Everything in this folder is in the unnamed namespace, since an inline function
// that two ISAs shared by name could be kept by the linker with the instructions of the wrong one.

#include <xsimd/xsimd.hpp>

namespace swivel {
namespace {

template <class V>
using scalar_of = typename V::value_type;

template <class V>
using mask_of = typename V::batch_bool_type;

template <class V>
inline V sign_of(V a) noexcept {
    return a & V(scalar_of<V>(-0.0));
}

template <class V>
inline V magnitude(V a) noexcept {
    // Not bitwise_andnot: releases of xsimd disagree on which operand it inverts.
    return a & ~V(scalar_of<V>(-0.0));
}

}  // namespace
}  // namespace swivel

#endif
