#ifndef SWIVEL_KERNELS_LOOPS_TABLES_HPP
#define SWIVEL_KERNELS_LOOPS_TABLES_HPP

// From the operations of a source of kernels to their tables.
//
// What an operation is, a struct says:
//   struct slerp : heavy {
//       template <class V, int LongWay, int P>
//       using op = slerp_op<precision_index(P), LongWay != 0, V>;
//   };
// with the variants of its kernel_set; the precision, where there is one, is the last.

#include "kernels/loops/arrays.hpp"
#include "kernels/loops/contiguous.hpp"
#include "kernels/loops/staged.hpp"

namespace swivel {

// The ISA that the source is compiled for; each is a tag of its own.
struct SWIVEL_KERNEL_ISA;
using here = SWIVEL_KERNEL_ISA;

namespace {

// Cheaper than to transpose what it reads and writes: in `fast` tails and arrays have bodies of their own. The
// rest, and everything in `reproducible`, has one body, through which arrays go by way of blocks.
struct light {
    static constexpr bool in_twins = false;
    template <int...>
    static constexpr bool is_light = true;
};
struct heavy {
    static constexpr bool in_twins = false;
    template <int...>
    static constexpr bool is_light = false;
};
// Of many steps that wait for one another: two registers at a time (twin.hpp).
struct deep {
    static constexpr bool in_twins = true;
    template <int...>
    static constexpr bool is_light = false;
};

template <class V, class Op>
void light_any(const batch<scalar_of<V>>& b) noexcept {
    if constexpr (may_be_arrays<typename Op::reads>() && may_be_arrays<typename Op::writes>())
        if (are_arrays<Op>(b)) return array_loop<V, Op>(b);
    staged_loop<V, Op>(b, light_loop<V, Op>);
}

template <class V, class W, class Op>
void heavy_any(const batch<scalar_of<V>>& b) noexcept {
    staged_loop<V, Op>(b, heavy_loop<W, Op>);
}

template <class V, class Kind, int... Which>
constexpr loops<scalar_of<V>> loops_of() noexcept {
    constexpr int which[] = {Which...};
    constexpr bool is_fast = which[sizeof...(Which) - 1] == fast_index;
    if constexpr (Kind::template is_light<Which...> && is_fast) {
        using op = typename Kind::template op<V, Which...>;
        return {light_loop<V, op>, light_any<V, op>};
    } else {
        using W = std::conditional_t<Kind::in_twins && takes_twins, twin<V>, V>;
        using op = typename Kind::template op<W, Which...>;
        return {heavy_loop<W, op>, heavy_any<V, W, op>};
    }
}

// What the variants of one kernel are, from its place in the table: a number in a system whose digits have that
// many values each.
template <int Number, std::size_t Place, int... Variants>
constexpr int digit() noexcept {
    constexpr int values[] = {Variants...};
    int rest = Number;
    for (std::size_t k = sizeof...(Variants) - 1; k > Place; --k) rest /= values[k];
    return rest % values[Place];
}

template <class V, class Kind, int Number, int... Variants, std::size_t... Place>
constexpr loops<scalar_of<V>> numbered(std::index_sequence<Place...>) noexcept {
    return loops_of<V, Kind, digit<Number, Place, Variants...>()...>();
}

template <class V, class Kind, int Number, class T, int... Variants>
constexpr loops<T> numbered(const kernel_set<T, Variants...>&) noexcept {
    return numbered<V, Kind, Number, Variants...>(std::make_index_sequence<sizeof...(Variants)>());
}

template <class V, class Kind, class Kernels, int... Number>
constexpr Kernels filled(std::integer_sequence<int, Number...>) noexcept {
    Kernels table{};
    ((table.all[Number] = numbered<V, Kind, Number>(table)), ...);
    return table;
}

template <class T, int... Variants>
constexpr auto numbers_of(const kernel_set<T, Variants...>&) noexcept {
    return std::make_integer_sequence<int, (1 * ... * Variants)>();
}

// The kernels of the operation `Kind` for the element type T.
template <class Kernels, class T, class Kind>
constexpr Kernels table_of() noexcept {
    return filled<xsimd::batch<T, architecture>, Kind, Kernels>(numbers_of(Kernels{}));
}

}  // namespace
}  // namespace swivel

#endif
