#ifndef SWIVEL_TESTS_SUPPORT_BVH_TEXT_HPP
#define SWIVEL_TESTS_SUPPORT_BVH_TEXT_HPP

// A small valid BVH file, and ways to change and compare.

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "swivel/clip/read.hpp"
#include "swivel/clip/write.hpp"

namespace swivel::clip {

inline const std::string valid_bvh =
    "HIERARCHY\n"                                                                 // 1
    "ROOT Hips\n"                                                                 // 2
    "{\n"                                                                         // 3
    "\tOFFSET 0 95 0\n"                                                           // 4
    "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"  // 5
    "\tJOINT Leg\n"                                                               // 6
    "\t{\n"                                                                       // 7
    "\t\tOFFSET 0 -45 0\n"                                                        // 8
    "\t\tCHANNELS 3 Xrotation Yrotation Zrotation\n"                              // 9
    "\t\tEnd Site\n"                                                              // 10
    "\t\t{\n"                                                                     // 11
    "\t\t\tOFFSET 0 -40 0\n"                                                      // 12
    "\t\t}\n"                                                                     // 13
    "\t}\n"                                                                       // 14
    "}\n"                                                                         // 15
    "MOTION\n"                                                                    // 16
    "Frames: 2\n"                                                                 // 17
    "Frame Time: 0.01\n"                                                          // 18
    "0 95 0 1 2 3 4 5 6\n"                                                        // 19
    "1 96 1 7 8 9 10 11 12\n";                                                    // 20

inline std::string with(std::string_view text, std::string_view old, std::string_view replacement) {
    const std::size_t at = text.find(old);
    if (at == text.npos) {
        ADD_FAILURE() << "the text to be replaced is not there: " << old;
        return std::string(text);
    }
    std::string result(text.substr(0, at));
    result += replacement;
    result += text.substr(at + old.size());
    return result;
}

inline std::string with(std::string_view old, std::string_view replacement) {
    return with(valid_bvh, old, replacement);
}

inline std::string with_every(std::string_view text, char old, std::string_view replacement) {
    std::string result;
    for (const char c : text) {
        if (c == old)
            result += replacement;
        else
            result += c;
    }
    return result;
}

inline std::string shown(const diagnostic& d) {
    return std::to_string(d.line) + ":" + std::to_string(d.column) + ": " + d.what + ", expected " +
           d.expected;
}

// Every double of the clip, so that -0 and 0 differ.
inline std::vector<std::uint64_t> bits(const clip& c) {
    std::vector<std::uint64_t> all;
    const auto add = [&](double v) { all.push_back(std::bit_cast<std::uint64_t>(v)); };
    const auto add_offset = [&](const vec3& v) { add(v.x), add(v.y), add(v.z); };
    add(c.frame_time);
    for (const joint& j : c.skeleton.joints) {
        add_offset(j.offset);
        if (j.end) add_offset(j.end->offset);
    }
    for (const double v : c.values) add(v);
    return all;
}

inline testing::AssertionResult same(const clip& a, const clip& b) {
    if (!(a.skeleton == b.skeleton)) return testing::AssertionFailure() << "the hierarchies differ";
    if (a.frames != b.frames)
        return testing::AssertionFailure() << a.frames << " and " << b.frames << " frames";
    if (bits(a) != bits(b)) return testing::AssertionFailure() << "the numbers differ in bits";
    return testing::AssertionSuccess();
}

// Written, read and written again: the same clip, the same text.
inline testing::AssertionResult survives_round_trip(const clip& c) {
    if (const std::string fault = bvh_fault(c); !fault.empty()) return testing::AssertionFailure() << fault;
    const std::string text = write_bvh(c);
    const read_result again = read_bvh(text);
    if (!again) return testing::AssertionFailure() << shown(again.error);
    if (!again.warnings.empty()) return testing::AssertionFailure() << shown(again.warnings[0]);
    if (write_bvh(*again.value) != text) return testing::AssertionFailure() << "the second text differs";
    return same(c, *again.value);
}

}  // namespace swivel::clip

#endif  // SWIVEL_TESTS_SUPPORT_BVH_TEXT_HPP
