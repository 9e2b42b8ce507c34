#!/usr/bin/env python3
"""Checks that public headers are plain C++: no intrinsics, no xsimd, nothing that a macro of the user could change.
Those of the operations include little of the standard library, and nothing of the clips.

usage: check_headers.py HEADER...
"""

import re
import sys

COMMENT = re.compile(r"//.*")
DIRECTIVE = re.compile(r"^\s*#\s*(\w+)\s*(.*?)\s*$")
INCLUDE = re.compile(r'<(cstddef|cstdint|limits|span|type_traits)>|"swivel/\w+\.hpp"')
CLIP_INCLUDE = re.compile(r'<[a-z_]+>|"swivel/(clip/)?\w+\.hpp"')
INTRINSIC = re.compile(r"\b(_mm\d*_\w+|__m(64|128|256|512)\w*|v\w+q?_[fsu](32|64)|(float|u?int)\d+x\d+\w*_t|__builtin_\w+)\b")


def faults(path, lines):
    allowed = CLIP_INCLUDE if "/include/swivel/clip/" in path else INCLUDE
    guard = None
    for number, line in enumerate(lines, 1):
        line = COMMENT.sub("", line)
        if match := INTRINSIC.search(line):
            yield number, f"intrinsic {match[0]}"
        directive = DIRECTIVE.match(line)
        if not directive:
            continue
        name, rest = directive.groups()
        if name == "include":
            if not allowed.fullmatch(rest):
                yield number, f"include of {rest}"
        elif name == "ifndef" and guard is None:
            guard = rest
        elif not (name == "endif" or (name == "define" and rest == guard)):
            yield number, f"#{name} {rest}: only an include guard is allowed"
    if guard is None:
        yield 1, "no include guard"


def main():
    bad = 0
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            for number, what in faults(path, file):
                print(f"{path}:{number}: {what}")
                bad += 1
    return 1 if bad or len(sys.argv) < 2 else 0


if __name__ == "__main__":
    sys.exit(main())
