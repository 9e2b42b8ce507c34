#!/usr/bin/env python3
"""Checks that every public header of operations belongs to one family, the folder in src/ that includes it, that the
header of the family includes all of them and nothing else, and that swivel.hpp includes all families.

usage: check_families.py FOLDER   the folder of include and src
"""

import collections
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s+"swivel/(\w+)\.hpp"', re.MULTILINE)
# What belongs to no family, and the folders that are none.
COMMON = {"isa", "reference", "types", "version"}
SHARED = {"call", "clip", "reference"}


def included(file):
    return set(INCLUDE.findall(file.read_text(encoding="utf-8")))


def faults(root):
    headers = {file.stem: included(file) for file in (root / "include/swivel").glob("*.hpp")}
    operations = collections.defaultdict(set)
    families = collections.defaultdict(set)
    for file in (root / "src").glob("*/*.?pp"):
        if file.parent.name not in SHARED:
            for name in included(file) - COMMON:
                operations[file.parent.name].add(name)
                families[name].add(file.parent.name)

    for name, folders in sorted(families.items()):
        if len(folders) > 1:
            yield f"{name}.hpp: in the families {' '.join(sorted(folders))}, expected one"
    # A family of one header has that one.
    umbrellas = {}
    for family, names in operations.items():
        umbrellas[family if len(names) > 1 else min(names)] = names
    for name in sorted(headers.keys() - COMMON - {"swivel"} - umbrellas.keys() - families.keys()):
        yield f"{name}.hpp: in no family, expected an include in one folder of src"
    expected = {name: names for name, names in umbrellas.items() if names != {name}}
    expected["swivel"] = COMMON | umbrellas.keys()
    for name, names in sorted(expected.items()):
        found = headers.get(name, set())
        for other in sorted(names - found):
            yield f"{name}.hpp: lacks {other}.hpp"
        for other in sorted(found - names):
            yield f"{name}.hpp: must not include {other}.hpp"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    bad = [f"include/swivel/{fault}" for fault in faults(pathlib.Path(sys.argv[1]))]
    print(*bad, sep="\n", end="\n" if bad else "")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
