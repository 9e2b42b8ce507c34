"""The operations of `eval` on motors, against screws written in Python."""

import math
import random

from support import (EvalTest, conjugate, main, multiply, random_rotations, swing_twist, table, usable_isas)

PARTS = "x y z w dx dy dz dw".split()


def columns(*prefixes):
    return " ".join(prefix + part for prefix in prefixes for part in PARTS)


def turned(q, v):
    return multiply(multiply(q, tuple(v) + (0.0,)), conjugate(q))[:3]


def plus(a, b, scale=1.0):
    return tuple(x + scale * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def motor(q, t):
    """Turned by q, then moved by t."""
    return tuple(q) + tuple(c / 2 for c in multiply(tuple(t) + (0.0,), q))


def after(a, b):
    """The motion b, then the motion a."""
    return multiply(a[:4], b[:4]) + plus(multiply(a[:4], b[4:]), multiply(a[4:], b[:4]))


class Screw:
    """About a line in the direction u through c: turned by an angle, moved along by a length."""

    def __init__(self, generator, most):
        size = 0
        while size < 0.1:
            u = [generator.gauss(0, 1) for _ in range(3)]
            size = math.hypot(*u)
        self.u = tuple(x / size for x in u)
        self.c = tuple(generator.uniform(-2, 2) for _ in range(3))
        self.angle, self.length = generator.uniform(0.1, most), generator.uniform(-2, 2)

    def motor(self, t=1.0):
        half = t * self.angle / 2
        q = tuple(x * math.sin(half) for x in self.u) + (math.cos(half),)
        return motor(q, plus(plus(self.c, turned(q, self.c), -1), self.u, t * self.length))

    def the_long_way(self):
        """The same end, by the rest of the turn in the other direction."""
        other = Screw(random.Random(0), 1)
        other.u, other.c = tuple(-x for x in self.u), self.c
        other.angle, other.length = 2 * math.pi - self.angle, -self.length
        return other


def screws(count, seed, most=6.0):
    generator = random.Random(seed)
    return [Screw(generator, most) for _ in range(count)]


def motors(count, seed):
    return [s.motor() for s in screws(count, seed)]


class Motors(EvalTest):
    def check(self, operation, header, given, expected_header, expected, *options, tolerance=3e-14):
        """In both layouts and types; errors of f32 are those of f64 in its unit."""
        stdin = table(header + "\n", given)
        for kind, unit in (("f64", 1.0), ("f32", 2.0 ** 29)):
            for layout in ("soa", "aos"):
                names, out = self.evaluate(operation, stdin, "--type", kind, "--layout", layout, *options)
                self.assertEqual(names, expected_header.split())
                self.assertEqual(len(out), len(expected))
                for row, values in zip(out, expected):
                    self.assertNear(row, values, tolerance * unit)

    def test_a_motor_is_a_rotation_and_half_of_the_translation_times_it(self):
        generator = random.Random(1)
        rotations = random_rotations(40)
        poses = [q + tuple(generator.uniform(-3, 3) for _ in range(3)) for q in rotations]
        made = [motor(p[:4], p[4:]) for p in poses]
        pose_header = "qx qy qz qw tx ty tz"
        self.check("from_rotation_translation", pose_header, poses, columns("m"), made)
        self.check("to_rotation_translation", columns("m"), made, pose_header, poses)
        # Of any length.
        twice = [tuple(2 * c for c in m) for m in made]
        self.check("to_rotation_translation", columns("m"), twice, pose_header,
                   [tuple(2 * c for c in p[:4]) + p[4:] for p in poses])

    def test_transform_turns_and_moves(self):
        generator = random.Random(2)
        given, expected = [], []
        for q in random_rotations(40, 2):
            t, p = [tuple(generator.uniform(-3, 3) for _ in range(3)) for _ in range(2)]
            given.append(motor(q, t) + p)
            expected.append(plus(turned(q, p), t))
        self.check("transform", columns("m") + " px py pz", given, "rx ry rz", expected)

    def test_multiply_moves_by_b_and_then_by_a(self):
        a, b = motors(40, 3), motors(40, 4)
        header = columns("a", "b")
        given = [p + q for p, q in zip(a, b)]
        self.check("motor_multiply", header, given, columns("m"), [after(p, q) for p, q in zip(a, b)])
        points = [(1.0, -2.0, 0.5)] * len(a)
        _, once = self.evaluate("transform", table(columns("m") + " px py pz\n", [q + p for q, p in zip(b, points)]))
        _, twice = self.evaluate("transform", table(columns("m") + " px py pz\n",
                                                    [p + tuple(r) for p, r in zip(a, once)]))
        _, product = self.evaluate("motor_multiply", table(header + "\n", given))
        self.check("transform", columns("m") + " px py pz", [tuple(m) + p for m, p in zip(product, points)],
                   "rx ry rz", twice, tolerance=1e-13)

    def test_conjugate_is_the_motion_backwards(self):
        given = motors(40, 5)
        back = [conjugate(m[:4]) + conjugate(m[4:]) for m in given]
        for m, r in zip(given, back):
            self.assertNear(after(m, r), (0, 0, 0, 1, 0, 0, 0, 0))
        self.check("motor_conjugate", columns("m"), given, columns("m"), back)

    def test_normalize_goes_to_the_unit_motors(self):
        generator = random.Random(6)
        given, expected = [], []
        for m in motors(40, 6):
            length, along = generator.uniform(0.1, 3), generator.uniform(-1, 1)
            given.append(tuple(length * c for c in m[:4]) + plus([length * c for c in m[4:]], m[:4], along))
            expected.append(m)
        self.check("motor_normalize", columns("m"), given + [(0.0,) * 8], columns("m"),
                   expected + [(0, 0, 0, 1, 0, 0, 0, 0)])

    def test_the_square_root_is_half_of_the_screw(self):
        # Up to a full turn, where the root with w >= 0 is half of the same turn.
        found = screws(40, 7, 6.0)
        self.check("motor_square_root", columns("m"), [s.motor() for s in found], columns("m"),
                   [s.motor(0.5) for s in found], tolerance=1e-12)

    def test_the_logarithm_is_half_of_the_angle_about_the_line(self):
        found = screws(40, 8, 6.0)
        given = [s.motor() for s in found]
        logs = [tuple(x * s.angle / 2 for x in s.u) +
                tuple(x * s.length / 2 + y * s.angle / 2 for x, y in zip(s.u, cross(s.c, s.u))) for s in found]
        translation = (0.0, 0.0, 0.0, 1.0, 0.5, 1.0, 1.5, 0.0)
        given.append(translation)
        logs.append((0, 0, 0, 0.5, 1.0, 1.5))
        self.check("motor_log", columns("m"), given, "bx by bz nx ny nz", logs, tolerance=1e-12)
        self.check("motor_exp", "bx by bz nx ny nz", logs, columns("m"), given)

    def test_a_power_is_a_part_of_the_screw(self):
        found = screws(40, 9, 6.0)
        generator = random.Random(9)
        exponents = [generator.uniform(-1, 1) for _ in found]
        given = [s.motor() for s in found]
        for options, t in (((), 0.5), (("--t", "-0.75"), -0.75)):
            self.check("motor_power", columns("m"), given, columns("m"), [s.motor(t) for s in found], *options,
                       tolerance=1e-12)
        self.check("motor_power", "t " + columns("m"), [(t,) + m for t, m in zip(exponents, given)], columns("m"),
                   [s.motor(t) for s, t in zip(found, exponents)], "--t", "column", tolerance=1e-12)

    def test_sclerp_goes_along_the_screw_from_a_to_b(self):
        generator = random.Random(10)
        starts, between = motors(40, 10), screws(40, 11, 3.0)
        parameters = [generator.uniform(-0.25, 1.25) for _ in starts]
        ends = [after(a, s.motor()) for a, s in zip(starts, between)]
        # b and -b are the same pose.
        ends = [tuple(-c for c in b) if generator.random() < 0.5 else b for b in ends]
        header = columns("a", "b")
        given = [a + b for a, b in zip(starts, ends)]
        self.check("sclerp", header, given, columns("m"),
                   [after(a, s.motor(0.5)) for a, s in zip(starts, between)])
        with_t = [p + (t,) for p, t in zip(given, parameters)]
        self.check("sclerp", header + " t", with_t, columns("m"),
                   [after(a, s.motor(t)) for a, s, t in zip(starts, between, parameters)], "--t", "column")
        self.check("sclerp", header + " t", with_t, columns("m"),
                   [after(a, s.the_long_way().motor(t)) for a, s, t in zip(starts, between, parameters)],
                   "--t", "column", "--way", "long", tolerance=1e-12)
        self.fails(1, f"<stdin>:1:{len(header) + 1}: the column 't' is missing", "eval", "sclerp", "--t", "column",
                   stdin=header + "\n")

    def test_a_whole_path_is_a_table_of_parameters(self):
        # A quarter of a turn about the line through (1, 0, 0), upwards by 2.
        screw = screws(1, 12)[0]
        screw.u, screw.c, screw.angle, screw.length = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), math.pi / 2, 2.0
        start = motor((0, 0, 0, 1), (0, 0, 0))
        steps = [k / 8 for k in range(9)]
        path = self.succeeds("eval", "sclerp", "--t", "column",
                             stdin=table("t " + columns("a", "b") + "\n",
                                         [(t,) + start + screw.motor() for t in steps])).stdout
        _, poses = self.evaluate("to_rotation_translation", path)
        for t, pose in zip(steps, poses):
            angle = t * math.pi / 2
            self.assertNear(pose, [0, 0, math.sin(angle / 2), math.cos(angle / 2), 1 - math.cos(angle),
                                   -math.sin(angle), 2 * t])

    def test_blend_is_the_normalised_sum_on_the_side_of_the_first(self):
        generator = random.Random(13)
        for count, options in ((2, ()), (1, ("--motors", "1")), (4, ("--motors", "4"))):
            header = columns(*("m" + str(k + 1) for k in range(count)))
            header += "".join(" w" + str(k + 1) for k in range(count))
            given, expected = [], []
            for first in motors(30, 14):
                all_of_row = [first]
                for s in screws(count - 1, generator.random(), 1.5):
                    m = after(first, s.motor())
                    all_of_row.append(tuple(-c for c in m) if generator.random() < 0.5 else m)
                weights = [generator.uniform(0.1, 1) for _ in range(count)]
                total = (0.0,) * 8
                for m, w in zip(all_of_row, weights):
                    side = math.copysign(1, sum(x * y for x, y in zip(first[:4], m[:4])))
                    total = plus(total, m, side * w)
                length = math.sqrt(sum(c * c for c in total[:4]))
                r = [c / length for c in total[:4]]
                d = [c / length for c in total[4:]]
                expected.append(tuple(r) + plus(d, r, -sum(x * y for x, y in zip(r, d))))
                given.append(tuple(c for m in all_of_row for c in m) + tuple(weights))
            self.check("blend", header, given, columns("m"), expected, *options)
        self.fails(2, "--motors: ", "eval", "blend", "--motors", "0", stdin="")
        self.fails(2, "--motors: ", "eval", "blend", "--motors", "257", stdin="")
        self.fails(2, "--weights: one for each of the --motors", "eval", "blend", "--weights", "1,2,3", stdin="")
        self.fails(2, "--weights: 'a' is no finite number", "eval", "blend", "--weights", "1,a", stdin="")
        self.fails(1, "<stdin>:1:", "eval", "blend", "--motors", "3", stdin=columns("m1", "m2") + " w1 w2\n")

    def test_decompose_is_swing_twist_and_translation_and_compose_the_inverse(self):
        generator = random.Random(15)
        rotations = random_rotations(40, 15)
        moves = [tuple(generator.uniform(-3, 3) for _ in range(3)) for _ in rotations]
        given = [motor(q, t) for q, t in zip(rotations, moves)]
        factors_header = "sx sy sz sw tx ty tz tw px py pz"
        for text, axis in (("z", (0, 0, 1)), ("3,-4,12", (3, -4, 12))):
            for product in ("swing-twist", "twist-swing"):
                expected = []
                for q, t in zip(rotations, moves):
                    swing, twist = swing_twist(q, axis)
                    if product == "twist-swing":
                        swing = multiply(conjugate(twist), q)
                    expected.append(swing + twist + t)
                # Close to the pole, the twist is that much less certain.
                self.check("motor_decompose", columns("m"), given, factors_header, expected, "--axis", text,
                           "--product", product, tolerance=1e-12)
                self.check("motor_compose", factors_header, expected, columns("m"), given, "--product", product)
        axes = [tuple(generator.uniform(-9, 9) for _ in range(3)) for _ in rotations]
        self.check("motor_decompose", columns("m") + " ax ay az", [m + a for m, a in zip(given, axes)], factors_header,
                   [swing_twist(q, a)[0] + swing_twist(q, a)[1] + t for q, a, t in zip(rotations, axes, moves)],
                   "--axis", "columns", tolerance=1e-12)
        _, out = self.evaluate("motor_decompose", table(columns("m") + "\n", given), "--positive-twist")
        for q, row in zip(rotations, out):
            swing, twist = swing_twist(q, (0, 0, 1))
            self.assertNear(row[:8], swing + tuple(math.copysign(1, twist[3]) * c for c in twist), 1e-12)

    def test_reproducible_is_the_same_text_on_every_isa_and_layout(self):
        a, b = motors(70, 16), motors(70, 17)
        pairs = table(columns("a", "b") + "\n", [p + q for p, q in zip(a, b)])
        singles = table(columns("m") + "\n", a)
        for operation, stdin in (("sclerp", pairs), ("motor_multiply", pairs), ("motor_log", singles),
                                 ("motor_power", singles), ("motor_decompose", singles)):
            texts = {self.succeeds("eval", operation, "--isa", isa, "--layout", layout, "--precision", "reproducible",
                                   stdin=stdin).stdout for isa in usable_isas() for layout in ("soa", "aos")}
            self.assertEqual(len(texts), 1, operation)

    def test_every_operation_has_an_example(self):
        for operation in ("from_rotation_translation", "to_rotation_translation", "transform", "motor_multiply",
                          "motor_conjugate", "motor_normalize", "motor_square_root", "motor_log", "motor_exp",
                          "motor_power", "sclerp", "blend", "motor_decompose", "motor_compose"):
            self.assertIn("Examples:", self.succeeds("eval", operation, "--help").stdout.decode(), operation)


if __name__ == "__main__":
    main()
