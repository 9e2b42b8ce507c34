#include "eval_options.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "failure.hpp"
#include "number_text.hpp"
#include "row_fields.hpp"

namespace swivel::command {

namespace {

using operations::option;
using operations::settings;

operations::number parse_finite(const std::string& name, std::string_view text, const char* expected) {
    const clip::parsed<double> wide = parse_real<double>(text);
    if (!wide.fault.empty() || !std::isfinite(wide.value))
        throw bad_usage(name + ": '" + std::string(text) + "' is " + expected);
    const clip::parsed<float> narrow = parse_real<float>(text);
    if (!narrow.fault.empty()) throw bad_usage(name + ": '" + std::string(text) + "' is too large for f32");
    return {narrow.value, wide.value};
}

operations::parameter_setting parse_parameter(const std::string& name, const std::string& given) {
    if (given == "column") return operations::column{};
    return parse_finite(name, given, "neither a finite number nor column");
}

// A number, or the word `column` for the column of that name.
void add_parameter(command_line line, const std::string& name, operations::parameter_setting& value,
                   const std::string& description) {
    line.add_value(
        name, "NUMBER|column",
        [&value, name](const std::string& given) { value = parse_parameter(name, given); }, description);
}

std::vector<operations::number> parse_numbers(const std::string& name, const std::string& given) {
    std::vector<field> fields;
    if (split_row(given, fields)) throw bad_usage(name + ": '" + given + "' is no list of numbers");
    std::vector<operations::number> numbers;
    numbers.reserve(fields.size());
    for (const field& f : fields) numbers.push_back(parse_finite(name, f.text, "no finite number"));
    return numbers;
}

void add_twist_axis(command_line line, settings& s, axis_words words, const std::string& description = "") {
    const auto set = [&s](const axis_argument& given) {
        if (const auto* const coordinate = std::get_if<swivel::axis>(&given))
            s.axis = *coordinate;
        else if (const auto* const vector = std::get_if<operations::axis_vector>(&given))
            s.axis = *vector;
        else
            s.axis = operations::column{};
    };
    if (description.empty())
        add_axis(line, set, words);
    else
        add_axis(line, set, words, description);
}

void add_euler_order(command_line line, settings& s) {
    using swivel::euler_order;
    line.add_choice(
        "--order", s.euler,
        {{"xyz", euler_order::xyz},
         {"xzy", euler_order::xzy},
         {"yxz", euler_order::yxz},
         {"yzx", euler_order::yzx},
         {"zxy", euler_order::zxy},
         {"zyx", euler_order::zyx},
         {"xyx", euler_order::xyx},
         {"xzx", euler_order::xzx},
         {"yxy", euler_order::yxy},
         {"yzy", euler_order::yzy},
         {"zxz", euler_order::zxz},
         {"zyz", euler_order::zyz}},
        "Order of the three rotations, the outermost first, as the channels of a BVH file have it");
}

void add_motors(command_line line, settings& s) {
    line.add_value(
        "--motors", "NUMBER",
        [&s](const std::string& given) {
            std::size_t motors = 0;
            const char* const end = given.data() + given.size();
            const auto read = std::from_chars(given.data(), end, motors);
            if (read.ec != std::errc() || read.ptr != end || motors < 1 || motors > 256)
                throw bad_usage("--motors: '" + given + "' is no whole number from 1 to 256");
            s.motors = motors;
        },
        "How many motors each row has, 1 to 256 (default: 2)");
}

void add_rotation(command_line line, settings& s) {
    line.add_value(
        "--by", "X,Y,Z,W",
        [&s](const std::string& given) {
            const std::vector<operations::number> n = parse_numbers("--by", given);
            if (n.size() != 4) throw bad_usage("--by: '" + given + "' is not four numbers, x y z w");
            s.by = {{n[0].f32, n[1].f32, n[2].f32, n[3].f32}, {n[0].f64, n[1].f64, n[2].f64, n[3].f64}};
        },
        "One rotation for every row, a quaternion of length 1");
}

}  // namespace

void add_option(command_line line, option which, settings& s) {
    switch (which) {
        case option::axis:
            return add_twist_axis(line, s, axis_words::columns);
        case option::axis_of_compact:
            return add_twist_axis(
                line, s, axis_words::none,
                "Axis of the compact form: x, y or z (default: z); the full form does not depend on it");
        case option::axis_of_ends:
            return add_twist_axis(
                line, s, axis_words::columns,
                "Axis, a vector of any length but 0; columns: one for every row, in nx ny nz (default: z)");
        case option::product:
            return add_product(line, s.options.order);
        case option::form:
            return line.add_choice("--form", s.form,
                                   {{"full", operations::factor_form::full},
                                    {"compact", operations::factor_form::compact},
                                    {"twist", operations::factor_form::twist},
                                    {"swing", operations::factor_form::swing},
                                    {"angle", operations::factor_form::angle}},
                                   "What is written of the factors");
        case option::form_read:
            return line.add_choice(
                "--form", s.form,
                {{"full", operations::factor_form::full}, {"compact", operations::factor_form::compact}},
                "What is read of the factors");
        case option::positive_twist:
            return line.add_flag(
                "--positive-twist", s.options.positive_twist,
                "Flip the twist where needed so that tw (tc) is not negative; its angle is then "
                "in [-pi, pi], and the swing is the same either way");
        case option::signs:
            return line.add_flag("--signs", s.signs,
                                 "--positive-twist, and -1 or 1 in the column `sign` for flipped or not, for "
                                 "`compose --signs`");
        case option::signs_read:
            return line.add_flag(
                "--signs", s.signs,
                "Read the column `sign` of `decompose --signs` too, and restore the rotation with its sign");
        case option::pole_threshold:
            return add_pole_threshold(line, s.options.pole_threshold);
        case option::exponent:
            return add_parameter(line, "--t", s.t,
                                 "The exponent; column: one of its own for every row (default: 0.5)");
        case option::t:
            return add_parameter(line, "--t", s.t,
                                 "How far from a to b, 0 to 1 and beyond; column: one for every row, in the "
                                 "column t (default: 0.5)");
        case option::way:
            return line.add_choice("--way", s.options.long_way, {{"short", false}, {"long", true}},
                                   "By way of the nearer or the further of b and -b");
        case option::frame:
            return line.add_choice(
                "--frame", s.options.axis_frame,
                {{"world", swivel::frame::world}, {"body", swivel::frame::body}},
                "Where the axis is given: in the world, as it lies at a, or in the body that a and b turn");
        case option::tip:
            return line.add_flag("--tip", s.tip,
                                 "Write px py pz too, where the axis points to on its way, and off, its "
                                 "angle in radians from the "
                                 "great circle between its ends");
        case option::tip_about:
            for (const option o : {option::axis_of_ends, option::frame, option::tip}) add_option(line, o, s);
            return;
        case option::t_twist:
            return line.add_value(
                "--t-twist", "NUMBER|column",
                [&s](const std::string& given) { s.t_twist = parse_parameter("--t-twist", given); },
                "How far for the twist, where it is not as far as the swing; column: in the column t_twist "
                "(default: as --t)");
        case option::motion:
            return line.add_choice("--motion", s.options.motion,
                                   {{"slerp", swivel::flavour::slerp}, {"nlerp", swivel::flavour::nlerp}},
                                   "Swing and twist at constant speed, or along their chords");
        case option::angle:
            return add_parameter(
                line, "--angle", s.angle,
                "The angle of the twist in radians; column: one of its own for every row (default: 0)");
        case option::euler_order:
            return add_euler_order(line, s);
        case option::motors:
            return add_motors(line, s);
        case option::weights:
            return line.add_value(
                "--weights", "W,...",
                [&s](const std::string& given) { s.weights = parse_numbers("--weights", given); },
                "The weights of the motors, the same for every row; default: columns");
        case option::by:
            return add_rotation(line, s);
        case option::sequence:
            return line.add_flag("--sequence", s.sequence,
                                 "Compare each row with the one before it as it was written");
    }
}

}  // namespace swivel::command
