"""Help, version, info, and what is bad usage."""

import os
import shlex
import subprocess
import unittest

from support import CLIP, COMMAND, HEADER, CommandTest, main, run, usable_isas

EVERY_COMMAND = ([], ["info"], ["decompose"], ["eval"], ["eval", "decompose"], ["eval", "compose"], ["eval", "twist"],
                 ["eval", "swing"], ["eval", "twist_angle"])


class Usage(CommandTest):
    def test_every_command_explains_itself_with_examples(self):
        for command in EVERY_COMMAND:
            result = self.succeeds(*command, "--help")
            self.assertIn("Examples:", result.stdout.decode(), command)
            self.assertEqual(result.stderr, b"", command)

    def test_every_example_of_an_operation_that_names_no_file_runs(self):
        listed = self.succeeds("eval", "--help").stdout.decode().split("Subcommands:")[1].split("\n\n")[0]
        operations = [line.split()[0] for line in listed.splitlines() if line.startswith("  ") and line[2] != " "]
        self.assertGreater(len(operations), 50)
        command = " ".join(map(shlex.quote, COMMAND))
        without = []
        for operation in operations:
            lines = self.succeeds("eval", operation, "--help").stdout.decode().split("Examples:\n")[1]
            examples = lines.replace("|\n    ", "| ").splitlines()
            runnable = [e for e in examples if e.startswith("  printf")]
            without += [] if runnable else [operation]
            for example in runnable:
                result = subprocess.run("set -o pipefail;" + example.replace("swivel eval", command + " eval"),
                                        shell=True, executable="/bin/bash", capture_output=True, check=False)
                self.assertEqual((result.returncode, result.stderr), (0, b""), example)
                self.assertGreaterEqual(len(result.stdout.splitlines()), 2, example)
        self.assertEqual(without, ["conformal_multiply", "conformal_interpolate"])

    def test_the_version_is_that_of_the_library(self):
        version = self.succeeds("--version").stdout.decode().split()
        self.assertEqual(version[0], "swivel")
        self.assertIn("version:       " + version[1], self.succeeds("info").stdout.decode())

    def test_info_tells_the_isas_and_the_compiler(self):
        keys = [line.split(":")[0] for line in self.succeeds("info").stdout.decode().splitlines()]
        self.assertEqual(keys, ["version", "isa in use", "isas compiled", "isas usable", "compiler"])

    def test_the_environment_selects_the_isa(self):
        for isa in usable_isas():
            result = self.succeeds("info", environment={"SWIVEL_ISA": isa})
            self.assertIn("isa in use:    " + isa + "\n", result.stdout.decode())
            self.assertEqual(result.stderr, b"")

    def test_an_isa_of_the_environment_that_is_not_usable_is_warned_of(self):
        for wanted in ("neon65", "SSE2"):
            result = self.succeeds("info", environment={"SWIVEL_ISA": wanted})
            self.assertTrue(result.stderr.decode().startswith("warning: SWIVEL_ISA=" + wanted), result.stderr)

    def test_the_option_goes_before_the_environment(self):
        isa = usable_isas()[0]
        result = self.succeeds("eval", "twist", "--isa", isa, stdin=HEADER, environment={"SWIVEL_ISA": "nothing"})
        self.assertEqual(result.stderr, b"")

    def test_bad_usage_ends_with_2_and_says_why(self):
        clip = self.path("clip.bvh", CLIP)
        table = ["eval", "decompose"]
        for arguments, message in (
            ([], "A subcommand is required"),
            (["juggle"], "The following argument was not expected: juggle"),
            (["--juggle"], "The following argument was not expected: --juggle"),
            (["info", "more"], "The following argument was not expected: more"),
            (["eval"], "A subcommand is required"),
            (["eval", "juggle"], "The following argument was not expected: juggle"),
            (["decompose"], "CLIP is required"),
            (["decompose", clip, clip], "The following argument was not expected"),
            (["decompose", clip, "--axis", "w"], "--axis: 'w' is none of auto|x|y|z|X,Y,Z"),
            (["decompose", clip, "--axis", "columns"], "--axis: 'columns' is none of"),
            (["decompose", clip, "--product", "swing"], "--product: 'swing' is none of swing-twist|twist-swing"),
            (["decompose", clip, "--joint", "hand"],
             clip + " has no joint 'hand', near names are 'Hand'"),
            (["decompose", clip, "--joint", "{}"], clip + " has no joint '{}'"),
            (["decompose", clip, "--joint", "[Hips]"], clip + " has no joint '[Hips]'"),
            (["decompose", clip, "--joint", ""], clip + " has no joint ''"),
            (["decompose", clip, "--joint"], "--joint: 1 required NAME missing"),
            (table + ["a", "b"], "The following argument was not expected: b"),
            (table + ["--axis", "auto"], "--axis: 'auto' is none of"),
            (table + ["--axis", "0,0,0"], "--axis: '0,0,0' has no direction"),
            (table + ["--axis", "-0,0,0"], "--axis: '-0,0,0' has no direction"),
            (table + ["--axis", "1,0"], "--axis: '1,0' is none of"),
            (table + ["--axis", "1,0,0,0"], "--axis: '1,0,0,0' is none of"),
            (table + ["--axis", "1,,0"], "--axis: '1,,0': '' is no finite number"),
            (table + ["--axis", "1,nan,0"], "--axis: '1,nan,0': 'nan' is no finite number"),
            (table + ["--axis", "1,inf,0"], "--axis: '1,inf,0': 'inf' is no finite number"),
            (table + ["--axis", "1,1e999,0"], "--axis: '1,1e999,0': '1e999' is no finite number"),
            (table + ["--axis", "1,0,0x"], "--axis: '1,0,0x': '0x' is no finite number"),
            (table + ["--axis", ""], "--axis: '' is none of"),
            (table + ["--axis", "1e-60,0,0", "--type", "f32"], "--axis: has no direction in f32"),
            (table + ["--axis", "1e60,0,0", "--type", "f32"], "--axis: too long for f32"),
            (table + ["--axis", "z", "--axis", "x"], "--axis: At Most 1 required but received 2"),
            (table + ["--isa", "neon65"], "--isa: 'neon65' is unknown, usable are: " + " ".join(usable_isas())),
            (table + ["--type", "f16"], "--type: 'f16' is none of f32|f64"),
            (table + ["--type", "0"], "--type: '0' is none of f32|f64"),
            (table + ["--form", "half"], "--form: 'half' is none of full|compact|twist|swing|angle"),
            (table + ["--precision", "FAST"], "--precision: 'FAST' is none of fast|reproducible"),
            (table + ["--layout", "aosoa"], "--layout: 'aosoa' is none of soa|aos"),
            (table + ["--pole-threshold", "2"], "--pole-threshold: '2' is no number from 0 to 1"),
            (table + ["--pole-threshold", "-1"], "--pole-threshold: '-1' is no number from 0 to 1"),
            (table + ["--pole-threshold", "nan"], "--pole-threshold: 'nan' is no number from 0 to 1"),
            (table + ["--form", "compact", "--axis", "1,0,0"], "--form compact is about a coordinate axis"),
            (table + ["--form", "compact", "--axis", "columns"], "--form compact is about a coordinate axis"),
            (table + ["--form", "angle", "--signs"], "--signs goes with --form full or compact"),
            (["eval", "compose", "--form", "compact", "--axis", "1,0,0"],
             "--form compact is about a coordinate axis"),
            (["eval", "compose", "--form", "twist"], "--form: 'twist' is none of full|compact"),
            (["eval", "compose", "--positive-twist"], "The following argument was not expected: --positive-twist"),
        ):
            result = self.fails(2, message, *arguments, stdin=HEADER)
            self.assertEqual(result.stdout, b"", arguments)
            self.assertIn("Run with --help for more information.", result.stderr.decode())

    def test_an_isa_that_is_not_usable_is_refused(self):
        unusable = {"sse2", "avx2", "avx512", "neon64"} - set(usable_isas())
        for isa in unusable:
            self.fails(2, "--isa: '" + isa + "' is not usable on this machine", "eval", "twist", "--isa", isa)

    def test_an_argument_after_a_double_dash_is_a_file(self):
        with open(os.path.join(self.folder, "--axis"), "w", encoding="ascii") as file:
            file.write(HEADER)
        result = run("eval", "twist", "--", "--axis", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (0, b"tx,ty,tz,tw\n"))

    def test_axes_may_begin_with_a_minus(self):
        for axis in ("-1,0,0", "-.5,0,1"):
            self.succeeds("eval", "twist", "--axis", axis, stdin=HEADER)
            self.succeeds("eval", "twist", "--axis=" + axis, stdin=HEADER)


if __name__ == "__main__":
    main()
