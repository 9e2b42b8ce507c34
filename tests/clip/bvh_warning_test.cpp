// What the BVH reader takes with a warning, and what it salvages.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/bvh_text.hpp"
#include "swivel/clip/read.hpp"

namespace swivel::clip {
namespace {

std::vector<std::string> shown(const std::vector<diagnostic>& warnings) {
    std::vector<std::string> lines;
    for (const diagnostic& w : warnings) lines.push_back(swivel::clip::shown(w));
    return lines;
}

// Reads with these warnings, and when strict not at all, with the first of them as the error.
clip read_with_warnings(std::string_view text, const std::vector<std::string>& warnings) {
    read_result r = read_bvh(text);
    EXPECT_TRUE(r) << swivel::clip::shown(r.error) << "\n" << text;
    EXPECT_EQ(shown(r.warnings), warnings) << text;
    const read_result strict = read_bvh(text, {.strict = true});
    EXPECT_FALSE(strict) << text;
    EXPECT_TRUE(strict.warnings.empty());
    EXPECT_FALSE(read_bvh(text, {.strict = true, .salvage = true})) << text;
    if (!r || r.warnings.empty()) return {};
    EXPECT_EQ(strict.error.line, r.warnings[0].line);
    EXPECT_EQ(strict.error.column, r.warnings[0].column);
    EXPECT_EQ(strict.error.expected, r.warnings[0].expected);
    EXPECT_TRUE(r.warnings[0].what.starts_with(strict.error.what + "; ")) << strict.error.what;
    EXPECT_TRUE(survives_round_trip(*r.value));
    return std::move(*r.value);
}

clip valid_clip() { return *read_bvh(valid_bvh).value; }

TEST(BvhWarning, EndMarksAndNulPaddingAfterTheLastRow) {
    using namespace std::string_view_literals;
    const std::string end = " after the last row; taken as the end of the text, expected the end of the text";
    const std::string bare = valid_bvh.substr(0, valid_bvh.size() - 1);
    for (const std::string_view tail :
         {"\x1a"sv, "\x1a\n"sv, "\x1a\r\n"sv, "\x1a\x1a\x1a"sv, "\x1a\n\n \t\x1a"sv, "\x1a\0\0"sv}) {
        EXPECT_TRUE(
            same(read_with_warnings(valid_bvh + std::string(tail), {"21:1: '\\x1a'" + end}), valid_clip()));
        EXPECT_TRUE(
            same(read_with_warnings(bare + std::string(tail), {"20:22: '\\x1a'" + end}), valid_clip()));
    }
    for (const std::size_t count : {1u, 511u, 100'000u}) {
        const std::string padding(count, '\0');
        EXPECT_TRUE(same(read_with_warnings(valid_bvh + padding, {"21:1: '\\x00'" + end}), valid_clip()));
        EXPECT_TRUE(same(read_with_warnings(bare + padding + "\n", {"20:22: '\\x00'" + end}), valid_clip()));
    }
    EXPECT_TRUE(
        same(read_with_warnings(with_every(valid_bvh, '\n', "\r\n") + "\n \x1a", {"22:2: '\\x1a'" + end}),
             valid_clip()));
}

TEST(BvhWarning, EndMarksHideNoOtherError) {
    const read_result cut = read_bvh(with("Frames: 2", "Frames: 3") + "\x1a");
    ASSERT_FALSE(cut);
    EXPECT_EQ(swivel::clip::shown(cut.error), "21:1: 2 rows of motion, expected 3, as Frames says");
    const read_result open = read_bvh(valid_bvh.substr(0, valid_bvh.find("MOTION")) + std::string(9, '\0'));
    ASSERT_FALSE(open);
    EXPECT_EQ(swivel::clip::shown(open.error), "16:1: the text ends here, expected ROOT or MOTION");
}

TEST(BvhWarning, JointWithoutChannelsDoesNotMove) {
    const std::string rows = "3 4 5 6\n1 96 1 7 8 9 10 11 12";
    const std::string text =
        with(with("\t\tCHANNELS 3 Xrotation Yrotation Zrotation\n", ""), rows, "3\n1 96 1 7 8 9");
    const clip expected =
        *read_bvh(with(with("3 Xrotation Yrotation Zrotation", "0"), rows, "3\n1 96 1 7 8 9")).value;
    const std::string what = " has no CHANNELS; it does not move, expected CHANNELS first";
    EXPECT_TRUE(same(read_with_warnings(text, {"9:3: joint 'Leg'" + what}), expected));

    const std::string rest = "\nMOTION Frames: 1 Frame Time: 1\n5\n";
    const clip root = read_with_warnings(
        "HIERARCHY ROOT a {OFFSET 0 0 0\nJOINT b {OFFSET 0 0 0 CHANNELS 1 Xrotation}}" + rest,
        {"2:1: joint 'a'" + what});
    EXPECT_EQ(root.skeleton.joints[1].first_channel, 0u);
    const clip leaf = read_with_warnings(
        "HIERARCHY ROOT a {OFFSET 0 0 0 CHANNELS 1 Xrotation\nJOINT b {OFFSET 0 0 0}\nJOINT c {OFFSET 1 0 0 "
        "}}" +
            rest,
        {"2:22: joint 'b'" + what, "3:23: joint 'c'" + what});
    EXPECT_TRUE(leaf.skeleton.joints[1].channels.empty());
    EXPECT_EQ(leaf.values, std::vector<double>{5});
}

TEST(BvhWarning, EndSiteAsOneWord) {
    const std::string what = " is one word; read as two, expected End Site";
    EXPECT_TRUE(
        same(read_with_warnings(with("End Site", "EndSite"), {"10:3: 'EndSite'" + what}), valid_clip()));
    EXPECT_TRUE(same(read_with_warnings(with("End Site\n\t\t{", "ENDSITE{"), {"10:3: 'ENDSITE'" + what}),
                     valid_clip()));
    EXPECT_EQ(read_with_warnings(with("End Site", "endsite Toe"), {"10:3: 'endsite'" + what})
                  .skeleton.joints[1]
                  .end->name,
              "Toe");
}

TEST(BvhWarning, ColumnsOfEndSitesAreLeftOut) {
    const std::string what = "CHANNELS in an End Site; they are left out, expected OFFSET alone";
    const std::string channels = "CHANNELS 2 Zrotation Xposition";
    const std::string after = with("OFFSET 0 -40 0", "OFFSET 0 -40 0\n" + channels);
    const std::string before = with("OFFSET 0 -40 0", channels + "\nOFFSET 0 -40 0");
    const auto with_columns = [](const std::string& text) {
        return with(with(text, "4 5 6\n", "4 5 6 77 78\n"), "11 12\n", "11 12 79 80\n");
    };
    EXPECT_TRUE(same(read_with_warnings(with_columns(after), {"13:1: " + what}), valid_clip()));
    EXPECT_TRUE(same(read_with_warnings(with_columns(before), {"12:4: " + what}), valid_clip()));
    EXPECT_TRUE(
        same(read_with_warnings(with("OFFSET 0 -40 0", "OFFSET 0 -40 0 CHANNELS 0"), {"12:19: " + what}),
             valid_clip()));

    const std::string wrapped = with(with_columns(after), "0 95 0 1", "0 95 0\n1");
    EXPECT_TRUE(same(read_with_warnings(wrapped, {"13:1: " + what}), valid_clip()));

    const clip c = read_with_warnings(
        "HIERARCHY\nROOT a {OFFSET 0 0 0 CHANNELS 1 Xrotation\n"
        "End Site {OFFSET 1 0 0 CHANNELS 1 Yrotation}\n"
        "JOINT b {OFFSET 0 0 0 CHANNELS 2 Zrotation Xrotation\nEnd Site {OFFSET 1 0 0\nCHANNELS 3 Xrotation "
        "Yrotation Zrotation}}\n"
        "JOINT c {OFFSET 0 0 0 CHANNELS 1 Yrotation}}\n"
        "MOTION Frames: 2 Frame Time: 1\n1 0 2 3 0 0 0 4\n5 0 6 7 0 0 0 8\n",
        {"3:24: " + what, "6:1: " + what});
    EXPECT_EQ(c.values, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(c.skeleton.joints[2].first_channel, 3u);
}

TEST(BvhWarning, RowsWithoutColumnsForEndSites) {
    const std::string text =
        with("OFFSET 0 -40 0", "OFFSET 0 -40 0 CHANNELS 3 Zrotation Xrotation Yrotation");
    EXPECT_TRUE(same(read_with_warnings(
                         text, {"12:19: CHANNELS in an End Site; they are left out, expected OFFSET alone",
                                "19:1: row of 9 values; the rows have none for the End Sites, expected 12"}),
                     valid_clip()));
}

TEST(BvhWarning, ListOfOneKindIsBounded) {
    std::string text = "HIERARCHY\nROOT r {OFFSET 0 0 0 CHANNELS 1 Xrotation\n";
    for (int j = 0; j < 5000; ++j)
        text += "JOINT " + std::to_string(j) + " {OFFSET 0 0 0 EndSite {OFFSET 0 0 0 CHANNELS 0}}\n";
    text += "}\nMOTION Frames: 1 Frame Time: 1\n1\n2\n\x1a";
    const read_result r = read_bvh(text);
    ASSERT_TRUE(r) << swivel::clip::shown(r.error);
    ASSERT_EQ(r.warnings.size(), 102u);
    EXPECT_EQ(r.warnings_left_out, 14'900u);
    EXPECT_EQ(r.warnings[99].line, 36u);
    EXPECT_EQ(r.warnings[100].what, "2 rows of motion; those from here on are left out");
    EXPECT_EQ(r.warnings[101].what, "'\\x1a' after the last row; taken as the end of the text");
    EXPECT_EQ(read_bvh(valid_bvh).warnings_left_out, 0u);
}

// Three rows announced, of which the first `frames` come out, and this warning.
void expect_salvage(const std::string& text, std::size_t frames, const std::string& warning) {
    SCOPED_TRACE(text.substr(text.find("Frame Time")));
    EXPECT_FALSE(read_bvh(text));
    EXPECT_FALSE(read_bvh(text, {.strict = true, .salvage = true}));
    const read_result r = read_bvh(text, {.salvage = true});
    ASSERT_TRUE(r) << swivel::clip::shown(r.error);
    EXPECT_EQ(shown(r.warnings), std::vector{warning});
    clip expected = valid_clip();
    expected.frames = frames;
    expected.values.resize(9 * frames);
    EXPECT_TRUE(same(*r.value, expected));
    EXPECT_TRUE(survives_round_trip(*r.value));
}

TEST(BvhSalvage, KeepsTheWholeRowsOfAClipThatWasCutOff) {
    const std::string three = with("Frames: 2", "Frames: 3");
    expect_salvage(three, 2, "21:1: 2 rows of motion; 2 of 3 rows read, expected 3, as Frames says");
    expect_salvage(three + "\n \n", 2,
                   "23:1: 2 rows of motion; 2 of 3 rows read, expected 3, as Frames says");
    expect_salvage(three + "1 2 3", 2, "21:6: row too short: 3 values; 2 of 3 rows read, expected 9");
    expect_salvage(three + "1 2 3 4 5 6 7 8 -", 2,
                   "21:17: '-' is not a number; 2 of 3 rows read, expected a number");
    expect_salvage(three + "1 2.5e", 2, "21:3: '2.5e' is not a number; 2 of 3 rows read, expected a number");
    expect_salvage(with("11 12\n", "11"), 1, "20:19: row too short: 8 values; 1 of 2 rows read, expected 9");
}

TEST(BvhSalvage, LeavesOutARowWhoseLastNumberMayBeCut) {
    const std::string three = with("Frames: 2", "Frames: 3");
    const std::string cut = three.substr(0, three.size() - 2);
    expect_salvage(cut, 1, "20:21: 2 rows of motion; 1 of 3 rows read, expected 3, as Frames says");
    expect_salvage(with(three, "6\n1 96 1 7 8 9 10 11 12\n", "6 "), 1,
                   "19:20: 1 row of motion; 1 of 3 rows read, expected 3, as Frames says");
}

TEST(BvhSalvage, StopsAtTheFirstRowThatIsDamaged) {
    expect_salvage(with("7 8", "7 nan 8"), 1,
                   "20:10: 'nan' is not finite; 1 of 2 rows read, expected a number");
    expect_salvage(with("7 8", std::string_view("7\0\0\0 8", 6)), 1,
                   "20:8: '7\\x00\\x00\\x00' is not a number; 1 of 2 rows read, expected a number");
    expect_salvage(with("7 8", "7 8 8"), 1, "20:22: row too long: 10 values; 1 of 2 rows read, expected 9");
    expect_salvage(with("11 12\n", "11 OFFSET 0 5 0\n}\nMOTION\n"), 1,
                   "20:20: 'OFFSET' is not a number; 1 of 2 rows read, expected a number");
    expect_salvage(valid_bvh + "1 2 3", 2, "21:6: row too short: 3 values; 2 of 2 rows read, expected 9");
    expect_salvage(
        valid_bvh + "MOTION", 2,
        "21:1: unexpected 'MOTION' after the last row; 2 of 2 rows read, expected the end of the text");
}

TEST(BvhSalvage, WhereThePaddingOfACutIsNulBothAreSaid) {
    const read_result r = read_bvh(with("11 12\n", "11" + std::string(64, '\0')), {.salvage = true});
    ASSERT_TRUE(r) << swivel::clip::shown(r.error);
    EXPECT_EQ(r.value->frames, 1u);
    EXPECT_EQ(
        shown(r.warnings),
        (std::vector<std::string>{"20:19: row too short: 8 values; 1 of 2 rows read, expected 9",
                                  "20:19: '\\x00' after the last row; taken as the end of the text, expected "
                                  "the end of the text"}));
}

TEST(BvhSalvage, LeavesOutTheColumnsOfEndSitesToo) {
    const std::string text =
        with(with("OFFSET 0 -40 0", "OFFSET 0 -40 0 CHANNELS 1 Xrotation"), "4 5 6\n", "4 5 6 9\n");
    const read_result r = read_bvh(text, {.salvage = true});
    ASSERT_TRUE(r) << swivel::clip::shown(r.error);
    EXPECT_EQ(r.value->values, (std::vector<double>{0, 95, 0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(r.warnings.size(), 2u);
}

TEST(BvhSalvage, NothingToSalvageIsTheErrorItWas) {
    for (const std::string& text :
         {with("0 95 0", "0 95 x"), with("\n1 96 1 7 8 9 10 11 12\n", ""), with("Frame Time", "Frame Tim"),
          with("OFFSET 0 95 0", "OFFSET 0 95"), valid_bvh.substr(0, valid_bvh.find("0 95 0 1"))}) {
        const read_result plain = read_bvh(text);
        const read_result salvaged = read_bvh(text, {.salvage = true});
        ASSERT_FALSE(plain);
        ASSERT_FALSE(salvaged) << text;
        EXPECT_EQ(plain.error, salvaged.error);
    }
}

TEST(BvhSalvage, EveryTruncationGivesTheRowsThatWereWholeOrAnError) {
    std::string text = with("Frames: 2", "Frames: 40");
    std::vector<std::size_t> ends = {text.find("0 95 0 1")};  // where row i is complete
    ends.push_back(text.find("\n1 96") + 1);
    ends.push_back(text.size());
    for (int row = 2; row < 40; ++row) {
        text += "1 2 3 4 5 6 7.25 8 -" + std::to_string(row) + ".5e-3\n";
        ends.push_back(text.size());
    }
    const clip whole = *read_bvh(text).value;
    for (std::size_t length = 0; length < text.size() - 1; ++length) {
        const read_result r = read_bvh(text.substr(0, length), {.salvage = true});
        std::size_t rows = 0;
        while (rows < 40 && ends[rows + 1] <= length) ++rows;
        if (rows == 0) {
            EXPECT_FALSE(r) << length;
            continue;
        }
        if (rows == 39 && r.warnings.empty()) continue;  // part of the last number of all
        ASSERT_TRUE(r) << length;
        ASSERT_EQ(r.value->frames, rows) << length;
        ASSERT_EQ(r.warnings.size(), 1u);
        EXPECT_NE(r.warnings[0].what.find(std::to_string(rows) + " of 40 rows read"), std::string::npos);
        EXPECT_TRUE(std::equal(r.value->values.begin(), r.value->values.end(), whole.values.begin()));
    }
}

TEST(BvhSalvage, ChangesNothingWhereNothingIsMissing) {
    const read_result r = read_bvh(valid_bvh, {.salvage = true});
    ASSERT_TRUE(r);
    EXPECT_TRUE(r.warnings.empty());
    EXPECT_TRUE(same(*r.value, valid_clip()));
    EXPECT_TRUE(read_bvh(valid_bvh.substr(0, valid_bvh.size() - 1), {.salvage = true}).warnings.empty());
}

}  // namespace
}  // namespace swivel::clip
