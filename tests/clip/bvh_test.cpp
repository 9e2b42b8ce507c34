// What the BVH reader accepts, and what the writer makes of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sample_clip.hpp"
#include "support/bvh_text.hpp"
#include "swivel/clip/read.hpp"
#include "swivel/clip/write.hpp"

namespace swivel::clip {
namespace {

using enum channel;

clip read_without_warning(std::string_view text) {
    read_result r = read_bvh(text);
    EXPECT_TRUE(r) << shown(r.error);
    EXPECT_TRUE(r.warnings.empty()) << shown(r.warnings[0]);
    if (!r) return {};
    EXPECT_TRUE(survives_round_trip(*r.value));
    return std::move(*r.value);
}

std::vector<channel> channels(const joint& j) { return {j.channels.begin(), j.channels.end()}; }

TEST(Bvh, ReadsHierarchyAndMotion) {
    const clip c = read_without_warning(valid_bvh);
    ASSERT_EQ(c.skeleton.joints.size(), 2u);
    const joint& hips = c.skeleton.joints[0];
    const joint& leg = c.skeleton.joints[1];
    EXPECT_EQ(hips.name, "Hips");
    EXPECT_EQ(hips.parent, -1);
    EXPECT_EQ(hips.offset, (vec3{0, 95, 0}));
    EXPECT_EQ(channels(hips),
              (std::vector{x_position, y_position, z_position, z_rotation, x_rotation, y_rotation}));
    EXPECT_EQ(hips.first_channel, 0u);
    EXPECT_FALSE(hips.end);
    EXPECT_EQ(leg.name, "Leg");
    EXPECT_EQ(leg.parent, 0);
    EXPECT_EQ(leg.offset, (vec3{0, -45, 0}));
    EXPECT_EQ(channels(leg), (std::vector{x_rotation, y_rotation, z_rotation}));
    EXPECT_EQ(leg.first_channel, 6u);
    ASSERT_TRUE(leg.end);
    EXPECT_EQ(*leg.end, (end_site{{0, -40, 0}, ""}));
    EXPECT_EQ(c.skeleton.channel_count, 9u);
    EXPECT_EQ(c.frame_time, 0.01);
    EXPECT_EQ(c.frames, 2u);
    EXPECT_EQ(c.values, (std::vector<double>{0, 95, 0, 1, 2, 3, 4, 5, 6, 1, 96, 1, 7, 8, 9, 10, 11, 12}));
}

TEST(Bvh, WritesWhatItReadInItsOwnForm) { EXPECT_EQ(write_bvh(read_without_warning(valid_bvh)), valid_bvh); }

TEST(Bvh, KeepsAllSixRotationOrdersMixedInOneFile) {
    const std::vector<std::vector<channel>> orders = {
        {x_rotation, y_rotation, z_rotation}, {x_rotation, z_rotation, y_rotation},
        {y_rotation, x_rotation, z_rotation}, {y_rotation, z_rotation, x_rotation},
        {z_rotation, x_rotation, y_rotation}, {z_rotation, y_rotation, x_rotation}};
    const clip c = read_without_warning(
        "HIERARCHY\n"
        "ROOT a {OFFSET 0 0 0 CHANNELS 3 Xrotation Yrotation Zrotation\n"
        "JOINT b {OFFSET 0 1 0 CHANNELS 3 Xrotation Zrotation Yrotation\n"
        "JOINT c {OFFSET 0 1 0 CHANNELS 3 Yrotation Xrotation Zrotation\n"
        "JOINT d {OFFSET 0 1 0 CHANNELS 3 Yrotation Zrotation Xrotation\n"
        "JOINT e {OFFSET 0 1 0 CHANNELS 3 Zrotation Xrotation Yrotation\n"
        "JOINT f {OFFSET 0 1 0 CHANNELS 3 Zrotation Yrotation Xrotation}}}}}}\n"
        "MOTION Frames: 0 Frame Time: 1");
    ASSERT_EQ(c.skeleton.joints.size(), orders.size());
    for (std::size_t j = 0; j < orders.size(); ++j) EXPECT_EQ(channels(c.skeleton.joints[j]), orders[j]);
}

TEST(Bvh, PositionAndRotationChannelsInAnyOrderInAnyJoint) {
    const clip c = read_without_warning(
        "HIERARCHY\n"
        "ROOT a {OFFSET 0 0 0 CHANNELS 6 Zrotation Yposition Xrotation Xposition Zposition Yrotation\n"
        "JOINT b {OFFSET 0 1 0 CHANNELS 2 Zposition Xrotation}\n"
        "JOINT c {OFFSET 0 1 0 CHANNELS 1 Yposition}}\n"
        "MOTION Frames: 1 Frame Time: 1\n1 2 3 4 5 6 7 8 9\n");
    const auto& joints = c.skeleton.joints;
    EXPECT_EQ(channels(joints[0]),
              (std::vector{z_rotation, y_position, x_rotation, x_position, z_position, y_rotation}));
    EXPECT_EQ(channels(joints[1]), (std::vector{z_position, x_rotation}));
    EXPECT_EQ(channels(joints[2]), (std::vector{y_position}));
    EXPECT_EQ(joints[2].first_channel, 8u);
}

TEST(Bvh, JointWithoutChannels) {
    const clip c = read_without_warning(with(with("3 Xrotation Yrotation Zrotation", "0"),
                                             "3 4 5 6\n1 96 1 7 8 9 10 11 12", "3\n1 96 1 7 8 9"));
    EXPECT_TRUE(c.skeleton.joints[1].channels.empty());
    EXPECT_EQ(c.skeleton.channel_count, 6u);
}

TEST(Bvh, NoChannelsAtAllTakesFramesAsItStands) {
    const clip c = read_without_warning(
        "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 } MOTION Frames: 16777216 Frame Time: 1\n\n\n");
    EXPECT_EQ(c.frames, bvh_max_frames);
    EXPECT_TRUE(c.values.empty());
}

TEST(Bvh, RootWithoutPosition) {
    const clip c = read_without_warning(
        "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation }\n"
        "MOTION\nFrames: 1\nFrame Time: 1\n1 2 3\n");
    EXPECT_EQ(c.skeleton.channel_count, 3u);
}

TEST(Bvh, SeveralRootsInTheirOrder) {
    const clip c = read_without_warning(
        "HIERARCHY\nROOT b {OFFSET 0 0 0 CHANNELS 1 Xrotation JOINT c {OFFSET 0 0 0 CHANNELS 0}}\n"
        "ROOT a {OFFSET 1 0 0 CHANNELS 1 Zrotation}\nMOTION\nFrames: 1\nFrame Time: 1\n1 2\n");
    ASSERT_EQ(c.skeleton.joints.size(), 3u);
    EXPECT_EQ(c.skeleton.joints[0].name, "b");
    EXPECT_EQ(c.skeleton.joints[1].parent, 0);
    EXPECT_EQ(c.skeleton.joints[2].name, "a");
    EXPECT_EQ(c.skeleton.joints[2].parent, -1);
}

TEST(Bvh, NameIsTheRestOfTheLineTrimmed) {
    for (const std::string name : {"mixamorig:LeftLeg", "thigh.L", "Left Leg", "a\tb", "Bip01 L Thigh_2",
                                   "OFFSET", "End", "\xe8\x85\xbf", "JOINT", "9", ":", "\"Leg\"", "a  b"}) {
        EXPECT_EQ(read_without_warning(with("Leg\n", name + "\n")).skeleton.joints[1].name, name);
        EXPECT_EQ(read_without_warning(with("Leg\n", " \t" + name + " \t \r\n")).skeleton.joints[1].name,
                  name);
        EXPECT_EQ(read_without_warning(with("Leg\n\t{", name + "{")).skeleton.joints[1].name, name);
    }
}

TEST(Bvh, NameOnTheLineAfterItsKeyword) {
    EXPECT_EQ(read_without_warning(with("JOINT Leg", "JOINT \n\n\tLeft Leg")).skeleton.joints[1].name,
              "Left Leg");
}

TEST(Bvh, NamesThatDifferInCaseAreDifferent) {
    EXPECT_EQ(read_without_warning(with("Leg", "HIPS")).skeleton.joints[1].name, "HIPS");
}

TEST(Bvh, EndSiteWithName) {
    EXPECT_EQ(read_without_warning(with("End Site", "End Site Left Toe ")).skeleton.joints[1].end->name,
              "Left Toe");
    EXPECT_EQ(read_without_warning(with("End Site\n\t\t{", "End Site tip{")).skeleton.joints[1].end->name,
              "tip");
}

TEST(Bvh, EndSitesMayShareANameWithAnything) {
    const clip c = read_without_warning(
        "HIERARCHY\nROOT a {OFFSET 0 0 0 CHANNELS 0\nEnd Site a\n{OFFSET 0 1 0}}\n"
        "ROOT b {OFFSET 0 0 0 CHANNELS 0\nEnd Site a\n{OFFSET 0 1 0}}\nMOTION Frames: 0 Frame Time: 1");
    EXPECT_EQ(c.skeleton.joints[0].end, c.skeleton.joints[1].end);
}

TEST(Bvh, EndSiteMissing) {
    const clip c = read_without_warning(with("\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 -40 0\n\t\t}\n", ""));
    EXPECT_FALSE(c.skeleton.joints[1].end);
}

TEST(Bvh, EndSiteBesideChildren) {
    const std::string end = "End Site\n{\nOFFSET 7 8 9\n}\n";
    const clip before = read_without_warning(with("\tJOINT Leg", end + "\tJOINT Leg"));
    const clip after = read_without_warning(with("}\nMOTION", end + "}\nMOTION"));
    EXPECT_EQ(before.skeleton.joints[0].end->offset, (vec3{7, 8, 9}));
    EXPECT_TRUE(same(before, after));
}

TEST(Bvh, ChannelsBeforeOffset) {
    const clip c =
        read_without_warning(with("\t\tOFFSET 0 -45 0\n\t\tCHANNELS 3 Xrotation Yrotation Zrotation\n",
                                  "CHANNELS 3 Xrotation Yrotation Zrotation OFFSET 0 -45 0\n"));
    EXPECT_TRUE(same(c, read_without_warning(valid_bvh)));
}

TEST(Bvh, LineEndsOfEveryKind) {
    const clip expected = read_without_warning(valid_bvh);
    EXPECT_TRUE(same(read_without_warning(with_every(valid_bvh, '\n', "\r\n")), expected));
    EXPECT_TRUE(same(read_without_warning(with_every(valid_bvh, '\n', "\r")), expected));
    std::string mixed;
    const std::string_view ends[] = {"\r\n", "\n", "\r"};
    std::size_t line = 0;
    for (const char ch : valid_bvh) {
        if (ch == '\n')
            mixed += ends[line++ % 3];
        else
            mixed += ch;
    }
    EXPECT_TRUE(same(read_without_warning(mixed), expected));
}

TEST(Bvh, ByteOrderMark) {
    EXPECT_TRUE(same(read_without_warning("\xef\xbb\xbf" + valid_bvh), read_without_warning(valid_bvh)));
}

TEST(Bvh, BlanksAnywhereBetweenTokens) {
    const clip expected = read_without_warning(valid_bvh);
    EXPECT_TRUE(same(read_without_warning(with_every(valid_bvh, '\n', " \t \n\n  \n")), expected));
    EXPECT_TRUE(same(read_without_warning(with_every(valid_bvh, ' ', "\t")), expected));
    EXPECT_TRUE(same(read_without_warning(with_every(valid_bvh, ' ', "    ")), expected));
    EXPECT_TRUE(same(read_without_warning(" \n\t" + valid_bvh + "\n \t\n\r\n   "), expected));
    EXPECT_TRUE(same(read_without_warning(with("OFFSET 0 95 0", "OFFSET 0\n95\n0")), expected));
    EXPECT_TRUE(same(read_without_warning(with("3 Xrotation Y", "3\nXrotation\nY")), expected));
}

TEST(Bvh, LastLineWithoutEnd) {
    EXPECT_TRUE(same(read_without_warning(valid_bvh.substr(0, valid_bvh.size() - 1)),
                     read_without_warning(valid_bvh)));
}

TEST(Bvh, BracesOnTheLineOfTheName) {
    const std::string text =
        with(with(with("Hips\n{", "Hips {"), "Leg\n\t{", "Leg{"), "Site\n\t\t{", "Site{");
    EXPECT_TRUE(same(read_without_warning(text), read_without_warning(valid_bvh)));
}

TEST(Bvh, HierarchyOnOneLine) {
    const std::size_t motion = valid_bvh.find("MOTION");
    std::string line = with_every(with_every(valid_bvh.substr(0, motion), '\n', " "), '\t', "");
    line = with(with(line, " { OFF", "{OFF"), "} } }", "}}}");
    EXPECT_TRUE(same(read_without_warning(line + valid_bvh.substr(motion)), read_without_warning(valid_bvh)));
}

TEST(Bvh, KeywordsAndChannelNamesInAnyLetterCase) {
    std::string lower = with(with(valid_bvh, "Hips", "H"), "Leg", "L");
    std::string upper = lower;
    const clip expected = read_without_warning(lower);
    for (char& ch : lower)
        if (ch >= 'A' && ch <= 'Z' && ch != 'H' && ch != 'L') ch = static_cast<char>(ch - 'A' + 'a');
    for (char& ch : upper)
        if (ch >= 'a' && ch <= 'z') ch = static_cast<char>(ch - 'a' + 'A');
    EXPECT_TRUE(same(read_without_warning(lower), expected));
    EXPECT_TRUE(same(read_without_warning(upper), expected));
    EXPECT_TRUE(same(read_without_warning(with(valid_bvh, "3 Xrotation", "3 XRotation")),
                     read_without_warning(valid_bvh)));
}

TEST(Bvh, BlanksAroundTheColons) {
    const clip expected = read_without_warning(valid_bvh);
    for (const std::string_view frames :
         {"Frames:2", "Frames:\t2", "Frames : 2", "Frames:\t\t 2", "Frames:\n2", "Frames: +2"})
        EXPECT_TRUE(same(read_without_warning(with("Frames: 2", frames)), expected)) << frames;
    for (const std::string_view time : {"Frame Time:0.01", "Frame Time:\t0.01", "Frame\tTime : 0.01",
                                        "Frame  Time: .01 ", "Frame Time: +1e-2"})
        EXPECT_TRUE(same(read_without_warning(with("Frame Time: 0.01", time)), expected)) << time;
}

TEST(Bvh, FrameTimeKeepsFullPrecision) {
    EXPECT_EQ(read_without_warning(with("0.01", "0.0417083750417")).frame_time, 0.0417083750417);
    EXPECT_EQ(read_without_warning(with("0.01", ".0083333")).frame_time, 0.0083333);
}

TEST(Bvh, NumbersInEveryNotation) {
    const struct {
        std::string_view text;
        double value;
    } cases[] = {{"9.2e-007", 9.2e-7},
                 {".0083333", 0.0083333},
                 {"+5", 5},
                 {"+.5", 0.5},
                 {"5.", 5},
                 {"-.25", -0.25},
                 {"1E3", 1000},
                 {"1e+003", 1000},
                 {"007", 7},
                 {"-0", -0.0},
                 {"-0.0000", -0.0},
                 {"0e999999999999", 0},
                 {"1e-400", 0},
                 {"-1e-400", -0.0},
                 {"-1e-99999999999999999999", -0.0},
                 {"0.000001e-322", 0},
                 {"4.9406564584124654e-324", 4.9406564584124654e-324},
                 {"1.7976931348623157e308", 1.7976931348623157e308},
                 {"2.2250738585072011e-308", 2.2250738585072011e-308},
                 {"0.1", 0.1},
                 {"123456789012345678", 123456789012345678.0},
                 {"0.30000000000000004", 0.30000000000000004}};
    for (const auto& [text, value] : cases) {
        const clip c = read_without_warning(with("96", text));
        ASSERT_EQ(c.values.size(), 18u) << text;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(c.values[10]), std::bit_cast<std::uint64_t>(value)) << text;
    }
}

TEST(Bvh, NumberOfAMillionDigits) {
    EXPECT_EQ(read_without_warning(with("96", std::string(1'000'000, '0') + "96")).values[10], 96);
    EXPECT_EQ(read_without_warning(with("96", "0." + std::string(1'000'000, '0') + "1")).values[10], 0);
    EXPECT_EQ(read_without_warning(with("96", "96." + std::string(1'000'000, '0'))).values[10], 96);
}

TEST(Bvh, RowsWrappedOverLines) {
    const clip expected = read_without_warning(valid_bvh);
    EXPECT_TRUE(
        same(read_without_warning(with("0 95 0 1 2 3 4 5 6", "0 95 0\n1 2 3\n\n 4 5 \r6\t")), expected));
    const std::size_t rows = valid_bvh.find("0 95 0 1");
    const std::string one_value_a_line =
        valid_bvh.substr(0, rows) + with_every(valid_bvh.substr(rows), ' ', "\n");
    EXPECT_TRUE(same(read_without_warning(one_value_a_line), expected));
}

TEST(Bvh, NoFramesIsTheRestPose) {
    const clip c =
        read_without_warning(with(valid_bvh.substr(0, valid_bvh.find("0 95 0 1")), "Frames: 2", "Frames: 0"));
    EXPECT_EQ(c.frames, 0u);
    EXPECT_TRUE(c.values.empty());
    EXPECT_EQ(c.skeleton.joints.size(), 2u);
}

TEST(Bvh, MoreRowsThanFramesIsOneWarningAtTheFirst) {
    const read_result r = read_bvh(with("Frames: 2", "Frames: 1") + "\n  0 0 0 0 0 0 0 0 0\n");
    ASSERT_TRUE(r) << shown(r.error);
    EXPECT_EQ(r.value->frames, 1u);
    EXPECT_EQ(r.value->values.size(), 9u);
    ASSERT_EQ(r.warnings.size(), 1u);
    EXPECT_EQ(shown(r.warnings[0]),
              "20:1: 3 rows of motion; those from here on are left out, expected 1, as Frames says");
}

TEST(Bvh, StrictAcceptsWhatNeedsNoWarning) { EXPECT_TRUE(read_bvh(valid_bvh, {.strict = true})); }

TEST(Bvh, TwoHundredThousandNestedJoints) {
    constexpr std::size_t depth = 200'000;
    std::string text = "HIERARCHY\nROOT 0 {OFFSET 0 1 0 CHANNELS 1 Yrotation\n";
    for (std::size_t j = 1; j < depth; ++j)
        text += "JOINT " + std::to_string(j) + " {OFFSET 0 1 0 CHANNELS 1 Yrotation\n";
    text += std::string(depth, '}') + "\nMOTION\nFrames: 1\nFrame Time: 1\n";
    for (std::size_t j = 0; j < depth; ++j) text += "1 ";
    const clip c = read_without_warning(text);
    ASSERT_EQ(c.skeleton.joints.size(), depth);
    EXPECT_EQ(c.skeleton.joints.back().parent, static_cast<std::int32_t>(depth - 2));
    const std::vector<bone_direction> directions = bone_directions(c.skeleton);
    EXPECT_EQ(directions.back().rule, direction_rule::parent);
    EXPECT_EQ(directions.back().direction, (vec3{0, 1, 0}));
    EXPECT_LT(write_bvh(c).size(), 100 * text.size());
}

TEST(Bvh, TwoHundredThousandNestedJointsLeftOpen) {
    std::string text = "HIERARCHY\nROOT 0 {OFFSET 0 1 0 CHANNELS 0\n";
    for (std::size_t j = 1; j < 200'000; ++j)
        text += "JOINT " + std::to_string(j) + " {OFFSET 0 1 0 CHANNELS 0\n";
    const read_result r = read_bvh(text);
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error.line, 200'002u);
    EXPECT_EQ(r.error.what, "joint '199999' is not closed");
}

TEST(BvhWrite, SampleClipSurvivesRoundTrip) { EXPECT_TRUE(survives_round_trip(make_sample_clip())); }

TEST(BvhWrite, JointsOutOfDepthFirstOrderTakeTheirColumnsAlong) {
    clip c;
    const auto add_joint = [&](std::string name, std::int32_t parent, channel kind) {
        joint j;
        j.name = std::move(name);
        j.parent = parent;
        j.channels.add(kind);
        c.skeleton.joints.push_back(std::move(j));
    };
    add_joint("root", -1, x_rotation);
    add_joint("left", 0, y_rotation);
    add_joint("right", 0, z_rotation);
    add_joint("left tip", 1, x_position);
    number_channels(c.skeleton);
    c.frame_time = 1;
    c.frames = 2;
    c.values = {1, 2, 3, 4, 5, 6, 7, 8};
    const read_result r = read_bvh(write_bvh(c));
    ASSERT_TRUE(r) << shown(r.error);
    EXPECT_EQ(r.value->skeleton.joints[2].name, "left tip");
    EXPECT_EQ(r.value->skeleton.joints[2].parent, 1);
    EXPECT_EQ(r.value->skeleton.joints[3].name, "right");
    EXPECT_EQ(r.value->values, (std::vector<double>{1, 2, 4, 3, 5, 6, 8, 7}));
}

TEST(BvhWrite, ClipWithAFaultIsNamedAndNotWritten) {
    const clip good = read_without_warning(valid_bvh);
    const auto expect_fault = [&](std::string_view fault, auto&& spoil) {
        clip c = good;
        spoil(c);
        EXPECT_EQ(bvh_fault(c), fault);
        EXPECT_EQ(write_bvh(c), "");
    };
    const double nan = std::bit_cast<double>(std::uint64_t{0x7ff8} << 48);
    expect_fault("the skeleton has no joint", [](clip& c) { c.skeleton.joints.clear(); });
    expect_fault("joint 0 'Hips' does not stand after its parent",
                 [](clip& c) { c.skeleton.joints[0].parent = 0; });
    expect_fault("joint 1 'Leg' does not stand after its parent",
                 [](clip& c) { c.skeleton.joints[1].parent = -2; });
    expect_fault("joint 1 '' has a name that BVH cannot express",
                 [](clip& c) { c.skeleton.joints[1].name = ""; });
    expect_fault("joint 1 ' a' has a name that BVH cannot express",
                 [](clip& c) { c.skeleton.joints[1].name = " a"; });
    expect_fault("joint 1 'a{' has a name that BVH cannot express",
                 [](clip& c) { c.skeleton.joints[1].name = "a{"; });
    expect_fault("joint 1 'a\\x0a' has a name that BVH cannot express",
                 [](clip& c) { c.skeleton.joints[1].name = "a\n"; });
    expect_fault("joint 1 'Leg' has an End Site with a name that BVH cannot express",
                 [](clip& c) { c.skeleton.joints[1].end->name = "}"; });
    expect_fault("joint 1 'Leg' has an offset that is not finite",
                 [&](clip& c) { c.skeleton.joints[1].offset.y = nan; });
    expect_fault("joint 1 'Leg' has an offset that is not finite",
                 [&](clip& c) { c.skeleton.joints[1].end->offset.z = nan; });
    expect_fault("joint 1 'Leg' has columns out of order",
                 [](clip& c) { c.skeleton.joints[1].first_channel = 0; });
    expect_fault("two joints have the name 'Hips'", [](clip& c) { c.skeleton.joints[1].name = "Hips"; });
    expect_fault("the channel count is not the sum over the joints",
                 [](clip& c) { c.skeleton.channel_count = 8; });
    expect_fault("the frame time is not positive and finite", [](clip& c) { c.frame_time = 0; });
    expect_fault("the frame time is not positive and finite", [&](clip& c) { c.frame_time = nan; });
    expect_fault("there are more than 16777216 frames", [](clip& c) { c.frames = bvh_max_frames + 1; });
    expect_fault("the number of values is not frames times channels", [](clip& c) { c.values.pop_back(); });
    expect_fault("a value in frame 2 is not finite", [&](clip& c) { c.values[9] = nan; });
}

}  // namespace
}  // namespace swivel::clip
