#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "commands.hpp"
#include "eval_operation.hpp"
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
    eval_settings settings;
};

void require_axis_in_f32(const axis_argument& axis) {
    const auto* const vector = std::get_if<axis_vector>(&axis);
    if (vector == nullptr) return;
    const swivel::vec3<float>& v = vector->f32;
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        throw bad_usage("--axis: too long for f32");
    if (v.x == 0 && v.y == 0 && v.z == 0) throw bad_usage("--axis: has no direction in f32");
}

void evaluate(const eval_operation& operation, const eval_arguments& arguments) {
    // Before the input is looked at: contradictions are bad usage whatever the data are.
    (void)operation.columns(arguments.settings);
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

void add_operation(command_line eval, const eval_operation& operation) {
    const auto arguments = std::make_shared<eval_arguments>();
    command_line line = eval.add_command(operation.name, operation.description);
    line.add_operand("FILE", arguments->file, "Table to read, - for standard input (default: -)");
    operation.add_options(line, arguments->settings);
    add_precision(line, arguments->settings.options.accuracy);
    line.add_choice("--type", arguments->type, {{"f32", number_type::f32}, {"f64", number_type::f64}},
                    "Numbers that are computed with, read and written");
    add_isa(line, arguments->isa);
    line.add_choice("--layout", arguments->stream.layout,
                    {{"soa", memory_layout::soa}, {"aos", memory_layout::aos}},
                    "How quaternions and vectors lie in memory; the compact form is always soa");
    line.add_flag("--pass", arguments->stream.pass,
                  "Copy the columns that are not read, whatever is in them, in front of the results");
    line.add_text("--out", "FILE", arguments->out,
                  "File for the results, - for standard output (default: -)");
    line.set_footer(operation.footer);
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
    for (const eval_operation* const operation : eval_operations()) add_operation(line, *operation);
}

}  // namespace swivel::command
