#ifndef SWIVEL_COMMAND_EVAL_OPERATION_HPP
#define SWIVEL_COMMAND_EVAL_OPERATION_HPP

// The operations of `swivel eval`. One more is a definition in the file of its family, a declaration below
// and a row in eval_operations.cpp.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "arguments.hpp"
#include "eval_block.hpp"
#include "swivel/swivel.hpp"

namespace swivel::command {

enum class factor_form { full, compact, twist, swing, angle };

// What the options of all operations say; each operation adds those that it looks at.
struct eval_settings {
    axis_argument axis = swivel::axis::z;
    factor_form form = factor_form::full;
    bool signs = false;
    parameter_argument t = number{0.5F, 0.5}, angle = number{};
    std::optional<parameter_argument> twist_t;
    bool tip = false;
    std::size_t motors = 2;
    bool reads_axis = false;
    swivel::euler_order euler = swivel::euler_order::xyz;
    swivel::options options;
    // Each row goes on from the one before, over the blocks in which an operation gets them.
    bool sequence = false;
    mutable swivel::quat<double> last_of_sequence{};
};

struct eval_columns {
    std::vector<column_group> in, out;
};

// The groups of the blocks are those that eval_operation::columns named, in that order.
template <class T>
using eval_function = swivel::status (*)(const eval_settings&, const eval_block<T>& in,
                                         const eval_block<T>& out);

struct eval_operation {
    const char* name;
    const char* description;
    const char* footer;
    void (*add_options)(command_line, eval_settings&);
    // Throws bad_usage when the settings contradict each other.
    eval_columns (*columns)(const eval_settings&);
    eval_function<float> run_f32;
    eval_function<double> run_f64;
};

extern const eval_operation eval_nlerp, eval_slerp, eval_sterp;
extern const eval_operation eval_atan2, eval_sincos;
extern const eval_operation eval_from_axis_angle, eval_from_euler, eval_from_matrix, eval_from_spinor;
extern const eval_operation eval_to_axis_angle, eval_to_euler, eval_to_matrix, eval_to_spinor;
extern const eval_operation eval_align_signs, eval_conjugate, eval_dot, eval_multiply, eval_normalize,
    eval_rotate;
extern const eval_operation eval_conformal_multiply, eval_conformal_reverse, eval_conformal_from_motor,
    eval_conformal_from_rotation, eval_conformal_from_translation, eval_conformal_from_dilation,
    eval_conformal_transform, eval_conformal_square_root, eval_conformal_exp, eval_conformal_log,
    eval_conformal_power, eval_conformal_interpolate, eval_conformal_split;
extern const eval_operation eval_exp, eval_log, eval_power, eval_square_root;
extern const eval_operation eval_arc_with_twist, eval_shortest_arc;
extern const eval_operation eval_motor_compose, eval_motor_decompose, eval_motor_multiply,
    eval_motor_conjugate, eval_motor_normalize, eval_motor_square_root, eval_motor_log, eval_motor_exp,
    eval_motor_power;
extern const eval_operation eval_from_rotation_translation, eval_to_rotation_translation, eval_transform,
    eval_sclerp, eval_blend;
extern const eval_operation eval_compose, eval_decompose, eval_swing, eval_twist, eval_twist_angle;

[[nodiscard]] std::span<const eval_operation* const> eval_operations() noexcept;

// Shared by the operations that read a rotation and an axis: qx qy qz qw, with axis_columns ax ay az too.
[[nodiscard]] std::vector<column_group> rotation_columns(const eval_settings& settings);
template <class T>
[[nodiscard]] swivel::twist_axis<T> axis_of_rows(const eval_settings& settings,
                                                 const eval_block<T>& in) noexcept;

// For operations that have no options of their own.
inline void add_no_options(command_line, eval_settings&) {}

// --t of a power, and --t, or --t and --way, of what goes from a to b.
void add_exponent(command_line line, eval_settings& settings);
void add_t(command_line line, eval_settings& settings);
void add_t_and_way(command_line line, eval_settings& settings);

// With --t column, the column t too.
[[nodiscard]] eval_columns with_t(eval_columns columns, const eval_settings& settings);

// The parameter, or where it is a column the scalars of the group.
template <class T>
[[nodiscard]] swivel::parameter<T> parameter_of_rows(const parameter_argument& argument,
                                                     const eval_block<T>& in, std::size_t group) noexcept {
    const number* n = std::get_if<number>(&argument);
    if (n == nullptr) return in.scalar(group);
    if constexpr (std::is_same_v<T, float>)
        return n->f32;
    else
        return n->f64;
}

// For operations in compact form, which take nothing but a coordinate axis. Throws bad_usage.
void require_coordinate_axis(const eval_settings& settings);

extern template swivel::twist_axis<float> axis_of_rows(const eval_settings&,
                                                       const eval_block<float>&) noexcept;
extern template swivel::twist_axis<double> axis_of_rows(const eval_settings&,
                                                        const eval_block<double>&) noexcept;

}  // namespace swivel::command

#endif
