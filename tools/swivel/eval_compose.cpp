#include "eval_operation.hpp"
#include "failure.hpp"

namespace swivel::command {

namespace {

void add_options(command_line line, eval_settings& settings) {
    add_axis(line, settings.axis, axis_words::none,
             "Axis of the compact form: x, y or z (default: z); the full form does not depend on it");
    add_product(line, settings.options.order);
    line.add_choice("--form", settings.form, {{"full", factor_form::full}, {"compact", factor_form::compact}},
                    "What is read of the factors");
    line.add_flag(
        "--signs", settings.signs,
        "Read the column `sign` of `decompose --signs` too, and restore the rotation with its sign");
}

eval_columns columns(const eval_settings& settings) {
    eval_columns c;
    if (settings.form == factor_form::compact) {
        require_coordinate_axis(settings);
        c.in = {{group_kind::factors, ""}};
    } else {
        c.in = {{group_kind::quaternion, "s"}, {group_kind::quaternion, "t"}};
    }
    if (settings.signs) c.in.push_back({group_kind::scalar, "sign"});
    c.out = {{group_kind::quaternion, "q"}};
    return c;
}

template <class T>
swivel::status run(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    const swivel::quat_view<T> q = out.quaternion(0);
    const swivel::options& options = settings.options;
    if (settings.form == factor_form::compact) {
        const swivel::factor_view<const T> factors = in.factors(0);
        const swivel::axis axis = std::get<swivel::axis>(settings.axis);
        if (settings.signs)
            return swivel::compose(factors, axis, swivel::scalar_view<const T>(in.scalar(1)), q, options);
        return swivel::compose(factors, axis, q, options);
    }
    const swivel::quat_view<const T> swing = in.quaternion(0), twist = in.quaternion(1);
    if (settings.signs)
        return swivel::compose(swing, twist, swivel::scalar_view<const T>(in.scalar(2)), q, options);
    return swivel::compose(swing, twist, q, options);
}

}  // namespace

constinit const eval_operation eval_compose = {
    "compose",
    "Rotations from swing and twist, the inverse of decompose",
    "Reads sx sy sz sw tx ty tz tw, or with --form compact s1 s2 sc ts tc. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval decompose | swivel eval compose\n"
    "  swivel eval decompose --form compact --axis x rotations.csv |\n"
    "    swivel eval compose --form compact --axis x",
    add_options,
    columns,
    run<float>,
    run<double>};

}  // namespace swivel::command
