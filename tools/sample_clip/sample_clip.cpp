#include "sample_clip.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace swivel::clip {

namespace {

constexpr double frames_per_second = 60;
constexpr std::size_t frame_count = 240;

// The value of a channel over time: base + amplitude * wave(frequency * seconds + phase).
struct curve {
    channel kind;
    double base = 0;
    double amplitude = 0;
    double frequency = 0;  // turns per second; multiples of 1/4 make the clip a loop
    double phase = 0;      // turns
};

struct animated_joint {
    std::string name;
    std::int32_t parent;
    vec3 offset;  // centimetres; x to the left of the figure, y up, z forward
    std::vector<curve> curves;
    std::optional<vec3> tip = std::nullopt;
};

// A sine by parabolas, within 0.002 of the real one: plain arithmetic gives the same values on every machine.
double wave(double turns) noexcept {
    const double u = turns - std::floor(turns);
    const double p = u < 0.5 ? 16 * u * (0.5 - u) : -16 * (u - 0.5) * (1 - u);
    return p + 0.225 * (p * std::fabs(p) - p);
}

double value_at(const curve& c, double seconds) noexcept {
    constexpr double steps = 10000;
    return std::round((c.base + c.amplitude * wave(c.frequency * seconds + c.phase)) * steps) / steps;
}

std::vector<animated_joint> animated_figure() {
    using enum channel;
    return {
        {"Hips",
         -1,
         {0, 95, 0},
         {{x_position, 0, 1.5, 1},
          {y_position, 95, 1.2, 2, 0.1},
          {z_position},
          {z_rotation, 0, 2.5, 1, 0.25},
          {x_rotation, 3, 1, 2},
          {y_rotation, 0, 6, 1}}},
        {"Spine",
         0,
         {0, 12, 0},
         {{z_rotation, 0, 2, 1, 0.75}, {x_rotation, 2, 1, 2}, {y_rotation, 0, 4, 1, 0.5}}},
        {"Chest",
         1,
         {0, 22, -1},
         {{x_rotation, 3, 1.5, 2, 0.2}, {y_rotation, 0, 5, 1, 0.5}, {z_rotation, -2, 1, 0.5}}},
        {"Neck",
         2,
         {0, 24, 1},
         {{y_rotation, 0, 18, 0.25}, {x_rotation, 5, 4, 0.5}, {z_rotation, 0, 3, 0.25, 0.25}}},
        {"Head",
         3,
         {0, 9, 1.5},
         {{y_rotation, 0, 32, 0.25, 0.95}, {z_rotation, 0, 5, 0.25, 0.3}, {x_rotation, -4, 8, 0.5, 0.1}},
         vec3{0, 18, 2}},

        {"LeftShoulder", 2, {3, 18, 1}, {{x_rotation}, {z_rotation, -4, 2, 1}, {y_rotation, 0, 3, 1, 0.5}}},
        {"LeftArm",
         5,
         {14, 0, 0},
         {{y_rotation, 0, 28, 1, 0.5}, {z_rotation, -72, 3, 1}, {x_rotation, 8, 6, 1, 0.5}}},
        {"LeftForeArm",
         6,
         {27, 0, 0},
         {{z_rotation, 0, 2, 1}, {y_rotation, -22, 14, 1, 0.45}, {x_rotation, 20, 12, 1, 0.5}}},
        {"LeftHand",
         7,
         {25, 0, 0},
         {{x_rotation, 5, 4, 1, 0.4}, {y_rotation, -6, 5, 1, 0.4}, {z_rotation, -4, 6, 1, 0.35}},
         vec3{17, 0, 0}},

        {"RightShoulder", 2, {-3, 18, 1}, {{x_rotation}, {z_rotation, -9, 2, 0.5}, {y_rotation, 3, 2, 1}}},
        {"RightArm",
         9,
         {-14, 0, 0},
         {{z_rotation, -24, 5, 0.5, 0.1}, {x_rotation, -35, 10, 0.5}, {y_rotation, 18, 6, 0.5, 0.3}}},
        {"RightForeArm",
         10,
         {-27, 0, 0},
         {{y_rotation, 15, 6, 1.5, 0.2}, {z_rotation, -62, 24, 1.5}, {x_rotation, -12, 58, 0.75, 0.1}}},
        {"RightHand",
         11,
         {-25, 0, 0},
         {{z_rotation, 4, 22, 1.5, 0.85}, {y_rotation, 0, 10, 0.75}, {x_rotation, 6, 26, 0.75, 0.05}},
         vec3{-17, 0, 0}},

        {"LeftUpLeg",
         0,
         {9, -5, 0},
         {{x_rotation, -6, 26, 1}, {y_rotation, 4, 3, 1}, {z_rotation, 2, 2, 1, 0.25}}},
        {"LeftLeg", 13, {0, -42, 0}, {{x_rotation, 30, 27, 1, 0.88}, {z_rotation}, {y_rotation, 0, 2, 1}}},
        {"LeftFoot",
         14,
         {0, -41, 0},
         {{x_rotation, -8, 14, 1, 0.6}, {y_rotation, 8, 2, 1}, {z_rotation, 0, 3, 1}}},
        {"LeftToes", 15, {0, -6, 13}, {{x_rotation, -9, 11, 1, 0.3}}, vec3{0, 0, 7}},

        {"RightUpLeg",
         0,
         {-9, -5, 0},
         {{x_rotation, -6, 26, 1, 0.5}, {y_rotation, -4, 3, 1, 0.5}, {z_rotation, -2, 2, 1, 0.25}}},
        {"RightLeg",
         17,
         {0, -42, 0},
         {{x_rotation, 30, 27, 1, 0.38}, {z_rotation}, {y_rotation, 0, 2, 1, 0.5}}},
        {"RightFoot",
         18,
         {0, -41, 0},
         {{x_rotation, -8, 14, 1, 0.1}, {y_rotation, -8, 2, 1}, {z_rotation, 0, 3, 1, 0.5}}},
        {"RightToes", 19, {0, -6, 13}, {{x_rotation, -9, 11, 1, 0.8}}, vec3{0, 0, 7}},
    };
}

}  // namespace

clip make_sample_clip() {
    const std::vector<animated_joint> figure = animated_figure();
    clip c;
    for (const animated_joint& part : figure) {
        joint j;
        j.name = part.name;
        j.parent = part.parent;
        j.offset = part.offset;
        for (const curve& k : part.curves) j.channels.add(k.kind);
        if (part.tip) j.end = end_site{*part.tip, {}};
        c.skeleton.joints.push_back(std::move(j));
    }
    number_channels(c.skeleton);

    c.frame_time = 1 / frames_per_second;
    c.frames = frame_count;
    c.values.reserve(frame_count * c.skeleton.channel_count);
    for (std::size_t frame = 0; frame < frame_count; ++frame)
        for (const animated_joint& part : figure)
            for (const curve& k : part.curves)
                c.values.push_back(value_at(k, static_cast<double>(frame) / frames_per_second));
    return c;
}

}  // namespace swivel::clip
