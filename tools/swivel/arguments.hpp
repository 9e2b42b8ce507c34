#ifndef SWIVEL_COMMAND_ARGUMENTS_HPP
#define SWIVEL_COMMAND_ARGUMENTS_HPP

// The options that several commands share.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "command_line.hpp"
#include "swivel/swivel.hpp"

namespace swivel::command {

struct automatic_axis {};
struct axis_columns {};
// Read from the text in either type, so that neither is rounded twice.
struct axis_vector {
    swivel::vec3<float> f32{};
    swivel::vec3<double> f64{};
};
using axis_argument = std::variant<swivel::axis, axis_vector, automatic_axis, axis_columns>;

// One number for all rows, or a column with one for each.
struct parameter_column {};
struct number {
    float f32 = 0;
    double f64 = 0;
};
using parameter_argument = std::variant<number, parameter_column>;

// The words beside x, y, z and X,Y,Z that the axis may be given as.
enum class axis_words { none, automatic, columns };

void add_axis(command_line line, axis_argument& value, axis_words words);
// With a description of its own.
void add_axis(command_line line, axis_argument& value, axis_words words, const std::string& description);
void add_product(command_line line, swivel::product& value);
void add_precision(command_line line, swivel::precision& value);
[[nodiscard]] parameter_argument parse_parameter(const std::string& name, const std::string& given);
// A number, or the word `column` for the column of that name.
void add_parameter(command_line line, const std::string& name, parameter_argument& value,
                   const std::string& description);
void add_pole_threshold(command_line line, double& value);

void add_isa(command_line line, std::optional<swivel::isa>& value);
// Makes it the active one. Without a value, says on standard error when SWIVEL_ISA cannot be followed.
void select_isa(std::optional<swivel::isa> value);

[[nodiscard]] std::string isa_names(bool (*included)(swivel::isa) noexcept);
[[nodiscard]] std::optional<swivel::isa> find_isa(const std::string& name) noexcept;

}  // namespace swivel::command

#endif
