#include "eval_operation.hpp"

namespace swivel::command {

namespace {

template <class T>
swivel::status run_sincos(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::sincos(swivel::scalar_view<const T>(in.scalar(0)), out.scalar(0), out.scalar(1),
                          settings.options);
}

template <class T>
swivel::status run_atan2(const eval_settings& settings, const eval_block<T>& in, const eval_block<T>& out) {
    return swivel::atan2(swivel::scalar_view<const T>(in.scalar(0)),
                         swivel::scalar_view<const T>(in.scalar(1)), out.scalar(0), settings.options);
}

}  // namespace

constinit const eval_operation eval_sincos = {
    "sincos",
    "Sine and cosine of angles",
    "Reads angle, in radians. Writes sin and cos.\n\n"
    "Examples:\n"
    "  printf 'angle\\n0.5235987755982988\\n' | swivel eval sincos",
    add_no_options,
    [](const eval_settings&) {
        return eval_columns{{{group_kind::scalar, "angle"}},
                            {{group_kind::scalar, "sin"}, {group_kind::scalar, "cos"}}};
    },
    run_sincos<float>,
    run_sincos<double>};

constinit const eval_operation eval_atan2 = {"atan2",
                                             "Angles of points in the plane",
                                             "Reads y and x. Writes angle, in radians in [-pi, pi].\n\n"
                                             "Examples:\n"
                                             "  printf 'y x\\n1 -1\\n' | swivel eval atan2",
                                             add_no_options,
                                             [](const eval_settings&) {
                                                 return eval_columns{
                                                     {{group_kind::scalar, "y"}, {group_kind::scalar, "x"}},
                                                     {{group_kind::scalar, "angle"}}};
                                             },
                                             run_atan2<float>,
                                             run_atan2<double>};

}  // namespace swivel::command
