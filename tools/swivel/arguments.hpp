#ifndef SWIVEL_COMMAND_ARGUMENTS_HPP
#define SWIVEL_COMMAND_ARGUMENTS_HPP

// The options that several commands share.

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "command_line.hpp"
#include "operations/operation.hpp"
#include "swivel/swivel.hpp"

namespace swivel::command {

struct automatic_axis {};
using axis_argument = std::variant<swivel::axis, operations::axis_vector, operations::column, automatic_axis>;

// The words beside x, y, z and X,Y,Z that the axis may be given as.
enum class axis_words { none, automatic, columns };

using axis_reader = std::function<void(const axis_argument&)>;

void add_axis(command_line line, const axis_reader& read, axis_words words);
// With a description of its own.
void add_axis(command_line line, const axis_reader& read, axis_words words, const std::string& description);
void add_product(command_line line, swivel::product& value);
void add_precision(command_line line, swivel::precision& value);
void add_pole_threshold(command_line line, double& value);

void add_isa(command_line line, std::optional<swivel::isa>& value);
// Makes it the active one. Without a value, says on standard error when SWIVEL_ISA cannot be followed.
void select_isa(std::optional<swivel::isa> value);

[[nodiscard]] std::string isa_names(bool (*included)(swivel::isa) noexcept);
[[nodiscard]] std::optional<swivel::isa> find_isa(const std::string& name) noexcept;

}  // namespace swivel::command

#endif
