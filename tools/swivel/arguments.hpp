#ifndef SWIVEL_COMMAND_ARGUMENTS_HPP
#define SWIVEL_COMMAND_ARGUMENTS_HPP

// The options that several commands share.

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "swivel/swivel.hpp"

namespace swivel::command {

// What App::require_subcommand(1) does, but an unknown subcommand is named before one is asked for.
void require_one_subcommand(CLI::App& app);

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

// An option whose value is one of a few words.
template <class T>
CLI::Option* add_choice(CLI::App& app, const std::string& name, T& value,
                        std::initializer_list<std::pair<const char*, T>> choices,
                        const std::string& description) {
    std::string words, preset;
    for (const auto& [word, meaning] : choices) {
        words += words.empty() ? "" : "|";
        words += word;
        if (meaning == value) preset = word;
    }
    const std::vector<std::pair<const char*, T>> known = choices;
    return app
        .add_option_function<std::string>(
            name,
            [&value, known, name, words](const std::string& given) {
                for (const auto& [word, meaning] : known)
                    if (given == word) {
                        value = meaning;
                        return;
                    }
                throw CLI::ValidationError(name, "'" + given + "' is none of " + words);
            },
            description + " (default: " + preset + ")")
        ->type_name(words);
}

// The words beside x, y, z and X,Y,Z that the axis may be given as.
enum class axis_words { none, automatic, columns };

CLI::Option* add_axis(CLI::App& app, axis_argument& value, axis_words words);
void add_product(CLI::App& app, swivel::product& value);
void add_precision(CLI::App& app, swivel::precision& value);
[[nodiscard]] parameter_argument parse_parameter(const std::string& name, const std::string& given);
// A number, or the word `column` for the column of that name.
CLI::Option* add_parameter(CLI::App& app, const std::string& name, parameter_argument& value,
                           const std::string& description);
void add_pole_threshold(CLI::App& app, double& value);

void add_isa(CLI::App& app, std::optional<swivel::isa>& value);
// Makes it the active one. Without a value, says on standard error when SWIVEL_ISA cannot be followed.
void select_isa(std::optional<swivel::isa> value);

[[nodiscard]] std::string isa_names(bool (*included)(swivel::isa) noexcept);
[[nodiscard]] std::optional<swivel::isa> find_isa(const std::string& name) noexcept;

}  // namespace swivel::command

#endif
