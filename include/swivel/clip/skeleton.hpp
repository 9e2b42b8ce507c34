#ifndef SWIVEL_CLIP_SKELETON_HPP
#define SWIVEL_CLIP_SKELETON_HPP

// swivel::clip: skeletons and clips of motion, and the files that hold them
//
//   Target     swivel::clip in CMake (find_package(swivel COMPONENTS clip)), swivel-clip in pkg-config. It needs
//              swivel::swivel, of which it sees the public headers only.
//   Headers    skeleton.hpp   joints, channels, the direction of bones
//              clip.hpp       a skeleton with its motion, rotations of a joint over time
//              read.hpp       clips from files, with errors and warnings as values
//              write.hpp      clips to files
//              text.hpp       numbers and words of text files
//              Unlike those of swivel::swivel they use the strings and vectors of the standard library.
//   Memory     A clip owns what it holds; there is nothing to be freed by hand.
//   Errors     Values, never exceptions, but for std::bad_alloc where a function is not noexcept.
//   Threads    No state is shared: any thread may call anything on clips of its own, and many may read one clip.
//   Units      Lengths as in the file (often centimetres or inches), angles of channels in degrees, times in
//              seconds. Rotations that come out are quaternions as in swivel/types.hpp.
//   Checked    What readers return is whole: parents stand before their children, columns are numbered, all
//              numbers are finite, names differ. A skeleton or clip that is built by hand is what its builder
//              made of it; bvh_fault (write.hpp) tells.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "swivel/types.hpp"

namespace swivel::clip {

using vec3 = swivel::vec3<double>;

enum class channel : std::uint8_t { x_position, y_position, z_position, x_rotation, y_rotation, z_rotation };

[[nodiscard]] constexpr bool is_rotation(channel c) noexcept { return c >= channel::x_rotation; }

// The channels of one joint in the order in which the file gives them, each at most once.
class channel_list {
public:
    static constexpr std::size_t capacity = 6;

    // False, and nothing is added, when `c` is already there.
    bool add(channel c) noexcept;
    [[nodiscard]] bool contains(channel c) const noexcept;
    [[nodiscard]] std::size_t size() const noexcept { return count_; }
    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
    [[nodiscard]] const channel* begin() const noexcept { return order_.data(); }
    [[nodiscard]] const channel* end() const noexcept { return order_.data() + count_; }

    friend bool operator==(const channel_list&, const channel_list&) = default;

private:
    std::array<channel, capacity> order_{};
    std::uint8_t count_ = 0;
};

// The tip of a bone that has no joint of its own.
struct end_site {
    vec3 offset{};
    std::string name;  // often empty

    friend bool operator==(const end_site&, const end_site&) = default;
};

struct joint {
    std::string name;
    std::int32_t parent = -1;  // index in skeleton::joints, always less than the joint's own; -1 for a root
    vec3 offset{};             // from the parent, in the rest pose
    channel_list channels;
    std::size_t first_channel = 0;  // column of this joint's first channel in a row of the clip
    std::optional<end_site> end;

    friend bool operator==(const joint&, const joint&) = default;
};

struct skeleton {
    std::vector<joint> joints;      // parent before child; several roots are allowed
    std::size_t channel_count = 0;  // columns of a row, the sum over all joints

    friend bool operator==(const skeleton&, const skeleton&) = default;
};

// Numbers the columns: sets every first_channel and channel_count from the joints' channel lists, in joint
// order. For whoever builds a skeleton by hand; readers have done it.
void number_channels(skeleton& s) noexcept;

// The index of the joint of that name (exact, case matters), or nothing. Linear in the joints.
[[nodiscard]] std::optional<std::size_t> find_joint(const skeleton& s, std::string_view name) noexcept;

// How the direction of a bone was found.
enum class direction_rule : std::uint8_t {
    child,             // the offset of the only child
    mean_of_children,  // several children: the mean of their offsets
    end_site,          // no child: the offset of the joint's own End Site
    parent,            // neither: the direction of the parent
    none               // neither, and no parent has one: y
};

// The English words for a rule, for messages.
[[nodiscard]] std::string_view name(direction_rule r) noexcept;

struct bone_direction {
    vec3 direction{};  // unit length, in the joint's own rest frame
    direction_rule rule = direction_rule::none;

    friend bool operator==(const bone_direction&, const bone_direction&) = default;
};

// The axis along the bone of every joint, in joint order: the first of the rules above that gives a
// direction.
//   Zero-length offsets: a child with offset (0, 0, 0) stands at the joint itself, so what that child points
//   at (its children, else its End Site) stands in its place. An End Site with offset (0, 0, 0) counts as
//   none. Lengths below 1e-290 count as zero. Children whose mean vanishes (1e-9 of the mean of their
//   lengths, or less) give no direction.
//   Not checked: that parents stand before their children and offsets are finite, as readers leave them.
// Linear in the joints.
[[nodiscard]] std::vector<bone_direction> bone_directions(const skeleton& s);

}  // namespace swivel::clip

#endif  // SWIVEL_CLIP_SKELETON_HPP
