#ifndef SWIVEL_COMMAND_JOINT_CURVES_HPP
#define SWIVEL_COMMAND_JOINT_CURVES_HPP

// The rotation of one joint over a whole clip, factored.

#include <cstddef>
#include <vector>

#include "swivel/clip/clip.hpp"
#include "swivel/swivel.hpp"

namespace swivel::command {

// Beyond this swing, in degrees, the twist counts as ill conditioned: noise in the rotation comes out in the
// twist a hundred times larger and more.
inline constexpr double near_pole_degrees = 179;

// One element a frame.
struct joint_curves {
    std::vector<double> sx, sy, sz, sw;
    std::vector<double> tx, ty, tz, tw;  // tw >= 0
    std::vector<double> twist_degrees;   // in [-180, 180]
    std::vector<double> swing_degrees;   // in [0, 180]
};

// Into `curves`, whose memory is used again. Throws bad_usage when the library refuses an argument.
void factor_joint(const clip::clip& c, std::size_t joint_index, const swivel::twist_axis<double>& axis,
                  swivel::options options, joint_curves& curves);

struct joint_summary {
    std::size_t frames = 0;               // the rest holds with at least one, the jump with at least two
    double twist_min = 0, twist_max = 0;  // of twists in (-180, 180]
    double swing_min = 0, swing_max = 0;
    std::size_t near_pole = 0;
    // The largest change of the twist from one frame to the next, the shorter way round, and the later frame.
    double jump = 0;
    std::size_t jump_frame = 0;
};

[[nodiscard]] joint_summary summarize(const joint_curves& curves) noexcept;

}  // namespace swivel::command

#endif
