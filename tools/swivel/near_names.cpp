#include "near_names.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace swivel::command {

namespace {

// Longer names are compared by their beginnings, so that the cost of a comparison has a bound.
constexpr std::size_t compared = 48;
constexpr std::size_t most = 5;

std::string lower_case(std::string_view text) {
    std::string lower(text.substr(0, compared));
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

// Letters to insert, remove or replace to get from one to the other.
std::size_t edit_distance(std::string_view a, std::string_view b) noexcept {
    std::array<std::size_t, compared + 1> row{};
    for (std::size_t k = 0; k <= b.size(); ++k) row[k] = k;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t k = 1; k <= b.size(); ++k) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
            diagonal = row[k];
            row[k] = std::min({replaced, row[k] + 1, row[k - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

std::vector<std::string_view> near_names(std::string_view wanted,
                                         const std::vector<std::string_view>& names) {
    const std::string pattern = lower_case(wanted);
    const std::size_t far = std::max<std::size_t>(2, pattern.size() / 3) + 1;
    std::vector<std::pair<std::size_t, std::string_view>> found;
    for (const std::string_view name : names) {
        const std::string candidate = lower_case(name);
        std::size_t distance = edit_distance(pattern, candidate);
        const bool is_part = pattern.size() > 1 && candidate.find(pattern) != std::string::npos;
        if (is_part) distance = std::min(distance, far - 1);
        if (distance < far && distance < candidate.size()) found.emplace_back(distance, name);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string_view> near;
    for (std::size_t i = 0; i < std::min(most, found.size()); ++i) near.push_back(found[i].second);
    return near;
}

}  // namespace swivel::command
