#include "text_table.hpp"

#include <algorithm>
#include <utility>

#include "swivel/clip/text.hpp"

namespace swivel::command {

namespace {

bool begins_character(char c) noexcept { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }

std::size_t characters(std::string_view text) noexcept {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

}  // namespace

text_table::text_table(std::vector<column> columns) : columns_(std::move(columns)) {
    for (const column& c : columns_) widths_.push_back(characters(c.title));
}

void text_table::add(std::vector<std::string> row) {
    row.resize(columns_.size());
    for (std::size_t i = 0; i < row.size(); ++i) widths_[i] = std::max(widths_[i], characters(row[i]));
    rows_.push_back(std::move(row));
}

std::string text_table::text() const {
    std::string text;
    const auto append_line = [&](const auto& cell_of) {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const std::string& cell = cell_of(i);
            const std::string padding(widths_[i] - characters(cell), ' ');
            if (i > 0) text += "  ";
            text += columns_[i].align == alignment::left ? cell + padding : padding + cell;
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    };
    append_line([&](std::size_t i) -> const std::string& { return columns_[i].title; });
    for (const auto& row : rows_) append_line([&](std::size_t i) -> const std::string& { return row[i]; });
    return text;
}

std::string shown_in_table(std::string_view name) {
    constexpr std::size_t most = 40;
    std::string shown;
    std::size_t count = 0;
    for (const char c : name) {
        if (begins_character(c) && count++ == most) return shown + "...";
        shown += clip::is_control(c) ? ' ' : c;
    }
    return shown;
}

}  // namespace swivel::command
