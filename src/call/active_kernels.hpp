#ifndef SWIVEL_SRC_CALL_ACTIVE_KERNELS_HPP
#define SWIVEL_SRC_CALL_ACTIVE_KERNELS_HPP

#include <atomic>
#include <type_traits>

#include "kernels/kernel_table.hpp"

namespace swivel {

// Null until the first call; the only mutable state of the library.
extern std::atomic<const kernel_table*> chosen_kernels;

const kernel_table& choose_kernels() noexcept;

inline const kernel_table& active_kernels() noexcept {
    const kernel_table* table = chosen_kernels.load(std::memory_order_acquire);
    return table != nullptr ? *table : choose_kernels();
}

template <class T>
const operations<T>& active_operations() noexcept {
    if constexpr (std::is_same_v<T, float>)
        return active_kernels().f32;
    else
        return active_kernels().f64;
}

}  // namespace swivel

#endif
