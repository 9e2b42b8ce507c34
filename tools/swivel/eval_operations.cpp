#include "eval_operation.hpp"
#include "failure.hpp"

namespace swivel::command {

std::span<const eval_operation* const> eval_operations() noexcept {
    static constexpr const eval_operation* operations[] = {
        &eval_decompose,
        &eval_compose,
        &eval_twist,
        &eval_swing,
        &eval_twist_angle,
        &eval_slerp,
        &eval_nlerp,
        &eval_sterp,
        &eval_sincos,
        &eval_atan2,
        &eval_multiply,
        &eval_conjugate,
        &eval_normalize,
        &eval_rotate,
        &eval_dot,
        &eval_align_signs,
        &eval_square_root,
        &eval_exp,
        &eval_log,
        &eval_power,
        &eval_shortest_arc,
        &eval_arc_with_twist,
        &eval_from_axis_angle,
        &eval_to_axis_angle,
        &eval_from_spinor,
        &eval_to_spinor,
        &eval_from_matrix,
        &eval_to_matrix,
        &eval_from_euler,
        &eval_to_euler,
        &eval_from_rotation_translation,
        &eval_to_rotation_translation,
        &eval_transform,
        &eval_motor_multiply,
        &eval_motor_conjugate,
        &eval_motor_normalize,
        &eval_motor_square_root,
        &eval_motor_log,
        &eval_motor_exp,
        &eval_motor_power,
        &eval_sclerp,
        &eval_blend,
        &eval_motor_decompose,
        &eval_motor_compose,
        &eval_conformal_multiply,
        &eval_conformal_reverse,
        &eval_conformal_from_motor,
        &eval_conformal_from_rotation,
        &eval_conformal_from_translation,
        &eval_conformal_from_dilation,
        &eval_conformal_transform,
        &eval_conformal_square_root,
        &eval_conformal_exp,
        &eval_conformal_log,
        &eval_conformal_power,
        &eval_conformal_interpolate,
        &eval_conformal_split,
    };
    return operations;
}

std::vector<column_group> rotation_columns(const eval_settings& settings) {
    std::vector<column_group> groups = {{group_kind::quaternion, "q"}};
    if (std::holds_alternative<axis_columns>(settings.axis)) groups.push_back({group_kind::vector, "a"});
    return groups;
}

eval_columns with_t(eval_columns columns, const eval_settings& settings) {
    if (std::holds_alternative<parameter_column>(settings.t)) columns.in.push_back({group_kind::scalar, "t"});
    return columns;
}

template <class T>
swivel::twist_axis<T> axis_of_rows(const eval_settings& settings, const eval_block<T>& in) noexcept {
    if (const auto* const vector = std::get_if<axis_vector>(&settings.axis)) {
        if constexpr (std::is_same_v<T, float>)
            return vector->f32;
        else
            return vector->f64;
    }
    if (const auto* const coordinate = std::get_if<swivel::axis>(&settings.axis)) return *coordinate;
    return in.vector(1);
}

template swivel::twist_axis<float> axis_of_rows(const eval_settings&, const eval_block<float>&) noexcept;
template swivel::twist_axis<double> axis_of_rows(const eval_settings&, const eval_block<double>&) noexcept;

void require_coordinate_axis(const eval_settings& settings) {
    if (!std::holds_alternative<swivel::axis>(settings.axis))
        throw bad_usage("--form compact is about a coordinate axis: --axis x, y or z");
}

}  // namespace swivel::command
