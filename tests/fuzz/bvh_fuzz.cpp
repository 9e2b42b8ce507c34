// Any bytes: the reader yields a clip that survives writing and reading, or an error inside the text.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "swivel/clip/read.hpp"
#include "swivel/clip/write.hpp"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace swivel::clip;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const read_result first = read_bvh(text);
    if (!first) {
        require(first.error.line >= 1 && first.error.column >= 1);
        require(first.error.line <= size + 1 && first.error.column <= size + 1);
        require(!first.error.what.empty() && !first.error.expected.empty());
        return 0;
    }
    const clip& c = *first.value;
    require(bvh_fault(c).empty());
    require(bone_directions(c.skeleton).size() == c.skeleton.joints.size());

    const std::string written = write_bvh(c);
    const read_result second = read_bvh(written);
    require(second && second.warnings.empty());
    require(c == *second.value);
    require(same_bits(c.frame_time, second.value->frame_time));
    for (std::size_t i = 0; i < c.values.size(); ++i)
        require(same_bits(c.values[i], second.value->values[i]));
    require(write_bvh(*second.value) == written);
    return 0;
}
