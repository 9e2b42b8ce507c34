"""The operations of `eval` against the mathematics written a second time."""

import math
import random

from support import (HEADER, EvalTest, conjugate, main, multiply, random_rotations, rotation_of, rows, swing_twist,
                     table, usable_isas)

AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1), "3,-4,12": (3, -4, 12), "-1e-200,2e-200,0": (-1, 2, 0)}


class Operations(EvalTest):
    def test_a_half_turn_about_z_is_a_twist_on_every_isa_in_both_precisions(self):
        for isa in usable_isas():
            for precision in ("fast", "reproducible"):
                names, out = self.evaluate("decompose", HEADER + "0 0 1 0\n", "--axis", "z", "--isa", isa,
                                           "--precision", precision)
                self.assertEqual(names, "sx sy sz sw tx ty tz tw".split())
                self.assertNear(out[0], [0, 0, 0, 1, 0, 0, 1, 0], 1e-15)
                if precision == "reproducible":
                    self.assertEqual(out[0], [0, 0, 0, 1, 0, 0, 1, 0])

    def test_decompose_is_the_definition(self):
        rotations = random_rotations(101)
        stdin = table(HEADER, rotations)
        for text, axis in AXES.items():
            for kind, tolerance in (("f64", 1e-13), ("f32", 3e-5)):
                for layout in ("soa", "aos"):
                    options = ["--axis", text, "--layout", layout, "--type", kind]
                    if kind == "f32" and "e-200" in text:
                        continue
                    names, out = self.evaluate("decompose", stdin, *options)
                    self.assertEqual(names, "sx sy sz sw tx ty tz tw".split())
                    for q, row in zip(rotations, out):
                        swing, twist = swing_twist(q, axis)
                        self.assertNear(row, swing + twist, tolerance)
                    _, out = self.evaluate("decompose", stdin, *options, "--product", "twist-swing")
                    for q, row in zip(rotations, out):
                        _, twist = swing_twist(q, axis)
                        self.assertNear(row, multiply(conjugate(twist), q) + twist, tolerance)

    def test_the_parts_are_those_of_decompose(self):
        stdin = table(HEADER, random_rotations(50))
        for options in (["--axis", "y"], ["--axis", "1,2,3", "--product", "twist-swing", "--positive-twist"]):
            _, full = self.evaluate("decompose", stdin, *options, "--precision", "reproducible")
            for operation, form, part in (("twist", "twist", slice(4, 8)), ("swing", "swing", slice(0, 4))):
                for command in (["decompose", "--form", form], [operation]):
                    _, out = self.evaluate(command[0], stdin, *command[1:], *options, "--precision", "reproducible")
                    self.assertEqual(out, [row[part] for row in full])
            angle = self.evaluate("twist_angle", stdin, *options)
            self.assertEqual(angle, self.evaluate("decompose", stdin, *options, "--form", "angle"))
            self.assertEqual(angle[0], ["angle"])
            for (radians,), row in zip(angle[1], full):
                self.assertAlmostEqual(math.cos(radians / 2), row[7], places=12)
                if "--positive-twist" in options:
                    self.assertLessEqual(abs(radians), math.pi)

    def test_the_compact_form_is_the_full_one_without_its_zeros(self):
        stdin = table(HEADER, random_rotations(50))
        for k, axis in enumerate("xyz"):
            for product in ("swing-twist", "twist-swing"):
                options = ["--axis", axis, "--product", product]
                _, full = self.evaluate("decompose", stdin, *options)
                names, compact = self.evaluate("decompose", stdin, *options, "--form", "compact")
                self.assertEqual(names, ["s1", "s2", "sc", "ts", "tc"])
                for row, five in zip(full, compact):
                    self.assertNear(five, [row[(k + 1) % 3], row[(k + 2) % 3], row[3], row[4 + k], row[7]])

    def test_compose_restores_the_rotation(self):
        rotations = random_rotations(77)
        stdin = table(HEADER, rotations)
        for form in ("full", "compact"):
            for product in ("swing-twist", "twist-swing"):
                for signs in ([], ["--signs"]):
                    for axis in "xyz":
                        options = ["--axis", axis, "--form", form, "--product", product, *signs]
                        factors = self.succeeds("eval", "decompose", *options, stdin=stdin).stdout
                        names, out = self.evaluate("compose", factors, *options)
                        self.assertEqual(names, ["qx", "qy", "qz", "qw"])
                        for q, row in zip(rotations, out):
                            self.assertNear(q, row)

    def test_signs_restore_what_a_positive_twist_forgets(self):
        factors = self.succeeds("eval", "decompose", "--signs", "--precision", "reproducible",
                                stdin=HEADER + "0 0 0 -1\n0 0 0 1\n").stdout
        self.assertEqual(factors.splitlines()[0], b"sx,sy,sz,sw,tx,ty,tz,tw,sign")
        _, values = rows(factors)
        self.assertEqual([(row[7], row[8]) for row in values], [(1, -1), (1, 1)])
        _, out = self.evaluate("compose", factors, "--signs", "--precision", "reproducible")
        self.assertEqual([row[3] for row in out], [-1, 1])
        self.fails(1, "<stdin>:1:25: unknown column 'sign'", "eval", "compose", stdin=factors)

    def test_every_row_may_have_its_axis(self):
        generator = random.Random(2)
        rotations = random_rotations(40)
        axes = [tuple(generator.uniform(-9, 9) for _ in range(3)) for _ in rotations]
        stdin = table("az ay ax " + HEADER, [(a[2], a[1], a[0]) + q for a, q in zip(axes, rotations)])
        for layout in ("soa", "aos"):
            _, out = self.evaluate("decompose", stdin, "--axis", "columns", "--layout", layout)
            for q, a, row in zip(rotations, axes, out):
                swing, twist = swing_twist(q, a)
                self.assertNear(row, swing + twist)
        _, out = self.evaluate("twist", "ax ay az " + HEADER + "0 0 0 0 0 .6 .8\nnan 0 1 0 0 .6 .8\n0 0 5 0 0 .6 .8\n",
                               "--axis", "columns")
        self.assertNear(out[0], [0, 0, 0, 1])
        self.assertTrue(all(math.isnan(x) for x in out[1]))
        self.assertNear(out[2], [0, 0, 0.6, 0.8])
        self.fails(1, "<stdin>:1:12: the column 'ax' is missing, expected a header row with the columns "
                   "qx qy qz qw ax ay az", "eval", "twist", "--axis", "columns", stdin=HEADER)

    def test_reproducible_is_the_same_text_on_every_isa_and_layout(self):
        stdin = table(HEADER, random_rotations(333) + [(1, 0, 0, 0), (1, 0, 0, -0.0), (0, 0, 0, 0), (1, 1e-17, 0, 0)])
        for kind in ("f32", "f64"):
            for operation in ("decompose", "twist", "swing", "twist_angle"):
                texts = {self.succeeds("eval", operation, "--axis", "1,-2,3", "--type", kind, "--isa", isa, "--layout",
                                       layout, "--precision", "reproducible", stdin=stdin).stdout
                         for isa in usable_isas() for layout in ("soa", "aos")}
                self.assertEqual(len(texts), 1, operation)

    def test_the_exponentials_are_the_definitions(self):
        rotations = random_rotations(60)
        generator = random.Random(3)
        exponents = [generator.uniform(-2, 2) for _ in rotations]
        stdin = table(HEADER, rotations)
        logs = []
        for x, y, z, w in rotations:
            m = math.hypot(x, y, z)
            angle = math.atan2(m, w)
            logs.append((x / m * angle, y / m * angle, z / m * angle))

        def about(b, t):
            size = math.hypot(*b)
            return [c / size * math.sin(t * size) for c in b] + [math.cos(t * size)]

        for kind, tolerance in (("f64", 1e-14), ("f32", 2e-6)):
            names, out = self.evaluate("log", stdin, "--type", kind)
            self.assertEqual(names, ["bx", "by", "bz"])
            for b, row in zip(logs, out):
                self.assertNear(row, b, tolerance)
            names, out = self.evaluate("exp", table("bx by bz\n", logs), "--type", kind)
            self.assertEqual(names, ["qx", "qy", "qz", "qw"])
            for q, row in zip(rotations, out):
                self.assertNear(row, q, tolerance)
            names, out = self.evaluate("square_root", stdin, "--type", kind)
            self.assertEqual(names, ["rx", "ry", "rz", "rw"])
            for q, row in zip(rotations, out):
                self.assertNear(multiply(row, row), q, tolerance)
                self.assertGreaterEqual(row[3], 0)
            for options, t in ((["--t", "-1.5"], -1.5), ([], 0.5)):
                names, out = self.evaluate("power", stdin, "--type", kind, *options)
                self.assertEqual(names, ["rx", "ry", "rz", "rw"])
                for b, row in zip(logs, out):
                    self.assertNear(row, about(b, t), tolerance)
            rows_with_t = table("t " + HEADER, [(t,) + q for t, q in zip(exponents, rotations)])
            _, out = self.evaluate("power", rows_with_t, "--type", kind, "--t", "column")
            for b, t, row in zip(logs, exponents, out):
                self.assertNear(row, about(b, t), tolerance)
        _, out = self.evaluate("log", HEADER + "0 0 0 -2\n0 0 0 0\n0 0 0 5\n", "--precision", "reproducible")
        self.assertEqual(out, [[math.pi, 0, 0], [0, 0, 0], [0, 0, 0]])
        self.fails(1, "<stdin>:1:12: the column 't' is missing", "eval", "power", "--t", "column", stdin=HEADER)
        self.fails(2, "--t: 'half' is neither a finite number nor column", "eval", "power", "--t", "half",
                   stdin=HEADER)

    def test_arcs_turn_one_vector_to_the_other(self):
        generator = random.Random(4)

        def direction(v):
            length = math.hypot(*v)
            return [c / length for c in v]

        pairs = [tuple(generator.uniform(-9, 9) for _ in range(6)) for _ in range(50)]
        pairs += [(1, 2, 3, -2, -4, -6), (0, 0, 1, 0, 0, -1), (1, 2, 3, 1, 2, 3), (1e-200, 0, 0, 0, 1e200, 0)]
        angles = [generator.uniform(-6, 6) for _ in pairs]
        header = "vx vy vz wx wy wz"

        def turned(q, v):
            return multiply(multiply(q, tuple(v) + (0,)), conjugate(q))[:3]

        names, arcs = self.evaluate("shortest_arc", table(header + "\n", pairs))
        self.assertEqual(names, ["qx", "qy", "qz", "qw"])
        for p, q in zip(pairs, arcs):
            self.assertNear(turned(q, direction(p[:3])), direction(p[3:]), 1e-14)
            self.assertGreaterEqual(q[3], 0)
            # The axis is perpendicular to both.
            self.assertLessEqual(abs(sum(a * b for a, b in zip(q, direction(p[:3])))), 1e-14)
        stdin = table(header + " angle\n", [p + (a,) for p, a in zip(pairs, angles)])
        for product, first in (("swing-twist", slice(0, 3)), ("twist-swing", slice(3, 6))):
            _, out = self.evaluate("arc_with_twist", stdin, "--angle", "column", "--product", product)
            for p, a, arc, q in zip(pairs, angles, arcs, out):
                twist = [c * math.sin(a / 2) for c in direction(p[first])] + [math.cos(a / 2)]
                expected = multiply(arc, twist) if product == "swing-twist" else multiply(twist, arc)
                self.assertNear(q, expected, 1e-14)
                self.assertNear(turned(q, direction(p[:3])), direction(p[3:]), 1e-14)
        self.assertEqual(self.evaluate("arc_with_twist", table(header + "\n", pairs), "--precision", "reproducible")[0],
                         names)
        _, out = self.evaluate("arc_with_twist", header + "\n1 0 0 2 0 0\n", "--angle", "1")
        self.assertNear(out[0], [math.sin(0.5), 0, 0, math.cos(0.5)])

    def test_at_the_pole_the_twist_is_left_out(self):
        _, out = self.evaluate("decompose", HEADER + "1 0 0 0\n1 0 0 -0.0\n0 0 0 0\n")
        self.assertEqual([row[4:] for row in out], [[0, 0, 0, 1], [0, 0, 0, -1], [0, 0, 0, 1]])
        self.assertEqual([row[:4] for row in out], [[1, 0, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 0]])
        # Half a degree from the pole: kept, but not with a threshold of 1e-4.
        half = math.radians(179.5) / 2
        near = table(HEADER, [(math.sin(half), 0, math.cos(half) * 0.6, math.cos(half) * 0.8)])
        _, out = self.evaluate("decompose", near)
        self.assertNear(out[0][4:], [0, 0, 0.6, 0.8])
        _, out = self.evaluate("decompose", near, "--pole-threshold", "1e-4")
        self.assertEqual(out[0][4:], [0, 0, 0, 1])

    def test_multiply_is_the_hamilton_product(self):
        a, b = random_rotations(60, 11), random_rotations(60, 12)
        stdin = table("ax ay az aw bx by bz bw\n", [p + q for p, q in zip(a, b)])
        for kind, tolerance in (("f64", 1e-15), ("f32", 1e-6)):
            names, out = self.evaluate("multiply", stdin, "--type", kind)
            self.assertEqual(names, "qx qy qz qw".split())
            for p, q, row in zip(a, b, out):
                self.assertNear(row, multiply(p, q), tolerance)

    def test_conjugate_turns_the_vector_part_around(self):
        rotations = random_rotations(20) + [(3, -4, 12, 84)]
        names, out = self.evaluate("conjugate", table(HEADER, rotations))
        self.assertEqual(names, "qx qy qz qw".split())
        for q, row in zip(rotations, out):
            self.assertEqual(tuple(row), conjugate(q))
        self.assertEqual(self.succeeds("eval", "conjugate", stdin=HEADER + "nan -0.0 inf -1\n").stdout.splitlines()[1]
                         .replace(b"-nan", b"nan"), b"nan,0,-inf,-1")

    def test_normalize_divides_by_the_length_whatever_it_is(self):
        rotations = random_rotations(40)
        for scale, kind, tolerance in ((1, "f64", 1e-15), (1e-300, "f64", 1e-15), (1e307, "f64", 1e-15),
                                       (1e-37, "f32", 1e-6), (1e38, "f32", 1e-6)):
            stdin = table(HEADER, [[scale * c for c in q] for q in rotations])
            _, out = self.evaluate("normalize", stdin, "--type", kind)
            for q, row in zip(rotations, out):
                self.assertNear(row, q, tolerance)
        _, out = self.evaluate("normalize", HEADER + "0 0 0 0\n0 0 3 4\n", "--precision", "reproducible")
        self.assertEqual(out, [[0, 0, 0, 1], [0, 0, 0.6, 0.8]])

    def test_rotate_is_the_product_with_the_conjugate_on_both_sides(self):
        generator = random.Random(13)
        rotations = random_rotations(60)
        vectors = [tuple(generator.uniform(-9, 9) for _ in range(3)) for _ in rotations]
        stdin = table("vx vy vz " + HEADER, [v + q for v, q in zip(vectors, rotations)])
        for layout in ("soa", "aos"):
            names, out = self.evaluate("rotate", stdin, "--layout", layout)
            self.assertEqual(names, ["rx", "ry", "rz"])
            for q, v, row in zip(rotations, vectors, out):
                self.assertNear(row, multiply(multiply(q, v + (0.0,)), conjugate(q))[:3])

    def test_rotate_by_one_rotation_is_rotate_by_it_in_every_row(self):
        generator = random.Random(18)
        q = random_rotations(1, 18)[0]
        vectors = [tuple(generator.uniform(-9, 9) for _ in range(3)) for _ in range(50)]
        _, each = self.evaluate("rotate", table("vx vy vz " + HEADER, [v + q for v in vectors]))
        _, one = self.evaluate("rotate", table("vx vy vz\n", vectors), "--by", ",".join(map(repr, q)))
        for a, b in zip(each, one):
            self.assertNear(a, b, 1e-14)
        for given, message in (("0,0,1", "--by: '0,0,1' is not four numbers, x y z w"),
                               ("0,0,1,x", "--by: 'x' is no finite number"),
                               ("0,0,1,nan", "--by: 'nan' is no finite number")):
            self.fails(2, message, "eval", "rotate", "--by", given, stdin="vx vy vz\n")

    def test_angle_between_is_twice_the_arc_cosine_of_the_product(self):
        a, b = random_rotations(60, 19), random_rotations(60, 20)
        names, out = self.evaluate("angle_between", table("ax ay az aw bx by bz bw\n", [p + q for p, q in zip(a, b)]))
        self.assertEqual(names, ["angle"])
        for p, q, row in zip(a, b, out):
            self.assertNear(row, [2 * math.acos(abs(math.fsum(x * y for x, y in zip(p, q))))], 1e-7)

    def test_dot_is_the_sum_of_the_products(self):
        a, b = random_rotations(60, 14), random_rotations(60, 15)
        names, out = self.evaluate("dot", table("ax ay az aw bx by bz bw\n", [p + q for p, q in zip(a, b)]))
        self.assertEqual(names, ["dot"])
        for p, q, row in zip(a, b, out):
            self.assertNear(row, [math.fsum(x * y for x, y in zip(p, q))], 1e-15)

    def test_align_signs_takes_the_one_on_the_side_of_the_neighbour(self):
        q, n = random_rotations(60, 16), random_rotations(60, 17)
        names, out = self.evaluate("align_signs", table("qx qy qz qw nx ny nz nw\n", [p + r for p, r in zip(q, n)]))
        self.assertEqual(names, "qx qy qz qw".split())
        for p, r, row in zip(q, n, out):
            self.assertEqual(row, [math.copysign(1, sum(x * y for x, y in zip(p, r))) * c for c in p])

    def test_align_signs_of_a_sequence_goes_on_over_every_row(self):
        # More rows than are read at a time, with a nan where the second block begins.
        generator = random.Random(18)
        curve = [(math.sin(0.001 * i), 0.5, 0.0, math.cos(0.001 * i)) for i in range(2 ** 16 + 3000)]
        given = [q if i == 0 or generator.random() < 0.5 else tuple(-c for c in q) for i, q in enumerate(curve)]
        for bad in (2 ** 16 - 1, 2 ** 16):
            given[bad] = ("nan",) * 4
        stdin = HEADER + "".join(" ".join(str(c) for c in q) + "\n" for q in given)
        for kind, digits in (("f64", 15), ("f32", 6)):
            _, out = self.evaluate("align_signs", stdin, "--sequence", "--type", kind)
            self.assertEqual(len(out), len(curve))
            for i, (q, row) in enumerate(zip(curve, out)):
                if i in (2 ** 16 - 1, 2 ** 16):
                    self.assertTrue(all(math.isnan(c) for c in row))
                else:
                    self.assertNear(row, q, 10 ** -digits)
        self.fails(1, "<stdin>:1:13: unknown column 'nx'", "eval", "align_signs", "--sequence",
                   stdin="qx qy qz qw nx ny nz nw\n")

    def test_from_axis_angle_is_the_definition(self):
        generator = random.Random(3)
        angles = [generator.uniform(-9, 9) for _ in range(40)]
        axes = [tuple(generator.uniform(-9, 9) for _ in range(3)) for _ in angles]

        def expected(axis, angle):
            length = math.sqrt(sum(c * c for c in axis))
            return [c / length * math.sin(angle / 2) for c in axis] + [math.cos(angle / 2)]

        for text, axis in (("x", (1, 0, 0)), ("z", (0, 0, 1)), ("3,-4,12", (3, -4, 12))):
            names, out = self.evaluate("from_axis_angle", table("angle\n", [(a,) for a in angles]), "--axis", text)
            self.assertEqual(names, ["qx", "qy", "qz", "qw"])
            for angle, row in zip(angles, out):
                self.assertNear(row, expected(axis, angle))
        stdin = table("ax ay az angle\n", [v + (a,) for v, a in zip(axes, angles)] + [(0, 0, 0, 2)])
        _, out = self.evaluate("from_axis_angle", stdin, "--axis", "columns")
        for axis, angle, row in zip(axes, angles, out):
            self.assertNear(row, expected(axis, angle))
        self.assertEqual(out[-1], [0, 0, 0, 1])

    def test_to_axis_angle_is_the_definition(self):
        rotations = random_rotations(50)
        names, out = self.evaluate("to_axis_angle", table(HEADER, rotations + [(0, 0, 0, 1), (0, 3e-200, 4e-200, 1)]))
        self.assertEqual(names, ["ax", "ay", "az", "angle"])
        for q, row in zip(rotations, out):
            length = math.sqrt(sum(c * c for c in q[:3]))
            self.assertNear(row, [c / length for c in q[:3]] + [2 * math.atan2(length, q[3])])
        self.assertEqual(out[-2], [1, 0, 0, 0])
        self.assertNear(out[-1], [0, 0.6, 0.8, 0])
        self.assertAlmostEqual(out[-1][3] / 1e-199, 1)

    def test_spinors_are_moved_with_their_signs(self):
        names, out = self.evaluate("from_spinor", "d c b a\n4 3 2 1\n")
        self.assertEqual((names, out), (["qx", "qy", "qz", "qw"], [[-3, -4, -2, 1]]))
        names, out = self.evaluate("to_spinor", HEADER + "-3 -4 -2 1\n")
        self.assertEqual((names, out), (["a", "b", "c", "d"], [[1, 2, 3, 4]]))

    def test_matrices_turn_vectors_as_the_quaternion_does(self):
        rotations = random_rotations(40) + [(1, 0, 0, 0), (0.6, 0.8, 0, 0), (0, -0.6, 0.8, 0), (0, 0, 0, 1)]
        matrices = []
        for layout in ("soa", "aos"):
            names, matrices = self.evaluate("to_matrix", table(HEADER, rotations), "--layout", layout)
            self.assertEqual(names, ["m" + r + c for r in "xyz" for c in "xyz"])
            for q, m in zip(rotations, matrices):
                for column in range(3):
                    basis = tuple(float(k == column) for k in range(3)) + (0.0,)
                    self.assertNear(m[column::3], multiply(multiply(q, basis), conjugate(q))[:3])
        _, out = self.evaluate("from_matrix", table(" ".join(names) + "\n", matrices))
        for q, row in zip(rotations, out):
            sign = 1 if sum(a * b for a, b in zip(q, row)) > 0 else -1
            self.assertNear(row, [sign * c for c in q])
            self.assertGreaterEqual(math.copysign(1, row[3]), 0)

    def test_euler_angles_are_turns_in_the_order_of_the_channels(self):
        generator = random.Random(5)
        angles = [tuple(generator.uniform(-4, 4) for _ in range(3)) for _ in range(40)]
        for order in ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx"):
            names, out = self.evaluate("from_euler", table("ex ey ez\n", angles), "--order", order)
            self.assertEqual(names, ["qx", "qy", "qz", "qw"])
            channels = [c.upper() + "rotation" for c in order]
            for e, row in zip(angles, out):
                degrees = [math.degrees(e["xyz".index(c)]) for c in order]
                self.assertNear(row, rotation_of(channels, degrees))
            names, back = self.evaluate("to_euler", table(HEADER, out), "--order", order)
            self.assertEqual(names, ["ex", "ey", "ez"])
            for q, e in zip(out, back):
                self.assertLessEqual(abs(e["xyz".index(order[1])]), math.pi / 2)
                again = rotation_of(channels, [math.degrees(e["xyz".index(c)]) for c in order])
                sign = 1 if sum(a * b for a, b in zip(q, again)) > 0 else -1
                self.assertNear(q, [sign * c for c in again])
        # 90 degrees about y between x and z: what is left goes to x.
        half = math.sqrt(0.5)
        _, out = self.evaluate("to_euler", HEADER + f"0 {half!r} 0 {half!r}\n")
        self.assertNear(out[0], [0, math.pi / 2, 0])
        self.fails(2, "--order: 'abc' is none of xyz|xzy|yxz|yzx|zxy|zyx", "eval", "to_euler", "--order", "abc")


if __name__ == "__main__":
    main()
