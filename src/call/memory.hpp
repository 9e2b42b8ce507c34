#ifndef SWIVEL_SRC_CALL_MEMORY_HPP
#define SWIVEL_SRC_CALL_MEMORY_HPP

// The memory of a view, and whether what is written may touch what else there is.

#include <cstddef>
#include <cstdint>

#include "kernels/kernel.hpp"
#include "swivel/types.hpp"

namespace swivel {

// The bytes from the first to the last one of some streams.
struct extent {
    std::uintptr_t begin, end;

    bool overlaps(const extent& o) const noexcept { return begin < o.end && o.begin < end; }
};

// One view of a call: its streams among those of the batch, as the caller gave them.
struct group {
    int first, count;
    std::size_t size;
    std::ptrdiff_t stride;
};

// The extent of streams of any stride; empty where more has to be looked at: a null pointer, more than there is
// memory, or written streams of which two may share a byte. (Pure: what the caller knows of its own memory stays
// known across the call.)
template <class T>
[[gnu::pure]] extent extent_of_any(T* const* stream, int count, std::size_t size, std::ptrdiff_t stride,
                                   bool written) noexcept;

// Element for element, what the extents leave open: null pointers, sizes, strides, overlaps. Leaves stride 1
// in groups of one element.
template <class T>
status check_elements(const batch<T>& b, std::size_t size, group* in, int inputs, group* out,
                      int outputs) noexcept;

inline constexpr int most_scalars = 2;

// Fills a block with each scalar that is the same for all elements, so that the loops can load registers full of it.
template <class T>
void repeat_scalars(batch<T>& b, const group* in, int inputs,
                    T (&blocks)[most_scalars][repeated_bytes / sizeof(T)]) noexcept;

}  // namespace swivel

#endif
