#ifndef SWIVEL_KERNELS_REGISTERS_UNMASKED_HPP
#define SWIVEL_KERNELS_REGISTERS_UNMASKED_HPP

// What registers have in common on ISAs without masked operations.

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "kernels/registers/every_isa.hpp"

namespace swivel {
namespace {

template <class V>
inline V one_signed_like(V a) noexcept {
    return sign_of(a) | V(scalar_of<V>(1));
}

template <int Bit, class V>
inline mask_of<V> has_bit(V a) noexcept {
    using T = scalar_of<V>;
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    // Beside the bits of 1, since a comparison may take a number as small as that bit alone for 0.
    const V one(T(1)), bit(__builtin_bit_cast(T, static_cast<bits>(bits{1} << Bit)));
    return ((a & bit) | one) > one;
}

template <class V>
inline V product_or(mask_of<V> m, V a, V b, V other) noexcept {
    return select(m, a * b, other);
}

template <class V>
inline V product_or_zero(mask_of<V> m, V a, V b) noexcept {
    return select(m, a * b, V(scalar_of<V>(0)));
}

// Defined for the registers of the ISA: V::size quaternions, their components in the order of memory.
template <class A>
inline void load_quaternions(const float* from, xsimd::batch<float, A>* c) noexcept;
template <class A>
inline void load_quaternions(const double* from, xsimd::batch<double, A>* c) noexcept;
template <class A>
inline void store_quaternions(const xsimd::batch<float, A>* c, float* to) noexcept;
template <class A>
inline void store_quaternions(const xsimd::batch<double, A>* c, double* to) noexcept;

// Components in another order than that of memory pass through the stack; the processor forwards them without
// waiting for memory.
template <class V>
class quaternion_shuffle {
    using T = scalar_of<V>;

    int place_[4];
    bool as_it_is_;

public:
    void set(const std::ptrdiff_t* slot) noexcept {
        as_it_is_ = true;
        for (int k = 0; k < 4; ++k) {
            place_[slot[k]] = k;
            as_it_is_ = as_it_is_ && slot[k] == k;
        }
    }

    void load(const T* from, V* c) const noexcept {
        load_quaternions(from, c);
        if (as_it_is_) return;
        alignas(V) T slot[4][V::size];
        c[0].store_aligned(slot[place_[0]]);
        c[1].store_aligned(slot[place_[1]]);
        c[2].store_aligned(slot[place_[2]]);
        c[3].store_aligned(slot[place_[3]]);
        c[0] = V::load_aligned(slot[0]);
        c[1] = V::load_aligned(slot[1]);
        c[2] = V::load_aligned(slot[2]);
        c[3] = V::load_aligned(slot[3]);
    }

    void store(const V* c, T* to) const noexcept {
        if (as_it_is_) return store_quaternions(c, to);
        alignas(V) T slot[4][V::size];
        c[0].store_aligned(slot[0]);
        c[1].store_aligned(slot[1]);
        c[2].store_aligned(slot[2]);
        c[3].store_aligned(slot[3]);
        const V m[4] = {V::load_aligned(slot[place_[0]]), V::load_aligned(slot[place_[1]]),
                        V::load_aligned(slot[place_[2]]), V::load_aligned(slot[place_[3]])};
        store_quaternions(m, to);
    }
};

}  // namespace
}  // namespace swivel

#endif
