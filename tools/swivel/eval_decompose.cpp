#include "eval_operation.hpp"
#include "failure.hpp"

namespace swivel::command {

namespace {

void add_options(command_line line, eval_settings& settings) {
    add_axis(line, settings.axis, axis_words::columns);
    add_product(line, settings.options.order);
    line.add_choice("--form", settings.form,
                    {{"full", factor_form::full},
                     {"compact", factor_form::compact},
                     {"twist", factor_form::twist},
                     {"swing", factor_form::swing},
                     {"angle", factor_form::angle}},
                    "What is written of the factors");
    line.add_flag(
        "--positive-twist", settings.options.positive_twist,
        "Flip the twist where needed so that tw (tc) is not negative; the angle is then in [-pi, pi]");
    line.add_flag(
        "--signs", settings.signs,
        "--positive-twist, and -1 or 1 in the column `sign` for flipped or not, for `compose --signs`");
    add_pole_threshold(line, settings.options.pole_threshold);
}

eval_columns columns(const eval_settings& settings) {
    eval_columns c;
    c.in = rotation_columns(settings);
    switch (settings.form) {
        case factor_form::full:
            c.out = {{group_kind::quaternion, "s"}, {group_kind::quaternion, "t"}};
            break;
        case factor_form::compact:
            require_coordinate_axis(settings);
            c.out = {{group_kind::factors, ""}};
            break;
        case factor_form::twist:
            c.out = {{group_kind::quaternion, "t"}};
            break;
        case factor_form::swing:
            c.out = {{group_kind::quaternion, "s"}};
            break;
        case factor_form::angle:
            c.out = {{group_kind::scalar, "angle"}};
            break;
    }
    if (settings.signs) {
        if (settings.form != factor_form::full && settings.form != factor_form::compact)
            throw bad_usage(
                "--signs goes with --form full or compact, from which compose restores the rotation");
        c.out.push_back({group_kind::scalar, "sign"});
    }
    return c;
}

template <class T>
swivel::status run(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    const swivel::quat_view<const T> q = in.quaternion(0);
    const swivel::twist_axis<T> axis = axis_of_rows(settings, in);
    const swivel::options& options = settings.options;
    switch (settings.form) {
        case factor_form::full:
            if (settings.signs)
                return swivel::decompose(q, axis, out.quaternion(0), out.quaternion(1), out.scalar(2),
                                         options);
            return swivel::decompose(q, axis, out.quaternion(0), out.quaternion(1), options);
        case factor_form::compact:
            if (settings.signs)
                return swivel::decompose(q, axis.coordinate, out.factors(0), out.scalar(1), options);
            return swivel::decompose(q, axis.coordinate, out.factors(0), options);
        case factor_form::twist:
            return swivel::twist(q, axis, out.quaternion(0), options);
        case factor_form::swing:
            return swivel::swing(q, axis, out.quaternion(0), options);
        case factor_form::angle:
            break;
    }
    return swivel::twist_angle(q, axis, out.scalar(0), options);
}

}  // namespace

constinit const eval_operation eval_decompose = {
    "decompose",
    "Rotations into swing and twist",
    "Reads qx qy qz qw, and with --axis columns ax ay az. Writes for --form\n"
    "  full     sx sy sz sw tx ty tz tw\n"
    "  compact  s1 s2 sc ts tc   about x, y or z: the numbers of full that are not zero, s1 s2 along the "
    "axes that\n"
    "                            follow in the order x y z x y, sc = sw, ts along the axis, tc = tw\n"
    "  twist    tx ty tz tw\n"
    "  swing    sx sy sz sw\n"
    "  angle    angle            of the twist in radians, in (-2 pi, 2 pi]\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval decompose --axis z\n"
    "  swivel eval decompose --axis 0.6,0,0.8 --form angle --positive-twist rotations.csv\n"
    "  swivel eval decompose --signs rotations.csv | swivel eval compose --signs",
    add_options,
    columns,
    run<float>,
    run<double>};

}  // namespace swivel::command
