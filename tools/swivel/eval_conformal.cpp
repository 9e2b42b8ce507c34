#include "eval_operation.hpp"

namespace swivel::command {

namespace {

template <class T>
swivel::status run_multiply(const eval_settings& settings, const eval_block<T>& in,
                            const eval_block<T>& out) {
    return swivel::multiply(swivel::conformal_view<const T>(in.conformal(0)),
                            swivel::conformal_view<const T>(in.conformal(1)), out.conformal(0),
                            settings.options);
}

template <class T>
swivel::status run_reverse(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::reverse(swivel::conformal_view<const T>(in.conformal(0)), out.conformal(0),
                           settings.options);
}

template <class T>
swivel::status run_from_motor(const eval_settings& settings, const eval_block<T>& in,
                              const eval_block<T>& out) {
    return swivel::from_motor(swivel::motor_view<const T>(in.motor(0)), out.conformal(0), settings.options);
}

template <class T>
swivel::status run_from_rotation(const eval_settings& settings, const eval_block<T>& in,
                                 const eval_block<T>& out) {
    return swivel::from_rotation(swivel::quat_view<const T>(in.quaternion(0)), out.conformal(0),
                                 settings.options);
}

template <class T>
swivel::status run_from_translation(const eval_settings& settings, const eval_block<T>& in,
                                    const eval_block<T>& out) {
    return swivel::from_translation(swivel::vec3_view<const T>(in.vector(0)), out.conformal(0),
                                    settings.options);
}

template <class T>
swivel::status run_from_dilation(const eval_settings& settings, const eval_block<T>& in,
                                 const eval_block<T>& out) {
    return swivel::from_dilation(swivel::scalar_view<const T>(in.scalar(0)), out.conformal(0),
                                 settings.options);
}

template <class T>
swivel::status run_transform(const eval_settings& settings, const eval_block<T>& in,
                             const eval_block<T>& out) {
    return swivel::transform(swivel::conformal_view<const T>(in.conformal(0)),
                             swivel::vec3_view<const T>(in.vector(1)), out.vector(0), settings.options);
}

template <class T>
swivel::status run_square_root(const eval_settings& settings, const eval_block<T>& in,
                               const eval_block<T>& out) {
    return swivel::square_root(swivel::conformal_view<const T>(in.conformal(0)), out.conformal(0),
                               out.scalar(1), settings.options);
}

template <class T>
swivel::status run_exp(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::exp(swivel::bivector_view<const T>(in.bivector(0)), out.conformal(0), settings.options);
}

template <class T>
swivel::status run_log(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::log(swivel::conformal_view<const T>(in.conformal(0)), out.bivector(0), out.scalar(1),
                       settings.options);
}

template <class T>
swivel::status run_power(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::power(swivel::conformal_view<const T>(in.conformal(0)),
                         parameter_of_rows(settings.t, in, 1), out.conformal(0), out.scalar(1),
                         settings.options);
}

template <class T>
swivel::status run_interpolate(const eval_settings& settings, const eval_block<T>& in,
                               const eval_block<T>& out) {
    return swivel::interpolate(
        swivel::conformal_view<const T>(in.conformal(0)), swivel::conformal_view<const T>(in.conformal(1)),
        parameter_of_rows(settings.t, in, 2), out.conformal(0), out.scalar(1), settings.options);
}

template <class T>
swivel::status run_split(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::split(swivel::bivector_view<const T>(in.bivector(0)), out.bivector(0), out.bivector(1),
                         out.scalar(2), settings.options);
}

}  // namespace

constinit const eval_operation eval_conformal_multiply = {
    "conformal_multiply",
    "Products of conformal rotors",
    "Reads as a12 a13 a14 a15 a23 a24 a25 a34 a35 a45 a1234 a1235 a1245 a1345 a2345, even elements of the\n"
    "conformal algebra of space, and the same of b. Writes rs r12 ... r2345, the geometric product a b:\n"
    "first b, then a.\n\n"
    "Examples:\n"
    "  swivel eval conformal_multiply rotors.csv",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::conformal, "a"}, {group_kind::conformal, "b"}},
                            {{group_kind::conformal, "r"}}};
    },
    run_multiply<float>,
    run_multiply<double>};

constinit const eval_operation eval_conformal_reverse = {
    "conformal_reverse",
    "Inverses of conformal rotors",
    "Reads rs r12 ... r2345 and writes the same.\n\n"
    "Examples:\n"
    "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation | swivel eval conformal_reverse",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::conformal, "r"}}, {{group_kind::conformal, "r"}}};
    },
    run_reverse<float>,
    run_reverse<double>};

constinit const eval_operation eval_conformal_from_motor = {
    "conformal_from_motor",
    "Conformal rotors of motors",
    "Reads mx my mz mw mdx mdy mdz mdw. Writes rs r12 ... r2345.\n\n"
    "Examples:\n"
    "  printf 'mx my mz mw mdx mdy mdz mdw\\n0 0 1 0 0.5 0 0 0\\n' | swivel eval conformal_from_motor",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::motor, "m"}}, {{group_kind::conformal, "r"}}};
    },
    run_from_motor<float>,
    run_from_motor<double>};

constinit const eval_operation eval_conformal_from_rotation = {
    "conformal_from_rotation",
    "Conformal rotors of quaternions",
    "Reads qx qy qz qw. Writes rs r12 ... r2345.\n\n"
    "Examples:\n"
    "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval conformal_from_rotation",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::quaternion, "q"}}, {{group_kind::conformal, "r"}}};
    },
    run_from_rotation<float>,
    run_from_rotation<double>};

constinit const eval_operation eval_conformal_from_translation = {
    "conformal_from_translation",
    "Conformal rotors of translations",
    "Reads tx ty tz. Writes rs r12 ... r2345.\n\n"
    "Examples:\n"
    "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::vector, "t"}}, {{group_kind::conformal, "r"}}};
    },
    run_from_translation<float>,
    run_from_translation<double>};

constinit const eval_operation eval_conformal_from_dilation = {
    "conformal_from_dilation",
    "Conformal rotors of dilations",
    "Reads factor, by which lengths grow. Writes rs r12 ... r2345.\n\n"
    "Examples:\n"
    "  printf 'factor\\n2\\n' | swivel eval conformal_from_dilation",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::scalar, "factor"}}, {{group_kind::conformal, "r"}}};
    },
    run_from_dilation<float>,
    run_from_dilation<double>};

constinit const eval_operation eval_conformal_transform = {
    "conformal_transform",
    "Points moved by conformal rotors",
    "Reads rs r12 ... r2345 and the point px py pz. Writes vx vy vz.\n\n"
    "Examples:\n"
    "  printf 'factor px py pz\\n2 1 2 3\\n' | swivel eval conformal_from_dilation --pass |\n"
    "    swivel eval conformal_transform",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::conformal, "r"}, {group_kind::vector, "p"}},
                            {{group_kind::vector, "v"}}};
    },
    run_transform<float>,
    run_transform<double>};

constinit const eval_operation eval_conformal_square_root = {
    "conformal_square_root",
    "Half of conformal motions",
    "Reads rs r12 ... r2345. Writes the same of that whose square it is, and unique: 0 where there\n"
    "is none or more than one.\n\n"
    "Examples:\n"
    "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation | swivel eval "
    "conformal_square_root",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::conformal, "r"}},
                            {{group_kind::conformal, "r"}, {group_kind::scalar, "unique"}}};
    },
    run_square_root<float>,
    run_square_root<double>};

constinit const eval_operation eval_conformal_exp = {
    "conformal_exp",
    "Conformal rotors of bivectors",
    "Reads b12 b13 b14 b15 b23 b24 b25 b34 b35 b45. Writes rs r12 ... r2345.\n\n"
    "Examples:\n"
    "  printf 'b12 b13 b14 b15 b23 b24 b25 b34 b35 b45\\n0.5 0 0 0 0 0 0 1 1 0\\n' | swivel eval "
    "conformal_exp",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::bivector, "b"}}, {{group_kind::conformal, "r"}}};
    },
    run_exp<float>,
    run_exp<double>};

constinit const eval_operation eval_conformal_log = {
    "conformal_log",
    "Bivectors of conformal rotors",
    "Reads rs r12 ... r2345. Writes b12 ... b45, and unique: 0 where there is no logarithm or more than\n"
    "one.\n\n"
    "Examples:\n"
    "  printf 'tx ty tz\\n1 2 3\\n' | swivel eval conformal_from_translation | swivel eval conformal_log",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::conformal, "r"}},
                            {{group_kind::bivector, "b"}, {group_kind::scalar, "unique"}}};
    },
    run_log<float>,
    run_log<double>};

constinit const eval_operation eval_conformal_power = {
    "conformal_power",
    "Parts or multiples of conformal motions",
    "Reads rs r12 ... r2345, and with --t column t. Writes the same, and unique: 0 where there is no power\n"
    "or more than one.\n\n"
    "Examples:\n"
    "  printf 'factor\\n16\\n' | swivel eval conformal_from_dilation | swivel eval conformal_power --t 0.25",
    add_exponent,
    [](const eval_settings& settings) {
        return with_t(eval_columns{{{group_kind::conformal, "r"}},
                                   {{group_kind::conformal, "r"}, {group_kind::scalar, "unique"}}},
                      settings);
    },
    run_power<float>,
    run_power<double>};

constinit const eval_operation eval_conformal_interpolate = {
    "conformal_interpolate",
    "Conformal motions between two",
    "Reads as a12 ... a2345 and bs b12 ... b2345, and with --t column t. Writes rs r12 ... r2345, the\n"
    "motion at t on the way from a (0) to b (1), and unique: 0 where there is more than one way.\n\n"
    "Examples:\n"
    "  swivel eval conformal_interpolate --t 0.25 rotors.csv",
    add_t,
    [](const eval_settings& settings) {
        return with_t(eval_columns{{{group_kind::conformal, "a"}, {group_kind::conformal, "b"}},
                                   {{group_kind::conformal, "r"}, {group_kind::scalar, "unique"}}},
                      settings);
    },
    run_interpolate<float>,
    run_interpolate<double>};

constinit const eval_operation eval_conformal_split = {
    "conformal_split",
    "The two commuting parts of bivectors",
    "Reads b12 b13 b14 b15 b23 b24 b25 b34 b35 b45. Writes f12 ... f45, the larger turn, g12 ... g45, the\n"
    "rest, and unique: 0 where the parts are not unique.\n\n"
    "Examples:\n"
    "  printf 'b12 b13 b14 b15 b23 b24 b25 b34 b35 b45\\n0.5 0 0 0 0 0 0 1 1 0\\n' |\n"
    "    swivel eval conformal_split",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{
            {{group_kind::bivector, "b"}},
            {{group_kind::bivector, "f"}, {group_kind::bivector, "g"}, {group_kind::scalar, "unique"}}};
    },
    run_split<float>,
    run_split<double>};

}  // namespace swivel::command
