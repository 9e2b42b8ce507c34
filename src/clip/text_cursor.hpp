#ifndef SWIVEL_SRC_CLIP_TEXT_CURSOR_HPP
#define SWIVEL_SRC_CLIP_TEXT_CURSOR_HPP

// Walks over a text and knows its line and column.

#include <cstddef>
#include <string_view>

namespace swivel::clip {

// A piece of a line. Empty text: the end of the line or of the whole text, whichever was asked for.
struct token {
    std::string_view text;
    std::size_t line = 0;
    std::size_t column = 0;
};

[[nodiscard]] constexpr bool is_line_end(char c) noexcept { return c == '\n' || c == '\r'; }

class text_cursor {
public:
    explicit text_cursor(std::string_view text) noexcept : text_(text) {}

    [[nodiscard]] std::size_t remaining() const noexcept { return text_.size() - at_; }

    // The last byte of the whole text belongs to a token.
    [[nodiscard]] bool ends_in_token() const noexcept;

    // The next token on this line or a later one; each character of `singles` is a token of its own.
    token take(std::string_view singles) noexcept;
    [[nodiscard]] token peek(std::string_view singles) const noexcept;

    // The next token on this line; empty at the end of the line.
    token take_on_line() noexcept;

    // The rest of this line up to, not including, the character `stop`, without blanks at its ends.
    token take_rest_of_line(char stop) noexcept;

    // To the first byte that is neither blank nor a line end; false when there is none.
    bool skip_to_content() noexcept;

private:
    void skip_blanks() noexcept;
    [[nodiscard]] token piece(std::size_t length) const noexcept;

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::size_t line_start_ = 0;
};

}  // namespace swivel::clip

#endif  // SWIVEL_SRC_CLIP_TEXT_CURSOR_HPP
