#ifndef SWIVEL_SRC_CALL_ACTIVE_HPP
#define SWIVEL_SRC_CALL_ACTIVE_HPP

// The kernels of the ISA in use.

#include <atomic>
#include <cstdint>

#include "kernels/kernel.hpp"

namespace swivel {

// The tags by which the kernels are compiled. One more ISA is a tag here and a row in isa.cpp.
struct avx512;
struct avx2;
struct sse2;
struct neon64;

template <class... Isas>
struct isa_list {};

// Those of the build, best first.
using compiled_isas = isa_list<SWIVEL_COMPILED_ISAS>;

// Which of them is in use; the only mutable state of the library, for all operations at once.
inline constexpr std::uint8_t no_isa = 255;
extern std::atomic<std::uint8_t> chosen_isa;

std::uint8_t choose_isa() noexcept;

inline std::uint8_t isa_in_use() noexcept {
    const std::uint8_t chosen = chosen_isa.load(std::memory_order_relaxed);
    return chosen != no_isa ? chosen : choose_isa();
}

template <class Kernels, class Isas>
struct tables_of;

#if defined(__clang__)
// The tables are defined where the kernels are.
#pragma clang diagnostic ignored "-Wundefined-var-template"
#endif
template <class Kernels, class... Isas>
struct tables_of<Kernels, isa_list<Isas...>> {
    static constexpr const Kernels* all[] = {&kernels_on<Kernels, Isas>::table...};
};

template <class T, int... Variants, class... Which>
const loops<T>& kernel_of(const kernel_set<T, Variants...>& kernels, Which... which) noexcept {
    static_assert(sizeof...(Which) == sizeof...(Variants));
    int index = 0;
    ((index = index * Variants + static_cast<int>(which)), ...);
    return kernels.all[index];
}

template <template <class> class Kernels, class T, class... Which>
const loops<T>& active(Which... which) noexcept {
    return kernel_of(*tables_of<Kernels<T>, compiled_isas>::all[isa_in_use()], which...);
}

}  // namespace swivel

#endif
