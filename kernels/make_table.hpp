#ifndef SWIVEL_KERNELS_MAKE_TABLE_HPP
#define SWIVEL_KERNELS_MAKE_TABLE_HPP

// The kernels of one ISA. isa/<isa>.cpp includes this and defines its table; nothing else there.

#include "kernels/angles/atan2.hpp"
#include "kernels/angles/sincos.hpp"
#include "kernels/arcs/arc_with_twist.hpp"
#include "kernels/arcs/shortest_arc.hpp"
#include "kernels/conformal/conformal.hpp"
#include "kernels/conformal/conformal_exp.hpp"
#include "kernels/conformal/conformal_planes.hpp"
#include "kernels/conversions/axis_angle.hpp"
#include "kernels/conversions/euler.hpp"
#include "kernels/conversions/matrix.hpp"
#include "kernels/exponentials/exp.hpp"
#include "kernels/exponentials/log.hpp"
#include "kernels/exponentials/power.hpp"
#include "kernels/exponentials/square_root.hpp"
#include "kernels/interpolation/nlerp.hpp"
#include "kernels/interpolation/slerp.hpp"
#include "kernels/interpolation/sterp.hpp"
#include "kernels/loops/stream_loop.hpp"
#include "kernels/motors/motor.hpp"
#include "kernels/motors/motor_power.hpp"
#include "kernels/rotors/align_signs.hpp"
#include "kernels/rotors/conjugate.hpp"
#include "kernels/rotors/dot.hpp"
#include "kernels/rotors/normalize.hpp"
#include "kernels/rotors/rotate.hpp"
#include "kernels/swing_twist/compose.hpp"
#include "kernels/swing_twist/decompose.hpp"
#include "kernels/swing_twist/swing.hpp"
#include "kernels/swing_twist/twist.hpp"
#include "kernels/swing_twist/twist_angle.hpp"

namespace swivel {
namespace {

template <class V, precision_index P>
struct fill {
    using T = scalar_of<V>;
    using coordinate = coordinate_form<P, V>;
    using uniform = uniform_form<P, V>;
    using per_element = per_element_form<P, V>;

    template <class Op>
    static constexpr kernel<T> loop = stream_loop<V, Op>;
    template <class Op, class Wide>
    static constexpr kernel<T> deep_loop = twin_loop<V, Op, Wide>;
    using W = twin<V>;

    template <twist_sign S>
    static constexpr void with_sign(operations<T>& table) {
        table.decompose[coordinate_index][S][P] = loop<decompose_op<coordinate, S, V>>;
        table.decompose[uniform_index][S][P] = loop<decompose_op<uniform, S, V>>;
        table.decompose[per_element_index][S][P] = loop<decompose_op<per_element, S, V>>;
        table.decompose_compact[S][P] = loop<decompose_compact_op<coordinate, S, V>>;
        if constexpr (S != sign_kept) {
            table.twist[coordinate_index][S][P] = loop<twist_op<coordinate, S, V>>;
            table.twist[uniform_index][S][P] = loop<twist_op<uniform, S, V>>;
            table.twist[per_element_index][S][P] = loop<twist_op<per_element, S, V>>;
            table.twist_angle[coordinate_index][S][P] = loop<twist_angle_op<P, coordinate, S, V>>;
            table.twist_angle[uniform_index][S][P] = loop<twist_angle_op<P, uniform, S, V>>;
            table.twist_angle[per_element_index][S][P] = loop<twist_angle_op<P, per_element, S, V>>;
            table.motor_decompose[coordinate_index][S][P] = loop<motor_decompose_op<P, coordinate, S, V>>;
            table.motor_decompose[uniform_index][S][P] = loop<motor_decompose_op<P, uniform, S, V>>;
            table.motor_decompose[per_element_index][S][P] = loop<motor_decompose_op<P, per_element, S, V>>;
        }
    }

    template <template <precision_index, class> class Form, bool Body>
    static constexpr void with_form(kernel<T> (&motions)[2][2][precisions]) {
        motions[false][Body][P] = deep_loop<sterp_op<P, Form<P, V>, constant_speed<P>, Body, V>,
                                            sterp_op<P, Form<P, W>, constant_speed<P>, Body, W>>;
        motions[true][Body][P] = deep_loop<sterp_op<P, Form<P, V>, along_the_chord<P>, Body, V>,
                                           sterp_op<P, Form<P, W>, along_the_chord<P>, Body, W>>;
    }

    static constexpr void all(operations<T>& table) {
        with_sign<sign_left>(table);
        with_sign<sign_positive>(table);
        with_sign<sign_kept>(table);
        table.swing[coordinate_index][P] = loop<swing_op<coordinate, V>>;
        table.swing[uniform_index][P] = loop<swing_op<uniform, V>>;
        table.swing[per_element_index][P] = loop<swing_op<per_element, V>>;
        table.compose[false][P] = loop<compose_op<P, false, V>>;
        table.compose[true][P] = loop<compose_op<P, true, V>>;
        table.compose_compact[false][P] = loop<compose_compact_op<P, false, V>>;
        table.compose_compact[true][P] = loop<compose_compact_op<P, true, V>>;
        table.slerp[false][P] = deep_loop<slerp_op<P, false, V>, slerp_op<P, false, W>>;
        table.slerp[true][P] = loop<slerp_op<P, true, V>>;
        table.nlerp[false][P] = loop<nlerp_op<P, false, V>>;
        table.nlerp[true][P] = loop<nlerp_op<P, true, V>>;
        with_form<uniform_form, false>(table.sterp[false]);
        with_form<uniform_form, true>(table.sterp[false]);
        with_form<per_element_form, false>(table.sterp[true]);
        with_form<per_element_form, true>(table.sterp[true]);
        table.sincos[P] = loop<sincos_op<P, V>>;
        table.atan2[P] = loop<atan2_op<P, V>>;
        table.conjugate = loop<conjugate_op<V>>;
        table.normalize[P] = loop<normalize_op<P, V>>;
        table.rotate[false][P] = loop<rotate_op<P, V>>;
        table.rotate[true][P] = loop<rotate_by_one_op<P, V>>;
        table.dot[P] = loop<dot_op<P, V>>;
        table.align_signs[P] = loop<align_signs_op<P, V>>;
        table.square_root[P] = deep_loop<square_root_op<P, V>, square_root_op<P, W>>;
        table.exp[P] = deep_loop<exp_op<P, V>, exp_op<P, W>>;
        table.log[P] = deep_loop<log_op<P, V>, log_op<P, W>>;
        table.power[P] = deep_loop<power_op<P, V>, power_op<P, W>>;
        table.shortest_arc[P] = deep_loop<shortest_arc_op<P, V>, shortest_arc_op<P, W>>;
        table.arc_with_twist[false][P] =
            deep_loop<arc_with_twist_op<P, false, V>, arc_with_twist_op<P, false, W>>;
        table.arc_with_twist[true][P] =
            deep_loop<arc_with_twist_op<P, true, V>, arc_with_twist_op<P, true, W>>;
        table.from_axis_angle[coordinate_index][P] = loop<from_coordinate_axis_angle_op<P, V>>;
        table.from_axis_angle[uniform_index][P] = loop<from_uniform_axis_angle_op<P, V>>;
        table.from_axis_angle[per_element_index][P] = loop<from_each_axis_angle_op<P, V>>;
        table.to_axis_angle[P] = loop<to_axis_angle_op<P, V>>;
        table.from_euler[P] = loop<from_euler_op<P, V>>;
        table.to_euler[P] = loop<to_euler_op<P, V>>;
        table.from_matrix[P] = loop<from_matrix_op<P, V>>;
        table.to_matrix[P] = loop<to_matrix_op<P, V>>;
        table.motor_multiply[P] = loop<motor_multiply_op<P, V>>;
        table.motor_conjugate = loop<motor_conjugate_op<V>>;
        table.motor_normalize[P] = loop<motor_normalize_op<P, V>>;
        table.from_rotation_translation[P] = loop<from_rotation_translation_op<P, V>>;
        table.to_rotation_translation[P] = loop<to_rotation_translation_op<P, V>>;
        table.motor_transform[P] = loop<motor_transform_op<P, V>>;
        table.motor_square_root[P] = deep_loop<motor_square_root_op<P, V>, motor_square_root_op<P, W>>;
        table.motor_log[P] = deep_loop<motor_log_op<P, V>, motor_log_op<P, W>>;
        table.motor_exp[P] = deep_loop<motor_exp_op<P, V>, motor_exp_op<P, W>>;
        table.motor_power[P] = deep_loop<motor_power_op<P, V>, motor_power_op<P, W>>;
        table.sclerp[false][P] = deep_loop<sclerp_op<P, false, V>, sclerp_op<P, false, W>>;
        table.sclerp[true][P] = deep_loop<sclerp_op<P, true, V>, sclerp_op<P, true, W>>;
        table.motor_blend[P] = loop<motor_blend_op<P, V>>;
        table.motor_compose[P] = loop<motor_compose_op<P, V>>;
        table.conformal_multiply[P] = loop<conformal_multiply_op<P, V>>;
        table.conformal_reverse = loop<conformal_reverse_op<V>>;
        table.conformal_from_motor = loop<conformal_from_motor_op<V>>;
        table.conformal_from_rotation = loop<conformal_from_rotation_op<V>>;
        table.conformal_from_translation = loop<conformal_from_translation_op<V>>;
        table.conformal_from_dilation = loop<conformal_from_dilation_op<V>>;
        table.conformal_transform[P] = loop<conformal_transform_op<P, V>>;
        table.conformal_square_root[P] = loop<conformal_square_root_op<P, V>>;
        table.conformal_exp[P] = loop<conformal_exp_op<P, V>>;
        table.conformal_log[P] = loop<conformal_log_op<P, V>>;
        table.conformal_power[P] = loop<conformal_power_op<P, V>>;
        table.conformal_interpolate[P] = loop<conformal_interpolate_op<P, V>>;
        table.conformal_split[P] = loop<conformal_split_op<P, V>>;
    }
};

template <class V>
constexpr operations<scalar_of<V>> make_operations() {
    operations<scalar_of<V>> table{};
    fill<V, fast_index>::all(table);
    fill<V, reproducible_index>::all(table);
    return table;
}

template <class Arch>
constexpr kernel_table make_table() {
    return {make_operations<xsimd::batch<float, Arch>>(), make_operations<xsimd::batch<double, Arch>>()};
}

}  // namespace
}  // namespace swivel

#endif
