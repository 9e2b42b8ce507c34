#ifndef SWIVEL_COMMAND_NUMBER_TEXT_HPP
#define SWIVEL_COMMAND_NUMBER_TEXT_HPP

// Numbers from text and into text, whatever the locale is.

#include <string>
#include <string_view>

#include "swivel/clip/text.hpp"

namespace swivel::command {

// The whole token as the nearest float or double: a decimal number with an optional sign, or nan, inf or
// infinity in any letter case. Too small for the type is zero of its sign; too large is a fault.
template <class T>
[[nodiscard]] clip::parsed<T> parse_real(std::string_view token) noexcept;

// The shortest text that reads back as the same float or double; `nan` for every NaN.
void append_number(std::string& text, float value);
void append_number(std::string& text, double value);

// With a fixed number of decimals, and without a sign on zero.
[[nodiscard]] std::string fixed_decimals(double value, int decimals);

}  // namespace swivel::command

#endif
