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

std::string counted(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

// Every member function that returns bool returns false after the error has been noted.
class bvh_reader {
public:
    bvh_reader(std::string_view text, const read_options& options) noexcept : in_(text), options_(options) {}

    read_result read() {
        read_result result;
        if (read_hierarchy() && read_motion_header() && read_rows())
            result.value = std::move(clip_);
        else
            result.error = std::move(error_);
        result.warnings = std::move(warnings_);
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
    bool joint_is_complete(const token& next);
    bool read_motion_header();
    bool read_rows();
    bool note_surplus_rows(std::size_t rows, const token& first);

    bool take_keyword(std::string_view keyword, std::string_view expected);

    bool fail(const token& at, std::string what, std::string_view expected) {
        error_ = {at.line, at.column, std::move(what), std::string(expected)};
        return false;
    }

    bool fail_unexpected(const token& t, std::string_view expected) {
        return fail(t, t.text.empty() ? "the text ends here" : "unexpected " + quoted(t.text), expected);
    }

    [[nodiscard]] joint& current() noexcept {
        return clip_.skeleton.joints[static_cast<std::size_t>(current_)];
    }
    [[nodiscard]] std::string current_name() { return "joint " + quoted(current().name); }

    text_cursor in_;
    read_options options_;
    clip clip_;
    diagnostic error_;
    std::vector<diagnostic> warnings_;
    std::map<std::string_view, std::size_t> line_of_name_;

    // The innermost open joint. Its OFFSET and CHANNELS stand before its first child, so that a joint to
    // which the reader comes back has both.
    std::int32_t current_ = -1;
    bool has_offset_ = false;
    bool has_channels_ = false;
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
        if (has_channels_) return fail(keyword, current_name() + " has a second CHANNELS", "one CHANNELS");
        has_channels_ = true;
        return read_channels(keyword, current().channels);
    }
    if (is(keyword, "JOINT")) return joint_is_complete(keyword) && open_joint(keyword);
    if (is(keyword, "End")) return joint_is_complete(keyword) && read_end_site(keyword);
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
    has_offset_ = has_channels_ = false;

    const token brace = in_.take(braces);
    return brace.text == "{" || fail_unexpected(brace, "'{' after the name of the joint");
}

void bvh_reader::close_joint() noexcept {
    current_ = current().parent;
    has_offset_ = has_channels_ = true;
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
    if (!has_channels_) return fail(next, current_name() + " has no CHANNELS", "CHANNELS first");
    return true;
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
    return true;
}

bool bvh_reader::read_end_site(const token& keyword) {
    if (!take_keyword("Site", "Site after End")) return false;
    if (current().end) return fail(keyword, current_name() + " has a second End Site", "one End Site");
    const token name = in_.take_rest_of_line('{');
    if (!check_name(name)) return false;
    end_site end{{}, std::string(name.text)};

    if (const token t = in_.take(braces); t.text != "{") return fail_unexpected(t, "'{' after End Site");
    const token t = in_.take(braces);
    if (t.text == "}") return fail(t, "the End Site has no OFFSET", "OFFSET first");
    if (!is(t, "OFFSET")) return fail_unexpected(t, "OFFSET in the End Site");
    if (!read_offset(t, end.offset)) return false;
    if (const token close = in_.take(braces); close.text != "}") {
        if (is(close, "OFFSET")) return fail(close, "the End Site has a second OFFSET", "one OFFSET");
        return fail_unexpected(close, "'}' after the OFFSET of the End Site");
    }
    current().end = std::move(end);
    return true;
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

bool bvh_reader::read_rows() {
    const std::size_t width = clip_.skeleton.channel_count;
    std::vector<double>& values = clip_.values;
    // A value takes two bytes of text at least, so the product of the counts is bounded by what is there.
    values.reserve(std::min(clip_.frames * width, in_.remaining() / 2 + 1));

    std::size_t rows = 0;
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
                if (rows >= clip_.frames && filled == 0)
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
            if (rows < clip_.frames)
                values.push_back(number.value);
            else if (first_surplus.text.empty())
                first_surplus = t;
            last = t;
        }
        if (filled_before == 0) first_line_end = {{}, last.line, last.column + last.text.size()};
        if (filled == width) {
            ++rows;
            filled = 0;
        }
    }
    if (filled > 0) return fail_short_row(filled);
    if (rows < clip_.frames && width > 0)
        return fail(in_.peek({}), counted(rows, "row") + " of motion",
                    std::to_string(clip_.frames) + ", as Frames says");
    return rows <= clip_.frames || note_surplus_rows(rows, first_surplus);
}

bool bvh_reader::note_surplus_rows(std::size_t rows, const token& first) {
    const std::string what =
        counted(rows, "row") + " of motion" + (options_.strict ? "" : "; those from here on are left out");
    const std::string expected = std::to_string(clip_.frames) + ", as Frames says";
    if (options_.strict) return fail(first, what, expected);
    warnings_.push_back({first.line, first.column, what, expected});
    return true;
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
    if (is_utf16(text)) {
        read_result result;
        result.error = {1, 1, "the text is UTF-16", "ASCII or UTF-8"};
        return result;
    }
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
