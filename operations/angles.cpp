#include "operations/describe.hpp"

namespace swivel::operations {

std::span<const operation> angles() {
    static const operation all[] = {
        describe(
            "sincos", "Sine and cosine of angles",
            "Reads angle, in radians. Writes sin and cos.\n\n"
            "Examples:\n"
            "  printf 'angle\\n0.5235987755982988\\n' | swivel eval sincos",
            {},
            [](const settings&) {
                return groups{{scalar("angle", meaning::angle)}, {scalar("sin"), scalar("cos")}};
            },
            [](const auto&... a) { return swivel::sincos(a...); },
            [](const auto&... a) { return reference::sincos(a...); },
            [](auto sincos, const settings& s, const auto& in, const auto& out) {
                return sincos(in.scalar(0), out.scalar(0), out.scalar(1), s.options);
            }),
        describe(
            "atan2", "Angles of points in the plane",
            "Reads y and x. Writes angle, in radians in [-pi, pi].\n\n"
            "Examples:\n"
            "  printf 'y x\\n1 -1\\n' | swivel eval atan2",
            {},
            [](const settings&) {
                return groups{{scalar("y"), scalar("x")}, {scalar("angle", meaning::angle)}};
            },
            [](const auto&... a) { return swivel::atan2(a...); },
            [](const auto&... a) { return reference::atan2(a...); },
            [](auto atan2, const settings& s, const auto& in, const auto& out) {
                return atan2(in.scalar(0), in.scalar(1), out.scalar(0), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
