#include "eval_operation.hpp"

namespace swivel::command {

void add_exponent(command_line line, eval_settings& settings) {
    add_parameter(line, "--t", settings.t,
                  "The exponent; column: one of its own for every row (default: 0.5)");
}

namespace {

template <class T>
swivel::status run_square_root(const eval_settings& settings, const eval_block<T>& in,
                               const eval_block<T>& out) {
    return swivel::square_root(swivel::quat_view<const T>(in.quaternion(0)), out.quaternion(0),
                               settings.options);
}

template <class T>
swivel::status run_exp(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::exp(swivel::vec3_view<const T>(in.vector(0)), out.quaternion(0), settings.options);
}

template <class T>
swivel::status run_log(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::log(swivel::quat_view<const T>(in.quaternion(0)), out.vector(0), settings.options);
}

template <class T>
swivel::status run_power(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::power(swivel::quat_view<const T>(in.quaternion(0)), parameter_of_rows(settings.t, in, 1),
                         out.quaternion(0), settings.options);
}

}  // namespace

constinit const eval_operation eval_square_root = {
    "square_root",
    "Half of a rotation",
    "Reads qx qy qz qw, of any length. Writes rx ry rz rw, the unit quaternion whose square is that of q,\n"
    "with rw >= 0.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval square_root",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}}, {{group_kind::quaternion, "r"}}};
    },
    run_square_root<float>,
    run_square_root<double>};

constinit const eval_operation eval_exp = {
    "exp",
    "Rotations of rotation vectors",
    "Reads bx by bz, half of the angle in radians times the axis. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'bx by bz\\n0 0 0.785398163\\n' | swivel eval exp",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::vector, "b"}}, {{group_kind::quaternion, "q"}}};
    },
    run_exp<float>,
    run_exp<double>};

constinit const eval_operation eval_log = {
    "log",
    "Rotation vectors of rotations",
    "Reads qx qy qz qw, of any length. Writes bx by bz, half of the angle in radians times the axis, of\n"
    "length 0 to pi.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 1\\n' | swivel eval log",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}}, {{group_kind::vector, "b"}}};
    },
    run_log<float>,
    run_log<double>};

constinit const eval_operation eval_power = {
    "power",
    "Parts or multiples of rotations",
    "Reads qx qy qz qw, of any length, and with --t column t. Writes rx ry rz rw, the rotation about the\n"
    "same axis by t times the angle.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 1\\n' | swivel eval power --t 0.5\n"
    "  swivel eval power --t column rotations.csv",
    add_exponent,
    [](const eval_settings& settings) {
        return with_t({{{group_kind::quaternion, "q"}}, {{group_kind::quaternion, "r"}}}, settings);
    },
    run_power<float>,
    run_power<double>};

}  // namespace swivel::command
