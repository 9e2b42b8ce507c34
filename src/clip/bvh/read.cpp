#include "swivel/clip/read.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "src/clip/text_cursor.hpp"
#include "swivel/clip/text.hpp"

namespace swivel::clip {

namespace {

constexpr std::size_t max_joint_warnings = 100;
constexpr std::string_view braces = "{}";
constexpr std::string_view header_singles = "{}:";

bool is(const token& t, std::string_view keyword) noexcept { return equals_ignoring_case(t.text, keyword); }

bool is_brace(const token& t) noexcept { return t.text == "{" || t.text == "}"; }

std::optional<channel> parse_channel(std::string_view text) noexcept {
    constexpr std::pair<std::string_view, channel> names[] = {
        {"Xposition", channel::x_position}, {"Yposition", channel::y_position},
        {"Zposition", channel::z_position}, {"Xrotation", channel::x_rotation},
        {"Yrotation", channel::y_rotation}, {"Zrotation", channel::z_rotation}};
    for (const auto& [name, c] : names)
        if (equals_ignoring_case(text, name)) return c;
    return std::nullopt;
}

// A byte order mark, or Latin letters with a zero byte beside each.
bool is_utf16(std::string_view text) noexcept {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    return text.size() >= 4 && ((text[0] != 0 && text[1] == 0 && text[2] != 0 && text[3] == 0) ||
                                (text[0] == 0 && text[1] != 0 && text[2] == 0 && text[3] != 0));
}

std::string_view without_byte_order_mark(std::string_view text) noexcept {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

// The name of the format by which a file is packed, known by its first bytes; empty when it is not.
std::string_view packing(std::string_view text) noexcept {
    constexpr std::pair<std::string_view, std::string_view> beginnings[] = {{"\x1f\x8b", "gzip"},
                                                                            {"\x1f\x9d", "compress"},
                                                                            {"PK\3\4", "zip"},
                                                                            {"PK\5\6", "zip"},
                                                                            {"PK\7\b", "zip"},
                                                                            {"BZh", "bzip2"},
                                                                            {"\xfd"
                                                                             "7zXZ",
                                                                             "xz"},
                                                                            {"7z\xbc\xaf", "7-Zip"},
                                                                            {"\x28\xb5\x2f\xfd", "zstd"},
                                                                            {"\x04\x22\x4d\x18", "lz4"},
                                                                            {"Rar!\x1a", "rar"}};
    for (const auto& [bytes, name] : beginnings)
        if (text.starts_with(bytes)) return name;
    return {};
}

// Marks of the end of a file, as old systems wrote them or as space is left that was never written to.
bool is_end_mark(char c) noexcept { return c == '\x1a' || c == '\0'; }

// Up to the first mark after which nothing but marks, blanks and line ends follows.
std::string_view without_end_marks(std::string_view text) noexcept {
    std::size_t end = text.size();
    for (std::size_t at = text.size(); at > 0; --at) {
        const char c = text[at - 1];
        if (is_end_mark(c))
            end = at - 1;
        else if (!is_blank(c) && !is_line_end(c))
            break;
    }
    return text.substr(0, end);
}

std::string counted(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

// Columns of a row that belong to no joint.
struct column_range {
    std::size_t first;
    std::size_t count;
};

// Every member function that returns bool returns false after the error has been noted.
class bvh_reader {
public:
    bvh_reader(std::string_view text, const read_options& options) noexcept
        : in_(without_end_marks(text)), end_mark_(text.substr(in_.remaining(), 1)), options_(options) {}

    read_result read() {
        read_result result;
        if (read_hierarchy() && read_motion())
            result.value = std::move(clip_);
        else
            result.error = std::move(error_);
        result.warnings = std::move(warnings_);
        result.warnings_left_out = warnings_left_out_;
        return result;
    }

private:
    bool read_hierarchy();
    bool read_statement(const token& keyword);
    bool open_joint(const token& keyword);
    void close_joint() noexcept;
    bool read_name(const token& keyword, token& name);
    bool check_name(const token& name);
    bool read_offset(const token& keyword, vec3& offset);
    bool read_channels(const token& keyword, channel_list& channels);
    bool read_end_site(const token& keyword);
    bool read_end_site_block(end_site& end);
    bool read_end_site_channels(const token& keyword);
    bool joint_is_complete(const token& next);
    bool read_motion();
    bool read_motion_header();
    bool find_row_width();
    bool read_rows();
    bool salvage_rows();
    void leave_out_end_site_columns() noexcept;
    bool note_end_mark();

    bool take_keyword(std::string_view keyword, std::string_view expected);

    bool fail(const token& at, std::string what, std::string_view expected) {
        error_ = {at.line, at.column, std::move(what), std::string(expected)};
        return false;
    }

    // A warning, or an error when warnings are. `consequence`: what the reader does about it.
    bool warn(const token& at, const std::string& what, std::string_view consequence,
              std::string_view expected) {
        if (options_.strict) return fail(at, what, expected);
        warnings_.push_back(
            {at.line, at.column, what + "; " + std::string(consequence), std::string(expected)});
        return true;
    }

    // For what may be the matter with every joint.
    bool warn_of_joint(const token& at, const std::string& what, std::string_view consequence,
                       std::string_view expected) {
        if (warnings_.size() < max_joint_warnings) return warn(at, what, consequence, expected);
        ++warnings_left_out_;
        return true;
    }

    bool fail_unexpected(const token& t, std::string_view expected) {
        return fail(t, t.text.empty() ? "the text ends here" : "unexpected " + quoted(t.text), expected);
    }

    [[nodiscard]] joint& current() noexcept {
        return clip_.skeleton.joints[static_cast<std::size_t>(current_)];
    }
    [[nodiscard]] std::string current_name() { return "joint " + quoted(current().name); }

    text_cursor in_;
    std::string_view end_mark_;  // empty when there is none
    read_options options_;
    clip clip_;
    diagnostic error_;
    std::vector<diagnostic> warnings_;
    std::size_t warnings_left_out_ = 0;
    std::map<std::string_view, std::size_t> line_of_name_;
    std::vector<bool> has_channels_;  // by joint

    // The innermost open joint. Its OFFSET and CHANNELS stand before its first child or End Site, from which on
    // it is complete; so is a joint to which the reader comes back.
    std::int32_t current_ = -1;
    bool has_offset_ = false;
    bool is_complete_ = false;

    std::size_t row_width_ = 0;  // columns of all joints and End Sites so far
    std::vector<column_range> end_site_columns_;
    std::size_t rows_ = 0;  // read as a whole
};

bool bvh_reader::take_keyword(std::string_view keyword, std::string_view expected) {
    const token t = in_.take(header_singles);
    return is(t, keyword) || fail_unexpected(t, expected);
}

bool bvh_reader::read_hierarchy() {
    if (!in_.skip_to_content()) return fail({{}, 1, 1}, "the file is empty", "HIERARCHY");
    if (!take_keyword("HIERARCHY", "HIERARCHY")) return false;
    for (;;) {
        const token t = in_.take(braces);
        if (current_ >= 0) {
            if (!read_statement(t)) return false;
        } else if (is(t, "ROOT")) {
            if (!open_joint(t)) return false;
        } else if (is(t, "MOTION") && !clip_.skeleton.joints.empty()) {
            number_channels(clip_.skeleton);
            return true;
        } else {
            return fail_unexpected(t, clip_.skeleton.joints.empty() ? "ROOT" : "ROOT or MOTION");
        }
    }
}

bool bvh_reader::read_statement(const token& keyword) {
    if (is(keyword, "OFFSET")) {
        if (has_offset_) return fail(keyword, current_name() + " has a second OFFSET", "one OFFSET");
        has_offset_ = true;
        return read_offset(keyword, current().offset);
    }
    if (is(keyword, "CHANNELS")) {
        std::vector<bool>::reference has_channels = has_channels_[static_cast<std::size_t>(current_)];
        if (has_channels) return fail(keyword, current_name() + " has a second CHANNELS", "one CHANNELS");
        if (is_complete_)
            return fail(keyword, current_name() + " has CHANNELS after a child or End Site",
                        "CHANNELS before them");
        has_channels = true;
        return read_channels(keyword, current().channels);
    }
    if (is(keyword, "JOINT")) return joint_is_complete(keyword) && open_joint(keyword);
    if (is(keyword, "End"))
        return joint_is_complete(keyword) && take_keyword("Site", "Site after End") && read_end_site(keyword);
    if (is(keyword, "EndSite"))
        return joint_is_complete(keyword) &&
               warn_of_joint(keyword, quoted(keyword.text) + " is one word", "read as two", "End Site") &&
               read_end_site(keyword);
    if (keyword.text == "}") {
        if (!joint_is_complete(keyword)) return false;
        close_joint();
        return true;
    }
    if (keyword.text.empty() || is(keyword, "MOTION") || is(keyword, "ROOT"))
        return fail(keyword, current_name() + " is not closed", "'}'");
    return fail_unexpected(keyword, "OFFSET, CHANNELS, JOINT, End Site or '}'");
}

bool bvh_reader::open_joint(const token& keyword) {
    auto& joints = clip_.skeleton.joints;
    token name;
    if (!read_name(keyword, name)) return false;
    if (joints.size() >= bvh_max_joints)
        return fail(keyword, "too many joints", "at most " + std::to_string(bvh_max_joints));
    const auto [earlier, is_new] = line_of_name_.try_emplace(name.text, name.line);
    if (!is_new)
        return fail(name,
                    "the name " + quoted(name.text) + " was given in line " +
                        std::to_string(earlier->second) + " already",
                    "a name of its own for every joint");
    joint j;
    j.name = name.text;
    j.parent = current_;
    current_ = static_cast<std::int32_t>(joints.size());
    joints.push_back(std::move(j));
    has_channels_.push_back(false);
    has_offset_ = is_complete_ = false;

    const token brace = in_.take(braces);
    return brace.text == "{" || fail_unexpected(brace, "'{' after the name of the joint");
}

void bvh_reader::close_joint() noexcept {
    current_ = current().parent;
    has_offset_ = is_complete_ = true;
}

bool bvh_reader::read_name(const token& keyword, token& name) {
    name = in_.take_rest_of_line('{');
    if (name.text.empty()) {
        in_.skip_to_content();
        name = in_.take_rest_of_line('{');
    }
    if (name.text.empty())
        return fail(name, "no name after " + std::string(keyword.text), "the name of the joint");
    return check_name(name);
}

bool bvh_reader::check_name(const token& name) {
    for (std::size_t i = 0; i < name.text.size(); ++i) {
        const char c = name.text[i];
        if (c == '}' || (is_control(c) && c != '\t'))
            return fail({{}, name.line, name.column + i}, quoted(name.text.substr(i, 1)) + " in a name",
                        "no brace and no control character");
    }
    return true;
}

bool bvh_reader::joint_is_complete(const token& next) {
    if (!has_offset_) return fail(next, current_name() + " has no OFFSET", "OFFSET first");
    if (is_complete_) return true;
    is_complete_ = true;
    return has_channels_[static_cast<std::size_t>(current_)] ||
           warn_of_joint(next, current_name() + " has no CHANNELS", "it does not move", "CHANNELS first");
}

bool bvh_reader::read_offset(const token& keyword, vec3& offset) {
    std::size_t numbers = 0;
    for (double* const component : {&offset.x, &offset.y, &offset.z}) {
        const token t = in_.peek(braces);
        const parsed<double> number = parse_number(t.text);
        if (!number.fault.empty()) {
            if (t.line != keyword.line || is_brace(t))
                return fail(keyword, counted(numbers, "number") + " after OFFSET", "3");
            return fail(t, quoted(t.text) + " " + std::string(number.fault), "a number");
        }
        *component = number.value;
        ++numbers;
        in_.take(braces);
    }
    const token next = in_.peek(braces);
    if (parse_number(next.text).fault.empty()) return fail(next, "more than 3 numbers after OFFSET", "3");
    return true;
}

bool bvh_reader::read_channels(const token& keyword, channel_list& channels) {
    const token t = in_.take(braces);
    if (t.line != keyword.line || is_brace(t))
        return fail(keyword, "no count after CHANNELS", "a whole number from 0 to 6");
    const parsed<std::size_t> count = parse_count(t.text);
    if (!count.fault.empty())
        return fail(t, "the count of channels " + quoted(t.text) + " " + std::string(count.fault),
                    "a whole number from 0 to 6");
    if (count.value > channel_list::capacity)
        return fail(t, counted(count.value, "channel") + " in one joint", "at most 6");

    const std::string announced = "CHANNELS announces " + counted(count.value, "name");
    while (channels.size() < count.value) {
        const token name = in_.peek(braces);
        const std::optional<channel> c = parse_channel(name.text);
        if (!c) {
            if (name.line != t.line || is_brace(name))
                return fail(t, announced + " but gives " + std::to_string(channels.size()),
                            "the count and the names to agree");
            return fail(name, "unknown channel " + quoted(name.text),
                        "Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation");
        }
        if (!channels.add(*c))
            return fail(name, "the channel " + quoted(name.text) + " is given twice", "each channel once");
        in_.take(braces);
    }
    if (parse_channel(in_.peek(braces).text))
        return fail(t, announced + " but gives more", "the count and the names to agree");
    row_width_ += count.value;
    return true;
}

bool bvh_reader::read_end_site(const token& keyword) {
    if (current().end) return fail(keyword, current_name() + " has a second End Site", "one End Site");
    const token name = in_.take_rest_of_line('{');
    if (!check_name(name)) return false;
    end_site end{{}, std::string(name.text)};

    if (const token t = in_.take(braces); t.text != "{") return fail_unexpected(t, "'{' after End Site");
    if (!read_end_site_block(end)) return false;
    current().end = std::move(end);
    return true;
}

bool bvh_reader::read_end_site_block(end_site& end) {
    bool has_offset = false;
    bool has_channels = false;
    for (;;) {
        const token t = in_.take(braces);
        if (t.text == "}") return has_offset || fail(t, "the End Site has no OFFSET", "OFFSET first");
        if (is(t, "OFFSET")) {
            if (has_offset) return fail(t, "the End Site has a second OFFSET", "one OFFSET");
            has_offset = true;
            if (!read_offset(t, end.offset)) return false;
        } else if (is(t, "CHANNELS")) {
            if (has_channels) return fail(t, "the End Site has a second CHANNELS", "OFFSET alone");
            has_channels = true;
            if (!read_end_site_channels(t)) return false;
        } else {
            return fail_unexpected(
                t, has_offset ? "'}' after the OFFSET of the End Site" : "OFFSET in the End Site");
        }
    }
}

bool bvh_reader::read_end_site_channels(const token& keyword) {
    if (!warn_of_joint(keyword, "CHANNELS in an End Site", "they are left out", "OFFSET alone")) return false;
    const std::size_t first = row_width_;
    channel_list channels;
    if (!read_channels(keyword, channels)) return false;
    if (!channels.empty()) end_site_columns_.push_back({first, channels.size()});
    return true;
}

bool bvh_reader::read_motion() {
    if (!read_motion_header() || !find_row_width()) return false;
    if (!read_rows() && !salvage_rows()) return false;
    leave_out_end_site_columns();
    return note_end_mark();
}

bool bvh_reader::read_motion_header() {
    if (!take_keyword("Frames", "Frames:") || !take_keyword(":", "':' after Frames")) return false;
    const token frames = in_.take(header_singles);
    const parsed<std::size_t> count = parse_count(frames.text);
    if (frames.text.empty()) return fail_unexpected(frames, "the number of frames");
    if (!count.fault.empty())
        return fail(frames, "the number of frames " + quoted(frames.text) + " " + std::string(count.fault),
                    "a whole number, 0 or more");
    if (count.value > bvh_max_frames)
        return fail(frames, counted(count.value, "frame"), "at most " + std::to_string(bvh_max_frames));
    clip_.frames = count.value;

    if (!take_keyword("Frame", "Frame Time:") || !take_keyword("Time", "Frame Time:") ||
        !take_keyword(":", "':' after Frame Time"))
        return false;
    const token time = in_.take(header_singles);
    const parsed<double> seconds = parse_number(time.text);
    if (time.text.empty()) return fail_unexpected(time, "a positive number of seconds");
    if (!seconds.fault.empty())
        return fail(time, "the frame time " + quoted(time.text) + " " + std::string(seconds.fault),
                    "a positive number of seconds");
    if (!(seconds.value > 0))
        return fail(time, "the frame time " + quoted(time.text) + " is not positive",
                    "a positive number of seconds");
    clip_.frame_time = seconds.value;

    const token rest = in_.take_on_line();
    return rest.text.empty() || fail_unexpected(rest, "nothing more on the line of Frame Time");
}

// Whether the rows have columns for the channels of End Sites: not if the first line has just those of the joints.
bool bvh_reader::find_row_width() {
    if (end_site_columns_.empty() || !in_.skip_to_content()) return true;
    text_cursor ahead = in_;
    const token first = ahead.take_on_line();
    std::size_t count = 1;
    while (!ahead.take_on_line().text.empty()) ++count;
    if (count != clip_.skeleton.channel_count) return true;
    const std::string expected = std::to_string(row_width_);
    row_width_ = count;
    end_site_columns_.clear();
    return warn(first, "row of " + counted(count, "value"), "the rows have none for the End Sites", expected);
}

void bvh_reader::leave_out_end_site_columns() noexcept {
    if (end_site_columns_.empty()) return;
    std::size_t kept = 0;
    const auto keep = [&](std::size_t from, std::size_t to) {
        for (; from < to; ++from) clip_.values[kept++] = clip_.values[from];
    };
    for (std::size_t row = 0; row < clip_.values.size(); row += row_width_) {
        std::size_t column = 0;
        for (const column_range& range : end_site_columns_) {
            keep(row + column, row + range.first);
            column = range.first + range.count;
        }
        keep(row + column, row + row_width_);
    }
    clip_.values.resize(kept);
}

bool bvh_reader::read_rows() {
    const std::size_t width = row_width_;
    std::vector<double>& values = clip_.values;
    // A value takes two bytes of text at least, so the product of the counts is bounded by what is there.
    values.reserve(std::min(clip_.frames * width, in_.remaining() / 2 + 1));

    std::size_t filled = 0;  // values of the row that is being read
    token first_surplus;
    token first_line_end;  // of the row that is being read
    const auto fail_short_row = [&](std::size_t count) {
        return fail(first_line_end, "row too short: " + counted(count, "value"), std::to_string(width));
    };

    while (in_.skip_to_content()) {
        const std::size_t filled_before = filled;
        token last;
        for (token t = in_.take_on_line(); !t.text.empty(); t = in_.take_on_line()) {
            const parsed<double> number = parse_number(t.text);
            if (!number.fault.empty()) {
                if (rows_ >= clip_.frames && filled == 0)
                    return fail(t, "unexpected " + quoted(t.text) + " after the last row",
                                "the end of the text");
                return fail(t, quoted(t.text) + " " + std::string(number.fault), "a number");
            }
            if (filled == width) {
                if (filled_before > 0) return fail_short_row(filled_before);
                while (!in_.take_on_line().text.empty()) ++filled;
                return fail(t, "row too long: " + counted(filled + 1, "value"), std::to_string(width));
            }
            ++filled;
            if (rows_ < clip_.frames)
                values.push_back(number.value);
            else if (first_surplus.text.empty())
                first_surplus = t;
            last = t;
        }
        if (filled_before == 0) first_line_end = {{}, last.line, last.column + last.text.size()};
        if (filled == width) {
            ++rows_;
            filled = 0;
        }
    }
    if (filled > 0) return fail_short_row(filled);
    const bool are_missing = rows_ < clip_.frames && width > 0;
    if (!are_missing && rows_ <= clip_.frames) return true;
    const std::string what = counted(rows_, "row") + " of motion";
    const std::string expected = std::to_string(clip_.frames) + ", as Frames says";
    if (!are_missing) return warn(first_surplus, what, "those from here on are left out", expected);
    // Of a number that the text ends in, digits may be missing.
    if (rows_ > 0 && in_.ends_in_token()) --rows_;
    return fail(in_.peek({}), what, expected);
}

bool bvh_reader::salvage_rows() {
    if (!options_.salvage || options_.strict || rows_ == 0) return false;
    const std::size_t announced = clip_.frames;
    clip_.frames = std::min(rows_, announced);
    clip_.values.resize(clip_.frames * row_width_);
    return warn({{}, error_.line, error_.column}, error_.what,
                std::to_string(clip_.frames) + " of " + counted(announced, "row") + " read", error_.expected);
}

bool bvh_reader::note_end_mark() {
    if (end_mark_.empty() || in_.skip_to_content()) return true;
    return warn(in_.peek({}), quoted(end_mark_) + " after the last row", "taken as the end of the text",
                "the end of the text");
}

read_result failed_at_start(std::string what, std::string expected) {
    read_result result;
    result.error = {1, 1, std::move(what), std::move(expected)};
    return result;
}

read_result failed_as_a_whole(std::string what, std::string expected) {
    read_result result;
    result.error = {0, 0, std::move(what), std::move(expected)};
    return result;
}

read_result too_large(std::size_t max_bytes) {
    return failed_as_a_whole("the file is too large", "at most " + std::to_string(max_bytes) + " bytes");
}

read_result unreadable(std::string_view doing, int error_number) {
    return failed_as_a_whole(
        "cannot " + std::string(doing) + ": " + std::generic_category().message(error_number),
        "a readable file");
}

}  // namespace

read_result read_bvh(std::string_view text, const read_options& options) {
    if (text.size() > options.max_bytes) return too_large(options.max_bytes);
    if (const std::string_view format = packing(text); !format.empty())
        return failed_at_start("the file is compressed (" + std::string(format) + ")",
                               "text: unpack it first");
    if (is_utf16(text)) return failed_at_start("the text is UTF-16", "ASCII or UTF-8");
    return bvh_reader(without_byte_order_mark(text), options).read();
}

read_result read_bvh_file(const std::string& path, const read_options& options) {
    const bool is_standard_input = path == "-";
    const auto close = [](std::FILE* f) { std::fclose(f); };
    const std::unique_ptr<std::FILE, decltype(close)> opened(
        is_standard_input ? nullptr : std::fopen(path.c_str(), "rb"), close);
    std::FILE* const file = is_standard_input ? stdin : opened.get();
    if (!file) return unreadable("open the file", errno);

    std::string text;
    std::array<char, 65536> block;
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file)) {
        if (count > options.max_bytes - text.size()) return too_large(options.max_bytes);
        text.append(block.data(), count);
    }
    if (std::ferror(file)) return unreadable("read the file", errno);
    return read_bvh(text, options);
}

}  // namespace swivel::clip
