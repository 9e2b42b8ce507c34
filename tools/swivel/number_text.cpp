#include "number_text.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace swivel::command {

namespace {

template <class T>
constexpr std::string_view too_large = "is too large for f64";
template <>
constexpr std::string_view too_large<float> = "is too large for f32";

// A number that is well formed, but that from_chars finds outside the range of the type at either end.
template <class T>
clip::parsed<T> out_of_range(std::string_view token) noexcept {
    const clip::parsed<double> wide = clip::parse_number(token);
    if (!wide.fault.empty() || std::fabs(wide.value) > 1) return {T{0}, too_large<T>};
    return {static_cast<T>(wide.value), {}};
}

template <class T>
void append_shortest(std::string& text, T value) {
    if (std::isnan(value)) {
        text += "nan";
        return;
    }
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end.ptr);
}

}  // namespace

template <class T>
clip::parsed<T> parse_real(std::string_view token) noexcept {
    constexpr clip::parsed<T> no_number{T{0}, "is not a number"};
    const bool negative = token.starts_with('-');
    if (negative || token.starts_with('+')) token.remove_prefix(1);
    if (token.empty() || token.front() == '-' || token.front() == '+') return no_number;
    const T sign = negative ? T{-1} : T{1};

    if (clip::equals_ignoring_case(token, "nan")) return {std::numeric_limits<T>::quiet_NaN(), {}};
    if (clip::equals_ignoring_case(token, "inf") || clip::equals_ignoring_case(token, "infinity"))
        return {sign * std::numeric_limits<T>::infinity(), {}};

    T value{};
    const char* const end = token.data() + token.size();
    const auto [stop, fault] = std::from_chars(token.data(), end, value);
    if (fault == std::errc::invalid_argument || stop != end || std::isnan(value)) return no_number;
    if (fault == std::errc::result_out_of_range || std::isinf(value)) {
        clip::parsed<T> limit = out_of_range<T>(token);
        limit.value *= sign;
        return limit;
    }
    return {sign * value, {}};
}

template clip::parsed<float> parse_real<float>(std::string_view) noexcept;
template clip::parsed<double> parse_real<double>(std::string_view) noexcept;

void append_number(std::string& text, float value) { append_shortest(text, value); }
void append_number(std::string& text, double value) { append_shortest(text, value); }

std::string fixed_decimals(double value, int decimals) {
    if (!std::isfinite(value)) {
        std::string text;
        append_number(text, value);
        return text;
    }
    char digits[400];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals);
    std::string text(digits, end.ptr);
    const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
    if (is_zero && text.starts_with('-')) text.erase(0, 1);
    return text;
}

}  // namespace swivel::command
