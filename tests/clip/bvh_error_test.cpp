// Every input that the BVH reader refuses, with the place it names.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "support/bvh_text.hpp"
#include "swivel/clip/read.hpp"

namespace swivel::clip {
namespace {

void expect_error(std::string_view text, std::size_t line, std::size_t column, std::string_view what,
                  std::string_view expected, const read_options& options = {}) {
    const read_result r = read_bvh(text, options);
    ASSERT_FALSE(r) << "was read as a clip";
    EXPECT_EQ(shown(r.error), shown({line, column, std::string(what), std::string(expected)}));
}

TEST(BvhError, EmptyFile) {
    expect_error("", 1, 1, "the file is empty", "HIERARCHY");
    expect_error("\xef\xbb\xbf", 1, 1, "the file is empty", "HIERARCHY");
    expect_error(" \t\r\n\n", 1, 1, "the file is empty", "HIERARCHY");
}

TEST(BvhError, NoHierarchy) {
    expect_error(with("HIERARCHY\n", ""), 1, 1, "unexpected 'ROOT'", "HIERARCHY");
    expect_error("\n  HIERARCHIES\n", 2, 3, "unexpected 'HIERARCHIES'", "HIERARCHY");
}

TEST(BvhError, NoRoot) {
    expect_error("HIERARCHY\nMOTION\nFrames: 0\nFrame Time: 1\n", 2, 1, "unexpected 'MOTION'", "ROOT");
    expect_error("HIERARCHY", 1, 10, "the text ends here", "ROOT");
}

TEST(BvhError, NoMotion) {
    expect_error(with("MOTION\n", ""), 16, 1, "unexpected 'Frames:'", "ROOT or MOTION");
    expect_error(valid_bvh.substr(0, valid_bvh.find("MOTION")), 16, 1, "the text ends here",
                 "ROOT or MOTION");
}

TEST(BvhError, Utf16WithAndWithoutByteOrderMark) {
    constexpr std::string_view with_mark[] = {{"\xff\xfeH\0I\0", 6}, {"\xfe\xff\0H\0I", 6}};
    constexpr std::string_view without_mark[] = {{"H\0I\0E\0", 6}, {"\0H\0I\0E", 6}};
    for (const auto& text : with_mark) expect_error(text, 1, 1, "the text is UTF-16", "ASCII or UTF-8");
    for (const auto& text : without_mark) expect_error(text, 1, 1, "the text is UTF-16", "ASCII or UTF-8");
}

TEST(BvhError, PackedFilesAreNamed) {
    const struct {
        std::string_view bytes, format;
    } files[] = {{"\x1f\x8b\x08", "gzip"},    {"PK\x03\x04\x14", "zip"},       {"PK\x05\x06", "zip"},
                 {"PK\x07\x08PK", "zip"},     {"\xfd\x37zXZ", "xz"},           {"\x28\xb5\x2f\xfd", "zstd"},
                 {"BZh91AY&SY", "bzip2"},     {"7z\xbc\xaf\x27\x1c", "7-Zip"}, {"\x1f\x9d\x90", "compress"},
                 {"\x04\x22\x4d\x18", "lz4"}, {"Rar!\x1a\x07", "rar"}};
    for (const auto& [bytes, format] : files)
        for (const std::string& rest : {std::string(), std::string(100, '\0'), valid_bvh})
            expect_error(std::string(bytes) + rest, 1, 1,
                         "the file is compressed (" + std::string(format) + ")", "text: unpack it first");
}

TEST(BvhError, UnknownKeyword) {
    expect_error(with("\tJOINT Leg", "\tBONE Leg"), 6, 2, "unexpected 'BONE'",
                 "OFFSET, CHANNELS, JOINT, End Site or '}'");
    expect_error(with("End Site", "End Point"), 10, 7, "unexpected 'Point'", "Site after End");
    expect_error(with("ROOT", "JOINT"), 2, 1, "unexpected 'JOINT'", "ROOT");
}

TEST(BvhError, NameMissing) {
    expect_error(with("ROOT Hips", "ROOT"), 3, 1, "no name after ROOT", "the name of the joint");
    expect_error(with("JOINT Leg\n\t{", "joint {"), 6, 8, "no name after joint", "the name of the joint");
    expect_error("HIERARCHY\nROOT", 2, 5, "no name after ROOT", "the name of the joint");
}

TEST(BvhError, BraceOrControlCharacterInName) {
    expect_error(with("Leg", "Le}g"), 6, 10, "'}' in a name", "no brace and no control character");
    expect_error(with("Leg", "Le\x01g"), 6, 10, "'\\x01' in a name", "no brace and no control character");
    expect_error(with("Leg", std::string_view("L\0g", 3)), 6, 9, "'\\x00' in a name",
                 "no brace and no control character");
    expect_error(with("End Site", "End Site x\x7f"), 10, 13, "'\\x7f' in a name",
                 "no brace and no control character");
}

TEST(BvhError, TwoJointsWithOneName) {
    expect_error(with("Leg", "Hips"), 6, 8, "the name 'Hips' was given in line 2 already",
                 "a name of its own for every joint");
}

TEST(BvhError, OpeningBraceMissing) {
    expect_error(with("\t{\n", ""), 7, 3, "unexpected 'OFFSET'", "'{' after the name of the joint");
    expect_error(with("\t\t{\n", ""), 11, 4, "unexpected 'OFFSET'", "'{' after End Site");
}

TEST(BvhError, ClosingBraceMissing) {
    expect_error(with("}\nMOTION", "MOTION"), 15, 1, "joint 'Hips' is not closed", "'}'");
    expect_error(with("\t\t}\n\t}\n}\n", "\t\t}\n\t}\nROOT b\n"), 15, 1, "joint 'Hips' is not closed", "'}'");
    expect_error(with("\t\t}\n\t}\n}\n", "\n\t\n\n"), 16, 1, "unexpected 'MOTION'",
                 "'}' after the OFFSET of the End Site");
    expect_error(valid_bvh.substr(0, valid_bvh.find("\tJOINT")), 6, 1, "joint 'Hips' is not closed", "'}'");
}

TEST(BvhError, BraceTooMany) {
    expect_error(with("}\nMOTION", "}}\nMOTION"), 15, 2, "unexpected '}'", "ROOT or MOTION");
    expect_error(with("\t{\n", "\t{{\n"), 7, 3, "unexpected '{'", "OFFSET, CHANNELS, JOINT, End Site or '}'");
    expect_error(with("MOTION\n", "MOTION\n}\n"), 17, 1, "unexpected '}'", "Frames:");
}

TEST(BvhError, OffsetMissing) {
    expect_error(with("\t\tOFFSET 0 -45 0\n", ""), 9, 3, "joint 'Leg' has no OFFSET", "OFFSET first");
    expect_error(with("\tOFFSET 0 95 0\n", ""), 5, 2, "joint 'Hips' has no OFFSET", "OFFSET first");
    expect_error(with("\t\t\tOFFSET 0 -40 0\n", ""), 12, 3, "the End Site has no OFFSET", "OFFSET first");
}

TEST(BvhError, OffsetTwice) {
    expect_error(with("\tOFFSET 0 95 0\n", "\tOFFSET 0 95 0 OFFSET 0 95 0\n"), 4, 16,
                 "joint 'Hips' has a second OFFSET", "one OFFSET");
    expect_error(with("\t}\n}\n", "\t}\nOFFSET 1 2 3\n}\n"), 15, 1, "joint 'Hips' has a second OFFSET",
                 "one OFFSET");
    expect_error(with("\t\t\tOFFSET 0 -40 0\n", "\t\t\tOFFSET 0 -40 0\n\t\t\tOFFSET 0 -40 0\n"), 13, 4,
                 "the End Site has a second OFFSET", "one OFFSET");
}

TEST(BvhError, OffsetWithoutThreeNumbers) {
    expect_error(with("OFFSET 0 95 0", "OFFSET 0 95"), 4, 2, "2 numbers after OFFSET", "3");
    expect_error(with("OFFSET 0 95 0", "OFFSET"), 4, 2, "0 numbers after OFFSET", "3");
    expect_error(with("OFFSET 0 -40 0", "OFFSET 0}"), 12, 4, "1 number after OFFSET", "3");
    expect_error(with("OFFSET 0 95 0", "OFFSET 0 95 0 7"), 4, 16, "more than 3 numbers after OFFSET", "3");
    expect_error(with("OFFSET 0 95 0", "OFFSET 0 9,5 0"), 4, 11, "'9,5' is not a number", "a number");
    expect_error(with("OFFSET 0 95 0", "OFFSET 0 nan 0"), 4, 11, "'nan' is not finite", "a number");
}

TEST(BvhError, ChannelsAfterAChildOrEndSite) {
    const std::string_view late = "joint 'Leg' has CHANNELS after a child or End Site";
    const std::string none = with("\t\tCHANNELS 3 Xrotation Yrotation Zrotation\n", "");
    expect_error(with(none, "\t\t}\n\t}", "\t\t}\n\t\tCHANNELS 1 Xrotation\n\t}"), 13, 3, late,
                 "CHANNELS before them");
    expect_error(with(none, "\t\t}\n\t}", "\t\t}\nJOINT a {OFFSET 0 0 0 CHANNELS 0}\nCHANNELS 0\n\t}"), 14, 1,
                 late, "CHANNELS before them");
}

TEST(BvhError, ChannelsTwice) {
    expect_error(with("Yrotation Zrotation\n", "Yrotation Zrotation\n\t\tCHANNELS 0\n"), 10, 3,
                 "joint 'Leg' has a second CHANNELS", "one CHANNELS");
}

TEST(BvhError, ChannelCountAndNamesDisagree) {
    expect_error(with("3 Xrotation Yrotation Zrotation", "3 Xrotation Yrotation"), 9, 12,
                 "CHANNELS announces 3 names but gives 2", "the count and the names to agree");
    expect_error(with("3 Xrotation Yrotation Zrotation", "2 Xrotation Yrotation Zrotation"), 9, 12,
                 "CHANNELS announces 2 names but gives more", "the count and the names to agree");
    expect_error(with("3 Xrotation Yrotation Zrotation", "0 Xrotation"), 9, 12,
                 "CHANNELS announces 0 names but gives more", "the count and the names to agree");
    expect_error(with("3 Xrotation Yrotation Zrotation", "1}"), 9, 12,
                 "CHANNELS announces 1 name but gives 0", "the count and the names to agree");
}

TEST(BvhError, ChannelCountIsNoCount) {
    const auto expect_count_error = [](std::string_view count, std::string_view what) {
        expect_error(with("CHANNELS 3", "CHANNELS " + std::string(count)), 9, 12, what,
                     "a whole number from 0 to 6");
    };
    expect_count_error("-3", "the count of channels '-3' is negative");
    expect_count_error("3.0", "the count of channels '3.0' is not a whole number");
    expect_count_error("three", "the count of channels 'three' is not a whole number");
    expect_count_error("99999999999999999999", "the count of channels '99999999999999999999' is too large");
    expect_error(with("CHANNELS 3 Xrotation Yrotation Zrotation", "CHANNELS"), 9, 3,
                 "no count after CHANNELS", "a whole number from 0 to 6");
}

TEST(BvhError, ChannelCountAboveSixAllocatesNothing) {
    expect_error(with("CHANNELS 3", "CHANNELS 7"), 9, 12, "7 channels in one joint", "at most 6");
    expect_error(with("CHANNELS 3", "CHANNELS 2147483647"), 9, 12, "2147483647 channels in one joint",
                 "at most 6");
}

TEST(BvhError, UnknownChannel) {
    expect_error(with("3 Xrotation Yrotation", "3 Xrotation Wrotation"), 9, 24, "unknown channel 'Wrotation'",
                 "Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation");
}

TEST(BvhError, ChannelTwice) {
    expect_error(with("3 Xrotation Yrotation", "3 Xrotation XROTATION"), 9, 24,
                 "the channel 'XROTATION' is given twice", "each channel once");
}

TEST(BvhError, SecondEndSite) {
    expect_error(with("\t}\n}\n", "End Site\n{\nOFFSET 0 0 0\n}\n\t}\n}\n"), 14, 1,
                 "joint 'Leg' has a second End Site", "one End Site");
}

TEST(BvhError, EndSiteWithMoreThanAnOffset) {
    expect_error(with("OFFSET 0 -40 0\n", "OFFSET 0 -40 0\nEnd Site\n"), 13, 1, "unexpected 'End'",
                 "'}' after the OFFSET of the End Site");
    expect_error(with("OFFSET 0 -40 0\n", "OFFSET 0 -40 0\nCHANNELS 0 CHANNELS 0\n"), 13, 12,
                 "the End Site has a second CHANNELS", "OFFSET alone");
    expect_error(with("OFFSET 0 -40 0\n", "CHANNELS 1 Xrotation\n"), 13, 3, "the End Site has no OFFSET",
                 "OFFSET first");
    expect_error(with("OFFSET 0 -40 0\n", "OFFSET 0 -40 0\nCHANNELS 7\n"), 13, 10, "7 channels in one joint",
                 "at most 6");
    expect_error(with("\t\t\tOFFSET 0 -40 0\n", "\t\t\tJOINT x\n"), 12, 4, "unexpected 'JOINT'",
                 "OFFSET in the End Site");
}

TEST(BvhError, TooManyJoints) {
    std::string text = "HIERARCHY\n";
    for (std::size_t j = 0; j <= bvh_max_joints; ++j)
        text += "ROOT " + std::to_string(j) + "{OFFSET 0 0 0 CHANNELS 0}\n";
    expect_error(text, bvh_max_joints + 2, 1, "too many joints", "at most 1000000");
}

TEST(BvhError, TooManyBytes) {
    expect_error(valid_bvh, 0, 0, "the file is too large", "at most 100 bytes", {.max_bytes = 100});
}

TEST(BvhError, FramesMissing) {
    expect_error(with("Frames: 2\n", ""), 17, 1, "unexpected 'Frame'", "Frames:");
    expect_error(with("Frames: 2", "Frames 2"), 17, 8, "unexpected '2'", "':' after Frames");
    expect_error(valid_bvh.substr(0, valid_bvh.find(" 2\n")), 17, 8, "the text ends here",
                 "the number of frames");
}

TEST(BvhError, FramesIsNoCount) {
    const auto expect_frames_error = [](std::string_view frames, std::string_view what) {
        expect_error(with("Frames: 2", "Frames: " + std::string(frames)), 17, 9, what,
                     "a whole number, 0 or more");
    };
    expect_frames_error("-2", "the number of frames '-2' is negative");
    expect_frames_error("2.5", "the number of frames '2.5' is not a whole number");
    expect_frames_error("2x", "the number of frames '2x' is not a whole number");
    expect_frames_error("nan", "the number of frames 'nan' is not a whole number");
    expect_frames_error("18446744073709551616", "the number of frames '18446744073709551616' is too large");
}

TEST(BvhError, HugeFramesAllocatesNothing) {
    expect_error(with("Frames: 2", "Frames: 2147483647"), 17, 9, "2147483647 frames", "at most 16777216");
    expect_error(with("Frames: 2", "Frames: 16777216"), 21, 1, "2 rows of motion",
                 "16777216, as Frames says");
}

TEST(BvhError, FrameTimeMissing) {
    expect_error(with("Frame Time: 0.01\n", ""), 18, 1, "unexpected '0'", "Frame Time:");
    expect_error(with("Frame Time: 0.01", "Frame: 0.01"), 18, 6, "unexpected ':'", "Frame Time:");
    expect_error(with("Frame Time: 0.01", "Frame Time 0.01"), 18, 12, "unexpected '0.01'",
                 "':' after Frame Time");
    expect_error(valid_bvh.substr(0, valid_bvh.find(" 0.01")), 18, 12, "the text ends here",
                 "a positive number of seconds");
}

TEST(BvhError, FrameTimeNotPositiveAndFinite) {
    const auto expect_time_error = [](std::string_view time, std::string_view what) {
        expect_error(with("Time: 0.01", "Time: " + std::string(time)), 18, 13, what,
                     "a positive number of seconds");
    };
    expect_time_error("0", "the frame time '0' is not positive");
    expect_time_error("-0.0", "the frame time '-0.0' is not positive");
    expect_time_error("-0.01", "the frame time '-0.01' is not positive");
    expect_time_error("1e-999", "the frame time '1e-999' is not positive");
    expect_time_error("inf", "the frame time 'inf' is not finite");
    expect_time_error("nan", "the frame time 'nan' is not finite");
    expect_time_error("1e999", "the frame time '1e999' is too large for a double");
    expect_time_error("0,01", "the frame time '0,01' is not a number");
}

TEST(BvhError, SomethingAfterFrameTime) {
    expect_error(with("Time: 0.01\n", "Time: 0.01 0 95 0 1 2 3 4 5 6\n"), 18, 18, "unexpected '0'",
                 "nothing more on the line of Frame Time");
}

TEST(BvhError, BadNumberInRow) {
    const auto expect_bad_number = [](std::string_view number, std::string_view what) {
        expect_error(with("1 96 1", "1 " + std::string(number) + " 1"), 20, 3, what, "a number");
    };
    for (const std::string number :
         {"1x0", "1,5", "0x10",  "1.5e", "1.5e+", "--1", "+-1", "++1",  "+",  "-",       ".",
          "-.",  "e5",  "1e5.5", "1..5", "1_000", "1f",  "1:5", "#IND", "1}", "\xc2\xa0"})
        expect_bad_number(number, "'" + number + "' is not a number");
    for (const std::string number : {"nan", "-nan", "NaN", "inf", "-inf", "+Infinity", "nan(1)"})
        expect_bad_number(number, "'" + number + "' is not finite");
    for (const std::string number : {"1e309", "-1e309", "1.8e308", "1e99999999999999999999", "0.1e400"})
        expect_bad_number(number, "'" + number + "' is too large for a double");
    expect_bad_number(std::string_view("9\0", 2), "'9\\x00' is not a number");
    expect_bad_number(std::string_view("9\0006", 3), "'9\\x006' is not a number");
    expect_bad_number(std::string(60, 'x'), "'" + std::string(48, 'x') + "...' is not a number");
}

TEST(BvhError, LastNumberCutShort) {
    expect_error(with("11 12\n", "11 1.5e"), 20, 20, "'1.5e' is not a number", "a number");
    expect_error(with("11 12\n", "11 -"), 20, 20, "'-' is not a number", "a number");
}

TEST(BvhError, ShortRowNamesItsLineAndColumn) {
    expect_error(with("3 4 5 6\n", "3 4 5\n"), 19, 17, "row too short: 8 values", "9");
    expect_error(with("3 4 5 6\n", "3 4 5 \t\r\n"), 19, 17, "row too short: 8 values", "9");
    expect_error(with(" 11 12\n", ""), 20, 16, "row too short: 7 values", "9");
    expect_error(with(" 11 12\n", "\n11\n"), 20, 16, "row too short: 8 values", "9");
}

TEST(BvhError, ContinuationThatOvershootsNamesTheShortRowBefore) {
    expect_error(with("3 4 5 6\n", "3\n4 5\n"), 19, 13, "row too short: 8 values", "9");
}

TEST(BvhError, LongRowNamesItsFirstSurplusValue) {
    expect_error(with("3 4 5 6\n", "3 4 5 6 7\n"), 19, 20, "row too long: 10 values", "9");
    expect_error(with("3 4 5 6\n", "3 4 5 6 7 8  9\n"), 19, 20, "row too long: 12 values", "9");
    expect_error(with("3 4 5 6\n", "3 4 5 6 "), 19, 20, "row too long: 18 values", "9");
    expect_error(with("11 12\n", "11 12 13"), 20, 23, "row too long: 10 values", "9");
}

TEST(BvhError, ValuesWithoutChannels) {
    expect_error("HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 } MOTION Frames: 1 Frame Time: 1\n5", 2, 1,
                 "row too long: 1 value", "0");
}

TEST(BvhError, FewerRowsThanFramesIsFoundAtTheEnd) {
    expect_error(with("Frames: 2", "Frames: 3"), 21, 1, "2 rows of motion", "3, as Frames says");
    expect_error(with("\n1 96 1 7 8 9 10 11 12\n", ""), 19, 19, "1 row of motion", "2, as Frames says");
    expect_error(valid_bvh.substr(0, valid_bvh.find("0 95 0 1")), 19, 1, "0 rows of motion",
                 "2, as Frames says");
}

TEST(BvhError, MoreRowsThanFramesWhenStrict) {
    expect_error(with("Frames: 2", "Frames: 1"), 20, 1, "2 rows of motion", "1, as Frames says",
                 {.strict = true});
}

TEST(BvhError, JunkAfterTheEnd) {
    expect_error(valid_bvh + "MOTION\n", 21, 1, "unexpected 'MOTION' after the last row",
                 "the end of the text");
    expect_error(valid_bvh + "\n  }", 22, 3, "unexpected '}' after the last row", "the end of the text");
    expect_error(valid_bvh + "\x1a\n1", 21, 1, "unexpected '\\x1a' after the last row",
                 "the end of the text");
    expect_error(valid_bvh + "x\x1a", 21, 1, "unexpected 'x' after the last row", "the end of the text");
    expect_error(valid_bvh + "1 2 3\n", 21, 6, "row too short: 3 values", "9");
}

TEST(BvhError, ColumnsCountBytesAndLinesCountEveryKindOfLineEnd) {
    const auto expect_at = [](const std::string& text, std::size_t line, std::size_t column) {
        expect_error(text, line, column, "'1x0' is not a number", "a number");
    };
    const std::string bad = with("7 8", "1x0 8");
    expect_at(bad, 20, 8);
    expect_at(with_every(bad, '\n', "\r\n"), 20, 8);
    expect_at(with_every(bad, '\n', "\r"), 20, 8);
    expect_at(with_every(bad, '\n', "\n\r"), 39, 8);
    expect_error("\xef\xbb\xbfROOT", 1, 1, "unexpected 'ROOT'", "HIERARCHY");
    expect_error(with("\tJOINT Leg\n\t{", "\tJOINT \xc3\xa9 { x"), 6, 13, "unexpected 'x'",
                 "OFFSET, CHANNELS, JOINT, End Site or '}'");
}

}  // namespace
}  // namespace swivel::clip
