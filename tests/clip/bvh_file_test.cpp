// BVH files from the disk and from a generator: known clips and cases, random clips, truncations, mutations.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "support/bvh_text.hpp"
#include "swivel/clip/read.hpp"

namespace swivel::clip {
namespace {

namespace fs = std::filesystem;

const fs::path shared = SWIVEL_SHARED_DIR;

class temporary_file {
public:
    explicit temporary_file(std::string_view content)
        : path_(fs::temp_directory_path() /
                ("swivel_bvh_" + std::to_string(std::random_device()()) + ".bvh")) {
        std::ofstream(path_, std::ios::binary) << content;
    }
    temporary_file(const temporary_file&) = delete;
    temporary_file& operator=(const temporary_file&) = delete;
    ~temporary_file() { fs::remove(path_); }
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    fs::path path_;
};

TEST(BvhFile, ReadsTheFileAtAPath) {
    const temporary_file file(valid_bvh);
    const read_result r = read_bvh_file(file.path());
    ASSERT_TRUE(r) << shown(r.error);
    EXPECT_TRUE(same(*r.value, *read_bvh(valid_bvh).value));
}

TEST(BvhFile, ReadsStandardInput) {
    const temporary_file file(valid_bvh);
    ASSERT_NE(std::freopen(file.path().c_str(), "rb", stdin), nullptr);
    const read_result r = read_bvh_file("-");
    ASSERT_TRUE(r) << shown(r.error);
    EXPECT_TRUE(same(*r.value, *read_bvh(valid_bvh).value));
}

TEST(BvhFile, WhatCannotBeReadIsAnErrorAtLineZero) {
    const read_result missing =
        read_bvh_file((fs::temp_directory_path() / "swivel" / "no" / "such.bvh").string());
    EXPECT_FALSE(missing);
    EXPECT_EQ(missing.error.line, 0u);
    EXPECT_EQ(missing.error.what, "cannot open the file: No such file or directory");
    const read_result folder = read_bvh_file(fs::temp_directory_path().string());
    EXPECT_FALSE(folder);
    EXPECT_EQ(folder.error.line, 0u);
}

TEST(BvhFile, TooLargeIsRefusedBeforeItIsRead) {
    const temporary_file file(valid_bvh);
    EXPECT_TRUE(read_bvh_file(file.path(), {.max_bytes = valid_bvh.size()}));
    const read_result r = read_bvh_file(file.path(), {.max_bytes = valid_bvh.size() - 1});
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error.what, "the file is too large");
    if (fs::exists("/dev/zero")) {
        EXPECT_EQ(read_bvh_file("/dev/zero", {.max_bytes = 1'000'000}).error.what, "the file is too large");
    }
}

struct known_clip {
    const char* file;
    std::size_t joints, frames, channels, end_sites, warnings;
};

TEST(BvhFile, MotionCaptureClipsSurviveRoundTripInBits) {
    const known_clip clips[] = {{"boxing_toes_zxy_extra_row.bvh", 21, 3069, 66, 5, 1},
                                {"bvhtoolbox_walk01_zxy_sci.bvh", 19, 101, 60, 5, 0},
                                {"cmu_01_06_long_yzx.bvh", 31, 5133, 96, 7, 0},
                                {"cmu_131_01_mixed_order_mixed_eol.bvh", 31, 994, 96, 7, 0},
                                {"fair1_dab_xyz_yxz.bvh", 27, 339, 84, 7, 0},
                                {"fairmotion_sinusoidal_no_endsite.bvh", 4, 120, 15, 0, 0},
                                {"makehuman_benchmark_pos_on_134_joints.bvh", 163, 1, 891, 49, 0},
                                {"makehuman_zombiewalk.bvh", 75, 31, 228, 16, 0},
                                {"pybvh_full_precision_frame_time.bvh", 2, 3, 9, 1, 0},
                                {"pybvh_rotation_first_root.bvh", 4, 4, 15, 2, 0},
                                {"rokoko_jesse_dance_yxz.bvh", 60, 1007, 183, 13, 0}};
    const fs::path folder = shared / "mocap" / "bvh";
    if (!fs::exists(folder))
        GTEST_SKIP() << "no folder " << folder << ": the motion capture clips are not tested";
    for (const known_clip& known : clips) {
        SCOPED_TRACE(known.file);
        const read_result r = read_bvh_file((folder / known.file).string());
        ASSERT_TRUE(r) << shown(r.error);
        std::size_t end_sites = 0;
        for (const joint& j : r.value->skeleton.joints) end_sites += j.end.has_value();
        EXPECT_EQ(r.value->skeleton.joints.size(), known.joints);
        EXPECT_EQ(r.value->frames, known.frames);
        EXPECT_EQ(r.value->skeleton.channel_count, known.channels);
        EXPECT_EQ(end_sites, known.end_sites);
        EXPECT_EQ(r.warnings.size(), known.warnings);
        EXPECT_TRUE(survives_round_trip(*r.value));
    }
}

struct known_case {
    const char* file;
    std::size_t line, column;  // of the error; 0 for a clip
};

TEST(BvhFile, OddAndBrokenCasesHaveTheExpectedVerdict) {
    const known_case cases[] = {{"00_ok.bvh", 0, 0},
                                {"02_no_hierarchy.bvh", 1, 1},
                                {"04_short_row.bvh", 20, 19},
                                {"06_fewer_rows_than_frames.bvh", 21, 1},
                                {"08_nan.bvh", 19, 7},
                                {"10_neg_frames.bvh", 17, 9},
                                {"12_zero_frametime.bvh", 18, 13},
                                {"14_unclosed_brace.bvh", 15, 1},
                                {"16_channels_count_mismatch.bvh", 9, 14},
                                {"18_duplicate_channel.bvh", 9, 26},
                                {"20_duplicate_names.bvh", 6, 9},
                                {"22_zero_channels.bvh", 0, 0},
                                {"24_crlf.bvh", 0, 0},
                                {"26_bare_cr.bvh", 0, 0},
                                {"28_lower_channels.bvh", 0, 0},
                                {"30_sci.bvh", 0, 0},
                                {"32_end_site_named.bvh", 0, 0},
                                {"34_two_roots.bvh", 0, 0},
                                {"36_frametime_tab.bvh", 0, 0},
                                {"38_huge_channels.bvh", 9, 14},
                                {"42_truncated_mid_number.bvh", 20, 15},
                                {"44_root_no_position.bvh", 0, 0},
                                {"46_gimbal.bvh", 0, 0}};
    const fs::path folder = shared / "bvh-cases";
    if (!fs::exists(folder)) GTEST_SKIP() << "no folder " << folder << ": its cases are not tested";
    for (const known_case& known : cases) {
        SCOPED_TRACE(known.file);
        const read_result r = read_bvh_file((folder / known.file).string());
        EXPECT_EQ(r.error.line, known.line) << shown(r.error);
        EXPECT_EQ(r.error.column, known.column) << shown(r.error);
        EXPECT_EQ(static_cast<bool>(r), known.line == 0);
        EXPECT_TRUE(r.warnings.empty());
        if (r) {
            EXPECT_TRUE(survives_round_trip(*r.value));
        }
    }
}

class generator {
public:
    explicit generator(std::uint64_t seed) : engine_(seed) {}

    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(engine_() % limit); }

    // All finite doubles by their bits, with the awkward ones more often than they would come.
    double number() {
        constexpr double awkward[] = {
            0.0, -0.0, 0.1, 4.9e-324, -1.7976931348623157e308, 2.2250738585072014e-308, 360};
        if (below(4) == 0) return awkward[below(std::size(awkward))];
        for (;;)
            if (const double d = std::bit_cast<double>(engine_()); std::isfinite(d)) return d;
    }

    std::string name() {
        const std::string_view parts[] = {"Left", "arm", ".", ":",      "_",       "\xc3\xa9",
                                          " ",    "\t",  "7", "OFFSET", "End Site"};
        std::string text = "j";
        for (std::size_t part = below(5); part > 0; --part) text += parts[below(std::size(parts))];
        return text + std::to_string(engine_());
    }

    clip next() {
        clip c;
        std::int32_t parent = -1;
        for (std::size_t count = 1 + below(12); count > 0; --count) {
            joint j;
            j.name = name();
            // The new joint goes under the last one or one of its ancestors, which keeps the depth-first
            // order.
            while (parent >= 0 && below(3) == 0)
                parent = c.skeleton.joints[static_cast<std::size_t>(parent)].parent;
            j.parent = parent;
            j.offset = {number(), number(), number()};
            for (std::size_t draws = below(10); draws > 0; --draws)
                j.channels.add(static_cast<channel>(below(6)));
            if (below(3) == 0) j.end = end_site{{number(), number(), number()}, below(2) == 0 ? name() : ""};
            parent = static_cast<std::int32_t>(c.skeleton.joints.size());
            c.skeleton.joints.push_back(std::move(j));
        }
        number_channels(c.skeleton);
        do c.frame_time = std::fabs(number());
        while (c.frame_time == 0);
        c.frames = below(6);
        for (std::size_t i = c.frames * c.skeleton.channel_count; i > 0; --i) c.values.push_back(number());
        return c;
    }

private:
    std::mt19937_64 engine_;
};

TEST(BvhProperty, RandomClipsSurviveRoundTripInBits) {
    generator random(1);
    for (int i = 0; i < 3000; ++i) ASSERT_TRUE(survives_round_trip(random.next())) << "clip " << i;
}

// The lengths of the lines, counted in another way than the reader's.
std::vector<std::size_t> line_lengths(std::string_view text) {
    std::vector<std::size_t> lengths(1, 0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n"))
            lengths.push_back(0);
        else if (text[i] != '\r')
            ++lengths.back();
    }
    return lengths;
}

testing::AssertionResult is_clip_or_error_inside(std::string_view text) {
    const read_result r = read_bvh(text);
    if (r) return survives_round_trip(*r.value);
    const std::vector<std::size_t> lengths = line_lengths(text);
    const diagnostic& e = r.error;
    if (e.line < 1 || e.line > lengths.size() || e.column < 1 || e.column > lengths[e.line - 1] + 1)
        return testing::AssertionFailure() << shown(e) << " is not inside the text:\n" << text;
    if (e.what.empty() || e.expected.empty())
        return testing::AssertionFailure() << shown(e) << " says nothing";
    return testing::AssertionSuccess();
}

TEST(BvhProperty, EveryTruncationIsAClipOrAnErrorInsideTheText) {
    for (const std::string& text :
         {valid_bvh, with_every(valid_bvh, '\n', "\r\n"), with_every(valid_bvh, '\n', "\r")})
        for (std::size_t length = 0; length <= text.size(); ++length)
            ASSERT_TRUE(is_clip_or_error_inside(text.substr(0, length))) << length;
}

TEST(BvhProperty, ATruncationIsReadOnlyWhenItLosesPartOfTheLastNumberAtMost) {
    for (std::size_t length = 0; length < valid_bvh.size() - 2; ++length)
        EXPECT_FALSE(read_bvh(valid_bvh.substr(0, length))) << length;
}

TEST(BvhProperty, EveryByteChangedToEachAwkwardByteIsAClipOrAnErrorInsideTheText) {
    constexpr std::string_view awkward("\0\t\n\v\r {}:-+.,eE019xX\x7f\x80\xff", 23);
    for (std::size_t at = 0; at < valid_bvh.size(); ++at)
        for (const char replacement : awkward) {
            std::string text = valid_bvh;
            text[at] = replacement;
            ASSERT_TRUE(is_clip_or_error_inside(text)) << at;
        }
}

TEST(BvhProperty, RandomMutationsAreClipsOrErrorsInsideTheText) {
    generator random(2);
    for (int i = 0; i < 20000; ++i) {
        std::string text = valid_bvh;
        for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) {
            const std::size_t at = random.below(text.size());
            const char byte = static_cast<char>(random.below(256));
            switch (random.below(4)) {
                case 0:
                    text[at] = byte;
                    break;
                case 1:
                    text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), byte);
                    break;
                case 2:
                    text.erase(at, 1 + random.below(8));
                    break;
                default:
                    text += text.substr(at, random.below(30));
                    break;
            }
            if (text.empty()) text = valid_bvh;
        }
        ASSERT_TRUE(is_clip_or_error_inside(text)) << "mutation " << i;
    }
}

}  // namespace
}  // namespace swivel::clip
