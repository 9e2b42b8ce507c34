#include "eval_operation.hpp"

namespace swivel::command {

namespace {

eval_columns arc_columns(const eval_settings&) {
    return {{{group_kind::vector, "v"}, {group_kind::vector, "w"}}, {{group_kind::quaternion, "q"}}};
}

eval_columns twist_columns(const eval_settings& settings) {
    eval_columns columns = arc_columns(settings);
    if (std::holds_alternative<parameter_column>(settings.angle))
        columns.in.push_back({group_kind::scalar, "angle"});
    return columns;
}

template <class T>
swivel::status run_shortest_arc(const eval_settings& settings, const eval_block<T>& in,
                                const eval_block<T>& out) {
    return swivel::shortest_arc(swivel::vec3_view<const T>(in.vector(0)),
                                swivel::vec3_view<const T>(in.vector(1)), out.quaternion(0),
                                settings.options);
}

template <class T>
swivel::status run_arc_with_twist(const eval_settings& settings, const eval_block<T>& in,
                                  const eval_block<T>& out) {
    return swivel::arc_with_twist(
        swivel::vec3_view<const T>(in.vector(0)), swivel::vec3_view<const T>(in.vector(1)),
        parameter_of_rows(settings.angle, in, 2), out.quaternion(0), settings.options);
}

}  // namespace

constinit const eval_operation eval_shortest_arc = {
    "shortest_arc",
    "The shortest rotations from one vector to another",
    "Reads vx vy vz and wx wy wz, of any length. Writes qx qy qz qw, which turns v to the direction of w.\n\n"
    "Examples:\n"
    "  printf 'vx vy vz wx wy wz\\n1 0 0 0 2 0\\n' | swivel eval shortest_arc",
    add_no_options,
    arc_columns,
    run_shortest_arc<float>,
    run_shortest_arc<double>};

constinit const eval_operation eval_arc_with_twist = {
    "arc_with_twist",
    "Rotations from one vector to another, by the angle of their twist",
    "Reads vx vy vz and wx wy wz, of any length, and with --angle column angle, in radians. Writes qx qy qz\n"
    "qw, which turns v to the direction of w.\n\n"
    "Examples:\n"
    "  printf 'vx vy vz wx wy wz\\n1 0 0 0 2 0\\n' | swivel eval arc_with_twist --angle 0.5\n"
    "  swivel eval arc_with_twist --angle column --product twist-swing bones.csv",
    [](command_line line, eval_settings& settings) {
        add_parameter(line, "--angle", settings.angle,
                      "The angle of the twist in radians; column: one of its own for every row (default: 0)");
        line.add_choice(
            "--product", settings.options.order,
            {{"swing-twist", swivel::product::swing_twist}, {"twist-swing", swivel::product::twist_swing}},
            "What comes first: the twist, about v, or the arc, before a twist about w");
    },
    twist_columns,
    run_arc_with_twist<float>,
    run_arc_with_twist<double>};

}  // namespace swivel::command
