#include "operations/describe.hpp"

namespace swivel::operations {

std::span<const operation> exponentials() {
    static const operation all[] = {
        describe(
            "square_root", "Half of a rotation",
            "Reads qx qy qz qw, of any length. Writes rx ry rz rw, the unit quaternion whose square is that "
            "of q,\n"
            "with rw >= 0.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval square_root",
            {},
            [](const settings&) {
                return groups{{quaternion("q")}, {quaternion("r")}};
            },
            [](const auto&... a) { return swivel::square_root(a...); },
            [](const auto&... a) { return reference::square_root(a...); },
            [](auto square_root, const settings& s, const auto& in, const auto& out) {
                return square_root(in.quaternion(0), out.quaternion(0), s.options);
            }),
        describe(
            "exp", "Rotations of rotation vectors",
            "Reads bx by bz, half of the angle in radians times the axis. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'bx by bz\\n0 0 0.785398163\\n' | swivel eval exp",
            {},
            [](const settings&) {
                return groups{{vector("b", meaning::logarithm)}, {quaternion("q")}};
            },
            [](const auto&... a) { return swivel::exp(a...); },
            [](const auto&... a) { return reference::exp(a...); },
            [](auto exp, const settings& s, const auto& in, const auto& out) {
                return exp(in.vector(0), out.quaternion(0), s.options);
            }),
        describe(
            "log", "Rotation vectors of rotations",
            "Reads qx qy qz qw, of any length. Writes bx by bz, half of the angle in radians times the axis, "
            "of\n"
            "length 0 to pi.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 1\\n' | swivel eval log",
            {},
            [](const settings&) {
                return groups{{quaternion("q")}, {vector("b", meaning::logarithm)}};
            },
            [](const auto&... a) { return swivel::log(a...); },
            [](const auto&... a) { return reference::log(a...); },
            [](auto log, const settings& s, const auto& in, const auto& out) {
                return log(in.quaternion(0), out.vector(0), s.options);
            }),
        describe(
            "power", "Parts or multiples of rotations",
            "Reads qx qy qz qw, of any length, and with --t column t. Writes rx ry rz rw, the rotation about "
            "the\n"
            "same axis by t times the angle.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 1\\n' | swivel eval power --t 0.5\n"
            "  swivel eval power --t column rotations.csv",
            {option::exponent},
            [](const settings& s) {
                return with_t({{quaternion("q")}, {quaternion("r")}}, s);
            },
            [](const auto&... a) { return swivel::power(a...); },
            [](const auto&... a) { return reference::power(a...); },
            [](auto power, const settings& s, const auto& in, const auto& out) {
                return power(in.quaternion(0), parameter_of(s.t, in, 1), out.quaternion(0), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
