#include "eval_operation.hpp"

namespace swivel::command {

namespace {

void add_axis_option(command_line line, eval_settings& settings) {
    add_axis(line, settings.axis, axis_words::columns);
}

template <class T>
swivel::status run_from_axis_angle(const eval_settings& settings, const eval_block<T>& in,
                                   const eval_block<T>& out) {
    return swivel::from_axis_angle(axis_of_rows(settings, in), swivel::scalar_view<const T>(in.scalar(0)),
                                   out.quaternion(0), settings.options);
}

template <class T>
swivel::status run_to_axis_angle(const eval_settings& settings, const eval_block<T>& in,
                                 const eval_block<T>& out) {
    return swivel::to_axis_angle(swivel::quat_view<const T>(in.quaternion(0)), out.vector(0), out.scalar(1),
                                 settings.options);
}

std::vector<column_group> spinor_columns() {
    return {{group_kind::scalar, "a"},
            {group_kind::scalar, "b"},
            {group_kind::scalar, "c"},
            {group_kind::scalar, "d"}};
}

template <class T>
swivel::spinor_view<T> spinors(const eval_block<T>& block) {
    return {block.scalar(0).data, block.scalar(1).data, block.scalar(2).data, block.scalar(3).data,
            block.size()};
}

template <class T>
swivel::status run_from_spinor(const eval_settings& settings, const eval_block<T>& in,
                               const eval_block<T>& out) {
    return swivel::from_spinor(swivel::spinor_view<const T>(spinors(in)), out.quaternion(0),
                               settings.options);
}

template <class T>
swivel::status run_to_spinor(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::to_spinor(swivel::quat_view<const T>(in.quaternion(0)), spinors(out), settings.options);
}

template <class T>
swivel::status run_from_matrix(const eval_settings& settings, const eval_block<T>& in,
                               const eval_block<T>& out) {
    return swivel::from_matrix(swivel::matrix_view<const T>(in.matrix(0)), out.quaternion(0),
                               settings.options);
}

template <class T>
swivel::status run_to_matrix(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::to_matrix(swivel::quat_view<const T>(in.quaternion(0)), out.matrix(0), settings.options);
}

void add_order(command_line line, eval_settings& settings) {
    using swivel::euler_order;
    line.add_choice(
        "--order", settings.euler,
        {{"xyz", euler_order::xyz},
         {"xzy", euler_order::xzy},
         {"yxz", euler_order::yxz},
         {"yzx", euler_order::yzx},
         {"zxy", euler_order::zxy},
         {"zyx", euler_order::zyx},
         {"xyx", euler_order::xyx},
         {"xzx", euler_order::xzx},
         {"yxy", euler_order::yxy},
         {"yzy", euler_order::yzy},
         {"zxz", euler_order::zxz},
         {"zyz", euler_order::zyz}},
        "Order of the three rotations, the outermost first, as the channels of a BVH file have it");
}

template <class T>
swivel::status run_from_euler(const eval_settings& settings, const eval_block<T>& in,
                              const eval_block<T>& out) {
    return swivel::from_euler(swivel::vec3_view<const T>(in.vector(0)), settings.euler, out.quaternion(0),
                              settings.options);
}

template <class T>
swivel::status run_to_euler(const eval_settings& settings, const eval_block<T>& in,
                            const eval_block<T>& out) {
    return swivel::to_euler(swivel::quat_view<const T>(in.quaternion(0)), settings.euler, out.vector(0),
                            settings.options);
}

}  // namespace

constinit const eval_operation eval_from_axis_angle = {
    "from_axis_angle",
    "Rotations from an axis and angles",
    "Reads angle, in radians, and with --axis columns ax ay az. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'angle\\n1.5707963267948966\\n' | swivel eval from_axis_angle --axis z",
    add_axis_option,
    [](const eval_settings& settings) {
        eval_columns c{{{group_kind::scalar, "angle"}}, {{group_kind::quaternion, "q"}}};
        if (std::holds_alternative<axis_columns>(settings.axis)) c.in.push_back({group_kind::vector, "a"});
        return c;
    },
    run_from_axis_angle<float>,
    run_from_axis_angle<double>};

constinit const eval_operation eval_to_axis_angle = {
    "to_axis_angle",
    "Axes and angles of rotations",
    "Reads qx qy qz qw. Writes ax ay az, of unit length, and angle, in radians in [0, 2 pi].\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_axis_angle",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}},
                            {{group_kind::vector, "a"}, {group_kind::scalar, "angle"}}};
    },
    run_to_axis_angle<float>,
    run_to_axis_angle<double>};

constinit const eval_operation eval_from_spinor = {
    "from_spinor",
    "Quaternions of the spinors a + b e12 + c e23 + d e31",
    "Reads a b c d. Writes qx qy qz qw, which are -c -d -b a.\n\n"
    "Examples:\n"
    "  printf 'a b c d\\n0.8 0.6 0 0\\n' | swivel eval from_spinor",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{spinor_columns(), {{group_kind::quaternion, "q"}}};
    },
    run_from_spinor<float>,
    run_from_spinor<double>};

constinit const eval_operation eval_to_spinor = {
    "to_spinor",
    "Quaternions as spinors a + b e12 + c e23 + d e31",
    "Reads qx qy qz qw. Writes a b c d, which are qw -qz -qx -qy.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_spinor",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}}, spinor_columns()};
    },
    run_to_spinor<float>,
    run_to_spinor<double>};

constinit const eval_operation eval_from_matrix = {
    "from_matrix",
    "Rotations from matrices that turn column vectors",
    "Reads mxx mxy mxz myx myy myz mzx mzy mzz, mxy being row x, column y. Writes qx qy qz qw, of unit\n"
    "length and with qw not negative.\n\n"
    "Examples:\n"
    "  printf 'mxx mxy mxz myx myy myz mzx mzy mzz\\n0 -1 0 1 0 0 0 0 1\\n' | swivel eval from_matrix",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::matrix, "m"}}, {{group_kind::quaternion, "q"}}};
    },
    run_from_matrix<float>,
    run_from_matrix<double>};

constinit const eval_operation eval_to_matrix = {
    "to_matrix",
    "Rotations as matrices that turn column vectors",
    "Reads qx qy qz qw, of any length. Writes mxx mxy mxz myx myy myz mzx mzy mzz, mxy being row x, column\n"
    "y.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_matrix",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}}, {{group_kind::matrix, "m"}}};
    },
    run_to_matrix<float>,
    run_to_matrix<double>};

constinit const eval_operation eval_from_euler = {
    "from_euler",
    "Rotations from three angles about the coordinate axes",
    "Reads ex ey ez, the angles about x, y and z in radians, whatever the order; for orders such as zxz the\n"
    "first, second and third angle. Writes qx qy qz qw.\n\n"
    "Examples:\n"
    "  printf 'ex ey ez\\n0.1 0.2 0.3\\n' | swivel eval from_euler --order zxy",
    add_order,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::vector, "e"}}, {{group_kind::quaternion, "q"}}};
    },
    run_from_euler<float>,
    run_from_euler<double>};

constinit const eval_operation eval_to_euler = {
    "to_euler",
    "Rotations as three angles about the coordinate axes",
    "Reads qx qy qz qw, of any length. Writes ex ey ez, the angles about x, y and z in radians: the second\n"
    "of the order in [-pi/2, pi/2], the others in [-pi, pi]. Where the second is pi/2 or -pi/2 the third is\n"
    "0. For orders such as zxz they are the first, second and third angle, the second in [0, pi], and where\n"
    "it is 0 or pi the third is 0.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 0.6 0.8\\n' | swivel eval to_euler --order zxy",
    add_order,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}}, {{group_kind::vector, "e"}}};
    },
    run_to_euler<float>,
    run_to_euler<double>};

}  // namespace swivel::command
