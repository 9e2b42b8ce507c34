#include "swivel/clip/clip.hpp"

#include <cmath>

namespace swivel::clip {

namespace {

using quaternion = quat<double>;

quaternion product(const quaternion& a, const quaternion& b) noexcept {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

struct sine_cosine {
    double sine, cosine;
};

constexpr double sqrt_half = 0.70710678118654752440;
constexpr double sqrt_three_quarters = 0.86602540378443864676;
constexpr double radians_per_degree = 0.017453292519943295769;

// Half the angle of a rotation. Both reductions are exact, and the angles that people type (multiples of 60
// and 90 degrees) do not pass through a rounded pi.
sine_cosine half_angle(double degrees) noexcept {
    const double half = std::fmod(degrees, 720.0) / 2;  // in (-360, 360)
    const double quarters = std::round(half / 90.0);    // -4..4
    const double rest = half - 90.0 * quarters;         // in [-45, 45]
    const double size = std::fabs(rest);
    double s = std::sin(rest * radians_per_degree);
    double c = std::cos(rest * radians_per_degree);
    if (size == 45.0) {
        s = std::copysign(sqrt_half, rest);
        c = sqrt_half;
    } else if (size == 30.0) {
        s = std::copysign(0.5, rest);
        c = sqrt_three_quarters;
    }
    switch ((static_cast<int>(quarters) + 4) % 4) {
        case 1:
            return {c, 0.0 - s};
        case 2:
            return {0.0 - s, -c};
        case 3:
            return {-c, s};
        default:
            return {s, c};
    }
}

quaternion rotation_about(channel axis, double degrees) noexcept {
    const sine_cosine h = half_angle(degrees);
    switch (axis) {
        case channel::x_rotation:
            return {h.sine, 0, 0, h.cosine};
        case channel::y_rotation:
            return {0, h.sine, 0, h.cosine};
        default:
            return {0, 0, h.sine, h.cosine};
    }
}

}  // namespace

status joint_rotations(const clip& c, std::size_t joint_index, const quat_view<double>& out) noexcept {
    const std::size_t width = c.skeleton.channel_count;
    if (joint_index >= c.skeleton.joints.size()) return status::bad_argument;
    const joint& j = c.skeleton.joints[joint_index];
    if (j.first_channel > width || j.channels.size() > width - j.first_channel) return status::bad_argument;
    if (out.size != c.frames) return status::size_mismatch;
    if (width > 0 && (c.values.size() % width != 0 || c.values.size() / width != c.frames))
        return status::size_mismatch;
    if (c.frames == 0) return status::ok;
    if (!out.x || !out.y || !out.z || !out.w) return status::null_stream;
    if (out.stride == 0) return status::bad_argument;

    for (std::size_t frame = 0; frame < c.frames; ++frame) {
        const double* value = c.values.data() + frame * width + j.first_channel;
        quaternion q{0, 0, 0, 1};
        bool first = true;
        for (const channel kind : j.channels) {
            if (is_rotation(kind)) {
                const quaternion r = rotation_about(kind, *value);
                q = first ? r : product(q, r);
                first = false;
            }
            ++value;
        }
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(frame) * out.stride;
        out.x[at] = q.x;
        out.y[at] = q.y;
        out.z[at] = q.z;
        out.w[at] = q.w;
    }
    return status::ok;
}

}  // namespace swivel::clip
