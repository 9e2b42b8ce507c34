#include "kernels/loops/tables.hpp"
#include "kernels/rotors/align_signs.hpp"
#include "kernels/rotors/angle_between.hpp"
#include "kernels/rotors/conjugate.hpp"
#include "kernels/rotors/dot.hpp"
#include "kernels/rotors/normalize.hpp"
#include "kernels/rotors/rotate.hpp"
#include "kernels/rotors/tables.hpp"

namespace swivel {

namespace {

struct conjugate_variants : light {
    template <class V, int>
    using op = conjugate_op<V>;
};

struct normalize_variants : light {
    template <class V, int P>
    using op = normalize_op<precision_index(P), V>;
};

struct rotate_variants : light {
    template <class V, int P>
    using op = rotate_op<precision_index(P), V>;
};

struct rotate_by_one_variants : light {
    template <class V, int P>
    using op = rotate_by_one_op<precision_index(P), V>;
};

struct dot_variants : light {
    template <class V, int P>
    using op = dot_op<precision_index(P), V>;
};

struct angle_between_variants : heavy {
    template <class V, int P>
    using op = angle_between_op<precision_index(P), V>;
};

struct align_signs_variants : light {
    template <class V, int P>
    using op = align_signs_op<precision_index(P), V>;
};

}  // namespace

template <>
constinit const conjugate_kernels<float> kernels_on<conjugate_kernels<float>, here>::table =
    table_of<conjugate_kernels<float>, float, conjugate_variants>();
template <>
constinit const conjugate_kernels<double> kernels_on<conjugate_kernels<double>, here>::table =
    table_of<conjugate_kernels<double>, double, conjugate_variants>();

template <>
constinit const normalize_kernels<float> kernels_on<normalize_kernels<float>, here>::table =
    table_of<normalize_kernels<float>, float, normalize_variants>();
template <>
constinit const normalize_kernels<double> kernels_on<normalize_kernels<double>, here>::table =
    table_of<normalize_kernels<double>, double, normalize_variants>();

template <>
constinit const rotate_kernels<float> kernels_on<rotate_kernels<float>, here>::table =
    table_of<rotate_kernels<float>, float, rotate_variants>();
template <>
constinit const rotate_kernels<double> kernels_on<rotate_kernels<double>, here>::table =
    table_of<rotate_kernels<double>, double, rotate_variants>();

template <>
constinit const rotate_by_one_kernels<float> kernels_on<rotate_by_one_kernels<float>, here>::table =
    table_of<rotate_by_one_kernels<float>, float, rotate_by_one_variants>();
template <>
constinit const rotate_by_one_kernels<double> kernels_on<rotate_by_one_kernels<double>, here>::table =
    table_of<rotate_by_one_kernels<double>, double, rotate_by_one_variants>();

template <>
constinit const dot_kernels<float> kernels_on<dot_kernels<float>, here>::table =
    table_of<dot_kernels<float>, float, dot_variants>();
template <>
constinit const dot_kernels<double> kernels_on<dot_kernels<double>, here>::table =
    table_of<dot_kernels<double>, double, dot_variants>();

template <>
constinit const angle_between_kernels<float> kernels_on<angle_between_kernels<float>, here>::table =
    table_of<angle_between_kernels<float>, float, angle_between_variants>();
template <>
constinit const angle_between_kernels<double> kernels_on<angle_between_kernels<double>, here>::table =
    table_of<angle_between_kernels<double>, double, angle_between_variants>();

template <>
constinit const align_signs_kernels<float> kernels_on<align_signs_kernels<float>, here>::table =
    table_of<align_signs_kernels<float>, float, align_signs_variants>();
template <>
constinit const align_signs_kernels<double> kernels_on<align_signs_kernels<double>, here>::table =
    table_of<align_signs_kernels<double>, double, align_signs_variants>();

}  // namespace swivel
