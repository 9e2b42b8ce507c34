#include "src/clip/text_cursor.hpp"

#include "swivel/clip/text.hpp"

namespace swivel::clip {

bool text_cursor::ends_in_token() const noexcept {
    return !text_.empty() && !is_blank(text_.back()) && !is_line_end(text_.back());
}

void text_cursor::skip_blanks() noexcept {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

bool text_cursor::skip_to_content() noexcept {
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (is_line_end(c)) {
            if (c == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
            ++line_;
            line_start_ = at_ + 1;
        } else if (!is_blank(c)) {
            return true;
        }
    }
    return false;
}

token text_cursor::piece(std::size_t length) const noexcept {
    return {text_.substr(at_, length), line_, at_ - line_start_ + 1};
}

token text_cursor::take(std::string_view singles) noexcept {
    skip_to_content();
    std::size_t end = at_;
    if (end < text_.size() && singles.find(text_[end]) != std::string_view::npos)
        ++end;
    else
        while (end < text_.size() && !is_blank(text_[end]) && !is_line_end(text_[end]) &&
               singles.find(text_[end]) == std::string_view::npos)
            ++end;
    const token t = piece(end - at_);
    at_ = end;
    return t;
}

token text_cursor::peek(std::string_view singles) const noexcept { return text_cursor(*this).take(singles); }

token text_cursor::take_on_line() noexcept {
    skip_blanks();
    std::size_t end = at_;
    while (end < text_.size() && !is_blank(text_[end]) && !is_line_end(text_[end])) ++end;
    const token t = piece(end - at_);
    at_ = end;
    return t;
}

token text_cursor::take_rest_of_line(char stop) noexcept {
    skip_blanks();
    std::size_t end = at_;
    while (end < text_.size() && !is_line_end(text_[end]) && text_[end] != stop) ++end;
    std::size_t last = end;
    while (last > at_ && is_blank(text_[last - 1])) --last;
    const token t = piece(last - at_);
    at_ = end;
    return t;
}

}  // namespace swivel::clip
