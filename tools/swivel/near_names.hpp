#ifndef SWIVEL_COMMAND_NEAR_NAMES_HPP
#define SWIVEL_COMMAND_NEAR_NAMES_HPP

#include <string>
#include <string_view>
#include <vector>

namespace swivel::command {

// The few names that somebody who typed `wanted` may have meant, best first: in another letter case, with a
// few letters different, or with `wanted` as a part.
[[nodiscard]] std::vector<std::string_view> near_names(std::string_view wanted,
                                                       const std::vector<std::string_view>& names);

}  // namespace swivel::command

#endif
