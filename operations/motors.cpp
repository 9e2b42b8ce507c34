#include "operations/describe.hpp"

namespace swivel::operations {

namespace {

groups one_to_one(const settings&) { return {{motor("m")}, {motor("m")}}; }

std::string numbered(char name, std::size_t number) {
    return std::string(1, name).append(std::to_string(number));
}

// The motors, then the weights.
groups blend_groups(const settings& s) {
    groups g{{}, {motor("m")}};
    for (std::size_t k = 1; k <= s.motors; ++k) g.in.push_back(motor(numbered('m', k)));
    if (s.weights.empty())
        for (std::size_t k = 1; k <= s.motors; ++k) g.in.push_back(scalar(numbered('w', k)));
    else if (s.weights.size() != s.motors)
        g.fault = "--weights: one for each of the --motors";
    return g;
}

template <class T, class Function>
status blend_all(Function blend, const settings& s, const block<const T>& in, const block<T>& out) {
    std::vector<motor_view<const T>> motors;
    std::vector<parameter<T>> weights;
    for (std::size_t k = 0; k < s.motors; ++k) {
        motors.push_back(in.motor(k));
        if (s.weights.empty())
            weights.push_back(in.scalar(s.motors + k));
        else
            weights.push_back(s.weights[k].as<T>());
    }
    return blend(std::span<const motor_view<const T>>(motors), std::span<const parameter<T>>(weights),
                 out.motor(0), s.options);
}

}  // namespace

std::span<const operation> motors() {
    static const operation all[] = {
        describe(
            "from_rotation_translation", "Motors that turn, then move",
            "Reads qx qy qz qw, of unit length, and tx ty tz. Writes the motor mx my mz mw mdx mdy mdz mdw: "
            "the\n"
            "rotation q, and half of the translation t times it. All operations on motors read and write "
            "them "
            "so.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw tx ty tz\\n0 0 0 1 1 2 3\\n' | swivel eval from_rotation_translation",
            {},
            [](const settings&) {
                return groups{{quaternion("q"), vector("t")}, {motor("m")}};
            },
            [](const auto&... a) { return swivel::from_rotation_translation(a...); },
            [](const auto&... a) { return reference::from_rotation_translation(a...); },
            [](auto f, const settings& s, const auto& in, const auto& out) {
                return f(in.quaternion(0), in.vector(1), out.motor(0), s.options);
            }),
        describe(
            "to_rotation_translation", "Rotations and translations of motors",
            "Reads mx my mz mw mdx mdy mdz mdw. Writes qx qy qz qw, which turns first, and tx ty tz.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 0 1 0.5 1 1.5 0\\n' | swivel eval "
            "to_rotation_translation",
            {},
            [](const settings&) {
                return groups{{motor("m")}, {quaternion("q"), vector("t")}};
            },
            [](const auto&... a) { return swivel::to_rotation_translation(a...); },
            [](const auto&... a) { return reference::to_rotation_translation(a...); },
            [](auto f, const settings& s, const auto& in, const auto& out) {
                return f(in.motor(0), out.quaternion(0), out.vector(1), s.options);
            }),
        describe(
            "transform", "Points moved by motors",
            "Reads mx my mz mw mdx mdy mdz mdw, of unit length, and px py pz. Writes rx ry rz.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw px py pz\\n0 0 1 0 1 0 0 0 3 4 5\\n' | swivel eval "
            "transform",
            {},
            [](const settings&) {
                return groups{{motor("m"), vector("p")}, {vector("r")}};
            },
            [](const auto&... a) { return swivel::transform(a...); },
            [](const auto&... a) { return reference::transform(a...); },
            [](auto transform, const settings& s, const auto& in, const auto& out) {
                return transform(in.motor(0), in.vector(1), out.vector(0), s.options);
            }),
        describe(
            "motor_multiply", "The motion b, then the motion a",
            "Reads ax ay az aw adx ady adz adw and bx by bz bw bdx bdy bdz bdw. Writes mx my mz mw mdx mdy "
            "mdz "
            "mdw.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw adx ady adz adw bx by bz bw bdx bdy bdz bdw\\n"
            "0 0 1 0 0 0 0 0 0 0 0 1 1 0 0 0\\n' |\n"
            "    swivel eval motor_multiply",
            {},
            [](const settings&) {
                return groups{{motor("a"), motor("b")}, {motor("m")}};
            },
            [](const auto&... a) { return swivel::multiply(a...); },
            [](const auto&... a) { return reference::multiply(a...); },
            [](auto multiply, const settings& s, const auto& in, const auto& out) {
                return multiply(in.motor(0), in.motor(1), out.motor(0), s.options);
            }),
        describe(
            "motor_conjugate", "Motions backwards",
            "Reads mx my mz mw mdx mdy mdz mdw and writes the same: the inverse where m is of unit "
            "length.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 0 1 0.5 1 1.5 0\\n' | swivel eval motor_conjugate",
            {}, one_to_one, [](const auto&... a) { return swivel::conjugate(a...); },
            [](const auto&... a) { return reference::conjugate(a...); },
            [](auto conjugate, const settings& s, const auto& in, const auto& out) {
                return conjugate(in.motor(0), out.motor(0), s.options);
            })
            .that_moves(),
        describe(
            "motor_normalize", "Motors of unit length, with the dual part at right angles to the rotation",
            "Reads mx my mz mw mdx mdy mdz mdw and writes the same.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 0 2 1 2 3 4\\n' | swivel eval motor_normalize",
            {}, one_to_one, [](const auto&... a) { return swivel::normalize(a...); },
            [](const auto&... a) { return reference::normalize(a...); },
            [](auto normalize, const settings& s, const auto& in, const auto& out) {
                return normalize(in.motor(0), out.motor(0), s.options);
            }),
        describe(
            "motor_square_root", "Half of a motion",
            "Reads mx my mz mw mdx mdy mdz mdw, of unit length, and writes the same: that whose square is "
            "m,\n"
            "with mw >= 0.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_square_root",
            {}, one_to_one, [](const auto&... a) { return swivel::square_root(a...); },
            [](const auto&... a) { return reference::square_root(a...); },
            [](auto square_root, const settings& s, const auto& in, const auto& out) {
                return square_root(in.motor(0), out.motor(0), s.options);
            }),
        describe(
            "motor_log", "Bivectors of motions",
            "Reads mx my mz mw mdx mdy mdz mdw, of unit length. Writes bx by bz, half of the angle in "
            "radians "
            "times\n"
            "the axis, of length 0 to pi, and nx ny nz, of a translation half of it.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_log",
            {},
            [](const settings&) {
                return groups{{motor("m")},
                              {vector("b", meaning::logarithm), vector("n", meaning::logarithm)}};
            },
            [](const auto&... a) { return swivel::log(a...); },
            [](const auto&... a) { return reference::log(a...); },
            [](auto log, const settings& s, const auto& in, const auto& out) {
                return log(in.motor(0), out.vector(0), out.vector(1), s.options);
            }),
        describe(
            "motor_exp", "Motions of bivectors",
            "Reads bx by bz and nx ny nz, as motor_log writes them. Writes mx my mz mw mdx mdy mdz mdw.\n\n"
            "Examples:\n"
            "  printf 'bx by bz nx ny nz\\n0 0 0.785398163 0 0 1\\n' | swivel eval motor_exp",
            {},
            [](const settings&) {
                return groups{{vector("b", meaning::logarithm), vector("n", meaning::logarithm)},
                              {motor("m")}};
            },
            [](const auto&... a) { return swivel::exp(a...); },
            [](const auto&... a) { return reference::exp(a...); },
            [](auto exp, const settings& s, const auto& in, const auto& out) {
                return exp(in.vector(0), in.vector(1), out.motor(0), s.options);
            }),
        describe(
            "motor_power", "Parts or multiples of motions",
            "Reads mx my mz mw mdx mdy mdz mdw, of unit length, and with --t column t. Writes mx my mz mw "
            "mdx "
            "mdy\n"
            "mdz mdw, t times as far along the same screw.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_power --t 0.25\n"
            "  swivel eval motor_power --t column motions.csv",
            {option::exponent}, [](const settings& s) { return with_t(one_to_one(s), s); },
            [](const auto&... a) { return swivel::power(a...); },
            [](const auto&... a) { return reference::power(a...); },
            [](auto power, const settings& s, const auto& in, const auto& out) {
                return power(in.motor(0), parameter_of(s.t, in, 1), out.motor(0), s.options);
            }),
        describe(
            "sclerp", "Between two poses on a screw at constant speed",
            "Reads ax ay az aw adx ady adz adw and bx by bz bw bdx bdy bdz bdw, of unit length, and t with "
            "--t\n"
            "column. Writes mx my mz mw mdx mdy mdz mdw.\n\n"
            "Examples:\n"
            "  printf 'ax ay az aw adx ady adz adw bx by bz bw bdx bdy bdz bdw\\n"
            "0 0 0 1 0 0 0 0 0 0 1 0 1 0 0 0\\n' |\n"
            "    swivel eval sclerp --t 0.25 | swivel eval to_rotation_translation\n"
            "  swivel eval sclerp --t column --way long poses.csv",
            {option::t, option::way},
            [](const settings& s) {
                return with_t({{motor("a"), motor("b")}, {motor("m")}}, s);
            },
            [](const auto&... a) { return swivel::sclerp(a...); },
            [](const auto&... a) { return reference::sclerp(a...); },
            [](auto sclerp, const settings& s, const auto& in, const auto& out) {
                return sclerp(in.motor(0), in.motor(1), parameter_of(s.t, in, 2), out.motor(0), s.options);
            }),
        describe(
            "blend", "Weighted means of motors, as in dual quaternion skinning",
            "Reads for each of the --motors motors its columns and its weight: m1x m1y m1z m1w m1dx m1dy "
            "m1dz "
            "m1dw\n"
            "w1, m2x ... w2 and so on; with --weights the motors alone. Writes mx my mz mw mdx mdy mdz "
            "mdw.\n\n"
            "Examples:\n"
            "  printf 'm1x m1y m1z m1w m1dx m1dy m1dz m1dw w1 m2x m2y m2z m2w m2dx m2dy m2dz m2dw w2\\n"
            "0 0 0 1 0 0 0 0 0.75 0 0 1 0 1 0 0 0 0.25\\n' |\n"
            "    swivel eval blend\n"
            "  swivel eval blend --motors 4 vertices.csv",
            {option::motors, option::weights}, blend_groups,
            [](const auto&... a) { return swivel::blend(a...); },
            [](const auto&... a) { return reference::blend(a...); },
            [](auto blend, const settings& s, const auto& in, const auto& out) {
                return blend_all(blend, s, in, out);
            }),
        describe(
            "motor_decompose", "Motions into swing, twist and translation",
            "Reads mx my mz mw mdx mdy mdz mdw, and with --axis columns ax ay az. Writes sx sy sz sw tx ty "
            "tz "
            "tw,\n"
            "swing and twist of the rotation as decompose does, and px py pz, the translation: where the "
            "origin\n"
            "goes.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' | swivel eval motor_decompose "
            "--axis z\n"
            "  swivel eval motor_decompose --axis 0.6,0,0.8 --product twist-swing poses.csv",
            {option::axis, option::product, option::positive_twist, option::pole_threshold},
            [](const settings& s) {
                return with_axis({{motor("m")}, {quaternion("s"), quaternion("t"), vector("p")}}, s);
            },
            [](const auto&... a) { return swivel::decompose(a...); },
            [](const auto&... a) { return reference::decompose(a...); },
            [](auto decompose, const settings& s, const auto& in, const auto& out) {
                return decompose(in.motor(0), axis_of(s, in, 1), out.quaternion(0), out.quaternion(1),
                                 out.vector(2), s.options);
            }),
        describe(
            "motor_compose", "Motions from swing, twist and translation, the inverse of motor_decompose",
            "Reads sx sy sz sw tx ty tz tw and px py pz. Writes mx my mz mw mdx mdy mdz mdw.\n\n"
            "Examples:\n"
            "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 1 0 0 0\\n' |\n"
            "    swivel eval motor_decompose | swivel eval motor_compose",
            {option::product},
            [](const settings&) {
                return groups{{quaternion("s"), quaternion("t"), vector("p")}, {motor("m")}};
            },
            [](const auto&... a) { return swivel::compose(a...); },
            [](const auto&... a) { return reference::compose(a...); },
            [](auto compose, const settings& s, const auto& in, const auto& out) {
                return compose(in.quaternion(0), in.quaternion(1), in.vector(2), out.motor(0), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
