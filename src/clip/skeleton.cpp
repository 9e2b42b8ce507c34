#include "swivel/clip/skeleton.hpp"

#include <algorithm>
#include <cmath>

namespace swivel::clip {

bool channel_list::add(channel c) noexcept {
    if (contains(c)) return false;
    order_[count_++] = c;
    return true;
}

bool channel_list::contains(channel c) const noexcept { return std::find(begin(), end(), c) != end(); }

void number_channels(skeleton& s) noexcept {
    s.channel_count = 0;
    for (joint& j : s.joints) {
        j.first_channel = s.channel_count;
        s.channel_count += j.channels.size();
    }
}

std::optional<std::size_t> find_joint(const skeleton& s, std::string_view name) noexcept {
    for (std::size_t j = 0; j < s.joints.size(); ++j)
        if (s.joints[j].name == name) return j;
    return std::nullopt;
}

std::string_view name(direction_rule r) noexcept {
    switch (r) {
        case direction_rule::child:
            return "child";
        case direction_rule::mean_of_children:
            return "mean of children";
        case direction_rule::end_site:
            return "end site";
        case direction_rule::parent:
            return "parent";
        case direction_rule::none:
            break;
    }
    return "none";
}

namespace {

// Offsets are summed on a smaller scale: the sum of a million of the largest doubles stays finite.
constexpr double sum_scale = 0x1p-30;
constexpr double shortest_offset = 1e-290;
constexpr double shortest_mean = 1e-9;

double length(const vec3& v) noexcept { return std::hypot(v.x, v.y, v.z); }

struct offset_sum {
    vec3 sum{};
    double lengths = 0;
    std::size_t count = 0;

    void add(const vec3& v, double length_of_v, std::size_t count_of_v) noexcept {
        sum.x += v.x;
        sum.y += v.y;
        sum.z += v.z;
        lengths += length_of_v;
        count += count_of_v;
    }

    void add(const vec3& offset) noexcept {
        if (length(offset) < shortest_offset) return;
        const vec3 v{offset.x * sum_scale, offset.y * sum_scale, offset.z * sum_scale};
        add(v, length(v), 1);
    }

    void add(const offset_sum& other) noexcept { add(other.sum, other.lengths, other.count); }

    [[nodiscard]] std::optional<vec3> direction() const noexcept {
        const double l = length(sum);
        if (count == 0 || l <= shortest_mean * lengths) return std::nullopt;
        return vec3{sum.x / l, sum.y / l, sum.z / l};
    }
};

offset_sum end_site_of(const joint& j) noexcept {
    offset_sum end;
    if (j.end) end.add(j.end->offset);
    return end;
}

}  // namespace

std::vector<bone_direction> bone_directions(const skeleton& s) {
    const std::size_t n = s.joints.size();
    std::vector<offset_sum> children(n);
    for (std::size_t i = n; i-- > 0;) {
        const joint& j = s.joints[i];
        if (j.parent < 0) continue;
        offset_sum& siblings = children[static_cast<std::size_t>(j.parent)];
        if (length(j.offset) >= shortest_offset)
            siblings.add(j.offset);
        else
            siblings.add(children[i].count > 0 ? children[i] : end_site_of(j));
    }

    std::vector<bone_direction> directions(n);
    for (std::size_t i = 0; i < n; ++i) {
        const joint& j = s.joints[i];
        if (const auto to_children = children[i].direction())
            directions[i] = {*to_children, children[i].count == 1 ? direction_rule::child
                                                                  : direction_rule::mean_of_children};
        else if (const auto to_end = end_site_of(j).direction())
            directions[i] = {*to_end, direction_rule::end_site};
        else if (j.parent < 0)
            directions[i] = {{0, 1, 0}, direction_rule::none};
        else if (const bone_direction& up = directions[static_cast<std::size_t>(j.parent)];
                 up.rule == direction_rule::none)
            directions[i] = up;
        else
            directions[i] = {up.direction, direction_rule::parent};
    }
    return directions;
}

}  // namespace swivel::clip
