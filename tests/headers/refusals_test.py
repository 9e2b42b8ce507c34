#!/usr/bin/env python3
"""check_includes.py and check_families.py refuse what they are there to refuse."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).parent

# Just enough of the library for both checks.
LIBRARY = {
    "include/swivel/types.hpp": [],
    "include/swivel/isa.hpp": ["swivel/types.hpp"],
    "include/swivel/reference.hpp": ["swivel/types.hpp"],
    "include/swivel/version.hpp": [],
    "include/swivel/slerp.hpp": ["swivel/types.hpp"],
    "include/swivel/nlerp.hpp": ["swivel/types.hpp"],
    "include/swivel/motor.hpp": ["swivel/types.hpp"],
    "include/swivel/interpolation.hpp": ["swivel/nlerp.hpp", "swivel/slerp.hpp"],
    "include/swivel/swivel.hpp": [
        "swivel/interpolation.hpp",
        "swivel/isa.hpp",
        "swivel/motor.hpp",
        "swivel/reference.hpp",
        "swivel/types.hpp",
        "swivel/version.hpp",
    ],
    "src/interpolation/slerp.cpp": ["swivel/slerp.hpp", "src/call/call.hpp", "kernels/interpolation/tables.hpp"],
    "src/interpolation/nlerp.cpp": ["swivel/nlerp.hpp"],
    "src/motors/motors.cpp": ["swivel/motor.hpp"],
    "src/clip/clip.cpp": ["swivel/clip/clip.hpp"],
    "kernels/interpolation/slerp.hpp": ["kernels/angles/sincos.hpp"],
    "tools/swivel/main.cpp": ["failure.hpp"],
}


class Refusals(unittest.TestCase):
    def check(self, script, changes):
        """Exit code and output for LIBRARY, where some files include other headers, or (None) are not there."""
        with tempfile.TemporaryDirectory() as folder:
            for path, headers in (LIBRARY | changes).items():
                if headers is None:
                    continue
                file = pathlib.Path(folder, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                includes = (h if h.startswith("<") else f'"{h}"' for h in headers)
                file.write_text("".join(f"#include {i}\n" for i in includes), encoding="utf-8")
            run = subprocess.run([sys.executable, HERE / script, folder], stdout=subprocess.PIPE, text=True)
            return run.returncode, run.stdout

    def test_a_library_without_fault_has_none(self):
        self.assertEqual(self.check("check_includes.py", {}), (0, f"0 faults in {len(LIBRARY)} files\n"))
        self.assertEqual(self.check("check_families.py", {}), (0, ""))

    def test_an_include_across_a_border_is_refused(self):
        for path, header in (
            ("include/swivel/slerp.hpp", "swivel/clip/clip.hpp"),
            ("include/swivel/slerp.hpp", "src/call/call.hpp"),
            ("kernels/interpolation/slerp.hpp", "src/reference/scalar.hpp"),
            ("kernels/interpolation/slerp.hpp", "swivel/types.hpp"),
            ("kernels/interpolation/slerp.hpp", "<xsimd/xsimd.hpp>"),
            ("kernels/interpolation/slerp.hpp", "<immintrin.h>"),
            ("kernels/interpolation/slerp.cpp", "kernels/arcs/tables.hpp"),
            ("kernels/interpolation/tables.hpp", "kernels/registers/ops.hpp"),
            ("kernels/constants.hpp", "kernels/registers/ops.hpp"),
            ("kernels/registers/neon.hpp", "kernels/loops/streams.hpp"),
            ("kernels/loops/arrays.hpp", "kernels/interpolation/slerp.hpp"),
            ("src/interpolation/slerp.cpp", "kernels/arcs/tables.hpp"),
            ("src/interpolation/slerp.cpp", "kernels/interpolation/slerp.hpp"),
            ("src/interpolation/slerp.cpp", "kernels/registers/ops.hpp"),
            ("src/interpolation/slerp.cpp", "src/arcs/arcs.hpp"),
            ("src/interpolation/slerp.cpp", "swivel/clip/clip.hpp"),
            ("src/interpolation/reference.cpp", "kernels/interpolation/tables.hpp"),
            ("src/call/memory.cpp", "src/reference/scalar.hpp"),
            ("src/call/memory.cpp", "kernels/interpolation/tables.hpp"),
            ("src/reference/scalar.hpp", "src/interpolation/reference.hpp"),
            ("src/clip/clip.cpp", "src/call/call.hpp"),
            ("src/clip/bvh/read.cpp", "kernels/kernel.hpp"),
            ("tools/swivel/main.cpp", "src/clip/text_cursor.hpp"),
            ("tools/swivel/main.cpp", "<CLI/CLI.hpp>"),
            ("tools/sample_clip/sample_clip.cpp", "kernels/constants.hpp"),
        ):
            with self.subTest(path=path, header=header):
                said = header if header.startswith("<") else f'"{header}"'
                code, output = self.check("check_includes.py", {path: ["<cstddef>", header]})
                self.assertEqual(code, 1)
                self.assertIn(f"{path}:2: include of {said}, expected some of: ", output)
                self.assertIn("\n1 fault in ", output)

    def test_a_file_that_no_rule_is_for_is_refused(self):
        code, output = self.check("check_includes.py", {"src/interpolation/sub/slerp.cpp": []})
        self.assertEqual(code, 1)
        self.assertIn("src/interpolation/sub/slerp.cpp:1: no rule says what may be included here\n", output)

    def test_nothing_to_check_is_a_failure(self):
        nothing = {path: None for path in LIBRARY}
        self.assertEqual(self.check("check_includes.py", nothing), (1, "0 faults in 0 files\n"))

    def test_a_header_outside_its_family_is_refused(self):
        for changes, fault in (
            ({"include/swivel/interpolation.hpp": ["swivel/slerp.hpp"]}, "interpolation.hpp: lacks nlerp.hpp"),
            (
                {"include/swivel/interpolation.hpp": ["swivel/motor.hpp", "swivel/nlerp.hpp", "swivel/slerp.hpp"]},
                "interpolation.hpp: must not include motor.hpp",
            ),
            (
                {"include/swivel/interpolation.hpp": None},
                "interpolation.hpp: lacks nlerp.hpp\ninclude/swivel/interpolation.hpp: lacks slerp.hpp",
            ),
            (
                {"include/swivel/sterp.hpp": []},
                "sterp.hpp: in no family, expected an include in one folder of src",
            ),
            (
                {"src/arcs/arcs.cpp": ["swivel/motor.hpp"]},
                "motor.hpp: in the families arcs motors, expected one",
            ),
            (
                {"include/swivel/swivel.hpp": LIBRARY["include/swivel/swivel.hpp"][1:]},
                "swivel.hpp: lacks interpolation.hpp",
            ),
            (
                {"include/swivel/swivel.hpp": LIBRARY["include/swivel/swivel.hpp"] + ["swivel/slerp.hpp"]},
                "swivel.hpp: must not include slerp.hpp",
            ),
        ):
            with self.subTest(fault=fault):
                self.assertEqual(self.check("check_families.py", changes), (1, f"include/swivel/{fault}\n"))


if __name__ == "__main__":
    unittest.main()
