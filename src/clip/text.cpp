#include "swivel/clip/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace swivel::clip {

namespace {

char lower(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

// The sign-free size of a well-formed number that no double can hold: above one, or below.
bool is_above_one(std::string_view number) noexcept {
    constexpr long long exponent_limit = 1'000'000'000'000'000;
    long long digits_before_point = 0;
    long long leading_zeros = 0;
    bool after_point = false;
    bool significant = false;
    std::size_t i = 0;
    for (; i < number.size() && lower(number[i]) != 'e'; ++i) {
        if (number[i] == '.') after_point = true;
        if (!is_digit(number[i])) continue;
        significant = significant || number[i] != '0';
        if (!significant) ++leading_zeros;
        if (!after_point) ++digits_before_point;
    }
    long long exponent = 0;
    const bool negative = i + 1 < number.size() && number[i + 1] == '-';
    for (; i < number.size(); ++i)
        if (is_digit(number[i]) && exponent < exponent_limit) exponent = 10 * exponent + (number[i] - '0');
    return significant && digits_before_point - leading_zeros + (negative ? -exponent : exponent) > 0;
}

}  // namespace

parsed<double> parse_number(std::string_view token) noexcept {
    constexpr parsed<double> no_number{0, "is not a number"};
    if (!token.empty() && token.front() == '+') {
        token.remove_prefix(1);
        if (!token.empty() && token.front() == '-') return no_number;
    }
    double value = 0;
    const char* const end = token.data() + token.size();
    const auto [stop, fault] = std::from_chars(token.data(), end, value);
    if (fault == std::errc::invalid_argument || stop != end) return no_number;
    if (fault == std::errc::result_out_of_range) {
        if (is_above_one(token)) return {0, "is too large for a double"};
        return {token.front() == '-' ? -0.0 : 0.0, {}};
    }
    if (!std::isfinite(value)) return {0, "is not finite"};
    return {value, {}};
}

parsed<std::size_t> parse_count(std::string_view token) noexcept {
    if (!token.empty() && token.front() == '+') token.remove_prefix(1);
    const bool negative = token.size() > 1 && token.front() == '-';
    if (negative) token.remove_prefix(1);
    std::size_t value = 0;
    const char* const end = token.data() + token.size();
    const auto [stop, fault] = std::from_chars(token.data(), end, value);
    if (fault == std::errc::invalid_argument || stop != end) return {0, "is not a whole number"};
    if (negative) return {0, "is negative"};
    if (fault == std::errc::result_out_of_range) return {0, "is too large"};
    return {value, {}};
}

bool equals_ignoring_case(std::string_view a, std::string_view b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char left, char right) { return lower(left) == lower(right); });
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 48;
    constexpr char hex[] = "0123456789abcdef";
    std::size_t shown = text.size();
    if (shown > longest) {
        const auto continues_character = [&](std::size_t i) {
            return (static_cast<unsigned char>(text[i]) & 0xc0u) == 0x80u;
        };
        shown = longest;
        while (shown > longest - 4 && continues_character(shown)) --shown;
    }
    std::string q = "'";
    for (const char c : text.substr(0, shown)) {
        if (is_control(c)) {
            const auto byte = static_cast<unsigned char>(c);
            q += "\\x";
            q += hex[byte >> 4];
            q += hex[byte & 15];
        } else {
            q += c;
        }
    }
    return q + (shown < text.size() ? "...'" : "'");
}

}  // namespace swivel::clip
