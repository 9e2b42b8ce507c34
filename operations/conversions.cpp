#include "operations/describe.hpp"

namespace swivel::operations {

std::span<const operation> conversions() {
    static const operation all[] = {
        describe(
            "from_axis_angle", "Rotations from an axis and angles",
            "Reads angle, in radians, and with --axis columns ax ay az. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'angle\\n1.5707963267948966\\n' | swivel eval from_axis_angle --axis z",
            {option::axis},
            [](const settings& s) {
                return with_axis({{scalar("angle", meaning::angle)}, {quaternion("q")}}, s);
            },
            [](const auto&... a) { return swivel::from_axis_angle(a...); },
            [](const auto&... a) { return reference::from_axis_angle(a...); },
            [](auto from_axis_angle, const settings& s, const auto& in, const auto& out) {
                return from_axis_angle(axis_of(s, in, 1), in.scalar(0), out.quaternion(0), s.options);
            }),
        describe(
            "to_axis_angle", "Axes and angles of rotations",
            "Reads qx qy qz qw. Writes ax ay az, of unit length, and angle, in radians in [0, 2 pi].\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_axis_angle",
            {},
            [](const settings&) {
                return groups{{quaternion("q")}, {vector("a"), scalar("angle", meaning::angle)}};
            },
            [](const auto&... a) { return swivel::to_axis_angle(a...); },
            [](const auto&... a) { return reference::to_axis_angle(a...); },
            [](auto to_axis_angle, const settings& s, const auto& in, const auto& out) {
                return to_axis_angle(in.quaternion(0), out.vector(0), out.scalar(1), s.options);
            }),
        describe(
            "from_spinor", "Quaternions of the spinors a + b e12 + c e23 + d e31",
            "Reads a b c d. Writes qx qy qz qw, which are -c -d -b a.\n\n"
            "Examples:\n"
            "  printf 'a b c d\\n0.8 0.6 0 0\\n' | swivel eval from_spinor",
            {},
            [](const settings&) {
                return groups{{spinor()}, {quaternion("q")}};
            },
            [](const auto&... a) { return swivel::from_spinor(a...); },
            [](const auto&... a) { return reference::from_spinor(a...); },
            [](auto from_spinor, const settings& s, const auto& in, const auto& out) {
                return from_spinor(in.spinor(0), out.quaternion(0), s.options);
            })
            .that_moves(),
        describe(
            "to_spinor", "Quaternions as spinors a + b e12 + c e23 + d e31",
            "Reads qx qy qz qw. Writes a b c d, which are qw -qz -qx -qy.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_spinor",
            {},
            [](const settings&) {
                return groups{{quaternion("q")}, {spinor()}};
            },
            [](const auto&... a) { return swivel::to_spinor(a...); },
            [](const auto&... a) { return reference::to_spinor(a...); },
            [](auto to_spinor, const settings& s, const auto& in, const auto& out) {
                return to_spinor(in.quaternion(0), out.spinor(0), s.options);
            })
            .that_moves(),
        describe(
            "from_matrix", "Rotations from matrices that turn column vectors",
            "Reads mxx mxy mxz myx myy myz mzx mzy mzz, mxy being row x, column y. Writes qx qy qz qw, of "
            "unit\n"
            "length and with qw not negative.\n\n"
            "Examples:\n"
            "  printf 'mxx mxy mxz myx myy myz mzx mzy mzz\\n0 -1 0 1 0 0 0 0 1\\n' | swivel eval "
            "from_matrix",
            {},
            [](const settings&) {
                return groups{{matrix("m")}, {quaternion("q")}};
            },
            [](const auto&... a) { return swivel::from_matrix(a...); },
            [](const auto&... a) { return reference::from_matrix(a...); },
            [](auto from_matrix, const settings& s, const auto& in, const auto& out) {
                return from_matrix(in.matrix(0), out.quaternion(0), s.options);
            }),
        describe(
            "to_matrix", "Rotations as matrices that turn column vectors",
            "Reads qx qy qz qw, of any length. Writes mxx mxy mxz myx myy myz mzx mzy mzz, mxy being row x, "
            "column\n"
            "y.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_matrix",
            {},
            [](const settings&) {
                return groups{{quaternion("q")}, {matrix("m")}};
            },
            [](const auto&... a) { return swivel::to_matrix(a...); },
            [](const auto&... a) { return reference::to_matrix(a...); },
            [](auto to_matrix, const settings& s, const auto& in, const auto& out) {
                return to_matrix(in.quaternion(0), out.matrix(0), s.options);
            }),
        describe(
            "from_euler", "Rotations from three angles about the coordinate axes",
            "Reads ex ey ez, the angles about x, y and z in radians, whatever the order; for orders such as "
            "zxz "
            "the\n"
            "first, second and third angle. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'ex ey ez\\n0.1 0.2 0.3\\n' | swivel eval from_euler --order zxy\n"
            "  printf 'ex ey ez\\n90 0 -45\\n' | swivel eval from_euler --degrees",
            {option::euler_order},
            [](const settings&) {
                return groups{{vector("e", meaning::angle)}, {quaternion("q")}};
            },
            [](const auto&... a) { return swivel::from_euler(a...); },
            [](const auto&... a) { return reference::from_euler(a...); },
            [](auto from_euler, const settings& s, const auto& in, const auto& out) {
                return from_euler(in.vector(0), s.euler, out.quaternion(0), s.options);
            }),
        describe(
            "to_euler", "Rotations as three angles about the coordinate axes",
            "Reads qx qy qz qw, of any length. Writes ex ey ez, the angles about x, y and z in radians: the "
            "second\n"
            "of the order in [-pi/2, pi/2], the others in [-pi, pi]. Where the second is pi/2 or -pi/2 the "
            "third "
            "is\n"
            "0. For orders such as zxz they are the first, second and third angle, the second in [0, pi], "
            "and "
            "where\n"
            "it is 0 or pi the third is 0.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_euler --order zxy",
            {option::euler_order},
            [](const settings&) {
                return groups{{quaternion("q")}, {vector("e", meaning::angle)}};
            },
            [](const auto&... a) { return swivel::to_euler(a...); },
            [](const auto&... a) { return reference::to_euler(a...); },
            [](auto to_euler, const settings& s, const auto& in, const auto& out) {
                return to_euler(in.quaternion(0), s.euler, out.vector(0), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
