#ifndef SWIVEL_BENCH_SUPPORT_PEER_ROWS_HPP
#define SWIVEL_BENCH_SUPPORT_PEER_ROWS_HPP

#include <type_traits>

#include "bench/peers/peers.hpp"
#include "bench/support/row.hpp"

namespace swivel_bench {

// Calls add(Peer{}, name) for each of the plain loops.
template <class T, class Add>
void for_each_plain(Add add) {
    add(plain<T, preferred_width>{}, "plain");
    add(plain<T, widest>{}, "plain512");
}

// A unit vector that is no coordinate axis.
template <class T>
inline constexpr swivel::vec3<T> oblique{T(2) / 7, T(-3) / 7, T(6) / 7};

// The floor of an operation over so many streams, and of the same one over arrays of quaternions.
template <class T, int inputs, int outputs>
void add_copy_rows(std::string_view op, layout l, std::size_t per_element = 1) {
    const auto prepare = [per_element](workload<T>& streams, auto copy_function) {
        const T* in[inputs];
        T* out[outputs];
        for (const T*& s : in) s = streams.copied(per_element);
        for (T*& s : out) s = streams.written(per_element);
        const std::size_t count = per_element * streams.size();
        return [in, out, count, copy_function] { copy_function(in, out, count); };
    };
    add_rows<T>(op, "copy", l, [prepare](workload<T>& s) { return prepare(s, copy<T, inputs, outputs>); });
    if constexpr (inputs <= outputs)
        add_rows<T>(op, "memcpy", l,
                    [prepare](workload<T>& s) { return prepare(s, copy_by_memcpy<T, inputs, outputs>); });
}

}  // namespace swivel_bench

#endif
