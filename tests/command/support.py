"""What the tests of the command share: running it, a clip, and the mathematics written a second time."""

import math
import os
import random
import subprocess
import sys
import tempfile
import unittest

COMMAND = sys.argv[1:]

HEADER = "qx qy qz qw\n"

CLIP = """HIERARCHY
ROOT Hips
{
  OFFSET 0 90 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Left Arm, upper
  {
    OFFSET 10 0 0
    CHANNELS 3 Xrotation Yrotation Zrotation
    JOINT Hand
    {
      OFFSET 20 0 0
      CHANNELS 3 Yrotation Zrotation Xrotation
      End Site
      {
        OFFSET 0 -5 0
      }
    }
  }
  JOINT Tail
  {
    OFFSET 0 -10 0
    CHANNELS 0
  }
}
MOTION
Frames: 4
Frame Time: 0.1
0 0 0  0 0 170   10 0 0   0 0 0
0 0 0  0 0 -170  20 5 0   0 0 180
0 0 0  0 0 -160  -30 0 7  0 0 40
0 0 0  0 0 -150  -30 0 7  0 0 40
"""


def run(*arguments, stdin="", environment=None, cwd=None):
    env = dict(os.environ)
    env.pop("SWIVEL_ISA", None)
    env.update(environment or {})
    data = stdin if isinstance(stdin, bytes) else stdin.encode()
    return subprocess.run(COMMAND + list(arguments), input=data, capture_output=True, env=env, cwd=cwd, timeout=300)


def rows(text):
    """The header and the rows of numbers of a table that `eval` wrote."""
    lines = text.decode().splitlines()
    return lines[0].split(","), [[float(x) for x in line.split(",")] for line in lines[1:]]


def usable_isas():
    for line in run("info").stdout.decode().splitlines():
        if line.startswith("isas usable:"):
            return line.split(":")[1].split()
    raise AssertionError("info does not list the usable ISAs")


class CommandTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name, content=None):
        path = os.path.join(self.folder, name)
        if content is not None:
            with open(path, "wb") as file:
                file.write(content if isinstance(content, bytes) else content.encode())
        return path

    def succeeds(self, *arguments, **options):
        result = run(*arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr.decode(errors="replace"))
        return result

    def fails(self, code, message, *arguments, **options):
        """Exits with the code, and says the message first on standard error."""
        result = run(*arguments, **options)
        error = result.stderr.decode(errors="replace")
        self.assertEqual(result.returncode, code, error)
        self.assertTrue(error.startswith(message), error + "\ndoes not begin with\n" + message)
        return result


class EvalTest(CommandTest):
    """The operations of `eval`, one table in and one out."""

    def assertNear(self, a, b, tolerance=1e-13):
        self.assertEqual(len(a), len(b))
        for x, y in zip(a, b):
            self.assertLessEqual(abs(x - y), tolerance, (a, b))

    def evaluate(self, operation, stdin, *options):
        return rows(self.succeeds("eval", operation, *options, stdin=stdin).stdout)


def random_rotations(count, seed=1):
    generator = random.Random(seed)
    found = []
    while len(found) < count:
        q = [generator.gauss(0, 1) for _ in range(4)]
        length = math.sqrt(sum(c * c for c in q))
        found.append(tuple(c / length for c in q))
    return found


def table(header, values):
    return header + "".join(" ".join(repr(x) for x in row) + "\n" for row in values)


def multiply(a, b):
    """The Hamilton product, x y z w."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + bw * ax + ay * bz - az * by, aw * by + bw * ay + az * bx - ax * bz,
            aw * bz + bw * az + ax * by - ay * bx, aw * bw - ax * bx - ay * by - az * bz)


def conjugate(q):
    return (-q[0], -q[1], -q[2], q[3])


def swing_twist(q, axis):
    """S and T with q = S T, from the definition: T is the part of q along the axis, of unit length."""
    length = math.sqrt(sum(c * c for c in axis))
    a = [c / length for c in axis]
    u = sum(p * c for p, c in zip(a, q))
    r = math.hypot(u, q[3])
    twist = (a[0] * u / r, a[1] * u / r, a[2] * u / r, q[3] / r)
    return multiply(q, conjugate(twist)), twist


def rotation_of(channels, degrees):
    """The rotation of a joint: its rotation channels from left to right."""
    q = (0.0, 0.0, 0.0, 1.0)
    for name, angle in zip(channels, degrees):
        if name.endswith("rotation"):
            half = math.radians(angle) / 2
            turn = [0.0, 0.0, 0.0, math.cos(half)]
            turn["XYZ".index(name[0])] = math.sin(half)
            q = multiply(q, turn)
    return q


def twist_degrees(q, axis):
    _, t = swing_twist(q, axis)
    length = math.sqrt(sum(c * c for c in axis))
    u = sum(p * c for p, c in zip(t, axis)) / length
    return math.degrees(math.remainder(2 * math.atan2(u, t[3]), 2 * math.pi))


def swing_degrees(q, axis):
    s, _ = swing_twist(q, axis)
    return math.degrees(2 * math.atan2(math.sqrt(s[0] ** 2 + s[1] ** 2 + s[2] ** 2), abs(s[3])))


def main():
    if not COMMAND:
        sys.exit("usage: <suite>_test.py COMMAND...")
    unittest.main(argv=sys.argv[:1], verbosity=2)
