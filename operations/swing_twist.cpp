#include "operations/describe.hpp"

namespace swivel::operations {

namespace {

groups rotation_to(const settings& s, std::vector<group> out) {
    return with_axis({{quaternion("q")}, std::move(out)}, s);
}

const char* const coordinate_axis_alone = "--form compact is about a coordinate axis: --axis x, y or z";

groups decompose_groups(const settings& s) {
    groups g;
    switch (s.form) {
        case factor_form::full:
            g = rotation_to(s, {quaternion("s"), quaternion("t")});
            break;
        case factor_form::compact:
            g = rotation_to(s, {factors()});
            if (!std::holds_alternative<swivel::axis>(s.axis)) g.fault = coordinate_axis_alone;
            break;
        case factor_form::twist:
            g = rotation_to(s, {quaternion("t")});
            break;
        case factor_form::swing:
            g = rotation_to(s, {quaternion("s")});
            break;
        case factor_form::angle:
            g = rotation_to(s, {scalar("angle", meaning::angle)});
            break;
    }
    if (s.signs) {
        if (s.form != factor_form::full && s.form != factor_form::compact)
            g.fault = "--signs goes with --form full or compact, from which compose restores the rotation";
        g.out.push_back(scalar("sign", meaning::sign));
    }
    return g;
}

groups compose_groups(const settings& s) {
    groups g;
    if (s.form == factor_form::compact) {
        g.in = {factors()};
        if (!std::holds_alternative<swivel::axis>(s.axis)) g.fault = coordinate_axis_alone;
    } else {
        g.in = {quaternion("s"), quaternion("t")};
    }
    if (s.signs) g.in.push_back(scalar("sign", meaning::sign));
    g.out = {quaternion("q")};
    return g;
}

struct library_factors {
    static status decompose(const auto&... a) { return swivel::decompose(a...); }
    static status twist(const auto&... a) { return swivel::twist(a...); }
    static status swing(const auto&... a) { return swivel::swing(a...); }
    static status twist_angle(const auto&... a) { return swivel::twist_angle(a...); }
};
struct reference_factors {
    static status decompose(const auto&... a) { return reference::decompose(a...); }
    static status twist(const auto&... a) { return reference::twist(a...); }
    static status swing(const auto&... a) { return reference::swing(a...); }
    static status twist_angle(const auto&... a) { return reference::twist_angle(a...); }
};

}  // namespace

std::span<const operation> swing_twist() {
    static const operation all[] = {
        describe(
            "decompose", "Rotations into swing and twist",
            "Reads qx qy qz qw, and with --axis columns ax ay az. Writes for --form\n"
            "  full     sx sy sz sw tx ty tz tw\n"
            "  compact  s1 s2 sc ts tc   about x, y or z: the numbers of full that are not zero, s1 s2 along "
            "the axes that\n"
            "                            follow in the order x y z x y, sc = sw, ts along the axis, tc = tw\n"
            "  twist    tx ty tz tw\n"
            "  swing    sx sy sz sw\n"
            "  angle    angle            of the twist in radians, in (-2 pi, 2 pi]\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval decompose --axis z\n"
            "  swivel eval decompose --axis 0.6,0,0.8 --form angle --positive-twist rotations.csv\n"
            "  swivel eval decompose --signs rotations.csv | swivel eval compose --signs",
            {option::axis, option::product, option::form, option::positive_twist, option::signs,
             option::pole_threshold},
            decompose_groups, library_factors{}, reference_factors{},
            [](auto f, const settings& s, const auto& in, const auto& out) {
                const auto q = in.quaternion(0);
                const auto axis = axis_of(s, in, 1);
                switch (s.form) {
                    case factor_form::full:
                        return s.signs
                                   ? f.decompose(q, axis, out.quaternion(0), out.quaternion(1), out.scalar(2),
                                                 s.options)
                                   : f.decompose(q, axis, out.quaternion(0), out.quaternion(1), s.options);
                    case factor_form::compact:
                        return s.signs
                                   ? f.decompose(q, axis.coordinate, out.factors(0), out.scalar(1), s.options)
                                   : f.decompose(q, axis.coordinate, out.factors(0), s.options);
                    case factor_form::twist:
                        return f.twist(q, axis, out.quaternion(0), s.options);
                    case factor_form::swing:
                        return f.swing(q, axis, out.quaternion(0), s.options);
                    case factor_form::angle:
                        break;
                }
                return f.twist_angle(q, axis, out.scalar(0), s.options);
            }),
        describe(
            "compose", "Rotations from swing and twist, the inverse of decompose",
            "Reads sx sy sz sw tx ty tz tw, or with --form compact s1 s2 sc ts tc. Writes qx qy qz qw.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval decompose | swivel eval compose\n"
            "  swivel eval decompose --form compact --axis x rotations.csv |\n"
            "    swivel eval compose --form compact --axis x",
            {option::axis_of_compact, option::product, option::form_read, option::signs_read}, compose_groups,
            [](const auto&... a) { return swivel::compose(a...); },
            [](const auto&... a) { return reference::compose(a...); },
            [](auto compose, const settings& s, const auto& in, const auto& out) {
                const auto q = out.quaternion(0);
                if (s.form == factor_form::compact) {
                    const swivel::axis axis = std::get<swivel::axis>(s.axis);
                    return s.signs ? compose(in.factors(0), axis, in.scalar(1), q, s.options)
                                   : compose(in.factors(0), axis, q, s.options);
                }
                return s.signs ? compose(in.quaternion(0), in.quaternion(1), in.scalar(2), q, s.options)
                               : compose(in.quaternion(0), in.quaternion(1), q, s.options);
            }),
        describe(
            "twist", "The twist alone",
            "Reads qx qy qz qw, and with --axis columns ax ay az. Writes tx ty tz tw, the same for both "
            "products.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval twist --axis z\n"
            "  swivel eval twist --axis columns --type f32 rotations.csv",
            {option::axis, option::product, option::positive_twist, option::pole_threshold},
            [](const settings& s) { return rotation_to(s, {quaternion("t")}); },
            [](const auto&... a) { return swivel::twist(a...); },
            [](const auto&... a) { return reference::twist(a...); },
            [](auto twist, const settings& s, const auto& in, const auto& out) {
                return twist(in.quaternion(0), axis_of(s, in, 1), out.quaternion(0), s.options);
            }),
        describe(
            "swing", "The swing alone",
            "Reads qx qy qz qw, and with --axis columns ax ay az. Writes sx sy sz sw.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval swing --axis z\n"
            "  swivel eval swing --product twist-swing rotations.csv",
            {option::axis, option::product, option::positive_twist, option::pole_threshold},
            [](const settings& s) { return rotation_to(s, {quaternion("s")}); },
            [](const auto&... a) { return swivel::swing(a...); },
            [](const auto&... a) { return reference::swing(a...); },
            [](auto swing, const settings& s, const auto& in, const auto& out) {
                return swing(in.quaternion(0), axis_of(s, in, 1), out.quaternion(0), s.options);
            }),
        describe(
            "twist_angle", "The angle of the twist",
            "Reads qx qy qz qw, and with --axis columns ax ay az. Writes angle, in radians in (-2 pi, 2 "
            "pi],\n"
            "with --positive-twist in [-pi, pi]; the same for both products.\n\n"
            "Examples:\n"
            "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval twist_angle --axis z\n"
            "  swivel eval twist_angle --axis 0.6,0,0.8 --positive-twist rotations.csv",
            {option::axis, option::product, option::positive_twist, option::pole_threshold},
            [](const settings& s) { return rotation_to(s, {scalar("angle", meaning::angle)}); },
            [](const auto&... a) { return swivel::twist_angle(a...); },
            [](const auto&... a) { return reference::twist_angle(a...); },
            [](auto twist_angle, const settings& s, const auto& in, const auto& out) {
                return twist_angle(in.quaternion(0), axis_of(s, in, 1), out.scalar(0), s.options);
            }),
    };
    return all;
}

}  // namespace swivel::operations
