#include "row_fields.hpp"

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

std::optional<field_fault> split_row(std::string_view line, std::vector<field>& fields) {
    fields.clear();
    const bool commas = has_separating_comma(line);
    std::size_t at = line.find_first_not_of(blanks);
    if (at == std::string_view::npos) return std::nullopt;

    for (;;) {
        std::size_t end = 0;
        if (at < line.size() && line[at] == '"') {
            end = end_of_quotes(line, at);
            if (end == std::string_view::npos)
                return field_fault{at + 1, "a quote that is not closed", "'\"' on the same line"};
            fields.push_back({line.substr(at + 1, end - at - 2), at + 1, true});
            if (end < line.size() && line[end] != ',' && !is_blank(line[end]))
                return field_fault{end + 1, "text right after a quoted field", "a separator"};
        } else {
            end = line.find_first_of(commas ? std::string_view(",") : blanks, at);
            if (end == std::string_view::npos) end = line.size();
            std::size_t last = end;
            while (last > at && is_blank(line[last - 1])) --last;
            fields.push_back({line.substr(at, last - at), at + 1, false});
        }

        at = line.find_first_not_of(blanks, end);
        if (commas) {
            if (at == std::string_view::npos) return std::nullopt;
            if (line[at] != ',') return field_fault{at + 1, "text after a quoted field", "','"};
            at = line.find_first_not_of(blanks, at + 1);
            // What follows the last comma is a field too, and an empty one.
            if (at == std::string_view::npos) at = line.size();
        } else if (at == std::string_view::npos) {
            return std::nullopt;
        }
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
    if (f.is_quoted) row += '"';
    row += f.text;
    if (f.is_quoted) row += '"';
}

}  // namespace swivel::command
