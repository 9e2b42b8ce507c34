"""The door of README.md: its commands as they stand there, its table and its picture."""

import math
import os
import re
import shlex
import subprocess
import sys

from support import COMMAND, CommandTest, main, rows

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
HINGE, HALF, OPEN = (2.0, 1.0), 0.4, math.radians(120)


def section():
    with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
        return re.search(r"\n## Rigid motions\n(.*?)\n## ", file.read(), re.DOTALL).group(1)


def middle(angle):
    return HINGE[0] + HALF * math.cos(angle), HINGE[1] + HALF * math.sin(angle)


class Door(CommandTest):
    def test_the_picture_is_what_the_script_draws(self):
        with open(os.path.join(ROOT, "docs", "door.svg"), "rb") as file:
            kept = file.read()
        for _ in range(2):
            drawn = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "door_picture.py"), *COMMAND],
                                   stdout=subprocess.PIPE, check=True).stdout
            self.assertEqual(drawn, kept, "docs/door.svg is not what tools/door_picture.py draws")

    def test_the_commands_work_as_printed_and_give_the_table(self):
        name = self.path("swivel", "#!/bin/sh\nexec " + shlex.join(os.path.abspath(c) if os.path.exists(c) else c
                                                                   for c in COMMAND) + ' "$@"\n')
        os.chmod(name, 0o755)
        commands = re.search(r"```sh\n(.*?)```", section(), re.DOTALL).group(1)
        environment = dict(os.environ, PATH=self.folder + os.pathsep + os.environ["PATH"])
        result = subprocess.run(["sh", "-e", "-c", commands], capture_output=True, env=environment, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        names, poses = rows(result.stdout)
        self.assertEqual(names, "qx qy qz qw tx ty tz".split())
        table = re.findall(r"^\| ([\d.]+) \| (\d+)[ a-z]* \| ([\d.]+) ([\d.]+) \| (\d+)[ a-z]* \| (\d+)[ a-z]* \|$",
                           section(), re.MULTILINE)
        self.assertEqual(len(table), 6)
        self.assertEqual(len(poses), len(table))
        for pose, (t, degrees, x, y, hinge, other_hinge) in zip(poses, table):
            angle = float(t) * OPEN
            self.assertEqual(round(math.degrees(angle)), int(degrees))
            for got, expected in zip(pose, (0, 0, math.sin(angle / 2), math.cos(angle / 2), *middle(angle), 0)):
                self.assertLessEqual(abs(got - expected), 1e-6)
            self.assertEqual((f"{pose[4]:.3f}", f"{pose[5]:.3f}"), (x, y))

            def centimetres_off(at):
                end = [c - HALF * f(angle) for c, f in zip(at, (math.cos, math.sin))]
                return round(100 * math.dist(end, HINGE))

            self.assertEqual(int(hinge), centimetres_off(pose[4:6]))
            chord = [(1 - float(t)) * a + float(t) * b for a, b in zip(middle(0), middle(OPEN))]
            self.assertEqual(int(other_hinge), centimetres_off(chord))

    def test_half_way_the_hinge_is_off_by_half_of_the_half_width(self):
        chord = [(a + b) / 2 for a, b in zip(middle(0), middle(OPEN))]
        hinge, edge = ([c + s * HALF * f(OPEN / 2) for c, f in zip(chord, (math.cos, math.sin))] for s in (-1, 1))
        self.assertAlmostEqual(math.dist(hinge, HINGE), 0.2)
        self.assertAlmostEqual(math.dist(edge, HINGE), 0.6)
        for figure in ("20 cm", "60 cm", "80 cm"):
            self.assertIn(figure, section())


if __name__ == "__main__":
    main()
