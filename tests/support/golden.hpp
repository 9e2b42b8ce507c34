#ifndef SWIVEL_TESTS_SUPPORT_GOLDEN_HPP
#define SWIVEL_TESTS_SUPPORT_GOLDEN_HPP

// The golden vectors, read once.

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "swivel/types.hpp"

namespace swivel::tests {

// A section of the file; null, and said loudly, where the file is absent.
inline nlohmann::json golden_section(const char* name) {
    static const nlohmann::json root = [] {
        const auto file = std::filesystem::path(SWIVEL_SHARED_DIR) / "golden" / "golden.json";
        if (std::filesystem::exists(file)) return nlohmann::json::parse(std::ifstream(file));
        std::cerr << "SKIPPED: no golden vectors at " << file << '\n';
        return nlohmann::json();
    }();
    return root.is_null() ? root : root.at(name);
}

// In the file w comes first.
inline quat<double> golden_quat(const nlohmann::json& numbers) {
    const auto q = numbers.get<std::array<double, 4>>();
    return {q[1], q[2], q[3], q[0]};
}

}  // namespace swivel::tests

#endif
