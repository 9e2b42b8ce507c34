#ifndef SWIVEL_SRC_CALL_CHECKS_HPP
#define SWIVEL_SRC_CALL_CHECKS_HPP

// What is checked of the streams before the first write, at a cost that does not depend on the size.

#include <cstddef>
#include <cstdint>
#include <tuple>

#include "kernels/kernel_table.hpp"
#include "swivel/types.hpp"

namespace swivel {

// The streams of one view, and the place of each among those that the kernel takes.
template <class T, int N>
struct stream_group {
    T* stream[N];
    std::size_t size;
    std::ptrdiff_t stride;
    const std::uint8_t* place;
};

// The streams in the order of the kernel, and their number as a value.
template <class T>
struct any_group {
    T* stream[most_in_group];
    int count;
    std::size_t size;
    std::ptrdiff_t stride;

    any_group() = default;

    template <int N>
    explicit any_group(const stream_group<T, N>& g) noexcept : count(N), size(g.size), stride(g.stride) {
        for (int k = 0; k < N; ++k) stream[g.place[k]] = g.stream[k];
    }
};

// All streams of a call.
template <class T>
struct call_streams {
    any_group<const T> in[most_groups];
    any_group<T> out[most_groups];
    int inputs = 0, outputs = 0;
    std::size_t size = 0;

    template <class... In, class... Out>
    call_streams(const std::tuple<In...>& reads, const std::tuple<Out...>& writes) noexcept {
        static_assert(sizeof...(In) <= most_groups && sizeof...(Out) <= most_groups);
        std::apply([&](const auto&... g) { ((in[inputs++] = any_group<const T>(g)), ...); }, reads);
        std::apply([&](const auto&... g) { ((out[outputs++] = any_group<T>(g)), ...); }, writes);
    }
};

// Leaves the size in s.size; 0 with `ok` means that there is nothing to do. The stride of a single element
// becomes 1.
template <class T>
status check(call_streams<T>& s) noexcept;

// The bytes from the first to the last one of some streams.
struct extent {
    std::uintptr_t begin, end;

    bool overlaps(const extent& o) const noexcept { return begin < o.end && o.begin < end; }
};

// Whether the group is an array of quaternions, x first or w first.
template <class T, int N>
bool is_array(const stream_group<T, N>& g) noexcept {
    if constexpr (N != 4) {
        return false;
    } else {
        T* const first = g.stream[0];
        return g.stride == 4 && g.stream[1] == first + 1 && g.stream[2] == first + 2 &&
               (g.stream[3] == first + 3 || g.stream[3] == first - 1);
    }
}

// Tells the usual call from one that must be looked at more closely, right or wrong: streams that are
// contiguous and, within a view, one after the other in memory, or arrays of quaternions; each view apart
// from the others or, in place, the same as one that is read. That takes a few dozen comparisons, since the
// number of streams is a constant, so that a call for a few elements costs little.
template <class T>
class usual_call {
public:
    explicit usual_call(std::size_t size) noexcept
        : size_(size),
          bytes_(static_cast<std::ptrdiff_t>(size * sizeof(T))),
          // Neither 0 nor too many.
          usual_(size - 1 < static_cast<std::size_t>(PTRDIFF_MAX) / (4 * sizeof(T))) {}

    template <int N>
    [[gnu::always_inline]] void read(const stream_group<const T, N>& g) noexcept {
        read_[reads_++] = look_at(g);
    }

    template <int N, class... In>
    [[gnu::always_inline]] void write(const stream_group<T, N>& g, const std::tuple<In...>& reads) noexcept {
        const extent e = look_at(g);
        for (int k = 0; k < writes_; ++k) usual_ = usual_ && !e.overlaps(written_[k]);
        written_[writes_++] = e;
        int k = 0;
        std::apply(
            [&](const auto&... in) { ((usual_ = usual_ && (!e.overlaps(read_[k++]) || same(g, in))), ...); },
            reads);
    }

    explicit operator bool() const noexcept { return usual_; }
    bool has_arrays() const noexcept { return has_arrays_; }

private:
    template <class U>
    static std::uintptr_t address(U* p) noexcept {
        return reinterpret_cast<std::uintptr_t>(p);
    }

    template <class U, int N>
    [[gnu::always_inline]] extent look_at(const stream_group<U, N>& g) noexcept {
        usual_ = usual_ && g.size == size_ && g.stream[0] != nullptr;
        if (g.stride == 1 || size_ == 1) {
            for (int k = 1; k < N; ++k)
                usual_ = usual_ && static_cast<std::ptrdiff_t>(address(g.stream[k]) -
                                                               address(g.stream[k - 1])) >= bytes_;
            return {address(g.stream[0]), address(g.stream[N - 1]) + static_cast<std::uintptr_t>(bytes_)};
        }
        has_arrays_ = true;
        usual_ = usual_ && is_array(g);
        const std::uintptr_t begin =
            address(g.stream[0]) - (N == 4 && g.stream[N - 1] < g.stream[0] ? sizeof(T) : 0);
        return {begin, begin + 4 * static_cast<std::uintptr_t>(bytes_)};
    }

    template <int N, int M>
    static bool same(const stream_group<T, N>& out, const stream_group<const T, M>& in) noexcept {
        if constexpr (N != M) {
            return false;
        } else {
            bool all = true;
            for (int k = 0; k < N; ++k) all = all && out.stream[k] == in.stream[k];
            return all;
        }
    }

    std::size_t size_;
    std::ptrdiff_t bytes_;
    bool usual_, has_arrays_ = false;
    int reads_ = 0, writes_ = 0;
    extent read_[most_groups], written_[most_groups];
};

}  // namespace swivel

#endif
