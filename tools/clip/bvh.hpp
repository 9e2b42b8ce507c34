#ifndef SWIVEL_CLIP_BVH_HPP
#define SWIVEL_CLIP_BVH_HPP

// Biovision hierarchy (BVH) files, read and written.
//
// Grammar
//   file      = "HIERARCHY" root { root } "MOTION" "Frames" ":" count "Frame" "Time" ":" number  rows
//   root      = "ROOT" name block
//   child     = "JOINT" name block
//   block     = "{" ( offset channels | channels offset ) { child | end-site } "}"   (one End Site at most)
//   end-site  = "End" "Site" [ name ] "{" offset "}"
//   offset    = "OFFSET" number number number
//   channels  = "CHANNELS" count { channel-name }         (count 0..6, that many different names)
//   channel-name = "Xposition" | "Yposition" | "Zposition" | "Xrotation" | "Yrotation" | "Zrotation"
//   rows      = one row a frame: as many numbers as there are channels, in the order of the hierarchy
//
// Text
//   Tokens are separated by blanks (space, tab, vertical tab, form feed) and line ends; braces need no blanks
//   around them, nor does the colon. Lines end with LF, CRLF or a bare CR, mixed as they come. A UTF-8 byte
//   order mark is skipped and not counted as a column. Keywords and channel names: any letter case.
//   name: the rest of the keyword's line up to "{", without blanks at either end, so blanks, dots and colons
//     within are part of it; when nothing is left on the line, the next line that is not blank. Any bytes but
//     braces and control characters (a tab within is kept). Case matters. The name of an End Site is optional
//     and stands on the line of "End Site" only. Names of joints differ from one another; those of End Sites
//     are not compared with anything.
//   number: decimal with a point, such as -1.5, +2, .0083333, 5., 9.2e-007. What is too small for a double is
//     read as zero of its sign. count: a whole number without point or exponent.
//   rows: each row begins on a line of its own, after the line of "Frame Time". It may be wrapped over
//     several lines. Blank lines are skipped. With no channels in the whole file there are no rows to
//     see, and "Frames" is taken as it stands.
//   Frames: 0 is a clip without frames: the rest pose, which the hierarchy alone describes.
//
// Errors: the first one is reported, at the first byte of the token that is wrong unless said otherwise
//   - nothing but blanks; UTF-16 (with or without a byte order mark); more than bvh_options::max_bytes
//   - no HIERARCHY first, no ROOT after it, no MOTION after the last root, an unknown keyword anywhere
//   - a name missing, with a brace or control character (a NUL among them) in it, or given to two joints
//   - "{" or "}" missing (at the token that stands in its place, or at the end) or one too many
//   - OFFSET or CHANNELS missing (at the child, End Site or "}" that comes before it), or given twice
//   - OFFSET with fewer than three numbers (at the keyword) or more (at the fourth)
//   - CHANNELS without a count (at the keyword), or with fewer or more names than its count (at the count)
//   - a channel that is unknown or given twice in a joint; a count of more than 6
//   - a second End Site in a joint; anything but one OFFSET in an End Site
//   - more than bvh_max_joints joints (that also bounds the nesting)
//   - Frames missing, negative, not whole, more than bvh_max_frames
//   - Frame Time missing, zero, negative, not finite, or followed by something on its line
//   - a number that is not one as a whole (1x0, 1,5, 0x10, 1.5e, a NUL within), nan, inf, or too large for a
//     double
//   - a row too long: at the first surplus value of the line that begins it
//   - a row too short: the lines that follow the beginning of a row must complete it exactly. Reported on the
//     line that begins the row, one past its last value
//   - fewer rows than Frames: at the end of the text
//   - anything but complete rows of numbers after the last row
// Warnings
//   - more rows than Frames: at the first of them. They are checked like the others, then left out. An error
//     with bvh_options::strict.
//
// Cost: time and memory are linear in the size of the text (a factor log n for comparing n names), whatever
// the counts in it say and however deep the joints are nested. Independent of the locale. The only exception
// is std::bad_alloc.

#include <cstddef>
#include <string>
#include <string_view>

#include "clip/clip.hpp"

namespace swivel::clip {

inline constexpr std::size_t bvh_max_joints = 1'000'000;
inline constexpr std::size_t bvh_max_frames = 16'777'216;

struct bvh_options {
    bool strict = false;                           // warnings are errors
    std::size_t max_bytes = std::size_t{1} << 30;  // larger input is refused before it is read to the end
};

[[nodiscard]] read_result read_bvh(std::string_view text, const bvh_options& options = {});

// From the file at `path`, or from standard input when it is "-". The text is held in memory while it is
// read. A file that cannot be opened or read is an error at line 0.
[[nodiscard]] read_result read_bvh_file(const std::string& path, const bvh_options& options = {});

// What keeps the clip from being written as a BVH file that reads back as the same clip, in one sentence;
// empty when nothing does. Clips from read_bvh have no fault. A fault is: no joint or too many, a parent that
// does not stand before its child, a name that the grammar above cannot express or that two joints share,
// columns not numbered as by number_channels, too many frames, a number of values that is not frames times
// channels, a frame time that is not positive, anything not finite.
[[nodiscard]] std::string bvh_fault(const clip& c);

// The clip as the text of a BVH file: LF, one tab a level (32 at most, so that the size stays linear in the
// joints), the shortest numbers that read back as the same doubles, -0 included. Reading it gives the same
// clip bit for bit if the joints are in depth-first order, as readers leave them; else the joints and their
// columns come back in that order. A clip with a fault gives the empty string, which is no BVH file.
[[nodiscard]] std::string write_bvh(const clip& c);

}  // namespace swivel::clip

#endif  // SWIVEL_CLIP_BVH_HPP
