#include <cmath>

#include "operations/describe.hpp"

namespace swivel::operations {

namespace {

// With the last finite element of the block before in front, and with a zero quaternion, which turns nothing over,
// where there is none.
template <class Function, class T>
status align_sequence(Function align_signs, const settings& s, const block<const T>& in,
                      const block<T>& out) {
    const quat_view<const T> from = in.quaternion(0);
    const quat_view<T> to = out.quaternion(0);
    quat<double>& last = s.last_of_sequence;
    std::vector<quat<T>> elements(from.size + 1);
    elements[0] = {static_cast<T>(last.x), static_cast<T>(last.y), static_cast<T>(last.z),
                   static_cast<T>(last.w)};
    for (std::size_t i = 0; i < from.size; ++i) {
        const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) * from.stride;
        elements[i + 1] = {from.x[k], from.y[k], from.z[k], from.w[k]};
    }
    const auto view = aos_xyzw(&elements[0].x, elements.size());
    if (const status result = align_signs(view, view, s.options); result != status::ok) return result;
    for (std::size_t i = 0; i < to.size; ++i) {
        const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) * to.stride;
        const quat<T>& q = elements[i + 1];
        to.x[k] = q.x, to.y[k] = q.y, to.z[k] = q.z, to.w[k] = q.w;
        if (std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w))
            last = {q.x, q.y, q.z, q.w};
    }
    return status::ok;
}

groups one_to_one(const settings&) { return {{quaternion("q")}, {quaternion("q")}}; }

}  // namespace

std::span<const operation> rotors() {
    static const operation all[] = {
        describe(
            "multiply", "Products of quaternions",
            "Reads ax ay az aw bx by bz bw. Writes qx qy qz qw, the product a b: the rotation b first, then "
            "a.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw bx by bz bw\\n1 0 0 0 0 1 0 0\\n' | swivel eval multiply",
            {},
            [](const settings&) {
                return groups{{quaternion("a"), quaternion("b")}, {quaternion("q")}};
            },
            [](const auto&... a) { return swivel::multiply(a...); },
            [](const auto&... a) { return reference::multiply(a...); },
            [](auto multiply, const settings& s, const auto& in, const auto& out) {
                return multiply(in.quaternion(0), in.quaternion(1), out.quaternion(0), s.options);
            }),
        describe(
            "conjugate", "Quaternions with the opposite vector part, the inverse of unit ones",
            "Reads qx qy qz qw. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval conjugate",
            {}, one_to_one, [](const auto&... a) { return swivel::conjugate(a...); },
            [](const auto&... a) { return reference::conjugate(a...); },
            [](auto conjugate, const settings& s, const auto& in, const auto& out) {
                return conjugate(in.quaternion(0), out.quaternion(0), s.options);
            })
            .that_moves(),
        describe(
            "normalize", "Quaternions of length 1",
            "Reads qx qy qz qw, of any length. Writes qx qy qz qw; 0 0 0 1 for a zero quaternion.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 3 4\\n' | swivel eval normalize",
            {}, one_to_one, [](const auto&... a) { return swivel::normalize(a...); },
            [](const auto&... a) { return reference::normalize(a...); },
            [](auto normalize, const settings& s, const auto& in, const auto& out) {
                return normalize(in.quaternion(0), out.quaternion(0), s.options);
            }),
        describe(
            "rotate", "Vectors turned by rotations",
            "Reads qx qy qz qw, of length 1, and vx vy vz; with --by the vectors alone. Writes rx ry rz.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw vx vy vz\\n0 0 1 0 1 2 3\\n' | swivel eval rotate\n"
            "  printf 'vx vy vz\\n1 2 3\\n' | swivel eval rotate --by 0,0,1,0",
            {option::by},
            [](const settings& s) {
                groups g{{vector("v")}, {vector("r")}};
                if (!s.by) g.in.push_back(quaternion("q"));
                return g;
            },
            [](const auto&... a) { return swivel::rotate(a...); },
            [](const auto&... a) { return reference::rotate(a...); },
            []<class T>(auto rotate, const settings& s, const block<const T>& in, const block<T>& out) {
                if (!s.by) return rotate(in.quaternion(1), in.vector(0), out.vector(0), s.options);
                if constexpr (std::is_same_v<T, float>)
                    return rotate(s.by->f32, in.vector(0), out.vector(0), s.options);
                else
                    return rotate(s.by->f64, in.vector(0), out.vector(0), s.options);
            }),
        describe(
            "dot", "Scalar products of quaternions",
            "Reads ax ay az aw bx by bz bw. Writes dot.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw bx by bz bw\\n0 0 0 1 0 0 .6 .8\\n' | swivel eval dot",
            {},
            [](const settings&) {
                return groups{{quaternion("a"), quaternion("b")}, {scalar("dot")}};
            },
            [](const auto&... a) { return swivel::dot(a...); },
            [](const auto&... a) { return reference::dot(a...); },
            [](auto dot, const settings& s, const auto& in, const auto& out) {
                return dot(in.quaternion(0), in.quaternion(1), out.scalar(0), s.options);
            }),
        describe(
            "angle_between", "How far one rotation is from another",
            "Reads ax ay az aw bx by bz bw. Writes angle, in radians in [0, pi]: q and -q are the same "
            "rotation.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw bx by bz bw\\n0 0 0 1 0 0 .6 .8\\n' | swivel eval angle_between --degrees",
            {},
            [](const settings&) {
                return groups{{quaternion("a"), quaternion("b")}, {scalar("angle", meaning::angle)}};
            },
            [](const auto&... a) { return swivel::angle_between(a...); },
            [](const auto&... a) { return reference::angle_between(a...); },
            [](auto angle_between, const settings& s, const auto& in, const auto& out) {
                return angle_between(in.quaternion(0), in.quaternion(1), out.scalar(0), s.options);
            }),
        describe(
            "align_signs", "Of q and -q, the same rotation, the one on the side of its neighbour",
            "Reads qx qy qz qw and the neighbour nx ny nz nw; with --sequence qx qy qz qw alone, the "
            "neighbour\n"
            "being the row before. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n0 0 -0.6 -0.8\\n' | swivel eval align_signs --sequence",
            {option::sequence},
            [](const settings& s) {
                groups g{{quaternion("q")}, {quaternion("q")}};
                if (!s.sequence) g.in.push_back(quaternion("n"));
                return g;
            },
            [](const auto&... a) { return swivel::align_signs(a...); },
            [](const auto&... a) { return reference::align_signs(a...); },
            [](auto align_signs, const settings& s, const auto& in, const auto& out) {
                if (s.sequence) return align_sequence(align_signs, s, in, out);
                return align_signs(in.quaternion(0), in.quaternion(1), out.quaternion(0), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
