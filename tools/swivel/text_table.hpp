#ifndef SWIVEL_COMMAND_TEXT_TABLE_HPP
#define SWIVEL_COMMAND_TEXT_TABLE_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace swivel::command {

enum class alignment { left, right };

// Rows for a terminal: columns of equal width, two blanks between them. Characters are counted, not bytes.
class text_table {
public:
    struct column {
        std::string title;
        alignment align;
    };

    explicit text_table(std::vector<column> columns);

    void add(std::vector<std::string> row);
    [[nodiscard]] std::string text() const;

private:
    std::vector<column> columns_;
    std::vector<std::size_t> widths_;
    std::vector<std::vector<std::string>> rows_;
};

// For a table: control characters replaced, and what is too long cut.
[[nodiscard]] std::string shown_in_table(std::string_view name);

}  // namespace swivel::command

#endif
