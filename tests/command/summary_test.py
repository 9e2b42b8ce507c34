"""`decompose`: the summary on the terminal and the table of all frames."""

import csv
import io
import re

from support import (CLIP, CommandTest, main, multiply, rotation_of, swing_degrees, swing_twist, twist_degrees,
                     usable_isas)

JOINTS = {
    # name: channels, first column, axis of --axis auto
    "Hips": (["Xposition", "Yposition", "Zposition", "Zrotation", "Xrotation", "Yrotation"], 0, (5, -5, 0)),
    "Left Arm, upper": (["Xrotation", "Yrotation", "Zrotation"], 6, (20, 0, 0)),
    "Hand": (["Yrotation", "Zrotation", "Xrotation"], 9, (0, -5, 0)),
    "Tail": ([], 12, (5, -5, 0)),
}
MOTION = [[float(x) for x in line.split()] for line in CLIP.split("Frame Time: 0.1\n")[1].splitlines()]
CSV_HEADER = "frame,time,joint,sx,sy,sz,sw,tx,ty,tz,tw,twist_degrees,swing_degrees"


def rotation(name, frame):
    channels, first, _ = JOINTS[name]
    return rotation_of(channels, MOTION[frame][first:first + len(channels)])


def summary(text):
    """The rows of the table by the name of the joint."""
    table = text.decode().split("\n\n")[1].splitlines()
    return {cells[0]: cells[1:] for cells in (re.split(r"  +", line) for line in table[1:])}


def wrapped(degrees):
    return abs((degrees + 180) % 360 - 180)


class Summary(CommandTest):
    def setUp(self):
        super().setUp()
        self.clip = self.path("clip.bvh", CLIP)

    def check(self, table, axis_of):
        for name, cells in table.items():
            axis = axis_of(name)
            twist = [twist_degrees(rotation(name, f), axis) for f in range(len(MOTION))]
            swing = [swing_degrees(rotation(name, f), axis) for f in range(len(MOTION))]
            jumps = [wrapped(b - a) for a, b in zip(twist, twist[1:])]
            numbers = [float(cell) for cell in cells[-7:]]
            for got, expected in zip(numbers, (min(twist), max(twist), min(swing), max(swing),
                                               sum(s > 179 for s in swing), max(jumps))):
                self.assertAlmostEqual(got, expected, delta=0.0051, msg=name)
            self.assertAlmostEqual(jumps[int(numbers[6]) - 1], max(jumps), places=6, msg=name)

    def test_the_ranges_are_those_of_the_definition(self):
        table = summary(self.succeeds("decompose", self.clip).stdout)
        self.assertEqual(list(table), list(JOINTS))
        self.check(table, lambda name: JOINTS[name][2])
        for text, axis in (("x", (1, 0, 0)), ("y", (0, 1, 0)), ("z", (0, 0, 1)), ("1,2,-3", (1, 2, -3))):
            for product in ("swing-twist", "twist-swing"):
                self.check(summary(self.succeeds("decompose", self.clip, "--axis", text, "--product",
                                                 product).stdout), lambda name, axis=axis: axis)

    def test_the_axis_and_what_gave_it_are_shown(self):
        table = summary(self.succeeds("decompose", self.clip).stdout)
        self.assertEqual({name: cells[:2] for name, cells in table.items()}, {
            "Hips": ["0.707,-0.707,0.000", "mean of children"],
            "Left Arm, upper": ["1.000,0.000,0.000", "child"],
            "Hand": ["0.000,-1.000,0.000", "end site"],
            "Tail": ["0.707,-0.707,0.000", "parent"],
        })
        for axis, shown in (("x", "x"), ("0,3,4", "0.000,0.600,0.800"), ("0,0,-1e300", "0.000,0.000,-1.000")):
            table = summary(self.succeeds("decompose", self.clip, "--axis", axis).stdout)
            self.assertEqual({tuple(cells[:2]) for cells in table.values()}, {(shown, "given")})

    def test_a_jump_is_the_shorter_way_round(self):
        # Hips turn about y from 170 over 180 to -170 degrees.
        cells = summary(self.succeeds("decompose", self.clip, "--axis", "y", "--joint", "Hips").stdout)["Hips"]
        self.assertEqual(cells[2:], ["-170.00", "170.00", "0.00", "0.00", "0", "20.00", "1"])

    def test_a_half_turn_about_the_axis_is_no_range(self):
        clip = CLIP.split("0 0 0  0 0 170")[0].replace("Frames: 4", "Frames: 2") + \
            "0 0 0  0 0 180  0 0 0  180 0 0\n0 0 0  0 0 -180  0 0 0  180 0 0\n"
        table = summary(self.succeeds("decompose", self.path("half.bvh", clip), "--axis", "y").stdout)
        self.assertEqual(table["Hips"][2:], ["180.00", "180.00", "0.00", "0.00", "0", "0.00", "1"])
        self.assertEqual(table["Hand"][2:4], ["180.00", "180.00"])
        table = summary(self.succeeds("decompose", self.path("half.bvh", clip), "--axis", "x").stdout)
        self.assertEqual(table["Hips"][2:7], ["0.00", "0.00", "180.00", "180.00", "2"])

    def test_the_table_is_aligned(self):
        lines = self.succeeds("decompose", self.clip).stdout.decode().split("\n\n")[1].splitlines()
        self.assertEqual(len({len(line) for line in lines}), 1)

    def test_joints_are_those_asked_for_in_that_order_once(self):
        result = self.succeeds("decompose", "--joint", "Hand", "--joint", "Hips", "--joint", "Hand", self.clip)
        self.assertEqual(list(summary(result.stdout)), ["Hand", "Hips"])

    def test_the_csv_has_a_row_for_each_joint_and_frame(self):
        out = self.path("out.csv")
        for product in ("swing-twist", "twist-swing"):
            for isa in usable_isas():
                self.succeeds("decompose", self.clip, "--out", out, "--product", product, "--isa", isa)
                with open(out, encoding="utf-8", newline="") as file:
                    text = file.read()
                self.assertTrue(text.startswith(CSV_HEADER + "\n"))
                found = list(csv.DictReader(io.StringIO(text)))
                self.assertEqual([(row["joint"], int(row["frame"])) for row in found],
                                 [(name, frame) for name in JOINTS for frame in range(4)])
                for row in found:
                    self.check_row(row, product)

    def check_row(self, row, product):
        name, frame = row["joint"], int(row["frame"])
        axis, q = JOINTS[name][2], rotation(name, frame)
        self.assertEqual(float(row["time"]), frame * 0.1)
        swing = tuple(float(row[c]) for c in ("sx", "sy", "sz", "sw"))
        twist = tuple(float(row[c]) for c in ("tx", "ty", "tz", "tw"))
        self.assertGreaterEqual(twist[3], 0)
        got = multiply(swing, twist) if product == "swing-twist" else multiply(twist, swing)
        sign = 1 if sum(a * b for a, b in zip(got, q)) > 0 else -1
        for a, b in zip(got, q):
            self.assertAlmostEqual(a, sign * b, places=13)
        _, expected = swing_twist(q, axis)
        for a, b in zip(twist, expected):
            self.assertAlmostEqual(a, b if expected[3] > 0 else -b, places=13)
        self.assertAlmostEqual(float(row["twist_degrees"]), twist_degrees(q, axis), places=10)
        self.assertAlmostEqual(float(row["swing_degrees"]), swing_degrees(q, axis), places=10)

    def test_standard_streams_take_the_place_of_files(self):
        to_file = self.succeeds("decompose", self.clip, "--out", self.path("out.csv"))
        with open(self.path("out.csv"), "rb") as file:
            expected = file.read()
        result = self.succeeds("decompose", "-", "--out", "-", stdin=CLIP)
        self.assertEqual(result.stdout, expected)
        self.assertEqual(result.stderr.decode(), to_file.stdout.decode().replace(self.clip, "<stdin>"))

    def test_the_csv_is_a_table_for_eval(self):
        table = self.succeeds("decompose", self.clip, "--out", "-").stdout
        out = self.succeeds("eval", "compose", "--pass", stdin=table).stdout.decode().splitlines()
        self.assertEqual(out[0], "frame,time,joint,twist_degrees,swing_degrees,qx,qy,qz,qw")
        self.assertEqual(len(out), 17)
        self.assertIn('"Left Arm, upper"', out[5])

    def test_reproducible_is_the_same_text_on_every_isa(self):
        texts = {self.succeeds("decompose", self.clip, "--out", "-", "--precision", "reproducible", "--isa",
                               isa).stdout for isa in usable_isas()}
        self.assertEqual(len(texts), 1)

    def test_a_clip_without_frames_has_no_ranges(self):
        clip = self.path("rest.bvh", CLIP.split("0 0 0  0 0 170")[0].replace("Frames: 4", "Frames: 0"))
        result = self.succeeds("decompose", clip, "--out", self.path("out.csv"))
        self.assertEqual(summary(result.stdout)["Hand"], ["0.000,-1.000,0.000", "end site"] + ["-"] * 7)
        with open(self.path("out.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read(), CSV_HEADER + "\n")

    def test_one_frame_has_no_jump(self):
        clip = CLIP.split("0 0 0  0 0 -170")[0].replace("Frames: 4", "Frames: 1")
        cells = summary(self.succeeds("decompose", "-", stdin=clip).stdout)["Hand"]
        self.assertEqual(cells[-2:], ["-", "-"])

    def test_surplus_rows_are_a_warning_or_with_strict_an_error(self):
        clip = self.path("surplus.bvh", CLIP + MOTION_ROW)
        result = self.succeeds("decompose", clip)
        self.assertIn(":33:1: warning: 5 rows of motion", result.stderr.decode())
        self.assertEqual(summary(result.stdout), summary(self.succeeds("decompose", self.clip).stdout))
        result = self.fails(1, clip + ":33:1: 5 rows of motion, expected 4", "decompose", clip, "--strict")
        self.assertEqual(result.stdout, b"")

    def test_a_clip_that_was_cut_off_is_salvaged_when_asked_for(self):
        whole = CLIP.splitlines(keepends=True)
        clip = self.path("cut.bvh", "".join(whole[:-2]) + whole[-2][:20])
        self.fails(1, clip + ":31:", "decompose", clip)
        result = self.succeeds("decompose", clip, "--salvage", "--joint", "Hand", "--out", self.path("out.csv"))
        self.assertRegex(result.stderr.decode(), r":31:\d+: warning: row too short: .*; 2 of 4 rows read, expected 12")
        with open(self.path("out.csv"), encoding="utf-8") as file:
            self.assertEqual(len(file.readlines()), 1 + 2)
        self.fails(2, "--strict and --salvage", "decompose", clip, "--strict", "--salvage")

    def test_warnings_of_one_kind_are_counted_beyond_a_hundred(self):
        joints = "".join(f"JOINT j{i} {{OFFSET 0 1 0 EndSite {{OFFSET 0 1 0}}}}\n" for i in range(200))
        clip = self.path("many.bvh", "HIERARCHY\nROOT r {OFFSET 0 0 0 CHANNELS 1 Xrotation\n" + joints +
                         "}\nMOTION\nFrames: 1\nFrame Time: 1\n5\n")
        lines = self.succeeds("decompose", clip, "--joint", "r").stderr.decode().splitlines()
        self.assertEqual(len(lines), 101)
        self.assertEqual(lines[-1], clip + ": warning: 300 more like these")

    def test_a_bad_clip_is_refused_with_its_place(self):
        for clip, message in (
            ("", ":1:1: the file is empty, expected HIERARCHY"),
            (CLIP.replace("20 5 0", "20 1,5 0"), ":30:21: '1,5' is not a number, expected a number"),
            (CLIP[:-30], ":32:"),
        ):
            path = self.path("bad.bvh", clip)
            result = self.fails(1, path + message, "decompose", path, "--out", self.path("none.csv"))
            self.assertEqual(result.stdout, b"")
            self.assertRaises(FileNotFoundError, open, self.path("none.csv"), "rb")
            self.fails(1, "<stdin>" + message, "decompose", "-", stdin=clip)

    def test_many_nested_joints_are_no_matter(self):
        depth = 20_000
        clip = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n" + "".join(
            f"JOINT j{i}\n{{\nOFFSET 0 1 0\nCHANNELS 0\n" for i in range(depth)) + "}\n" * depth + \
            "}\nMOTION\nFrames: 1\nFrame Time: 1\n90\n"
        result = self.succeeds("decompose", "-", "--joint", "r", "--joint", f"j{depth - 1}", stdin=clip)
        self.assertEqual(len(summary(result.stdout)), 2)
        self.assertEqual(len(summary(self.succeeds("decompose", "-", stdin=clip).stdout)), depth + 1)
        self.fails(2, f"<stdin> has no joint 'j{depth}', near names are 'j", "decompose", "-", "--joint",
                   f"j{depth}", stdin=clip)


MOTION_ROW = "0 0 0  0 0 0   0 0 0   0 0 0\n"

if __name__ == "__main__":
    main()
