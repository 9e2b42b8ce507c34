#ifndef SWIVEL_CLIP_CLIP_HPP
#define SWIVEL_CLIP_CLIP_HPP

// Skeletons and clips, independent of the file format they came from, and what a reader hands back.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swivel::clip {

struct vec3 {
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const vec3&, const vec3&) = default;
};

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
    vec3 offset;
    std::string name;  // often empty

    friend bool operator==(const end_site&, const end_site&) = default;
};

struct joint {
    std::string name;
    std::int32_t parent = -1;  // index in skeleton::joints, always less than the joint's own; -1 for a root
    vec3 offset;               // from the parent, in the rest pose
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

struct clip {
    swivel::clip::skeleton skeleton;
    double frame_time = 0;       // seconds
    std::size_t frames = 0;      // 0: the rest pose alone
    std::vector<double> values;  // frames rows of skeleton.channel_count columns; positions as in the file,
                                 // rotations in degrees

    friend bool operator==(const clip&, const clip&) = default;
};

// A position in a text and what is the matter there. Lines and columns count from 1, columns in bytes; line 0
// means the file as a whole (it cannot be opened, it is too large). To be shown as
// `FILE:LINE:COLUMN: what, expected expected`.
struct diagnostic {
    std::size_t line = 0;
    std::size_t column = 0;
    std::string what;
    std::string expected;

    friend bool operator==(const diagnostic&, const diagnostic&) = default;
};

// What a reader returns: a clip, or the first error. Warnings may stand beside either.
struct read_result {
    std::optional<clip> value;
    diagnostic error;  // meaningful when there is no value
    std::vector<diagnostic> warnings;

    explicit operator bool() const noexcept { return value.has_value(); }
};

// Numbers the columns: sets every first_channel and channel_count from the joints' channel lists, in joint
// order. For whoever builds a skeleton by hand; readers have done it.
void number_channels(skeleton& s) noexcept;

// The index of the joint of that name (exact, case matters), or nothing. Linear in the joints.
[[nodiscard]] std::optional<std::size_t> find_joint(const skeleton& s, std::string_view name) noexcept;

// The local rotation of one joint in every frame, as unit quaternions (Hamilton, active: v' = q v q*).
//   The joint's rotation channels are composed left to right as written: q = q1 q2 q3, so that the last one
//   acts first on a vector. Position channels do not matter. One or two rotation channels work; a joint
//   without any gives the identity.
//   x, y, z, w: four arrays of c.frames elements; joint_index < c.skeleton.joints.size().
//   Angles are reduced modulo 720 degrees without rounding, so a large angle is as accurate as a small one
//   and the sign of q follows the angle: 360 degrees is -1, and a curve that turns on and on stays
//   continuous. Single rotations by multiples of 60 and 90 degrees have correctly rounded components
//   (multiples of 180 are exact). | |q| - 1 | < 1e-15, tested by ClipRotation.IsUnit.
void joint_rotations(const clip& c, std::size_t joint_index, double* x, double* y, double* z,
                     double* w) noexcept;

// How the direction of a bone was found.
enum class direction_rule : std::uint8_t {
    child,             // the offset of the only child
    mean_of_children,  // several children: the mean of their offsets
    end_site,          // no child: the offset of the joint's own End Site
    parent,            // neither: the direction of the parent
    none               // neither, and no parent has one: y
};

[[nodiscard]] std::string_view name(direction_rule r) noexcept;

struct bone_direction {
    vec3 direction;  // unit length, in the joint's own rest frame
    direction_rule rule = direction_rule::none;

    friend bool operator==(const bone_direction&, const bone_direction&) = default;
};

// The axis along the bone of every joint, in joint order: the first of the rules above that gives a
// direction.
//   Zero-length offsets: a child with offset (0, 0, 0) stands at the joint itself, so what that child points
//   at (its children, else its End Site) stands in its place. An End Site with offset (0, 0, 0) counts as
//   none. Lengths below 1e-290 count as zero. Children whose mean vanishes (1e-9 of the mean of their
//   lengths, or less) give no direction.
// Linear in the joints.
[[nodiscard]] std::vector<bone_direction> bone_directions(const skeleton& s);

}  // namespace swivel::clip

#endif  // SWIVEL_CLIP_CLIP_HPP
