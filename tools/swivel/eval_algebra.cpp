#include <cmath>
#include <vector>

#include "eval_operation.hpp"

namespace swivel::command {

namespace {

eval_columns rotation_to_rotation(const eval_settings&) {
    return {{{group_kind::quaternion, "q"}}, {{group_kind::quaternion, "q"}}};
}

template <class T>
swivel::status run_multiply(const eval_settings& settings, const eval_block<T>& in,
                            const eval_block<T>& out) {
    return swivel::multiply(in.quaternion(0), in.quaternion(1), out.quaternion(0), settings.options);
}

template <class T>
swivel::status run_conjugate(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::conjugate(in.quaternion(0), out.quaternion(0), settings.options);
}

template <class T>
swivel::status run_normalize(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::normalize(in.quaternion(0), out.quaternion(0), settings.options);
}

template <class T>
swivel::status run_rotate(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::rotate(swivel::quat_view<const T>(in.quaternion(0)), in.vector(1), out.vector(0),
                          settings.options);
}

template <class T>
swivel::status run_dot(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::dot(in.quaternion(0), in.quaternion(1), out.scalar(0), settings.options);
}

void add_align_signs_options(command_line line, eval_settings& settings) {
    line.add_flag("--sequence", settings.sequence,
                  "Compare each row with the one before it as it was written");
}

// With the last finite row of the block before in front, and with a zero quaternion, which turns nothing
// over, where there is none.
template <class T>
swivel::status align_sequence(const eval_settings& settings, const eval_block<T>& in,
                              const eval_block<T>& out) {
    const swivel::quat_view<T> from = in.quaternion(0), to = out.quaternion(0);
    swivel::quat<double>& last = settings.last_of_sequence;
    std::vector<swivel::quat<T>> rows(from.size + 1);
    rows[0] = {static_cast<T>(last.x), static_cast<T>(last.y), static_cast<T>(last.z),
               static_cast<T>(last.w)};
    const auto at = [](std::size_t row, std::ptrdiff_t stride) {
        return static_cast<std::ptrdiff_t>(row) * stride;
    };
    for (std::size_t i = 0; i < from.size; ++i) {
        const std::ptrdiff_t k = at(i, from.stride);
        rows[i + 1] = {from.x[k], from.y[k], from.z[k], from.w[k]};
    }
    const auto view = swivel::aos_xyzw(&rows[0].x, rows.size());
    if (const swivel::status s = swivel::align_signs(view, view, settings.options); s != swivel::status::ok)
        return s;
    for (std::size_t i = 0; i < to.size; ++i) {
        const std::ptrdiff_t k = at(i, to.stride);
        const swivel::quat<T>& q = rows[i + 1];
        to.x[k] = q.x, to.y[k] = q.y, to.z[k] = q.z, to.w[k] = q.w;
        if (std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w))
            last = {q.x, q.y, q.z, q.w};
    }
    return swivel::status::ok;
}

template <class T>
swivel::status run_align_signs(const eval_settings& settings, const eval_block<T>& in,
                               const eval_block<T>& out) {
    if (settings.sequence) return align_sequence(settings, in, out);
    return swivel::align_signs(in.quaternion(0), in.quaternion(1), out.quaternion(0), settings.options);
}

}  // namespace

constinit const eval_operation eval_multiply = {
    "multiply",
    "Products of quaternions",
    "Reads ax ay az aw bx by bz bw. Writes qx qy qz qw, the product a b: the rotation b first, then a.\n\n"
    "Examples:\n"
    "  printf 'ax ay az aw bx by bz bw\\n1 0 0 0 0 1 0 0\\n' | swivel eval multiply",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "a"}, {group_kind::quaternion, "b"}},
                            {{group_kind::quaternion, "q"}}};
    },
    run_multiply<float>,
    run_multiply<double>};

constinit const eval_operation eval_conjugate = {
    "conjugate",
    "Quaternions with the opposite vector part, the inverse of unit ones",
    "Reads qx qy qz qw. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval conjugate",
    add_no_options,
    rotation_to_rotation,
    run_conjugate<float>,
    run_conjugate<double>};

constinit const eval_operation eval_normalize = {
    "normalize",
    "Quaternions of length 1",
    "Reads qx qy qz qw, of any length. Writes qx qy qz qw; 0 0 0 1 for a zero quaternion.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 3 4\\n' | swivel eval normalize",
    add_no_options,
    rotation_to_rotation,
    run_normalize<float>,
    run_normalize<double>};

constinit const eval_operation eval_rotate = {
    "rotate",
    "Vectors turned by rotations",
    "Reads qx qy qz qw, of length 1, and vx vy vz. Writes rx ry rz.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw vx vy vz\\n0 0 1 0 1 2 3\\n' | swivel eval rotate",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}, {group_kind::vector, "v"}},
                            {{group_kind::vector, "r"}}};
    },
    run_rotate<float>,
    run_rotate<double>};

constinit const eval_operation eval_dot = {
    "dot",
    "Scalar products of quaternions",
    "Reads ax ay az aw bx by bz bw. Writes dot.\n\n"
    "Examples:\n"
    "  printf 'ax ay az aw bx by bz bw\\n0 0 0 1 0 0 .6 .8\\n' | swivel eval dot",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "a"}, {group_kind::quaternion, "b"}},
                            {{group_kind::scalar, "dot"}}};
    },
    run_dot<float>,
    run_dot<double>};

constinit const eval_operation eval_align_signs = {
    "align_signs",
    "Of q and -q, the same rotation, the one on the side of its neighbour",
    "Reads qx qy qz qw and the neighbour nx ny nz nw; with --sequence qx qy qz qw alone, the neighbour\n"
    "being the row before. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n0 0 -0.6 -0.8\\n' | swivel eval align_signs --sequence",
    add_align_signs_options,
    [](const eval_settings& settings) {
        eval_columns c{{{group_kind::quaternion, "q"}}, {{group_kind::quaternion, "q"}}};
        if (!settings.sequence) c.in.push_back({group_kind::quaternion, "n"});
        return c;
    },
    run_align_signs<float>,
    run_align_signs<double>};

}  // namespace swivel::command
