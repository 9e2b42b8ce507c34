#ifndef SWIVEL_CLIP_CLIP_HPP
#define SWIVEL_CLIP_CLIP_HPP

// A skeleton and how it moves, whatever file it came from. skeleton.hpp has what holds for the whole library.
//
// Example    The twist of the wrist about its forearm in every frame, in radians.
//
//   swivel::clip::read_result read = swivel::clip::read_bvh_file("boxing.bvh");
//   if (!read) return report(read.error);
//   const swivel::clip::clip& c = *read.value;
//   const std::optional<std::size_t> wrist = swivel::clip::find_joint(c.skeleton, "RightWrist");
//   if (!wrist) return report("no such joint");
//   std::vector<double> q(4 * c.frames), angle(c.frames);
//   swivel::status s = swivel::clip::joint_rotations(c, *wrist, swivel::aos_xyzw(q.data(), c.frames));
//   if (s == swivel::status::ok)
//       s = swivel::twist_angle(swivel::aos_xyzw<const double>(q.data(), c.frames), swivel::axis::x,
//                               swivel::scalar_view<double>{angle.data(), c.frames});

#include <cstddef>
#include <vector>

#include "swivel/clip/skeleton.hpp"
#include "swivel/types.hpp"

namespace swivel::clip {

// Eight bytes for each value, some 200 for each joint.
struct clip {
    swivel::clip::skeleton skeleton;
    double frame_time = 0;       // seconds
    std::size_t frames = 0;      // 0: the rest pose alone
    std::vector<double> values;  // frames rows of skeleton.channel_count columns; positions as in the file,
                                 // rotations in degrees

    friend bool operator==(const clip&, const clip&) = default;
};

// The local rotation of one joint in every frame, as unit quaternions (Hamilton, active: v' = q v q*).
//   Formula   The joint's rotation channels are composed left to right as written: q = q1 q2 q3, so that the
//             last one acts first on a vector. Position channels do not matter. One or two rotation channels
//             work; a joint without any gives the identity.
//   Accuracy  Angles are reduced modulo 720 degrees without rounding, so a large angle is as accurate as a
//             small one and the sign of q follows the angle: 360 degrees is -1, and a curve that turns on and
//             on stays continuous. Single rotations by multiples of 60 and 90 degrees have correctly rounded
//             components (multiples of 180 are exact). | |q| - 1 | < 1e-15, tested by ClipRotation.IsUnit.
//   Errors    bad_argument: no joint of that index, or its channels are not numbered; an output of stride 0.
//             size_mismatch: `out` has not one element a frame, or the values are not frames times channels.
//             null_stream. On any status but `ok` nothing has been written.
//   Not checked  that the streams of `out` do not overlap. Values that are not finite come out as NaN.
status joint_rotations(const clip& c, std::size_t joint_index, const quat_view<double>& out) noexcept;

}  // namespace swivel::clip

#endif  // SWIVEL_CLIP_CLIP_HPP
