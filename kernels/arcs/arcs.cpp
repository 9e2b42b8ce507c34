#include "kernels/arcs/arc_with_twist.hpp"
#include "kernels/arcs/shortest_arc.hpp"
#include "kernels/arcs/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct shortest_arc_variants : deep {
    template <class V, int P>
    using op = shortest_arc_op<precision_index(P), V>;
};

struct arc_with_twist_variants : deep {
    template <class V, int Before, int P>
    using op = arc_with_twist_op<precision_index(P), Before != 0, V>;
};

}  // namespace

template <>
constinit const shortest_arc_kernels<float> kernels_on<shortest_arc_kernels<float>, here>::table =
    table_of<shortest_arc_kernels<float>, float, shortest_arc_variants>();
template <>
constinit const shortest_arc_kernels<double> kernels_on<shortest_arc_kernels<double>, here>::table =
    table_of<shortest_arc_kernels<double>, double, shortest_arc_variants>();

template <>
constinit const arc_with_twist_kernels<float> kernels_on<arc_with_twist_kernels<float>, here>::table =
    table_of<arc_with_twist_kernels<float>, float, arc_with_twist_variants>();
template <>
constinit const arc_with_twist_kernels<double> kernels_on<arc_with_twist_kernels<double>, here>::table =
    table_of<arc_with_twist_kernels<double>, double, arc_with_twist_variants>();

}  // namespace swivel
