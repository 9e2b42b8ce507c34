"""Motion capture clips and odd BVH files that are not part of the repository. Skipped where they are absent."""

import glob
import os
import re
import sys

from support import CommandTest, main, run

SHARED = os.environ.get("SWIVEL_SHARED_DIR", "")
CLIPS = sorted(glob.glob(os.path.join(SHARED, "mocap", "bvh", "*.bvh"))) if SHARED else []
CASES = sorted(glob.glob(os.path.join(SHARED, "bvh-cases", "*.bvh"))) if SHARED else []
SKIPPED = 77


def ranges(text):
    """Twist and swing ranges by the name of the joint."""
    table = text.decode().split("\n\n")[1].splitlines()
    rows = [re.split(r"  +", line) for line in table[1:]]
    return {row[0]: [float(x) for x in row[3:7]] for row in rows if row[3] != "-"}


class SharedClips(CommandTest):
    def clip(self, part):
        found = [path for path in CLIPS if part in path]
        if not found:
            self.skipTest("no clip of " + part)
        return found[0]

    def test_every_clip_has_sensible_ranges(self):
        for path in CLIPS:
            found = ranges(self.succeeds("decompose", path).stdout)
            self.assertTrue(found, path)
            for name, (twist_min, twist_max, swing_min, swing_max) in found.items():
                self.assertLessEqual(-180, twist_min, (path, name))
                self.assertLessEqual(twist_min, twist_max, (path, name))
                self.assertLessEqual(twist_max, 180, (path, name))
                self.assertLessEqual(0, swing_min, (path, name))
                self.assertLessEqual(swing_min, swing_max, (path, name))
                self.assertLessEqual(swing_max, 180, (path, name))

    def test_the_wrists_of_the_boxer_turn_as_seen(self):
        found = ranges(self.succeeds("decompose", self.clip("boxing")).stdout)
        for name, expected in (("LeftWrist", (-82.26, 25.18)), ("RightWrist", (-39.12, 83.50))):
            for got, want in zip(found[name][:2], expected):
                self.assertAlmostEqual(got, want, delta=0.011, msg=name)

    def test_the_hands_of_the_dab_turn_as_seen(self):
        clip = self.clip("dab")
        for axis, name, expected in (("x", "LeftHand", (-85.82, 59.14)), ("-1,0,0", "RightHand", (-77.52, 96.22))):
            found = ranges(self.succeeds("decompose", clip, "--axis", axis, "--joint", name).stdout)
            for got, want in zip(found[name][:2], expected):
                self.assertAlmostEqual(got, want, delta=0.011, msg=name)

    def test_odd_files_are_read_or_refused_with_their_place(self):
        for path in CASES:
            result = self.refused_or_read(path)
            if result.returncode == 1:
                self.assertRegex(result.stderr.decode(errors="replace"),
                                 "^" + re.escape(path) + r":\d+:\d+: .+, expected .+\n$", path)

    def refused_or_read(self, path):
        result = run("decompose", path)
        self.assertIn(result.returncode, (0, 1), path)
        self.assertEqual(result.stdout == b"", result.returncode == 1, path)
        return result


if __name__ == "__main__":
    if not CLIPS:
        print("SKIPPED: no motion capture clips in SWIVEL_SHARED_DIR='" + SHARED + "'")
        sys.exit(SKIPPED)
    main()
