#include <cmath>

#include "operations/describe.hpp"

namespace swivel::operations {

namespace {

// Where the groups are that not all settings have.
struct places {
    std::size_t axis = 2, t, twist;

    explicit places(const settings& s)
        : t(axis + is_column(s.axis)), twist(s.t_twist ? t + is_column(s.t) : t) {}
};

groups with_tip(const settings& s) {
    groups g{{quaternion("a"), quaternion("b")}, {quaternion("q")}};
    if (is_column(s.axis)) g.in.push_back(vector("n", meaning::axis));
    if (is_column(s.t)) g.in.push_back(scalar("t"));
    if (s.t_twist && is_column(*s.t_twist)) g.in.push_back(scalar("t_twist"));
    if (s.tip) {
        g.out.push_back(vector("p"));
        g.out.push_back(scalar("off", meaning::angle));
    }
    return g;
}

groups without_axis(const settings& s) {
    groups g = with_tip(s);
    if (is_column(s.axis) && !s.tip) g.fault = "--axis columns is read for --tip only";
    return g;
}

using direction = vec3<double>;

direction cross(const direction& a, const direction& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const direction& a, const direction& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(const direction& a) { return std::hypot(a.x, a.y, a.z); }

// q v q*
direction turned(const quat<double>& q, const direction& v) {
    const direction u{q.x, q.y, q.z}, once = cross(u, v), twice = cross(u, once);
    return {v.x + 2 * (q.w * once.x + twice.x), v.y + 2 * (q.w * once.y + twice.y),
            v.z + 2 * (q.w * once.z + twice.z)};
}

template <class T>
quat<double> unit_at(const quat_view<T>& v, std::size_t element) {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(element) * v.stride;
    const double x = v.x[i], y = v.y[i], z = v.z[i], w = v.w[i], n = std::hypot(std::hypot(x, y, z), w);
    return {x / n, y / n, z / n, w / n};
}

template <class T>
direction axis_at(const twist_axis<T>& axis, std::size_t element) {
    direction v{0, 0, 0};
    switch (axis.kind) {
        case twist_axis<T>::form::coordinate:
            (axis.coordinate == axis::x ? v.x : axis.coordinate == axis::y ? v.y : v.z) = 1;
            break;
        case twist_axis<T>::form::uniform:
            v = {axis.uniform.x, axis.uniform.y, axis.uniform.z};
            break;
        case twist_axis<T>::form::per_element: {
            const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(element) * axis.per_element.stride;
            v = {axis.per_element.x[i], axis.per_element.y[i], axis.per_element.z[i]};
            break;
        }
    }
    const double n = length(v);
    return {v.x / n, v.y / n, v.z / n};
}

// Where the axis points to, and how far that is from the great circle between where it points to at a and at b; 0
// where these two make no circle.
template <class T>
void write_tips(const settings& s, const twist_axis<T>& axis, const block<const T>& in, const block<T>& out) {
    const vec3_view<T> tip = out.vector(1);
    const scalar_view<T> off = out.scalar(2);
    for (std::size_t element = 0; element < out.size(); ++element) {
        const quat<double> a = unit_at(in.quaternion(0), element);
        direction body = axis_at(axis, element);
        if (s.options.axis_frame == frame::world) body = turned({-a.x, -a.y, -a.z, a.w}, body);
        const direction p = turned(unit_at(out.quaternion(0), element), body);
        const direction normal = cross(turned(a, body), turned(unit_at(in.quaternion(1), element), body));
        const double n = length(normal), height = n > 0 ? dot(p, normal) / n : 0 * (dot(p, p) + n);
        const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(element);
        tip.x[i * tip.stride] = static_cast<T>(p.x);
        tip.y[i * tip.stride] = static_cast<T>(p.y);
        tip.z[i * tip.stride] = static_cast<T>(p.z);
        off.data[i * off.stride] =
            static_cast<T>(std::atan2(height, std::sqrt(std::fmax(0, 1 - height * height))));
    }
}

// interpolate(a, b, axis, t of swing, t of twist, q)
template <class T, class Interpolate>
status with_tips(const settings& s, const block<const T>& in, const block<T>& out,
                 const Interpolate& interpolate) {
    const places at(s);
    const twist_axis<T> axis = axis_of(s, in, at.axis);
    const parameter<T> t = parameter_of(s.t, in, at.t);
    const parameter<T> twist = s.t_twist ? parameter_of(*s.t_twist, in, at.twist) : t;
    const status result = interpolate(in.quaternion(0), in.quaternion(1), axis, t, twist, out.quaternion(0));
    if (result == status::ok && s.tip) write_tips(s, axis, in, out);
    return result;
}

}  // namespace

std::span<const operation> interpolation() {
    static const operation all[] = {
        describe(
            "slerp", "Between two rotations at constant speed",
            "Reads ax ay az aw bx by bz bw, and t with --t column. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw bx by bz bw\\n0 0 0 1 0 0 1 1\\n' | swivel eval slerp --t 0.25\n"
            "  swivel eval slerp --t column --way long pairs.csv",
            {option::t, option::way, option::tip_about}, without_axis,
            [](const auto&... a) { return swivel::slerp(a...); },
            [](const auto&... a) { return reference::slerp(a...); },
            [](auto slerp, const settings& s, const auto& in, const auto& out) {
                return with_tips(s, in, out,
                                 [&](const auto& a, const auto& b, const auto&, const auto& t, const auto&,
                                     const auto& q) { return slerp(a, b, t, q, s.options); });
            }),
        describe(
            "nlerp", "Between two rotations along the chord",
            "Reads ax ay az aw bx by bz bw, and t with --t column. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw bx by bz bw\\n0 0 0 1 0 0 1 1\\n' | swivel eval nlerp --t 0.25",
            {option::t, option::way, option::tip_about}, without_axis,
            [](const auto&... a) { return swivel::nlerp(a...); },
            [](const auto&... a) { return reference::nlerp(a...); },
            [](auto nlerp, const settings& s, const auto& in, const auto& out) {
                return with_tips(s, in, out,
                                 [&](const auto& a, const auto& b, const auto&, const auto& t, const auto&,
                                     const auto& q) { return nlerp(a, b, t, q, s.options); });
            }),
        describe(
            "sterp", "Between two rotations, the axis by the shortest way and the twist about it",
            "Reads ax ay az aw bx by bz bw, with --axis columns nx ny nz, t with --t column, t_twist with "
            "--t-twist\n"
            "column.\n"
            "Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw bx by bz bw t\\n0 0 0 1 0.5 0.5 0.5 0.5 0.25\\n' | swivel eval sterp "
            "--axis x "
            "--t column\n"
            "  swivel eval sterp --axis 0,0,1 --frame body --t 0.5 --tip pairs.csv",
            {option::t, option::way, option::axis_of_ends, option::frame, option::tip, option::t_twist,
             option::motion, option::pole_threshold},
            with_tip, [](const auto&... a) { return swivel::sterp(a...); },
            [](const auto&... a) { return reference::sterp(a...); },
            [](auto sterp, const settings& s, const auto& in, const auto& out) {
                return with_tips(
                    s, in, out,
                    [&](const auto& a, const auto& b, const auto& axis, const auto& t, const auto& twist,
                        const auto& q) { return sterp(a, b, axis, t, twist, q, s.options); });
            }),
    };
    return all;
}

}  // namespace swivel::operations
