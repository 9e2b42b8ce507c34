#include "operations/describe.hpp"

namespace swivel::operations {

std::span<const operation> arcs() {
    static const operation all[] = {
        describe(
            "shortest_arc", "The shortest rotations from one vector to another",
            "Reads vx vy vz and wx wy wz, of any length. Writes qx qy qz qw, which turns v to the direction "
            "of "
            "w.\n\n"
            "Examples:\n"
            "  printf 'vx vy vz wx wy wz\\n1 0 0 0 2 0\\n' | swivel eval shortest_arc",
            {},
            [](const settings&) {
                return groups{{vector("v"), vector("w")}, {quaternion("q")}};
            },
            [](const auto&... a) { return swivel::shortest_arc(a...); },
            [](const auto&... a) { return reference::shortest_arc(a...); },
            [](auto shortest_arc, const settings& s, const auto& in, const auto& out) {
                return shortest_arc(in.vector(0), in.vector(1), out.quaternion(0), s.options);
            }),
        describe(
            "arc_with_twist", "Rotations from one vector to another, by the angle of their twist",
            "Reads vx vy vz and wx wy wz, of any length, and with --angle column angle, in radians. Writes "
            "qx qy "
            "qz\n"
            "qw, which turns v to the direction of w. With --product swing-twist the twist about v comes "
            "first,\n"
            "with twist-swing the arc, before a twist about w.\n\n"
            "Examples:\n"
            "  printf 'vx vy vz wx wy wz\\n1 0 0 0 2 0\\n' | swivel eval arc_with_twist --angle 0.5\n"
            "  swivel eval arc_with_twist --angle column --product twist-swing bones.csv",
            {option::angle, option::product},
            [](const settings& s) {
                groups g{{vector("v"), vector("w")}, {quaternion("q")}};
                if (is_column(s.angle)) g.in.push_back(scalar("angle", meaning::angle));
                return g;
            },
            [](const auto&... a) { return swivel::arc_with_twist(a...); },
            [](const auto&... a) { return reference::arc_with_twist(a...); },
            [](auto arc_with_twist, const settings& s, const auto& in, const auto& out) {
                return arc_with_twist(in.vector(0), in.vector(1), parameter_of(s.angle, in, 2),
                                      out.quaternion(0), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
