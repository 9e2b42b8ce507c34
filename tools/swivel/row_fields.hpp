#ifndef SWIVEL_COMMAND_ROW_FIELDS_HPP
#define SWIVEL_COMMAND_ROW_FIELDS_HPP

// One line of a table into its fields, and text into a field.
//
// A line with a comma outside quotes is comma separated: the blanks (spaces and tabs) around a field do not
// belong to it, those within do. Any other line is separated by blanks. A field that begins with a double
// quote ends at the next one; two in a row stand for one of them. It ends on its line. Where the separator is
// said, commas and blanks are no others.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swivel::command {

struct field {
    std::string_view text;  // without the quotes around it; those within are still doubled
    std::size_t column = 1;
    bool is_quoted = false;
};

struct field_fault {
    std::size_t column = 1;
    std::string_view what;
    std::string_view expected;
};

// One of them, or what the line itself shows.
enum class separator : char { of_line = 0, comma = ',', semicolon = ';', tab = '\t' };

// Into `fields`, whose memory is used again; no field for a line of nothing but blanks, which
// tabs are not where they are the separator.
[[nodiscard]] std::optional<field_fault> split_row(std::string_view line, std::vector<field>& fields,
                                                   separator between = separator::of_line);

// What a quoted field stands for.
[[nodiscard]] std::string unquoted(const field& f);

// As a field of a comma-separated row, in quotes if it needs them.
void append_field(std::string& row, std::string_view text);

// As it stood in its own row, in quotes where a comma is now a separator.
void append_field(std::string& row, const field& f);

}  // namespace swivel::command

#endif
