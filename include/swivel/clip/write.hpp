#ifndef SWIVEL_CLIP_WRITE_HPP
#define SWIVEL_CLIP_WRITE_HPP

// Clips to files. skeleton.hpp has what holds for the whole library; read.hpp has the grammar of BVH files.
//
// Example
//
//   if (const std::string fault = swivel::clip::bvh_fault(c); !fault.empty()) return report(fault);
//   std::ofstream("out.bvh", std::ios::binary) << swivel::clip::write_bvh(c);

#include <string>

#include "swivel/clip/clip.hpp"

namespace swivel::clip {

// What keeps the clip from being written as a BVH file that reads back as the same clip, in one sentence;
// empty when nothing does. Clips from read_bvh have no fault. A fault is: no joint or too many
// (bvh_max_joints), a parent that does not stand before its child, a name that the grammar cannot express or
// that two joints share, columns not numbered as by number_channels, too many frames (bvh_max_frames), a
// number of values that is not frames times channels, a frame time that is not positive, anything not finite.
// Linear in the clip, and a factor log n for comparing n names.
[[nodiscard]] std::string bvh_fault(const clip& c);

// The clip as the text of a BVH file: LF, one tab a level (32 at most, so that the size stays linear in the
// joints), the shortest numbers that read back as the same doubles, -0 included. Reading it gives the same
// clip bit for bit if the joints are in depth-first order, as readers leave them; else the joints and their
// columns come back in that order. A clip with a fault gives the empty string, which is no BVH file.
// Memory: the text as a whole, 25 bytes a value at most.
[[nodiscard]] std::string write_bvh(const clip& c);

}  // namespace swivel::clip

#endif  // SWIVEL_CLIP_WRITE_HPP
