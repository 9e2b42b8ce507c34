#!/usr/bin/env python3
"""Checks who includes whom.

usage: check_includes.py FOLDER   the folder of include, src, kernels, operations and tools
"""

import pathlib
import re
import sys

INCLUDE = re.compile(r"^\s*#\s*include\s+(.*?)\s*(//.*)?$")
STANDARD = ["<*>"]
OPERATIONS = STANDARD + ['"swivel/*.hpp"']
PUBLIC = OPERATIONS + ['"swivel/clip/*.hpp"']
REGISTERS = STANDARD + ['"kernels/registers/*.hpp"']
KERNELS = STANDARD + ['"kernels/*.hpp"', '"kernels/registers/ops.hpp"', '"kernels/loops/*.hpp"']
CALL = OPERATIONS + ['"kernels/kernel.hpp"', '"src/call/*.hpp"']
REFERENCE = OPERATIONS + ['"kernels/constants.hpp"', '"src/call/*.hpp"', '"src/reference/*.hpp"']
DESCRIPTIONS = ['"operations/*.hpp"']
TOOLS = PUBLIC + DESCRIPTIONS + ["<*.h>", "<sys/*.h>", '"*.hpp"']

# Of a file the first row counts that it matches. * is a part of a name without dots.
RULES = [
    ("include/swivel/*.hpp", OPERATIONS),
    ("include/swivel/clip/*.hpp", PUBLIC),
    # What src/ sees of the kernels: nothing that could be compiled to the instructions of an ISA.
    ("kernels/kernel.hpp", STANDARD),
    ("kernels/constants.hpp", STANDARD),
    # Registers know nothing of what is computed in them, loops nothing of the operation.
    ("kernels/registers/ops.hpp", REGISTERS + ['"kernels/kernel.hpp"', "SWIVEL_KERNEL_REGISTERS"]),
    ("kernels/registers/every_isa.hpp", ["<xsimd/xsimd.hpp>"]),
    ("kernels/registers/*.hpp", REGISTERS),
    ("kernels/loops/*.hpp", REGISTERS + ['"kernels/kernel.hpp"', '"kernels/loops/*.hpp"']),
    ("kernels/*/tables.hpp", STANDARD + ['"kernels/kernel.hpp"']),
    # Vectors are brought into range by powers of two, as quaternions are.
    ("kernels/vector3.hpp", KERNELS + ['"kernels/rotors/normalize.hpp"']),
    ("kernels/*.hpp", KERNELS),
    ("kernels/*/*.hpp", STANDARD + ['"kernels/*.hpp"', '"kernels/*/*.hpp"']),
    ("kernels/*/*.cpp", KERNELS + ['"kernels/{family}/*.hpp"']),
    # The processor is asked in src/call/cpu.cpp; axes are tested with the numbers of the kernels.
    ("src/call/*.cpp", CALL + ["<*.h>"]),
    ("src/call/*.hpp", CALL + ['"kernels/constants.hpp"']),
    ("src/reference/*.hpp", REFERENCE),
    ("src/clip/*.?pp", PUBLIC + ['"src/clip/*.hpp"']),
    ("src/clip/*/*.?pp", PUBLIC + ['"src/clip/*.hpp"', '"src/clip/*/*.hpp"']),
    # The reference of a family builds on that of another.
    ("src/*/reference*.?pp", REFERENCE + ['"src/*/reference.hpp"']),
    # Their kernels are those of another family: compose, and conjugate.
    ("src/rotors/multiply.cpp", CALL + ['"kernels/swing_twist/tables.hpp"']),
    ("src/conversions/spinor.cpp", CALL + ['"kernels/rotors/tables.hpp"']),
    ("src/*/*.?pp", CALL + ['"src/reference/*.hpp"', '"kernels/{family}/tables.hpp"']),
    ("operations/*.?pp", OPERATIONS + DESCRIPTIONS),
    ("tools/swivel/command_line.cpp", TOOLS + ["<CLI/CLI.hpp>"]),
    ("tools/*.cpp", TOOLS),
    ("tools/*/*.?pp", TOOLS),
]


def matches(text, row):
    return re.fullmatch(re.escape(row).replace(r"\*", r"\w*").replace(r"\?", "."), text)


def faults(path, lines):
    """Number of line and fault; path is relative to the folder."""
    row = next((allowed for paths, allowed in RULES if matches(path, paths)), None)
    if row is None:
        yield 1, "no rule says what may be included here"
        return
    family = path.split("/")[1]
    allowed = [one.replace("{family}", family) for one in row]
    for number, line in enumerate(lines, 1):
        if (match := INCLUDE.match(line)) and not any(matches(match[1], one) for one in allowed):
            yield number, f"include of {match[1]}, expected some of: {' '.join(allowed)}"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    checked = bad = 0
    for top in ("include", "kernels", "operations", "src", "tools"):
        for file in sorted((root / top).rglob("*.[ch]pp")):
            checked += 1
            path = file.relative_to(root).as_posix()
            for number, what in faults(path, file.read_text(encoding="utf-8").splitlines()):
                print(f"{path}:{number}: {what}")
                bad += 1
    print(f"{bad} fault{'' if bad == 1 else 's'} in {checked} files")
    return 1 if bad or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
