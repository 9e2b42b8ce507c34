#include "kernels/swing_twist/compose.hpp"

#include "kernels/loops/tables.hpp"
#include "kernels/swing_twist/tables.hpp"

namespace swivel {

namespace {

// Signs are given now and then only.
struct compose_variants : light {
    template <int Signs, int P>
    static constexpr bool is_light = Signs == 0;

    template <class V, int Signs, int P>
    using op = compose_op<precision_index(P), Signs != 0, V>;
};

struct compose_compact_variants : light {
    template <int Signs, int P>
    static constexpr bool is_light = Signs == 0;

    template <class V, int Signs, int P>
    using op = compose_compact_op<precision_index(P), Signs != 0, V>;
};

}  // namespace

template <>
constinit const compose_kernels<float> kernels_on<compose_kernels<float>, here>::table =
    table_of<compose_kernels<float>, float, compose_variants>();
template <>
constinit const compose_kernels<double> kernels_on<compose_kernels<double>, here>::table =
    table_of<compose_kernels<double>, double, compose_variants>();

template <>
constinit const compose_compact_kernels<float> kernels_on<compose_compact_kernels<float>, here>::table =
    table_of<compose_compact_kernels<float>, float, compose_compact_variants>();
template <>
constinit const compose_compact_kernels<double> kernels_on<compose_compact_kernels<double>, here>::table =
    table_of<compose_compact_kernels<double>, double, compose_compact_variants>();

}  // namespace swivel
