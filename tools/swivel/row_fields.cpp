#include "row_fields.hpp"

#include <algorithm>

namespace swivel::command {

namespace {

constexpr std::string_view blanks = " \t";

bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

// One past the closing quote of the field that begins at `at`; npos when there is none.
std::size_t end_of_quotes(std::string_view line, std::size_t at) noexcept {
    for (++at; at < line.size(); ++at) {
        if (line[at] != '"') continue;
        if (at + 1 == line.size() || line[at + 1] != '"') return at + 1;
        ++at;
    }
    return std::string_view::npos;
}

bool has_separating_comma(std::string_view line) noexcept {
    bool at_start = true;
    for (std::size_t i = 0; i < line.size();) {
        if (line[i] == ',') return true;
        if (at_start && line[i] == '"') {
            i = end_of_quotes(line, i);
            if (i == std::string_view::npos) return false;
            at_start = false;
            continue;
        }
        at_start = is_blank(line[i]);
        ++i;
    }
    return false;
}

}  // namespace

std::optional<field_fault> split_row(std::string_view line, std::vector<field>& fields, separator between) {
    fields.clear();
    const bool by_blanks = between == separator::of_line && !has_separating_comma(line);
    const char mark = between == separator::of_line ? ',' : static_cast<char>(between);
    // What may stand around a field.
    const std::string_view around = mark == '\t' ? std::string_view(" ") : blanks;
    const std::string_view ends = by_blanks ? blanks : std::string_view(&mark, 1);
    std::size_t at = line.find_first_not_of(around);
    // A line of tabs that separate is a row, of empty fields.
    if (at == std::string_view::npos) return std::nullopt;

    for (;;) {
        std::size_t end = 0;
        if (at < line.size() && line[at] == '"') {
            end = end_of_quotes(line, at);
            if (end == std::string_view::npos)
                return field_fault{at + 1, "a quote that is not closed", "'\"' on the same line"};
            fields.push_back({line.substr(at + 1, end - at - 2), at + 1, true});
            if (end < line.size() && line[end] != mark && !is_blank(line[end]))
                return field_fault{end + 1, "text right after a quoted field", "a separator"};
        } else {
            end = std::min(line.find_first_of(ends, at), line.size());
            std::size_t last = end;
            while (last > at && around.find(line[last - 1]) != std::string_view::npos) --last;
            fields.push_back({line.substr(at, last - at), at + 1, false});
        }

        at = line.find_first_not_of(around, end);
        if (at == std::string_view::npos) return std::nullopt;
        if (by_blanks) continue;
        if (line[at] != mark)
            return field_fault{at + 1, "text after a quoted field",
                               mark == ','   ? "','"
                               : mark == ';' ? "';'"
                                             : "a tab"};
        // What follows the last separator is a field too, and an empty one.
        at = std::min(line.find_first_not_of(around, at + 1), line.size());
    }
}

std::string unquoted(const field& f) {
    std::string text;
    for (std::size_t i = 0; i < f.text.size(); ++i) {
        text += f.text[i];
        if (f.is_quoted && f.text[i] == '"') ++i;
    }
    return text;
}

void append_field(std::string& row, std::string_view text) {
    const bool blank_at_an_end = !text.empty() && (is_blank(text.front()) || is_blank(text.back()));
    if (!blank_at_an_end && text.find_first_of(",\"\r\n") == std::string_view::npos) {
        row += text;
        return;
    }
    row += '"';
    for (const char c : text) {
        if (c == '"') row += '"';
        row += c;
    }
    row += '"';
}

void append_field(std::string& row, const field& f) {
    // Between semicolons a comma needs no quotes.
    if (!f.is_quoted) return append_field(row, f.text);
    row += '"';
    row += f.text;
    row += '"';
}

}  // namespace swivel::command
