"""Tables as `eval` reads and writes them."""

import struct

from support import HEADER, CommandTest, main, rows

TWIST_HEADER = b"tx,ty,tz,tw\n"


class Tables(CommandTest):
    def twist(self, table, *options):
        # In fast arithmetic the last digit depends on the processor.
        return self.succeeds("eval", "twist", "--precision", "reproducible", *options, stdin=table).stdout

    def test_separators_and_line_ends_may_be_mixed(self):
        expected = self.twist(HEADER + "0 0 .6 .8\n" * 3)
        for table in (
            "qx,qy,qz,qw\n" + "0,0,.6,.8\n" * 3,
            "qx , qy\t, qz,qw\n0, 0, .6, .8\n0\t0\t.6\t.8\n  0 0  .6 .8  \n",
            "qx qy qz qw\r\n0 0 .6 .8\r\n0 0 .6 .8\r\n0 0 .6 .8\r\n",
            "qx qy qz qw\r0 0 .6 .8\r0 0 .6 .8\r0 0 .6 .8",
            "\n  \nqx qy qz qw\n\n0 0 .6 .8\n\t\n0 0 .6 .8\r\n\r\n0 0 .6 .8\n\n",
            "\ufeffqx qy qz qw\n" + "0 0 .6 .8\n" * 3,
            '"qx","qy","qz","qw"\n' + '"0","0",".6",".8"\n' * 3,
            "qw qz qy qx\n" + ".8 .6 0 0\n" * 3,
        ):
            self.assertEqual(self.twist(table), expected, repr(table))

    def test_a_header_alone_gives_a_header_alone(self):
        for table in ("qx qy qz qw", "qx qy qz qw\n", "qx,qy,qz,qw\r\n\n"):
            self.assertEqual(self.twist(table), TWIST_HEADER)

    def test_numbers_of_every_spelling_are_read(self):
        for spelling in ("1", "+1", "1.", "+1.0", "1e0", "100E-2", "0.1e+1", "00001", "10e-1"):
            self.assertEqual(self.twist(HEADER + "0 0 0 " + spelling + "\n"), TWIST_HEADER + b"0,0,0,1\n", spelling)

    def test_nan_and_infinity_stay_in_their_row(self):
        for spelling in ("nan", "NaN", "-NAN", "+nan", "inf", "-inf", "+INF", "Infinity", "-infinity"):
            out = self.twist(HEADER + "0 0 0 1\n0 0 " + spelling + " 1\n0 0 1 0\n")
            self.assertEqual(out, TWIST_HEADER + b"0,0,0,1\nnan,nan,nan,nan\n0,0,1,0\n", spelling)

    def test_numbers_are_the_shortest_that_read_back(self):
        tiny, huge = "5e-324", "1.7976931348623157e+308"
        columns = "sx sy sz sw tx ty tz tw\n"
        out = self.succeeds("eval", "compose", "--precision", "reproducible",
                            stdin=columns + f"0.1 0 0 {tiny} 0 0 0 1\n-0.3 0 0 {huge} 0 0 0 1\n").stdout
        self.assertEqual(out, b"qx,qy,qz,qw\n0.1,0,0,5e-324\n-0.3,0,0,1.7976931348623157e+308\n")

    def test_f32_is_rounded_once(self):
        # Halfway between two floats but for a little more than a double can see.
        text = "1.00000005960464477540"
        self.assertEqual(struct.unpack("f", struct.pack("f", float(text)))[0], 1.0)
        out = self.succeeds("eval", "compose", "--precision", "reproducible", "--type", "f32",
                            stdin="sx sy sz sw tx ty tz tw\n0 0 0 " + text + " 0 0 0 1\n").stdout
        self.assertEqual(out, b"qx,qy,qz,qw\n0,0,0,1.0000001\n")

    def test_what_is_too_small_is_zero_of_its_sign(self):
        for kind, text in (("f64", "-1e-400"), ("f32", "-1e-400"), ("f32", "-1e-60")):
            out = self.succeeds("eval", "decompose", "--form", "angle", "--type", kind,
                                stdin=HEADER + f"1 0 0 {text}\n").stdout
            _, values = rows(out)
            self.assertAlmostEqual(values[0][0], 6.2831853, places=5, msg=kind)

    def test_bad_data_is_refused_with_its_place(self):
        expected = "expected a header row with the columns qx qy qz qw"
        for table, message in (
            ("", "<stdin>:1:1: the input is empty, " + expected),
            ("\n \r\n", "<stdin>:1:1: the input is empty, " + expected),
            ("0 0 1 0\n", "<stdin>:1:1: unknown column '0', " + expected),
            ("qx qy qz\n", "<stdin>:1:9: the column 'qw' is missing, " + expected),
            ("qx;qy;qz;qw\n", "<stdin>:1:1: unknown column 'qx;qy;qz;qw', " + expected),
            ("qx qy qz qw QW\n", "<stdin>:1:13: unknown column 'QW', " + expected),
            ("qx qy qz qw qy\n", "<stdin>:1:13: the column 'qy' is there twice, expected each column once"),
            ("qx,qy,,qz,qw\n", "<stdin>:1:7: a column without a name, " + expected),
            ("qx,qy,qz,qw,\n", "<stdin>:1:13: a column without a name, " + expected),
            ("qx,qy,qz,\"qw\n", "<stdin>:1:10: a quote that is not closed"),
            ("qx,qy,\"qz\"z,qw\n", "<stdin>:1:11: text right after a quoted field, expected a separator"),
            ("qx,qy,\"qz\" z,qw\n", "<stdin>:1:12: text after a quoted field, expected ','"),
            ("qx qy qz qw\n0 0 1x0 1\n", "<stdin>:2:5: '1x0' is not a number, expected a number"),
            ("qx qy qz qw\n0 0 0,5 1\n", "<stdin>:2:10: row too short: 2 fields, expected 4, as in the header row"),
            ("qx qy qz qw\n0,0 0,1\n", "<stdin>:2:8: row too short: 3 fields, expected 4"),
            ("qx qy qz qw\n0,5 0,5 0,5 0\n", "<stdin>:2:3: '5 0' is not a number"),
            ("qx qy qz qw\n0 0 1\n", "<stdin>:2:6: row too short: 3 fields, expected 4"),
            ("qx qy qz qw\n\n0 0 0 1 0\n", "<stdin>:3:9: row too long: 5 fields, expected 4"),
            ("qx,qy,qz,qw\n0,,0,1\n", "<stdin>:2:3: an empty field, expected a number"),
            ("qx,qy,qz,qw\n0,0,0,\n", "<stdin>:2:7: an empty field, expected a number"),
            ("qx,qy,qz,qw\n,0,0,1\n", "<stdin>:2:1: an empty field, expected a number"),
            ("qx,qy,qz,qw\n0,0,0,1,\n", "<stdin>:2:9: row too long: 5 fields, expected 4"),
            ("qx qy qz qw\n0 0 0 1e999\n", "<stdin>:2:7: '1e999' is too large for f64, expected a number"),
            ("qx qy qz qw\r0 0 0 1\r0 0 0 -\r", "<stdin>:3:7: '-' is not a number"),
            ("qx qy qz qw\n0 0 0 --1\n", "<stdin>:2:7: '--1' is not a number"),
            ("qx qy qz qw\n0 0 0 +-1\n", "<stdin>:2:7: '+-1' is not a number"),
            ("qx qy qz qw\n0 0 0 0x10\n", "<stdin>:2:7: '0x10' is not a number"),
            ("qx qy qz qw\n0 0 0 1e\n", "<stdin>:2:7: '1e' is not a number"),
            ("qx qy qz qw\n0 0 0 1d0\n", "<stdin>:2:7: '1d0' is not a number"),
            ("qx qy qz qw\n0 0 0 nan(1)\n", "<stdin>:2:7: 'nan(1)' is not a number"),
            ("qx qy qz qw\n0 0 0 infinit\n", "<stdin>:2:7: 'infinit' is not a number"),
            ("qx qy qz qw\n0 0 0 1\0\n", "<stdin>:2:7: '1\\x00' is not a number"),
            ("qx qy qz qw\n# 0 0 0\n", "<stdin>:2:1: '#' is not a number"),
            (b"\xff\xfeq\0x\0", "<stdin>:1:1: the text is UTF-16, expected ASCII or UTF-8"),
            ("qx qy qz qw\n" + " " * 1048577, "<stdin>:2:1: the line is too long, expected at most 1048576 bytes"),
        ):
            self.fails(1, message, "eval", "twist", stdin=table)
        self.fails(1, "<stdin>:2:7: '1e39' is too large for f32", "eval", "twist", "--type", "f32",
                   stdin=HEADER + "0 0 0 1e39\n")

    def test_a_line_of_the_largest_length_is_read(self):
        for end in ("", "\n", "\r", "\r\n"):
            line = "0 0 0" + " " * (1048576 - 7) + " 1"
            self.assertEqual(self.twist(HEADER + line + end), TWIST_HEADER + b"0,0,0,1\n")

    def test_the_rows_before_bad_data_are_written_whole(self):
        result = self.fails(1, "<stdin>:4:1: 'x' is not a number", "eval", "twist", "--precision", "reproducible",
                            stdin=HEADER + "0 0 1 0\n0 0 0 1\nx 0 0 1\n0 0 0 1\n")
        self.assertEqual(result.stdout, TWIST_HEADER + b"0,0,1,0\n0,0,0,1\n")

    def test_columns_are_passed_when_asked_for(self):
        table = 'frame,qx,qy,joint,qz,qw,note\n1,0,0,"Arm, ""left""",1,0,\n2,0,0,Hips,0,1,a b\n'
        self.fails(1, "<stdin>:1:1: unknown column 'frame'", "eval", "twist", stdin=table)
        self.assertEqual(
            self.twist(table, "--pass").decode(),
            'frame,joint,note,tx,ty,tz,tw\n1,"Arm, ""left""",,0,0,1,0\n2,Hips,a b,0,0,0,1\n')
        self.fails(1, "<stdin>:1:13: the column 'tx' cannot be passed", "eval", "twist", "--pass",
                   stdin="qx qy qz qw tx\n")
        self.fails(1, "<stdin>:1:15: the column 'n' is there twice", "eval", "twist", "--pass",
                   stdin="qx qy qz qw n n\n")

    def test_columns_without_a_name_are_passed(self):
        table = ",qx,qy,qz,qw\n17,0,0,1,0\n18,0,0,0,1\n"
        self.assertEqual(self.twist(table, "--pass"), b",tx,ty,tz,tw\n17,0,0,1,0\n18,0,0,0,1\n")
        self.assertEqual(self.twist("qx,,qy,\"\",qz,qw\n0,a,0,b,1,0\n", "--pass"), b",,tx,ty,tz,tw\na,b,0,0,1,0\n")
        self.fails(1, "<stdin>:1:1: a column without a name, expected a header row with the columns qx qy qz qw "
                   "(--pass copies other ones)", "eval", "twist", stdin=table)

    def test_semicolons_separate_when_asked_for(self):
        decimal = ("--separator", ";", "--decimal", ",")
        for table in ("qx;qy;qz;qw\n0;0;0,6;0,8\n", "\ufeffqw; qz ;qy;qx\r\n 8e-1;+0,6 ; 0 ;0\r\n",
                      '"qx";"qy";"qz";"qw"\n0;0;"0,6";,8\n'):
            self.assertEqual(self.twist(table, *decimal), TWIST_HEADER + b"0,0,0.6,0.8\n", table)
        self.assertEqual(self.twist("n;qx;qy;qz;qw\n1,5;0;0;1;0\n;0;0;1;0\n", "--pass", *decimal),
                         b'n,tx,ty,tz,tw\n"1,5",0,0,1,0\n,0,0,1,0\n')
        self.assertEqual(self.twist("qx;qy;qz;qw\n0;0;.6;.8\n", "--separator", ";"), TWIST_HEADER + b"0,0,0.6,0.8\n")
        self.assertEqual(self.twist("qx\tqy\tqz\tqw\n0\t0\t0,6\t 0,8 \n", "--separator", "tab", "--decimal", ","),
                         TWIST_HEADER + b"0,0,0.6,0.8\n")
        self.assertEqual(self.twist("q x,qy,qz,qw\n0,0,.6,.8\n", "--separator", ",", "--columns", "q=q x,qy,qz,qw"),
                         TWIST_HEADER + b"0,0,0.6,0.8\n")
        header = "qx;qy;qz;qw\n"
        for row, message in (
            ("0;0;0.6;1", "<stdin>:2:5: '0.6' is not a number, expected a number with a decimal comma"),
            ("0;0;1.000,6;1", "<stdin>:2:5: '1.000,6' is not a number, expected a number with a decimal comma"),
            ("0;0;1", "<stdin>:2:6: row too short: 3 fields, expected 4"),
            ("0;0;1;0;", "<stdin>:2:9: row too long: 5 fields, expected 4"),
            ('0;0;"1" 2;0', "<stdin>:2:9: text after a quoted field, expected ';'"),
        ):
            self.fails(1, message, "eval", "twist", *decimal, stdin=header + row + "\n")

    def test_a_header_with_semicolons_gets_a_hint(self):
        hint = "--separator ';' reads fields between semicolons, --decimal ',' numbers with a comma"
        for header in ("qx;qy;qz;qw\n", "qx; qy; qz; qw\n"):
            for options in ((), ("--pass",)):
                result = self.fails(1, "<stdin>:1:", "eval", "twist", *options, stdin=header)
                self.assertTrue(result.stderr.decode().rstrip().endswith(hint), result.stderr)
        for header, place in (('"qx";"qy";"qz";"qw"\n', "1:5"), ('"qx";"qy, deg";"qz";"qw"\n', "1:5"),
                              ('\ufeff"qx";"qy";"qz";"qw"\r\n', "1:5")):
            result = self.fails(1, f"<stdin>:{place}: text right after a quoted field, expected a separator; " + hint,
                                "eval", "twist", stdin=header)
            self.assertEqual(result.stdout, b"")
        for table in ("a b\n", 'qx,qy,qz,qw,"a;b"\n', "qx;qy,qz,qw\n", HEADER + '"0";0;0;1\n'):
            self.assertNotIn(b"--separator", self.fails(1, "<stdin>:", "eval", "twist", stdin=table).stderr, table)
        self.assertNotIn(b"--separator", self.fails(1, "<stdin>:1:1: ", "eval", "twist", "--separator", ",",
                                                    stdin="qx;qy;qz;qw\n").stderr)

    def test_the_separator_may_be_spelled_in_several_ways(self):
        table = "qx\tqy\tqz\tqw\r\n0\t0\t1\t0\r\n"
        for separator in ("tab", "\t", "auto"):
            self.assertEqual(self.twist(table, "--separator", separator), TWIST_HEADER + b"0,0,1,0\n", separator)

    def test_a_line_of_tabs_that_separate_is_a_row(self):
        table = "qx\tqy\tqz\tqw\n0\t0\t1\t0\n\t\t\t\n\n  \n0\t0\t0\t1\n"
        self.assertEqual(self.twist(table, "--separator", "tab", "--missing", "nan"),
                         TWIST_HEADER + b"0,0,1,0\nnan,nan,nan,nan\n0,0,0,1\n")
        result = self.fails(1, "<stdin>:3:1: an empty field, expected a number (--missing nan reads it as NaN)",
                            "eval", "twist", "--precision", "reproducible", "--separator", "tab", stdin=table)
        self.assertEqual(result.stdout, TWIST_HEADER + b"0,0,1,0\n")
        self.fails(1, "<stdin>:2:2: row too short: 2 fields, expected 4", "eval", "twist", "--separator", "tab",
                   stdin="qx\tqy\tqz\tqw\n\t\n")

    def test_passed_fields_are_quoted_where_commas_separate(self):
        self.assertEqual(
            self.twist('"a;b";n;qx;qy;qz;qw;"m,"\r\n"x;""y""";5" a;0;0;1;0;1,5\r\n', "--separator", ";", "--pass"),
            b'a;b,n,"m,",tx,ty,tz,tw\n"x;""y""","5"" a","1,5",0,0,1,0\n')
        self.assertEqual(self.twist("\tqx\tqy\tqz\tqw\na, b\t0\t0\t1\t0\n", "--separator", "tab", "--pass"),
                         b',tx,ty,tz,tw\n"a, b",0,0,1,0\n')

    def test_separators_that_contradict_are_bad_usage(self):
        for options, message in (
            (("--decimal", ","), "--decimal ',' goes with --separator ';' or tab"),
            (("--decimal", ",", "--separator", ","), "--decimal ',' goes with --separator ';' or tab"),
            (("--decimal", ",", "--separator", "auto"), "--decimal ',' goes with --separator ';' or tab"),
            (("--separator", ""), "--separator: '' is none of auto , ; tab"),
            (("--separator", "|"), "--separator: '|' is none of auto , ; tab"),
            (("--decimal", "_"), "--decimal: '_' is none of .|,"),
            (("--missing", "zero"), "--missing: 'zero' is none of error|nan"),
        ):
            self.fails(2, message, "eval", "twist", *options, stdin=HEADER)

    def test_columns_may_have_other_names(self):
        table = "frame,rot_x,rot_y,rot_z,rot_w\n1,0,0,1,0\n"
        names = ("--columns", "q=rot_x,rot_y,rot_z,rot_w")
        self.assertEqual(self.twist(table, *names, "--pass"), b"frame,tx,ty,tz,tw\n1,0,0,1,0\n")
        self.assertEqual(
            self.succeeds("eval", "slerp", "--t", "column", "--precision", "reproducible", "--columns", "t=when",
                          "--columns", "b=1,2,3,4", stdin="ax ay az aw 1 2 3 4 when\n0 0 0 1 0 0 1 0 1\n").stdout,
            b"qx,qy,qz,qw\n0,0,1,0\n")
        self.assertEqual(self.succeeds("eval", "compose", "--form", "compact", "--columns", "factors=a,b,c,d,e",
                                       stdin="e d c b a\n1 0 1 0 0\n").stdout, b"qx,qy,qz,qw\n0,0,0,1\n")
        self.fails(1, "<stdin>:1:1: unknown column 'qx', expected a header row with the columns rot_x rot_y rot_z rot_w",
                   "eval", "twist", *names, stdin=HEADER)
        self.fails(2, "--columns: the group 'q' is named twice", "eval", "twist", *names, "--columns", "q=a,b,c,d",
                   stdin=table)
        self.fails(2, "--columns: the column 'm' is read twice", "eval", "multiply", "--columns", "a=m,n,o,p",
                   "--columns", "b=k,l,j,m", stdin="")
        self.fails(2, "--columns: the column 'bx' is read twice", "eval", "multiply", "--columns", "a=bx,n,o,p",
                   stdin="")
        for given, message in (
            ("q", "--columns: 'q', expected GROUP=NAME,... with a group out of: q"),
            ("p=a,b,c,d", "--columns: the operation reads no group 'p', expected one out of: q"),
            ("q=a,b,c", "--columns: 3 names for 'q', expected 4, for qx qy qz qw"),
            ("q=a,b,,d", "--columns: a name is empty"),
            ("q=a,b,a,d", "--columns: the column 'a' is read twice"),
        ):
            self.fails(2, message, "eval", "twist", "--columns", given, stdin=table)

    def test_what_is_missing_is_nan_when_asked_for(self):
        table = "qx,qy,qz,qw\n0,0,1,0\n0,,1,0\n0,0,1,\n,,,\n0,0,0,1\n"
        self.assertEqual(self.twist(table, "--missing", "nan"),
                         TWIST_HEADER + b"0,0,1,0\n" + 3 * b"nan,nan,nan,nan\n" + b"0,0,0,1\n")
        self.fails(1, "<stdin>:3:3: an empty field, expected a number (--missing nan reads it as NaN)",
                   "eval", "twist", stdin=table)

    def test_angles_are_in_degrees_when_asked_for(self):
        def numbers(operation, table, *options):
            return rows(self.succeeds("eval", operation, "--degrees", *options, stdin=table).stdout)[1][0]

        def near(got, expected):
            self.assertEqual(len(got), len(expected))
            for a, b in zip(got, expected):
                self.assertAlmostEqual(a, b, places=12)

        near(numbers("twist_angle", HEADER + "0 0 1 1\n"), [90])
        near(numbers("decompose", HEADER + "0 0 1 1\n", "--form", "angle"), [90])
        near(numbers("sincos", "angle\n30\n"), [0.5, 3**0.5 / 2])
        near(numbers("from_euler", "ex ey ez\n0 0 180\n"), [0, 0, 1, 0])
        near(numbers("to_euler", HEADER + "0 0 1 1\n"), [0, 0, 90])
        near(numbers("to_axis_angle", HEADER + "0 0 1 1\n"), [0, 0, 1, 90])
        near(numbers("arc_with_twist", "vx vy vz wx wy wz\n0 0 1 0 0 1\n", "--angle", "180"), [0, 0, 1, 0])
        near(numbers("angle_between", "ax ay az aw bx by bz bw\n0 0 0 1 0 0 -1 -1\n"), [90])
        self.fails(2, "--degrees: no angle is read or written", "eval", "decompose", "--degrees", stdin=HEADER)
        self.assertNotIn("--degrees", self.succeeds("eval", "multiply", "--help").stdout.decode())

    def test_a_header_may_have_a_hundred_thousand_columns(self):
        names = [f"c{i}" for i in range(100_000)]
        table = ",".join(names + ["qx", "qy", "qz", "qw"]) + "\n" + "7," * len(names) + "0,0,1,0\n"
        header, row = self.twist(table, "--pass").decode().splitlines()
        self.assertEqual(header.split(","), names + ["tx", "ty", "tz", "tw"])
        self.assertEqual(row, "7," * len(names) + "0,0,1,0")
        self.fails(1, "<stdin>:1:688903: the column 'c9' is there twice", "eval", "twist", "--pass",
                   stdin=",".join(names + ["qx", "qy", "qz", "qw", "c9"]) + "\n")

    def test_long_tables_stream(self):
        count = 200_003
        table = HEADER + "".join(f"0 0 {i} 1\n" for i in range(count))
        lines = self.twist(table, "--axis", "x").splitlines()
        self.assertEqual(len(lines), count + 1)
        self.assertEqual(set(lines[1:]), {b"0,0,0,1"})
        out = self.succeeds("eval", "swing", "--axis", "x", "--pass", stdin="n " + HEADER + "".join(
            f"{i} 0 0 {i} 1\n" for i in range(count))).stdout.splitlines()
        self.assertEqual([int(line.split(b",")[0]) for line in out[1:]], list(range(count)))

    def test_line_ends_at_every_place_of_a_read(self):
        # The reads are 65536 bytes; a row is 13, so each place of a row meets the end of a read.
        for end in ("\n", "\r\n", "\r"):
            for shift in range(14):
                table = "qx qy qz qw" + " " * shift + end + ("0 0 0.6 0.8" + end) * 12000
                out = self.twist(table)
                self.assertEqual(len(out.splitlines()), 12001, (repr(end), shift))


if __name__ == "__main__":
    main()
