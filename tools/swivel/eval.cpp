#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "arguments.hpp"
#include "commands.hpp"
#include "eval_options.hpp"
#include "failure.hpp"
#include "line_reader.hpp"
#include "output.hpp"
#include "row_stream.hpp"

namespace swivel::command {

namespace {

enum class number_type { f32, f64 };

struct eval_arguments {
    std::string file = "-";
    std::string out = "-";
    number_type type = number_type::f64;
    std::optional<swivel::isa> isa;
    std::vector<std::string> columns;  // of --columns, as they are given
    row_stream_options stream;
    operations::settings settings;
};

void require_axis_in_f32(const operations::axis_setting& axis) {
    const auto* const vector = std::get_if<operations::axis_vector>(&axis);
    if (vector == nullptr) return;
    const swivel::vec3<float>& v = vector->f32;
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        throw bad_usage("--axis: too long for f32");
    if (v.x == 0 && v.y == 0 && v.z == 0) throw bad_usage("--axis: has no direction in f32");
}

bool has_angles(const std::vector<operations::group>& groups) {
    return std::any_of(groups.begin(), groups.end(),
                       [](const operations::group& g) { return g.meaning == operations::meaning::angle; });
}

bool has_option(const operations::operation& operation, operations::option which) {
    return std::find(operation.options.begin(), operation.options.end(), which) != operation.options.end();
}

// With some of its options at least.
bool may_have_angles(const operations::operation& operation) {
    const operations::groups g = operation.groups({});
    return has_angles(g.in) || has_angles(g.out) || has_option(operation, operations::option::form) ||
           has_option(operation, operations::option::tip) ||
           has_option(operation, operations::option::tip_about) ||
           has_option(operation, operations::option::angle);
}

std::string key_of(const operations::group& g) {
    if (g.kind == operations::group_kind::factors) return "factors";
    return g.kind == operations::group_kind::spinor ? "spinor" : g.prefix;
}

std::vector<std::string> split_at_commas(std::string_view text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

// The names of the columns that are read, group by group.
struct column_names {
    const std::vector<operations::group>& groups;
    std::vector<std::vector<std::string>> names = {};
    std::vector<bool> is_given = {};  // by --columns
    std::string keys = {};            // of all groups

    explicit column_names(const std::vector<operations::group>& read) : groups(read) {
        for (const operations::group& g : groups) {
            names.push_back(operations::stream_names(g));
            is_given.push_back(false);
            if (!keys.empty()) keys += ' ';
            keys += key_of(g);
        }
    }

    // As GROUP=NAME,... says.
    void rename(const std::string& mapping) {
        const std::size_t equals = mapping.find('=');
        if (equals == std::string::npos)
            throw bad_usage("--columns: '" + mapping +
                            "', expected GROUP=NAME,... with a group out of: " + keys);
        const std::string key = mapping.substr(0, equals);
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const operations::group& g) { return key_of(g) == key; });
        if (group == groups.end())
            throw bad_usage("--columns: the operation reads no group '" + key +
                            "', expected one out of: " + keys);
        const auto place = static_cast<std::size_t>(group - groups.begin());
        if (is_given[place]) throw bad_usage("--columns: the group '" + key + "' is named twice");
        is_given[place] = true;
        std::vector<std::string> wanted = split_at_commas(std::string_view(mapping).substr(equals + 1));
        if (wanted.size() != names[place].size()) {
            std::string usual;
            for (const std::string& name : names[place]) usual.append(" ").append(name);
            throw bad_usage("--columns: " + std::to_string(wanted.size()) + " names for '" + key +
                            "', expected " + std::to_string(names[place].size()) + ", for" + usual);
        }
        names[place] = std::move(wanted);
    }

    [[nodiscard]] std::vector<std::string> all() const {
        std::vector<std::string> every;
        for (const std::vector<std::string>& of_group : names)
            for (const std::string& name : of_group) {
                if (name.empty()) throw bad_usage("--columns: a name is empty");
                if (std::find(every.begin(), every.end(), name) != every.end()) throw read_twice(name);
                every.push_back(name);
            }
        return every;
    }

    static bad_usage read_twice(const std::string& name) {
        return bad_usage("--columns: the column '" + name + "' is read twice");
    }
};

void evaluate(const operations::operation& operation, eval_arguments& arguments) {
    // Before the input is looked at: contradictions are bad usage whatever the data are.
    const operations::groups groups = operation.groups(arguments.settings);
    if (!groups.fault.empty()) throw bad_usage(groups.fault);
    column_names names(groups.in);
    for (const std::string& mapping : arguments.columns) names.rename(mapping);
    arguments.stream.names = names.all();
    const separator between = arguments.stream.between;
    if (arguments.stream.decimal == ',' && (between == separator::of_line || between == separator::comma))
        throw bad_usage("--decimal ',' goes with --separator ';' or tab");
    if (arguments.stream.degrees) {
        if (!has_angles(groups.in) && !has_angles(groups.out) &&
            !has_option(operation, operations::option::angle))
            throw bad_usage("--degrees: no angle is read or written");
        auto* const angle = std::get_if<operations::number>(&arguments.settings.angle);
        if (angle != nullptr) {
            angle->f64 *= std::numbers::pi / 180;
            angle->f32 = static_cast<float>(angle->f64);
        }
    }
    if (arguments.type == number_type::f32) require_axis_in_f32(arguments.settings.axis);
    select_isa(arguments.isa);

    line_reader in(arguments.file);
    output out(arguments.out);
    if (arguments.type == number_type::f32)
        stream_rows<float>(operation, arguments.settings, arguments.stream, in, out);
    else
        stream_rows<double>(operation, arguments.settings, arguments.stream, in, out);
    out.commit();
}

separator parse_separator(const std::string& given) {
    if (given == "auto") return separator::of_line;
    if (given == ",") return separator::comma;
    if (given == ";") return separator::semicolon;
    if (given == "tab" || given == "\t") return separator::tab;
    throw bad_usage("--separator: '" + given + "' is none of auto , ; tab");
}

void add_operation(command_line eval, const operations::operation& operation) {
    const auto arguments = std::make_shared<eval_arguments>();
    command_line line = eval.add_command(operation.name, operation.description);
    line.add_operand("FILE", arguments->file, "Table to read, - for standard input (default: -)");
    for (const operations::option o : operation.options) add_option(line, o, arguments->settings);
    add_precision(line, arguments->settings.options.accuracy);
    line.add_choice("--type", arguments->type, {{"f32", number_type::f32}, {"f64", number_type::f64}},
                    "Numbers that are computed with, read and written");
    add_isa(line, arguments->isa);
    line.add_choice("--layout", arguments->stream.layout,
                    {{"soa", memory_layout::soa}, {"aos", memory_layout::aos}},
                    "How quaternions and vectors lie in memory; the compact form is always soa");
    if (may_have_angles(operation))
        line.add_flag("--degrees", arguments->stream.degrees, "Read and write angles in degrees");
    line.add_texts(
        "--columns", "GROUP=NAME,...", arguments->columns,
        "Names of the columns of a group that is read, where they are not the usual ones: of all, in "
        "order. GROUP is what the usual ones begin with, as q for qx qy qz qw, or the name of a single one, "
        "or factors or spinor. May be given once for each group");
    line.add_value(
        "--separator", "auto|,|;|tab",
        [arguments](const std::string& given) { arguments->stream.between = parse_separator(given); },
        "What stands between fields; auto: commas, or in a line without a comma blanks (default: auto)");
    line.add_choice("--decimal", arguments->stream.decimal, {{".", '.'}, {",", ','}},
                    "The decimal sign of numbers that are read");
    line.add_choice("--missing", arguments->stream.missing_is_nan, {{"error", false}, {"nan", true}},
                    "What an empty field of a column that is read is");
    line.add_flag("--pass", arguments->stream.pass,
                  "Copy the columns that are not read, whatever is in them, in front of the results");
    line.add_text("--out", "FILE", arguments->out,
                  "File for the results, - for standard output (default: -)");
    line.set_footer(operation.help);
    line.set_action([&operation, arguments] { evaluate(operation, *arguments); });
}

constexpr const char* footer =
    "Tables: a header row with the names of the columns, in any order, then a row of numbers for each\n"
    "rotation, comma separated, or blank separated where a line has no comma, or as --separator says.\n"
    "Fields may stand in double quotes. Lines end with LF, CRLF or CR and have at most 1048576 bytes; empty\n"
    "ones are skipped. Numbers are decimal, with an optional sign and the decimal sign of --decimal, or nan\n"
    "or inf in any letter case; an empty field is refused, or NaN with --missing nan. Columns that the\n"
    "operation does not read, with a name or without, are refused, or copied with --pass. The results are\n"
    "comma separated with decimal points however the table is written, with the shortest numbers that read\n"
    "back as the same ones.\n\n"
    "Bad data ends the command with FILE:LINE:COLUMN: what was wrong; the rows before it have been written\n"
    "to standard output. A file named by --out is replaced as a whole or left alone.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval decompose --axis z\n"
    "  printf 'qx;qy;qz;qw\\n0;0;0,6;0,8\\n' | swivel eval twist --separator ';' --decimal ','\n"
    "  swivel eval twist_angle --axis 0.6,0,0.8 --type f32 rotations.csv\n"
    "  swivel eval twist --columns q=rot_x,rot_y,rot_z,rot_w --pass --missing nan frame.csv\n"
    "  swivel eval to_euler --separator ';' --decimal ',' --degrees --order zxy export.csv\n"
    "  swivel eval decompose --help";

}  // namespace

void add_eval(command_line program) {
    command_line line =
        program.add_command("eval", "Applies an operation of the library to a table of numbers");
    line.require_subcommand();
    line.set_footer(footer);
    for (const operations::operation* const operation : operations::all()) add_operation(line, *operation);
}

}  // namespace swivel::command
