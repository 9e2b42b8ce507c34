#ifndef SWIVEL_CLIP_TEXT_HPP
#define SWIVEL_CLIP_TEXT_HPP

// Numbers and words of text files as the readers of this library take them, for programs that read files of
// their own or show what they were given. Independent of the locale. Nothing is allocated but by `quoted`.

#include <cstddef>
#include <string>
#include <string_view>

namespace swivel::clip {

// A number and, when the token is none, the reason, which completes the sentence "'1x0' ...".
template <class T>
struct parsed {
    T value{};
    std::string_view fault{};
};

// The whole token as a finite double. A sign may stand before it. Too small for a double is zero of its sign.
[[nodiscard]] parsed<double> parse_number(std::string_view token) noexcept;

// The whole token as a whole number, 0 or more, without point or exponent.
[[nodiscard]] parsed<std::size_t> parse_count(std::string_view token) noexcept;

// Of ASCII letters; other bytes have no case.
[[nodiscard]] bool equals_ignoring_case(std::string_view a, std::string_view b) noexcept;

[[nodiscard]] constexpr bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

// What a terminal would act on.
[[nodiscard]] constexpr bool is_control(char c) noexcept {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
}

// For messages: in quotes, control characters escaped, cut to a readable length.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace swivel::clip

#endif  // SWIVEL_CLIP_TEXT_HPP
