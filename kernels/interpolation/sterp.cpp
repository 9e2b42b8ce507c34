#include "kernels/interpolation/sterp.hpp"

#include "kernels/interpolation/tables.hpp"
#include "kernels/loops/tables.hpp"

namespace swivel {

namespace {

struct sterp_variants : deep {
    template <class V, int OwnAxis, int Chord, int P>
    using op = sterp_op<precision_index(P), axis_form<OwnAxis != 0 ? per_element_index : uniform_index, P, V>,
                        motion<Chord, precision_index(P)>, V>;
};

}  // namespace

template <>
constinit const sterp_kernels<float> kernels_on<sterp_kernels<float>, here>::table =
    table_of<sterp_kernels<float>, float, sterp_variants>();
template <>
constinit const sterp_kernels<double> kernels_on<sterp_kernels<double>, here>::table =
    table_of<sterp_kernels<double>, double, sterp_variants>();

}  // namespace swivel
