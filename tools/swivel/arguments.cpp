#include "arguments.hpp"

#include <cmath>
#include <cstdlib>
#include <iostream>

#include "failure.hpp"
#include "number_text.hpp"
#include "row_fields.hpp"
#include "swivel/clip/text.hpp"

namespace swivel::command {

namespace {

template <class T>
T axis_component(const field& f, const std::string& given) {
    const clip::parsed<T> number = parse_real<T>(f.text);
    if (!number.fault.empty() || !std::isfinite(number.value)) {
        // One that only f32 cannot hold matters to f32 only, which refuses it later.
        if constexpr (std::is_same_v<T, float>) return std::numeric_limits<float>::quiet_NaN();
        throw bad_usage("--axis: '" + given + "': '" + std::string(f.text) + "' is no finite number");
    }
    return number.value;
}

operations::axis_vector parse_axis_vector(const std::string& given, const std::string& words) {
    std::vector<field> fields;
    const bool is_list =
        given.find(',') != std::string::npos && !split_row(given, fields) && fields.size() == 3;
    if (!is_list) throw bad_usage("--axis: '" + given + "' is none of " + words);
    operations::axis_vector v;
    v.f64 = {axis_component<double>(fields[0], given), axis_component<double>(fields[1], given),
             axis_component<double>(fields[2], given)};
    v.f32 = {axis_component<float>(fields[0], given), axis_component<float>(fields[1], given),
             axis_component<float>(fields[2], given)};
    if (v.f64.x == 0 && v.f64.y == 0 && v.f64.z == 0)
        throw bad_usage("--axis: '" + given + "' has no direction");
    return v;
}

}  // namespace

namespace {

std::string names_of_axes(axis_words words) {
    switch (words) {
        case axis_words::automatic:
            return "auto|x|y|z|X,Y,Z";
        case axis_words::columns:
            return "x|y|z|X,Y,Z|columns";
        case axis_words::none:
            break;
    }
    return "x|y|z|X,Y,Z";
}

}  // namespace

void add_axis(command_line line, const axis_reader& read, axis_words words) {
    std::string description = "Axis of the twist: a coordinate axis, or a vector of any length but 0";
    if (words == axis_words::automatic)
        description += ", in the frame of each joint; auto: along the bone of each joint (default: auto)";
    else if (words == axis_words::columns)
        description +=
            "; columns: a vector of its own for every row, read from the columns ax ay az (default: z)";
    else
        description += " (default: z)";
    add_axis(line, read, words, description);
}

void add_axis(command_line line, const axis_reader& read, axis_words words, const std::string& description) {
    const std::string known = names_of_axes(words);
    line.add_value(
        "--axis", known,
        [read, known, words](const std::string& given) {
            if (given == "x")
                read(swivel::axis::x);
            else if (given == "y")
                read(swivel::axis::y);
            else if (given == "z")
                read(swivel::axis::z);
            else if (given == "auto" && words == axis_words::automatic)
                read(automatic_axis{});
            else if (given == "columns" && words == axis_words::columns)
                read(operations::column{});
            else
                read(parse_axis_vector(given, known));
        },
        description);
}

void add_product(command_line line, swivel::product& value) {
    line.add_choice(
        "--product", value,
        {{"swing-twist", swivel::product::swing_twist}, {"twist-swing", swivel::product::twist_swing}},
        "Order of the factors: q = swing twist (the twist is applied first), or q = twist swing");
}

void add_precision(command_line line, swivel::precision& value) {
    line.add_choice("--precision", value,
                    {{"fast", swivel::precision::fast}, {"reproducible", swivel::precision::reproducible}},
                    "Arithmetic: the quickest, or one that gives the same bits on every ISA");
}

void add_pole_threshold(command_line line, double& value) {
    line.add_value(
        "--pole-threshold", "T",
        [&value](const std::string& given) {
            const clip::parsed<double> number = parse_real<double>(given);
            if (!number.fault.empty() || !(number.value >= 0 && number.value <= 1))
                throw bad_usage("--pole-threshold: '" + given + "' is no number from 0 to 1");
            value = number.value;
        },
        "The twist is left out near the pole, where w^2 + (a.v)^2 <= T |q|^2, that is where the cosine "
        "of half the swing is at most the root of T; T from 0 to 1 (default: 2^-106 for f64, 2^-48 for "
        "f32)");
}

std::string isa_names(bool (*included)(swivel::isa) noexcept) {
    std::string names;
    for (const swivel::isa which : swivel::all_isas) {
        if (!included(which)) continue;
        names += names.empty() ? "" : " ";
        names += swivel::name(which);
    }
    return names;
}

std::optional<swivel::isa> find_isa(const std::string& name) noexcept {
    for (const swivel::isa which : swivel::all_isas)
        if (name == swivel::name(which)) return which;
    return std::nullopt;
}

void add_isa(command_line line, std::optional<swivel::isa>& value) {
    line.add_value(
        "--isa", "NAME",
        [&value](const std::string& given) {
            value = find_isa(given);
            if (value && swivel::is_usable(*value)) return;
            throw bad_usage("--isa: '" + given + "' is " +
                            (value ? "not usable on this machine" : "unknown") +
                            ", usable are: " + isa_names(swivel::is_usable));
        },
        "Instruction set of the kernels, before the environment variable SWIVEL_ISA; default: the best "
        "usable one");
}

void select_isa(std::optional<swivel::isa> value) {
    if (value) {
        if (const status s = swivel::set_active_isa(*value); s != status::ok)
            throw bad_usage(std::string("--isa: ") + swivel::name(s));
        return;
    }
    const char* const wanted = std::getenv("SWIVEL_ISA");
    if (wanted == nullptr || *wanted == '\0') return;
    if (const auto which = find_isa(wanted); which && swivel::is_usable(*which)) return;
    std::cerr << "warning: SWIVEL_ISA=" << wanted << " is not usable here, going on with "
              << swivel::name(swivel::active_isa()) << "\n";
}

}  // namespace swivel::command
