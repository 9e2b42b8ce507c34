#ifndef SWIVEL_SAMPLE_CLIP_HPP
#define SWIVEL_SAMPLE_CLIP_HPP

// A clip that needs no file: for demonstrations, tests and benchmarks.

#include "swivel/clip/clip.hpp"

namespace swivel::clip {

// A humanoid of 21 joints that walks on the spot for four seconds at 60 Hz, waves with its right hand, twists
// the forearm, turns the wrist and looks around. The joints use all six rotation orders. Every value is
// rounded to four decimals, so the clip is the same on every machine.
[[nodiscard]] clip make_sample_clip();

}  // namespace swivel::clip

#endif  // SWIVEL_SAMPLE_CLIP_HPP
