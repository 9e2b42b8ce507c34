#ifndef SWIVEL_CLIP_READ_HPP
#define SWIVEL_CLIP_READ_HPP

// Clips from files, with errors and warnings as values. skeleton.hpp has what holds for the whole library.
//
// Example
//
//   const swivel::clip::read_result r = swivel::clip::read_bvh_file("walk.bvh");
//   for (const swivel::clip::diagnostic& w : r.warnings) show("walk.bvh", w);
//   if (!r) return show("walk.bvh", r.error);
//   use(*r.value);
//
// Files are data of strangers: any bytes give a clip or an error, in time and memory that are linear in their
// number, whatever the counts in them say. Nothing recurses, nothing is asked of the locale.
//
// Biovision hierarchy (BVH) files
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
//   A text that was cut off within the last number of its last row reads as a shorter number.
//
// Errors: the first one is reported, at the first byte of the token that is wrong unless said otherwise
//   - nothing but blanks; UTF-16 (with or without a byte order mark); more than read_options::max_bytes
//   - a packed file (gzip, zip, bzip2, xz, zstd, lz4, compress, 7-Zip, rar), which is named
//   - no HIERARCHY first, no ROOT after it, no MOTION after the last root, an unknown keyword anywhere
//   - a name missing, with a brace or control character (a NUL among them) in it, or given to two joints
//   - "{" or "}" missing (at the token that stands in its place, or at the end) or one too many
//   - OFFSET missing (at the child, End Site or "}" that comes before it), or OFFSET or CHANNELS given twice
//   - CHANNELS after a child or End Site
//   - OFFSET with fewer than three numbers (at the keyword) or more (at the fourth)
//   - CHANNELS without a count (at the keyword), or with fewer or more names than its count (at the count)
//   - a channel that is unknown or given twice in a joint; a count of more than 6
//   - a second End Site in a joint; anything but one OFFSET, and what is warned of, in an End Site
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
// Warnings, each an error with read_options::strict
//   - CHANNELS missing in a joint (at the child, End Site or "}" that comes before it): it does not move
//   - "EndSite", one word
//   - CHANNELS in an End Site. Their columns are left out; and where the first line of the rows has as many
//     values as the joints alone have channels, there are none, which is a second warning
//   - more rows than Frames: at the first of them. They are checked like the others, then left out
//   - end-of-file marks (1A) and NUL after the last row with nothing but blanks and line ends between and
//     after them: at the first
//   The first three are listed a hundred times at most, all together.
// Salvage, with read_options::salvage and without strict
//   - Where the rows break off, or are wrong in any other way, the whole rows before that are the clip, if
//     there is one at least. What would have been the error is a warning that says how many of how many. A
//     row counts as whole if something follows its last number, so that no digit of it can be missing, or if
//     it is the last that Frames announces.
//
// Cost: linear in the size of the text, and a factor log n for comparing n names. Memory: the text, 8 bytes for
// each value and some 300 for each joint.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "swivel/clip/clip.hpp"

namespace swivel::clip {

inline constexpr std::size_t bvh_max_joints = 1'000'000;
inline constexpr std::size_t bvh_max_frames = 16'777'216;

// A position in a text and what is the matter there. Lines and columns count from 1, columns in bytes; line 0
// means the file as a whole (it cannot be opened, it is too large). To be shown as
// `FILE:LINE:COLUMN: what, expected expected`.
struct diagnostic {
    std::size_t line = 0;
    std::size_t column = 0;
    std::string what;
    std::string expected;

    friend bool operator==(const diagnostic&, const diagnostic&) = default;
};

// A clip, or the first error. Warnings may stand beside either.
struct read_result {
    std::optional<clip> value;
    diagnostic error;  // meaningful when there is no value
    std::vector<diagnostic> warnings;
    std::size_t warnings_left_out = 0;  // more of the kinds that are listed

    explicit operator bool() const noexcept { return value.has_value(); }
};

struct read_options {
    bool strict = false;                           // warnings are errors
    bool salvage = false;                          // a clip that was cut off is read as far as it goes
    std::size_t max_bytes = std::size_t{1} << 30;  // larger input is refused before it is read to the end
};

[[nodiscard]] read_result read_bvh(std::string_view text, const read_options& options = {});

// From the file at `path`, or from standard input when it is "-". The text is held in memory while it is
// read. A file that cannot be opened or read is an error at line 0.
[[nodiscard]] read_result read_bvh_file(const std::string& path, const read_options& options = {});

}  // namespace swivel::clip

#endif  // SWIVEL_CLIP_READ_HPP
