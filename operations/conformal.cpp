#include "operations/describe.hpp"

namespace swivel::operations {

namespace {

// 1 or 0, as `unique` of square_root, log, power, interpolate and split.
group unique() { return scalar("unique"); }

}  // namespace

std::span<const operation> conformal() {
    static const operation all[] = {
        describe(
            "conformal_multiply", "Products of conformal rotors",
            "Reads as a12 a13 a14 a15 a23 a24 a25 a34 a35 a45 a1234 a1235 a1245 a1345 a2345, even elements "
            "of "
            "the\n"
            "conformal algebra of space, and the same of b. Writes rs r12 ... r2345, the geometric product a "
            "b:\n"
            "first b, then a.\n\n"
            "Examples:\n"
            "  swivel eval conformal_multiply rotors.csv",
            {},
            [](const settings&) {
                return groups{{conformal("a"), conformal("b")}, {conformal("r")}};
            },
            [](const auto&... a) { return swivel::multiply(a...); },
            [](const auto&... a) { return reference::multiply(a...); },
            [](auto multiply, const settings& s, const auto& in, const auto& out) {
                return multiply(in.conformal(0), in.conformal(1), out.conformal(0), s.options);
            }),
        describe(
            "conformal_reverse", "Inverses of conformal rotors",
            "Reads rs r12 ... r2345 and writes the same.\n\n"
            "Examples:\n"
            "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation | swivel eval "
            "conformal_reverse",
            {},
            [](const settings&) {
                return groups{{conformal("r")}, {conformal("r")}};
            },
            [](const auto&... a) { return swivel::reverse(a...); },
            [](const auto&... a) { return reference::reverse(a...); },
            [](auto reverse, const settings& s, const auto& in, const auto& out) {
                return reverse(in.conformal(0), out.conformal(0), s.options);
            })
            .that_moves(),
        describe(
            "conformal_from_motor", "Conformal rotors of motors",
            "Reads mx my mz mw mdx mdy mdz mdw. Writes rs r12 ... r2345.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 0.5 0 0 0\\n' | swivel eval "
            "conformal_from_motor",
            {},
            [](const settings&) {
                return groups{{motor("m")}, {conformal("r")}};
            },
            [](const auto&... a) { return swivel::from_motor(a...); },
            [](const auto&... a) { return reference::from_motor(a...); },
            [](auto from_motor, const settings& s, const auto& in, const auto& out) {
                return from_motor(in.motor(0), out.conformal(0), s.options);
            }),
        describe(
            "conformal_from_rotation", "Conformal rotors of quaternions",
            "Reads qx qy qz qw. Writes rs r12 ... r2345.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval conformal_from_rotation",
            {},
            [](const settings&) {
                return groups{{quaternion("q")}, {conformal("r")}};
            },
            [](const auto&... a) { return swivel::from_rotation(a...); },
            [](const auto&... a) { return reference::from_rotation(a...); },
            [](auto from_rotation, const settings& s, const auto& in, const auto& out) {
                return from_rotation(in.quaternion(0), out.conformal(0), s.options);
            }),
        describe(
            "conformal_from_translation", "Conformal rotors of translations",
            "Reads tx ty tz. Writes rs r12 ... r2345.\n\n"
            "Examples:\n"
            "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation",
            {},
            [](const settings&) {
                return groups{{vector("t")}, {conformal("r")}};
            },
            [](const auto&... a) { return swivel::from_translation(a...); },
            [](const auto&... a) { return reference::from_translation(a...); },
            [](auto from_translation, const settings& s, const auto& in, const auto& out) {
                return from_translation(in.vector(0), out.conformal(0), s.options);
            }),
        describe(
            "conformal_from_dilation", "Conformal rotors of dilations",
            "Reads factor, by which lengths grow. Writes rs r12 ... r2345.\n\n"
            "Examples:\n"
            "  printf 'factor\\n2\\n' | swivel eval conformal_from_dilation",
            {},
            [](const settings&) {
                return groups{{scalar("factor")}, {conformal("r")}};
            },
            [](const auto&... a) { return swivel::from_dilation(a...); },
            [](const auto&... a) { return reference::from_dilation(a...); },
            [](auto from_dilation, const settings& s, const auto& in, const auto& out) {
                return from_dilation(in.scalar(0), out.conformal(0), s.options);
            }),
        describe(
            "conformal_transform", "Points moved by conformal rotors",
            "Reads rs r12 ... r2345 and the point px py pz. Writes vx vy vz.\n\n"
            "Examples:\n"
            "  printf 'factor px py pz\\n2 1 2 3\\n' | swivel eval conformal_from_dilation --pass |\n"
            "    swivel eval conformal_transform",
            {},
            [](const settings&) {
                return groups{{conformal("r"), vector("p")}, {vector("v")}};
            },
            [](const auto&... a) { return swivel::transform(a...); },
            [](const auto&... a) { return reference::transform(a...); },
            [](auto transform, const settings& s, const auto& in, const auto& out) {
                return transform(in.conformal(0), in.vector(1), out.vector(0), s.options);
            }),
        describe(
            "conformal_square_root", "Half of conformal motions",
            "Reads rs r12 ... r2345. Writes the same of that whose square it is, and unique: 0 where there\n"
            "is none or more than one.\n\n"
            "Examples:\n"
            "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation | swivel eval "
            "conformal_square_root",
            {},
            [](const settings&) {
                return groups{{conformal("r")}, {conformal("r"), unique()}};
            },
            [](const auto&... a) { return swivel::square_root(a...); },
            [](const auto&... a) { return reference::square_root(a...); },
            [](auto square_root, const settings& s, const auto& in, const auto& out) {
                return square_root(in.conformal(0), out.conformal(0), out.scalar(1), s.options);
            }),
        describe(
            "conformal_exp", "Conformal rotors of bivectors",
            "Reads b12 b13 b14 b15 b23 b24 b25 b34 b35 b45. Writes rs r12 ... r2345.\n\n"
            "Examples:\n"
            "  printf 'b12 b13 b14 b15 b23 b24 b25 b34 b35 b45\\n0.5 0 0 0 0 0 0 1 1 0\\n' | swivel eval "
            "conformal_exp",
            {},
            [](const settings&) {
                return groups{{bivector("b")}, {conformal("r")}};
            },
            [](const auto&... a) { return swivel::exp(a...); },
            [](const auto&... a) { return reference::exp(a...); },
            [](auto exp, const settings& s, const auto& in, const auto& out) {
                return exp(in.bivector(0), out.conformal(0), s.options);
            }),
        describe(
            "conformal_log", "Bivectors of conformal rotors",
            "Reads rs r12 ... r2345. Writes b12 ... b45, and unique: 0 where there is no logarithm or more "
            "than\n"
            "one.\n\n"
            "Examples:\n"
            "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation | swivel eval "
            "conformal_log",
            {},
            [](const settings&) {
                return groups{{conformal("r")}, {bivector("b"), unique()}};
            },
            [](const auto&... a) { return swivel::log(a...); },
            [](const auto&... a) { return reference::log(a...); },
            [](auto log, const settings& s, const auto& in, const auto& out) {
                return log(in.conformal(0), out.bivector(0), out.scalar(1), s.options);
            }),
        describe(
            "conformal_power", "Parts or multiples of conformal motions",
            "Reads rs r12 ... r2345, and with --t column t. Writes the same, and unique: 0 where there is no "
            "power\n"
            "or more than one.\n\n"
            "Examples:\n"
            "  printf 'factor\\n16\\n' | swivel eval conformal_from_dilation | swivel eval conformal_power "
            "--t "
            "0.25",
            {option::exponent},
            [](const settings& s) {
                return with_t({{conformal("r")}, {conformal("r"), unique()}}, s);
            },
            [](const auto&... a) { return swivel::power(a...); },
            [](const auto&... a) { return reference::power(a...); },
            [](auto power, const settings& s, const auto& in, const auto& out) {
                return power(in.conformal(0), parameter_of(s.t, in, 1), out.conformal(0), out.scalar(1),
                             s.options);
            }),
        describe(
            "conformal_interpolate", "Conformal motions between two",
            "Reads as a12 ... a2345 and bs b12 ... b2345, and with --t column t. Writes rs r12 ... r2345, "
            "the\n"
            "motion at t on the way from a (0) to b (1), and unique: 0 where there is more than one way.\n\n"
            "Examples:\n"
            "  swivel eval conformal_interpolate --t 0.25 rotors.csv",
            {option::t},
            [](const settings& s) {
                return with_t({{conformal("a"), conformal("b")}, {conformal("r"), unique()}}, s);
            },
            [](const auto&... a) { return swivel::interpolate(a...); },
            [](const auto&... a) { return reference::interpolate(a...); },
            [](auto interpolate, const settings& s, const auto& in, const auto& out) {
                return interpolate(in.conformal(0), in.conformal(1), parameter_of(s.t, in, 2),
                                   out.conformal(0), out.scalar(1), s.options);
            }),
        describe(
            "conformal_split", "The two commuting parts of bivectors",
            "Reads b12 b13 b14 b15 b23 b24 b25 b34 b35 b45. Writes f12 ... f45, the larger turn, g12 ... "
            "g45, "
            "the\n"
            "rest, and unique: 0 where the parts are not unique.\n\n"
            "Examples:\n"
            "  printf 'b12 b13 b14 b15 b23 b24 b25 b34 b35 b45\\n0.5 0 0 0 0 0 0 1 1 0\\n' |\n"
            "    swivel eval conformal_split",
            {},
            [](const settings&) {
                return groups{{bivector("b")}, {bivector("f"), bivector("g"), unique()}};
            },
            [](const auto&... a) { return swivel::split(a...); },
            [](const auto&... a) { return reference::split(a...); },
            [](auto split, const settings& s, const auto& in, const auto& out) {
                return split(in.bivector(0), out.bivector(0), out.bivector(1), out.scalar(2), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
