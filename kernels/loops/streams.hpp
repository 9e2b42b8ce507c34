#ifndef SWIVEL_KERNELS_LOOPS_STREAMS_HPP
#define SWIVEL_KERNELS_LOOPS_STREAMS_HPP

#include <cstddef>

namespace swivel {
namespace {

// What an operation reads or writes: the number of streams of each group, in order. An operation is
//   using reads = streams<4, 4, 1>, writes = streams<4>;
//   explicit Op(const T* uniform)                  takes the numbers that are the same for all elements
//   void operator()(const V* in, V* out) const     the maths for one register of each stream
template <int... Components>
struct streams {
    static constexpr int groups = sizeof...(Components), count = (0 + ... + Components);
    // One more, since there may be none.
    static constexpr int components[] = {Components..., 0};

    static constexpr int group_of(int stream) noexcept {
        int group = 0;
        while (stream >= components[group]) stream -= components[group++];
        return group;
    }
    static constexpr int first_of(int group) noexcept {
        int stream = 0;
        for (int k = 0; k < group; ++k) stream += components[k];
        return stream;
    }
    static constexpr bool is_scalar(int stream) noexcept { return components[group_of(stream)] == 1; }
};

template <class A, class B>
struct joined;
template <int... A, int... B>
struct joined<streams<A...>, streams<B...>> {
    using type = streams<A..., B...>;
};
template <class A, class B>
using joined_streams = typename joined<A, B>::type;

}  // namespace
}  // namespace swivel

#endif
