#include <charconv>
#include <string>
#include <vector>

#include "eval_operation.hpp"
#include "failure.hpp"

namespace swivel::command {

namespace {

template <class T>
swivel::motor_view<const T> motor_of(const eval_block<T>& in, std::size_t group) {
    return in.motor(group);
}

template <class T>
swivel::vec3_view<const T> vector_of(const eval_block<T>& in, std::size_t group) {
    return in.vector(group);
}

eval_columns motor_to_motor(const eval_settings&) {
    return {{{group_kind::motor, "m"}}, {{group_kind::motor, "m"}}};
}

eval_columns decompose_columns(const eval_settings& settings) {
    eval_columns columns{
        {{group_kind::motor, "m"}},
        {{group_kind::quaternion, "s"}, {group_kind::quaternion, "t"}, {group_kind::vector, "p"}}};
    if (std::holds_alternative<axis_columns>(settings.axis)) columns.in.push_back({group_kind::vector, "a"});
    return columns;
}

// The motors, then the weights.
eval_columns blend_columns(const eval_settings& settings) {
    eval_columns columns{{}, {{group_kind::motor, "m"}}};
    for (std::size_t k = 1; k <= settings.motors; ++k)
        columns.in.push_back({group_kind::motor, "m" + std::to_string(k)});
    for (std::size_t k = 1; k <= settings.motors; ++k)
        columns.in.push_back({group_kind::scalar, "w" + std::to_string(k)});
    return columns;
}

template <class T>
swivel::status run_from_rotation_translation(const eval_settings& settings, const eval_block<T>& in,
                                             const eval_block<T>& out) {
    return swivel::from_rotation_translation(swivel::quat_view<const T>(in.quaternion(0)), vector_of(in, 1),
                                             out.motor(0), settings.options);
}

template <class T>
swivel::status run_to_rotation_translation(const eval_settings& settings, const eval_block<T>& in,
                                           const eval_block<T>& out) {
    return swivel::to_rotation_translation(motor_of(in, 0), out.quaternion(0), out.vector(1),
                                           settings.options);
}

template <class T>
swivel::status run_transform(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::transform(motor_of(in, 0), vector_of(in, 1), out.vector(0), settings.options);
}

template <class T>
swivel::status run_multiply(const eval_settings& settings, const eval_block<T>& in,
                            const eval_block<T>& out) {
    return swivel::multiply(motor_of(in, 0), motor_of(in, 1), out.motor(0), settings.options);
}

template <class T>
swivel::status run_conjugate(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::conjugate(motor_of(in, 0), out.motor(0), settings.options);
}

template <class T>
swivel::status run_normalize(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::normalize(motor_of(in, 0), out.motor(0), settings.options);
}

template <class T>
swivel::status run_square_root(const eval_settings& settings, const eval_block<T>& in,
                               const eval_block<T>& out) {
    return swivel::square_root(motor_of(in, 0), out.motor(0), settings.options);
}

template <class T>
swivel::status run_log(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::log(motor_of(in, 0), out.vector(0), out.vector(1), settings.options);
}

template <class T>
swivel::status run_exp(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::exp(vector_of(in, 0), vector_of(in, 1), out.motor(0), settings.options);
}

template <class T>
swivel::status run_power(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::power(motor_of(in, 0), parameter_of_rows(settings.t, in, 1), out.motor(0),
                         settings.options);
}

template <class T>
swivel::status run_sclerp(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::sclerp(motor_of(in, 0), motor_of(in, 1), parameter_of_rows(settings.t, in, 2),
                          out.motor(0), settings.options);
}

template <class T>
swivel::status run_blend(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    std::vector<swivel::motor_view<const T>> motors;
    std::vector<swivel::parameter<T>> weights;
    for (std::size_t k = 0; k < settings.motors; ++k) {
        motors.push_back(in.motor(k));
        weights.push_back(in.scalar(settings.motors + k));
    }
    return swivel::blend(motors, weights, out.motor(0), settings.options);
}

template <class T>
swivel::status run_decompose(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::decompose(motor_of(in, 0), axis_of_rows(settings, in), out.quaternion(0),
                             out.quaternion(1), out.vector(2), settings.options);
}

template <class T>
swivel::status run_compose(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::compose(swivel::quat_view<const T>(in.quaternion(0)),
                           swivel::quat_view<const T>(in.quaternion(1)), vector_of(in, 2), out.motor(0),
                           settings.options);
}

}  // namespace

constinit const eval_operation eval_from_rotation_translation = {
    "from_rotation_translation",
    "Motors that turn, then move",
    "Reads qx qy qz qw, of unit length, and tx ty tz. Writes the motor mx my mz mw mdx mdy mdz mdw: the\n"
    "rotation q, and half of the translation t times it. All operations on motors read and write them so.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw tx ty tz\\n0 0 0 1 1 2 3\\n' | swivel eval from_rotation_translation",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}, {group_kind::vector, "t"}},
                            {{group_kind::motor, "m"}}};
    },
    run_from_rotation_translation<float>,
    run_from_rotation_translation<double>};

constinit const eval_operation eval_to_rotation_translation = {
    "to_rotation_translation",
    "Rotations and translations of motors",
    "Reads mx my mz mw mdx mdy mdz mdw. Writes qx qy qz qw, which turns first, and tx ty tz.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 0 1 0.5 1 1.5 0\\n' | swivel eval to_rotation_translation",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::motor, "m"}},
                            {{group_kind::quaternion, "q"}, {group_kind::vector, "t"}}};
    },
    run_to_rotation_translation<float>,
    run_to_rotation_translation<double>};

constinit const eval_operation eval_transform = {
    "transform",
    "Points moved by motors",
    "Reads mx my mz mw mdx mdy mdz mdw, of unit length, and px py pz. Writes rx ry rz.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw px py pz\\n0 0 1 0 1 0 0 0 3 4 5\\n' | swivel eval transform",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::motor, "m"}, {group_kind::vector, "p"}},
                            {{group_kind::vector, "r"}}};
    },
    run_transform<float>,
    run_transform<double>};

constinit const eval_operation eval_motor_multiply = {
    "motor_multiply",
    "The motion b, then the motion a",
    "Reads ax ay az aw adx ady adz adw and bx by bz bw bdx bdy bdz bdw. Writes mx my mz mw mdx mdy mdz "
    "mdw.\n\n"
    "Examples:\n"
    "  printf 'ax ay az aw adx ady adz adw bx by bz bw bdx bdy bdz bdw\\n"
    "0 0 1 0 0 0 0 0 0 0 0 1 1 0 0 0\\n' |\n"
    "    swivel eval motor_multiply",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::motor, "a"}, {group_kind::motor, "b"}}, {{group_kind::motor, "m"}}};
    },
    run_multiply<float>,
    run_multiply<double>};

constinit const eval_operation eval_motor_conjugate = {
    "motor_conjugate",
    "Motions backwards",
    "Reads mx my mz mw mdx mdy mdz mdw and writes the same: the inverse where m is of unit length.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 0 1 0.5 1 1.5 0\\n' | swivel eval motor_conjugate",
    add_no_options,
    motor_to_motor,
    run_conjugate<float>,
    run_conjugate<double>};

constinit const eval_operation eval_motor_normalize = {
    "motor_normalize",
    "Motors of unit length, with the dual part at right angles to the rotation",
    "Reads mx my mz mw mdx mdy mdz mdw and writes the same.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 0 2 1 2 3 4\\n' | swivel eval motor_normalize",
    add_no_options,
    motor_to_motor,
    run_normalize<float>,
    run_normalize<double>};

constinit const eval_operation eval_motor_square_root = {
    "motor_square_root",
    "Half of a motion",
    "Reads mx my mz mw mdx mdy mdz mdw, of unit length, and writes the same: that whose square is m,\n"
    "with mw >= 0.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_square_root",
    add_no_options,
    motor_to_motor,
    run_square_root<float>,
    run_square_root<double>};

constinit const eval_operation eval_motor_log = {
    "motor_log",
    "Bivectors of motions",
    "Reads mx my mz mw mdx mdy mdz mdw, of unit length. Writes bx by bz, half of the angle in radians times\n"
    "the axis, of length 0 to pi, and nx ny nz, of a translation half of it.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_log",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::motor, "m"}},
                            {{group_kind::vector, "b"}, {group_kind::vector, "n"}}};
    },
    run_log<float>,
    run_log<double>};

constinit const eval_operation eval_motor_exp = {
    "motor_exp",
    "Motions of bivectors",
    "Reads bx by bz and nx ny nz, as motor_log writes them. Writes mx my mz mw mdx mdy mdz mdw.\n\n"
    "Examples:\n"
    "  printf 'bx by bz nx ny nz\\n0 0 0.785398163 0 0 1\\n' | swivel eval motor_exp",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::vector, "b"}, {group_kind::vector, "n"}},
                            {{group_kind::motor, "m"}}};
    },
    run_exp<float>,
    run_exp<double>};

constinit const eval_operation eval_motor_power = {
    "motor_power",
    "Parts or multiples of motions",
    "Reads mx my mz mw mdx mdy mdz mdw, of unit length, and with --t column t. Writes mx my mz mw mdx mdy\n"
    "mdz mdw, t times as far along the same screw.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_power --t 0.25\n"
    "  swivel eval motor_power --t column motions.csv",
    add_exponent,
    [](const eval_settings& settings) { return with_t(motor_to_motor(settings), settings); },
    run_power<float>,
    run_power<double>};

constinit const eval_operation eval_sclerp = {
    "sclerp",
    "Between two poses on a screw at constant speed",
    "Reads ax ay az aw adx ady adz adw and bx by bz bw bdx bdy bdz bdw, of unit length, and t with --t\n"
    "column. Writes mx my mz mw mdx mdy mdz mdw.\n\n"
    "Examples:\n"
    "  printf 'ax ay az aw adx ady adz adw bx by bz bw bdx bdy bdz bdw\\n"
    "0 0 0 1 0 0 0 0 0 0 1 0 1 0 0 0\\n' |\n"
    "    swivel eval sclerp --t 0.25 | swivel eval to_rotation_translation\n"
    "  swivel eval sclerp --t column --way long poses.csv",
    add_t_and_way,
    [](const eval_settings& settings) {
        return with_t({{{group_kind::motor, "a"}, {group_kind::motor, "b"}}, {{group_kind::motor, "m"}}},
                      settings);
    },
    run_sclerp<float>,
    run_sclerp<double>};

constinit const eval_operation eval_blend = {
    "blend",
    "Weighted means of motors, as in dual quaternion skinning",
    "Reads for each of the --motors motors its columns and its weight: m1x m1y m1z m1w m1dx m1dy m1dz m1dw\n"
    "w1, m2x ... w2 and so on. Writes mx my mz mw mdx mdy mdz mdw.\n\n"
    "Examples:\n"
    "  printf 'm1x m1y m1z m1w m1dx m1dy m1dz m1dw w1 m2x m2y m2z m2w m2dx m2dy m2dz m2dw w2\\n"
    "0 0 0 1 0 0 0 0 0.75 0 0 1 0 1 0 0 0 0.25\\n' |\n"
    "    swivel eval blend\n"
    "  swivel eval blend --motors 4 vertices.csv",
    [](command_line line, eval_settings& settings) {
        line.add_value(
            "--motors", "NUMBER",
            [&settings](const std::string& given) {
                std::size_t motors = 0;
                const char* const end = given.data() + given.size();
                const auto read = std::from_chars(given.data(), end, motors);
                if (read.ec != std::errc() || read.ptr != end || motors < 1 || motors > 256)
                    throw bad_usage("--motors: '" + given + "' is no whole number from 1 to 256");
                settings.motors = motors;
            },
            "How many motors each row has, 1 to 256 (default: 2)");
    },
    blend_columns,
    run_blend<float>,
    run_blend<double>};

constinit const eval_operation eval_motor_decompose = {
    "motor_decompose",
    "Motions into swing, twist and translation",
    "Reads mx my mz mw mdx mdy mdz mdw, and with --axis columns ax ay az. Writes sx sy sz sw tx ty tz tw,\n"
    "swing and twist of the rotation as decompose does, and px py pz, the translation: where the origin\n"
    "goes.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_decompose --axis z\n"
    "  swivel eval motor_decompose --axis 0.6,0,0.8 --product twist-swing poses.csv",
    [](command_line line, eval_settings& settings) {
        add_axis(line, settings.axis, axis_words::columns);
        add_product(line, settings.options.order);
        line.add_flag(
            "--positive-twist", settings.options.positive_twist,
            "Flip the twist where needed so that tw is not negative; the angle is then in [-pi, pi]");
        add_pole_threshold(line, settings.options.pole_threshold);
    },
    decompose_columns,
    run_decompose<float>,
    run_decompose<double>};

constinit const eval_operation eval_motor_compose = {
    "motor_compose",
    "Motions from swing, twist and translation, the inverse of motor_decompose",
    "Reads sx sy sz sw tx ty tz tw and px py pz. Writes mx my mz mw mdx mdy mdz mdw.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' |\n"
    "    swivel eval motor_decompose | swivel eval motor_compose",
    [](command_line line, eval_settings& settings) { add_product(line, settings.options.order); },
    [](const eval_settings&) {
        return eval_columns{
            {{group_kind::quaternion, "s"}, {group_kind::quaternion, "t"}, {group_kind::vector, "p"}},
            {{group_kind::motor, "m"}}};
    },
    run_compose<float>,
    run_compose<double>};

}  // namespace swivel::command
