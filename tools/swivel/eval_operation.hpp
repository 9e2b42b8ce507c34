#ifndef SWIVEL_COMMAND_EVAL_OPERATION_HPP
#define SWIVEL_COMMAND_EVAL_OPERATION_HPP

// The operations of `swivel eval`. One more is a file like eval_twist.cpp, a declaration below and a row in
// eval_operations.cpp.

#include <CLI/CLI.hpp>
#include <array>
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
    swivel::options options;
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
    void (*add_options)(CLI::App&, eval_settings&);
    // Throws bad_usage when the settings contradict each other.
    eval_columns (*columns)(const eval_settings&);
    eval_function<float> run_f32;
    eval_function<double> run_f64;
};

extern const eval_operation eval_compose, eval_decompose, eval_swing, eval_twist, eval_twist_angle;

[[nodiscard]] const std::array<const eval_operation*, 5>& eval_operations() noexcept;

// Shared by the operations that read a rotation and an axis: qx qy qz qw, with axis_columns ax ay az too.
[[nodiscard]] std::vector<column_group> rotation_columns(const eval_settings& settings);
template <class T>
[[nodiscard]] swivel::twist_axis<T> axis_of_rows(const eval_settings& settings,
                                                 const eval_block<T>& in) noexcept;

// For operations in compact form, which take nothing but a coordinate axis. Throws bad_usage.
void require_coordinate_axis(const eval_settings& settings);

extern template swivel::twist_axis<float> axis_of_rows(const eval_settings&,
                                                       const eval_block<float>&) noexcept;
extern template swivel::twist_axis<double> axis_of_rows(const eval_settings&,
                                                        const eval_block<double>&) noexcept;

}  // namespace swivel::command

#endif
