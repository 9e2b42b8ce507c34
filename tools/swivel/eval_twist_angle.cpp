#include "eval_operation.hpp"

namespace swivel::command {

namespace {

void add_options(command_line line, eval_settings& settings) {
    add_axis(line, settings.axis, axis_words::columns);
    add_product(line, settings.options.order);
    line.add_flag("--positive-twist", settings.options.positive_twist,
                  "The angle of the twist whose tw is not negative, in [-pi, pi]");
    add_pole_threshold(line, settings.options.pole_threshold);
}

eval_columns columns(const eval_settings& settings) {
    return {rotation_columns(settings), {{group_kind::scalar, "angle"}}};
}

template <class T>
swivel::status run(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::twist_angle(swivel::quat_view<const T>(in.quaternion(0)), axis_of_rows(settings, in),
                               out.scalar(0), settings.options);
}

}  // namespace

constinit const eval_operation eval_twist_angle = {
    "twist_angle",
    "The angle of the twist",
    "Reads qx qy qz qw, and with --axis columns ax ay az. Writes angle, in radians in (-2 pi, 2 pi], the\n"
    "same for both products.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval twist_angle --axis z\n"
    "  swivel eval twist_angle --axis 0.6,0,0.8 --positive-twist rotations.csv",
    add_options,
    columns,
    run<float>,
    run<double>};

}  // namespace swivel::command
