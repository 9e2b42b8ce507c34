"""The operations of `eval` on conformal rotors."""

import math

from support import HEADER, EvalTest, main

ROTOR = ("rs r12 r13 r14 r15 r23 r24 r25 r34 r35 r45 r1234 r1235 r1245 r1345 r2345").split()


def pair(a, b):
    names = [name.replace("r", prefix) for prefix in "ab" for name in ROTOR]
    return " ".join(names) + "\n" + " ".join(map(repr, [*a, *b])) + "\n"


class Conformal(EvalTest):
    def test_conformal_rotors_are_those_of_their_motions(self):
        _, turns = self.evaluate("conformal_from_rotation", HEADER + "0 0 0.6 0.8\n")
        names, shifts = self.evaluate("conformal_from_translation", "tx ty tz\n1 2 3\n")
        self.assertEqual(names, [*ROTOR])
        _, scales = self.evaluate("conformal_from_dilation", "factor\n4\n")
        _, motors = self.evaluate("conformal_from_motor",
                                  "mx my mz mw mdx mdy mdz mdw\n0 0 0.6 0.8 1 0.5 1.2 -0.9\n")
        _, both = self.evaluate("conformal_multiply", pair(shifts[0], turns[0]))
        self.assertNear(motors[0], both[0], 1e-14)
        _, all_three = self.evaluate("conformal_multiply", pair(both[0], scales[0]))
        # (1, 0, 0) times 4, turned by 2 atan2(0.6, 0.8) about z, and moved.
        for kind, tolerance in (("f64", 1e-14), ("f32", 1e-5)):
            _, moved = self.evaluate("conformal_transform", " ".join(ROTOR) + " px py pz\n" +
                                     " ".join(map(repr, all_three[0])) + " 1 0 0\n", "--type", kind)
            self.assertNear(moved[0], [4 * 0.28 + 1, 4 * 0.96 + 2, 3], tolerance)
        _, back = self.evaluate("conformal_reverse", " ".join(ROTOR) + "\n" +
                                " ".join(map(repr, all_three[0])) + "\n")
        _, one = self.evaluate("conformal_multiply", pair(all_three[0], back[0]))
        self.assertNear(one[0], [1] + [0] * 15, 1e-13)

    def test_conformal_functions_belong_together(self):
        bivector = [0.3, -0.2, -1, -1, 0.7, 0.5, 0.5, 0.25, 0.25, 0.4]
        header = " ".join(name.replace("r", "b") for name in ROTOR[1:11]) + "\n"
        stdin = header + " ".join(map(repr, bivector)) + "\n"
        for kind, tolerance in (("f64", 1e-14), ("f32", 2e-6)):
            for layout in ("soa", "aos"):
                options = ["--type", kind, "--layout", layout]
                names, out = self.evaluate("conformal_exp", stdin, *options)
                self.assertEqual(names, [*ROTOR])
                rotor = " ".join(ROTOR) + "\n" + " ".join(map(repr, out[0])) + "\n"
                _, log = self.evaluate("conformal_log", rotor, *options)
                self.assertNear(log[0], bivector + [1], tolerance)
                names, root = self.evaluate("conformal_square_root", rotor, *options)
                self.assertEqual(names[-1], "unique")
                _, half = self.evaluate("conformal_power", rotor, *options, "--t", "0.5")
                self.assertNear(half[0], root[0], tolerance)
                _, square = self.evaluate("conformal_multiply", pair(root[0][:16], root[0][:16]), *options)
                self.assertNear(square[0], out[0], tolerance)
                one = [1] + [0] * 15
                _, part = self.evaluate("conformal_interpolate", pair(one, out[0]), *options, "--t", "0.5")
                self.assertNear(part[0], root[0], tolerance)
                names, parts = self.evaluate("conformal_split", stdin, *options)
                self.assertEqual(names[:2] + names[10:12] + names[20:], ["f12", "f13", "g12", "g13", "unique"])
                self.assertNear([a + b for a, b in zip(parts[0][:10], parts[0][10:20])], bivector, tolerance)

    def test_minus_one_has_no_conformal_root_of_its_own(self):
        minus_one = " ".join(ROTOR) + "\n-1" + " 0" * 15 + "\n"
        _, root = self.evaluate("conformal_square_root", minus_one)
        self.assertEqual(root[0], [0, 0, 0, 0, 0, -1] + [0] * 11)
        _, log = self.evaluate("conformal_log", minus_one)
        self.assertEqual(log[0], [0, 0, 0, 0, -math.pi, 0, 0, 0, 0, 0, 0])


if __name__ == "__main__":
    main()
