#include "joint_curves.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "failure.hpp"

namespace swivel::command {

namespace {

constexpr double degrees_per_radian = 57.295779513082320877;

// A twist of half a turn is -180 or 180 as rounding has it. A joint that rests there has a range of 180 to
// 180, not of everything.
double half_turn_once(double degrees) noexcept { return degrees < -180 + 1e-9 ? 180 : degrees; }

void require_ok(swivel::status s) {
    if (s != swivel::status::ok) throw bad_usage(std::string("the library refused: ") + swivel::name(s));
}

}  // namespace

void factor_joint(const clip::clip& c, std::size_t joint_index, const swivel::twist_axis<double>& axis,
                  swivel::options options, joint_curves& curves) {
    const std::size_t n = c.frames;
    for (std::vector<double>* const curve :
         {&curves.sx, &curves.sy, &curves.sz, &curves.sw, &curves.tx, &curves.ty, &curves.tz, &curves.tw,
          &curves.twist_degrees, &curves.swing_degrees})
        curve->resize(n);

    options.positive_twist = true;
    // The swing takes the place of the rotation.
    const auto swing = swivel::soa(curves.sx.data(), curves.sy.data(), curves.sz.data(), curves.sw.data(), n);
    require_ok(clip::joint_rotations(c, joint_index, swing));
    const auto twist = swivel::soa(curves.tx.data(), curves.ty.data(), curves.tz.data(), curves.tw.data(), n);
    const swivel::scalar_view<double> twist_angle{curves.twist_degrees.data(), n};
    require_ok(swivel::twist_angle(swivel::quat_view<const double>(swing), axis, twist_angle, options));
    require_ok(swivel::decompose(swivel::quat_view<const double>(swing), axis, swing, twist, options));

    // The angle of the swing is that of the twist of (|v|, 0, 0, w) about x, so that it needs no arc tangent
    // but the library's own.
    std::vector<double>& angle = curves.swing_degrees;
    for (std::size_t i = 0; i < n; ++i)
        angle[i] = std::sqrt(curves.sx[i] * curves.sx[i] + curves.sy[i] * curves.sy[i] +
                             curves.sz[i] * curves.sz[i]);
    const std::vector<double> zero(n);
    options.pole_threshold = swivel::default_pole_threshold;
    require_ok(swivel::twist_angle(swivel::soa(std::as_const(angle).data(), zero.data(), zero.data(),
                                               std::as_const(curves.sw).data(), n),
                                   swivel::axis::x, swivel::scalar_view<double>{angle.data(), n}, options));

    for (double& a : curves.twist_degrees) a *= degrees_per_radian;
    for (double& a : angle) a *= degrees_per_radian;
}

joint_summary summarize(const joint_curves& curves) noexcept {
    joint_summary s;
    s.frames = curves.twist_degrees.size();
    if (s.frames == 0) return s;
    const auto [swing_min, swing_max] =
        std::minmax_element(curves.swing_degrees.begin(), curves.swing_degrees.end());
    s.twist_min = s.twist_max = half_turn_once(curves.twist_degrees.front());
    for (const double twist : curves.twist_degrees) {
        s.twist_min = std::min(s.twist_min, half_turn_once(twist));
        s.twist_max = std::max(s.twist_max, half_turn_once(twist));
    }
    s.swing_min = *swing_min;
    s.swing_max = *swing_max;
    s.near_pole =
        static_cast<std::size_t>(std::count_if(curves.swing_degrees.begin(), curves.swing_degrees.end(),
                                               [](double swing) { return swing > near_pole_degrees; }));
    for (std::size_t i = 1; i < s.frames; ++i) {
        const double jump =
            std::fabs(std::remainder(curves.twist_degrees[i] - curves.twist_degrees[i - 1], 360.0));
        if (jump > s.jump || i == 1) {
            s.jump = jump;
            s.jump_frame = i;
        }
    }
    return s;
}

}  // namespace swivel::command
