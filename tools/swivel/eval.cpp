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

void evaluate(const operations::operation& operation, eval_arguments& arguments) {
    // Before the input is looked at: contradictions are bad usage whatever the data are.
    if (const operations::groups g = operation.groups(arguments.settings); !g.fault.empty())
        throw bad_usage(g.fault);
    if (arguments.stream.degrees) {
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
    line.add_flag("--pass", arguments->stream.pass,
                  "Copy the columns that are not read, whatever is in them, in front of the results");
    line.add_text("--out", "FILE", arguments->out,
                  "File for the results, - for standard output (default: -)");
    line.set_footer(operation.help);
    line.set_action([&operation, arguments] { evaluate(operation, *arguments); });
}

constexpr const char* footer =
    "Tables: a header row with the names of the columns, in any order, then a row of numbers for each\n"
    "rotation, comma separated, or blank separated where a line has no comma. Fields may stand in double\n"
    "quotes. Lines end with LF, CRLF or CR and have at most 1048576 bytes; empty ones are skipped. Numbers\n"
    "are decimal, with an optional sign, or nan or inf in any letter case. Columns that the operation does\n"
    "not read are refused, or copied with --pass. The results are comma separated, with the shortest\n"
    "numbers that read back as the same ones.\n\n"
    "Bad data ends the command with FILE:LINE:COLUMN: what was wrong; the rows before it have been written\n"
    "to standard output. A file named by --out is replaced as a whole or left alone.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval decompose --axis z\n"
    "  swivel eval twist_angle --axis 0.6,0,0.8 --type f32 rotations.csv\n"
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
