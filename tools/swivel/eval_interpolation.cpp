#include <cmath>

#include "eval_operation.hpp"
#include "failure.hpp"

namespace swivel::command {

void add_t(command_line line, eval_settings& settings) {
    add_parameter(
        line, "--t", settings.t,
        "How far from a to b, 0 to 1 and beyond; column: one for every row, in the column t (default: 0.5)");
}

void add_t_and_way(command_line line, eval_settings& settings) {
    add_t(line, settings);
    line.add_choice("--way", settings.options.long_way, {{"short", false}, {"long", true}},
                    "By way of the nearer or the further of b and -b");
}

namespace {

// The groups of columns in the order in which they are asked for.
struct interpolation_groups {
    std::size_t axis = 0, t = 0, twist = 0;
    std::vector<column_group> in = {{group_kind::quaternion, "a"}, {group_kind::quaternion, "b"}};

    explicit interpolation_groups(const eval_settings& settings) {
        if (std::holds_alternative<axis_columns>(settings.axis)) {
            axis = in.size();
            in.push_back({group_kind::vector, "n"});
        }
        if (std::holds_alternative<parameter_column>(settings.t)) {
            t = twist = in.size();
            in.push_back({group_kind::scalar, "t"});
        }
        if (settings.twist_t && std::holds_alternative<parameter_column>(*settings.twist_t)) {
            twist = in.size();
            in.push_back({group_kind::scalar, "t_twist"});
        }
    }
};

void add_rotation_options(command_line line, eval_settings& settings) {
    add_t_and_way(line, settings);
    add_axis(line, settings.axis, axis_words::columns,
             "Axis, a vector of any length but 0; columns: one for every row, in nx ny nz (default: z)");
    line.add_choice(
        "--frame", settings.options.axis_frame,
        {{"world", swivel::frame::world}, {"body", swivel::frame::body}},
        "Where the axis is given: in the world, as it lies at a, or in the body that a and b turn");
    line.add_flag("--tip", settings.tip,
                  "Write px py pz too, where the axis points to on its way, and off, its angle in radians "
                  "from the great circle between its ends");
}

void add_sterp_options(command_line line, eval_settings& settings) {
    add_rotation_options(line, settings);
    settings.reads_axis = true;
    line.add_value(
        "--t-twist", "NUMBER|column",
        [&settings](const std::string& given) { settings.twist_t = parse_parameter("--t-twist", given); },
        "How far for the twist, where it is not as far as the swing; column: in the column t_twist "
        "(default: as --t)");
    line.add_choice("--motion", settings.options.motion,
                    {{"slerp", swivel::flavour::slerp}, {"nlerp", swivel::flavour::nlerp}},
                    "Swing and twist at constant speed, or along their chords");
    add_pole_threshold(line, settings.options.pole_threshold);
}

eval_columns columns(const eval_settings& settings) {
    eval_columns c{interpolation_groups(settings).in, {{group_kind::quaternion, "q"}}};
    if (settings.tip) {
        c.out.push_back({group_kind::vector, "p"});
        c.out.push_back({group_kind::scalar, "off"});
    } else if (std::holds_alternative<axis_columns>(settings.axis) && !settings.reads_axis) {
        throw bad_usage("--axis columns is read for --tip only");
    }
    return c;
}

using vector = swivel::vec3<double>;

vector cross(const vector& a, const vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const vector& a, const vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(const vector& a) { return std::hypot(a.x, a.y, a.z); }

// q v q*
vector turned(const swivel::quat<double>& q, const vector& v) {
    const vector u{q.x, q.y, q.z}, once = cross(u, v), twice = cross(u, once);
    return {v.x + 2 * (q.w * once.x + twice.x), v.y + 2 * (q.w * once.y + twice.y),
            v.z + 2 * (q.w * once.z + twice.z)};
}

template <class T>
swivel::quat<double> unit_at(const swivel::quat_view<T>& v, std::size_t row) {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(row) * v.stride;
    const double x = v.x[i], y = v.y[i], z = v.z[i], w = v.w[i], n = std::hypot(std::hypot(x, y, z), w);
    return {x / n, y / n, z / n, w / n};
}

template <class T>
vector axis_at(const swivel::twist_axis<T>& axis, std::size_t row) {
    vector v{0, 0, 0};
    switch (axis.kind) {
        case swivel::twist_axis<T>::form::coordinate:
            (axis.coordinate == swivel::axis::x ? v.x : axis.coordinate == swivel::axis::y ? v.y : v.z) = 1;
            break;
        case swivel::twist_axis<T>::form::uniform:
            v = {axis.uniform.x, axis.uniform.y, axis.uniform.z};
            break;
        case swivel::twist_axis<T>::form::per_element: {
            const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(row) * axis.per_element.stride;
            v = {axis.per_element.x[i], axis.per_element.y[i], axis.per_element.z[i]};
            break;
        }
    }
    const double n = length(v);
    return {v.x / n, v.y / n, v.z / n};
}

// Where the axis points to, and how far that is from the great circle between where it points to at a and at
// b; 0 where these two make no circle.
template <class T>
void write_tips(const eval_settings& settings, const swivel::twist_axis<T>& axis, const eval_block<T>& in,
                const eval_block<T>& out) {
    const swivel::vec3_view<T> tip = out.vector(1);
    const swivel::scalar_view<T> off = out.scalar(2);
    for (std::size_t row = 0; row < out.size(); ++row) {
        const swivel::quat<double> a = unit_at(in.quaternion(0), row);
        vector body = axis_at(axis, row);
        if (settings.options.axis_frame == swivel::frame::world) body = turned({-a.x, -a.y, -a.z, a.w}, body);
        const vector p = turned(unit_at(out.quaternion(0), row), body);
        const vector normal = cross(turned(a, body), turned(unit_at(in.quaternion(1), row), body));
        const double n = length(normal), height = n > 0 ? dot(p, normal) / n : 0 * (dot(p, p) + n);
        const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(row) * tip.stride;
        tip.x[i] = static_cast<T>(p.x);
        tip.y[i] = static_cast<T>(p.y);
        tip.z[i] = static_cast<T>(p.z);
        off.data[row] = static_cast<T>(std::atan2(height, std::sqrt(std::fmax(0, 1 - height * height))));
    }
}

// The axis, or where it is in columns the vectors of the group.
template <class T>
swivel::twist_axis<T> axis_of_group(const eval_settings& settings, const eval_block<T>& in,
                                    std::size_t group) {
    if (std::holds_alternative<axis_columns>(settings.axis)) return in.vector(group);
    return axis_of_rows(settings, in);
}

// interpolate(a, b, axis, t of swing, t of twist, q)
template <class T, class Interpolate>
swivel::status run(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out,
                   const Interpolate& interpolate) {
    const interpolation_groups groups(settings);
    const swivel::twist_axis<T> axis = axis_of_group(settings, in, groups.axis);
    const swivel::parameter<T> t = parameter_of_rows(settings.t, in, groups.t);
    const swivel::parameter<T> twist =
        settings.twist_t ? parameter_of_rows(*settings.twist_t, in, groups.twist) : t;
    const swivel::status s =
        interpolate(swivel::quat_view<const T>(in.quaternion(0)),
                    swivel::quat_view<const T>(in.quaternion(1)), axis, t, twist, out.quaternion(0));
    if (s == swivel::status::ok && settings.tip) write_tips(settings, axis, in, out);
    return s;
}

template <class T>
swivel::status run_slerp(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return run(settings, in, out, [&](auto a, auto b, const auto&, const auto& t, const auto&, auto q) {
        return swivel::slerp(a, b, t, q, settings.options);
    });
}

template <class T>
swivel::status run_nlerp(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return run(settings, in, out, [&](auto a, auto b, const auto&, const auto& t, const auto&, auto q) {
        return swivel::nlerp(a, b, t, q, settings.options);
    });
}

template <class T>
swivel::status run_sterp(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return run(settings, in, out,
               [&](auto a, auto b, const auto& axis, const auto& t, const auto& twist, auto q) {
                   return swivel::sterp(a, b, axis, t, twist, q, settings.options);
               });
}

}  // namespace

constinit const eval_operation eval_slerp = {
    "slerp",
    "Between two rotations at constant speed",
    "Reads ax ay az aw bx by bz bw, and t with --t column. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'ax ay az aw bx by bz bw\\n0 0 0 1 0 0 1 1\\n' | swivel eval slerp --t 0.25\n"
    "  swivel eval slerp --t column --way long pairs.csv",
    add_rotation_options,
    columns,
    run_slerp<float>,
    run_slerp<double>};

constinit const eval_operation eval_nlerp = {
    "nlerp",
    "Between two rotations along the chord",
    "Reads ax ay az aw bx by bz bw, and t with --t column. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'ax ay az aw bx by bz bw\\n0 0 0 1 0 0 1 1\\n' | swivel eval nlerp --t 0.25",
    add_rotation_options,
    columns,
    run_nlerp<float>,
    run_nlerp<double>};

constinit const eval_operation eval_sterp = {
    "sterp",
    "Between two rotations, the axis by the shortest way and the twist about it",
    "Reads ax ay az aw bx by bz bw, with --axis columns nx ny nz, t with --t column, t_twist with --t-twist\n"
    "column.\n"
    "Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'ax ay az aw bx by bz bw t\\n0 0 0 1 0.5 0.5 0.5 0.5 0.25\\n' | swivel eval sterp --axis x "
    "--t column\n"
    "  swivel eval sterp --axis 0,0,1 --frame body --t 0.5 --tip pairs.csv",
    add_sterp_options,
    columns,
    run_sterp<float>,
    run_sterp<double>};

}  // namespace swivel::command
