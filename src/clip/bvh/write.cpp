#include "swivel/clip/write.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "swivel/clip/read.hpp"
#include "swivel/clip/text.hpp"

namespace swivel::clip {

namespace {

constexpr std::size_t deepest_indentation = 32;

bool is_finite(const vec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_expressible(std::string_view name) noexcept {
    if (!name.empty() && (is_blank(name.front()) || is_blank(name.back()))) return false;
    return std::none_of(name.begin(), name.end(),
                        [](char c) { return c == '{' || c == '}' || (is_control(c) && c != '\t'); });
}

std::string_view channel_name(channel c) noexcept {
    switch (c) {
        case channel::x_position:
            return "Xposition";
        case channel::y_position:
            return "Yposition";
        case channel::z_position:
            return "Zposition";
        case channel::x_rotation:
            return "Xrotation";
        case channel::y_rotation:
            return "Yrotation";
        case channel::z_rotation:
            break;
    }
    return "Zrotation";
}

template <class Number>
void append_number(std::string& text, Number number) {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

// The joints in the order in which a file nests them.
std::vector<std::size_t> depth_first(const std::vector<joint>& joints) {
    const std::size_t none = joints.size();
    std::vector<std::size_t> next_sibling(joints.size(), none);
    std::vector<std::size_t> first_child(joints.size(), none);
    std::size_t first_root = none;
    for (std::size_t j = joints.size(); j-- > 0;) {
        const std::int32_t parent = joints[j].parent;
        std::size_t& first = parent < 0 ? first_root : first_child[static_cast<std::size_t>(parent)];
        next_sibling[j] = first;
        first = j;
    }

    std::vector<std::size_t> order;
    order.reserve(joints.size());
    for (std::size_t j = first_root; j != none;) {
        order.push_back(j);
        if (first_child[j] != none) {
            j = first_child[j];
            continue;
        }
        while (next_sibling[j] == none && joints[j].parent >= 0)
            j = static_cast<std::size_t>(joints[j].parent);
        j = next_sibling[j];
    }
    return order;
}

class bvh_writer {
public:
    explicit bvh_writer(const clip& c) : clip_(c), order_(depth_first(c.skeleton.joints)) {}

    std::string write() {
        write_hierarchy();
        write_motion();
        return std::move(text_);
    }

private:
    void write_hierarchy();
    void write_joint(const joint& j);
    void write_motion();

    void begin_line() { text_.append(std::min(depth_, deepest_indentation), '\t'); }

    void write_line(std::string_view line) {
        begin_line();
        text_ += line;
        text_ += '\n';
    }

    void open_block() {
        write_line("{");
        ++depth_;
    }

    void close_block() {
        --depth_;
        write_line("}");
    }

    void write_offset(const vec3& offset) {
        begin_line();
        text_ += "OFFSET";
        for (const double component : {offset.x, offset.y, offset.z}) {
            text_ += ' ';
            append_number(text_, component);
        }
        text_ += '\n';
    }

    const clip& clip_;
    const std::vector<std::size_t> order_;
    std::size_t depth_ = 0;
    std::string text_;
};

void bvh_writer::write_hierarchy() {
    write_line("HIERARCHY");
    std::int32_t open = -1;
    const auto close_down_to = [&](std::int32_t ancestor) {
        for (; open != ancestor; open = clip_.skeleton.joints[static_cast<std::size_t>(open)].parent)
            close_block();
    };
    for (const std::size_t index : order_) {
        const joint& j = clip_.skeleton.joints[index];
        close_down_to(j.parent);
        write_joint(j);
        open = static_cast<std::int32_t>(index);
    }
    close_down_to(-1);
}

void bvh_writer::write_joint(const joint& j) {
    write_line((j.parent < 0 ? "ROOT " : "JOINT ") + j.name);
    open_block();
    write_offset(j.offset);

    begin_line();
    text_ += "CHANNELS ";
    append_number(text_, j.channels.size());
    for (const channel c : j.channels) {
        text_ += ' ';
        text_ += channel_name(c);
    }
    text_ += '\n';

    if (!j.end) return;
    write_line(j.end->name.empty() ? "End Site" : "End Site " + j.end->name);
    open_block();
    write_offset(j.end->offset);
    close_block();
}

void bvh_writer::write_motion() {
    text_ += "MOTION\nFrames: ";
    append_number(text_, clip_.frames);
    text_ += "\nFrame Time: ";
    append_number(text_, clip_.frame_time);
    text_ += '\n';
    if (clip_.skeleton.channel_count == 0) return;

    for (std::size_t frame = 0; frame < clip_.frames; ++frame) {
        const double* const row = clip_.values.data() + frame * clip_.skeleton.channel_count;
        for (const std::size_t index : order_) {
            const joint& j = clip_.skeleton.joints[index];
            for (std::size_t i = 0; i < j.channels.size(); ++i) {
                append_number(text_, row[j.first_channel + i]);
                text_ += ' ';
            }
        }
        text_.back() = '\n';
    }
}

std::string fault_of_joint(const skeleton& s, std::size_t index, std::size_t first_channel) {
    const joint& j = s.joints[index];
    const std::string subject = "joint " + std::to_string(index) + " " + quoted(j.name);
    if (j.parent < -1 || j.parent >= static_cast<std::int32_t>(index))
        return subject + " does not stand after its parent";
    if (j.name.empty() || !is_expressible(j.name)) return subject + " has a name that BVH cannot express";
    if (j.end && !is_expressible(j.end->name))
        return subject + " has an End Site with a name that BVH cannot express";
    if (!is_finite(j.offset) || (j.end && !is_finite(j.end->offset)))
        return subject + " has an offset that is not finite";
    if (j.first_channel != first_channel) return subject + " has columns out of order";
    return {};
}

}  // namespace

std::string bvh_fault(const clip& c) {
    const skeleton& s = c.skeleton;
    if (s.joints.empty()) return "the skeleton has no joint";
    if (s.joints.size() > bvh_max_joints)
        return "the skeleton has more than " + std::to_string(bvh_max_joints) + " joints";

    std::set<std::string_view> names;
    std::size_t columns = 0;
    for (std::size_t j = 0; j < s.joints.size(); ++j) {
        if (std::string fault = fault_of_joint(s, j, columns); !fault.empty()) return fault;
        if (!names.insert(s.joints[j].name).second)
            return "two joints have the name " + quoted(s.joints[j].name);
        columns += s.joints[j].channels.size();
    }
    if (s.channel_count != columns) return "the channel count is not the sum over the joints";
    if (!(c.frame_time > 0) || !std::isfinite(c.frame_time))
        return "the frame time is not positive and finite";
    if (c.frames > bvh_max_frames) return "there are more than " + std::to_string(bvh_max_frames) + " frames";
    if (c.values.size() != c.frames * columns) return "the number of values is not frames times channels";
    const auto bad =
        std::find_if_not(c.values.begin(), c.values.end(), [](double v) { return std::isfinite(v); });
    if (bad != c.values.end())
        return "a value in frame " +
               std::to_string(static_cast<std::size_t>(bad - c.values.begin()) / columns + 1) +
               " is not finite";
    return {};
}

std::string write_bvh(const clip& c) { return bvh_fault(c).empty() ? bvh_writer(c).write() : std::string(); }

}  // namespace swivel::clip
