#!/usr/bin/env python3
"""Prints the ratios that the project sets itself, from the rows of swivel_bench.

    bench_compare.py FILE.json [FILE.json ...]    files of --benchmark_out, with repetitions or several of them
    bench_compare.py --run BINARY                 runs the rows that the table needs, in rounds, then prints it

Times are medians over all repetitions in all files. Nothing fails because something was slow: the exit code is 0
when the table could be printed, 2 for bad usage or unreadable files.
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile

UNIT_IN_NS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
BEST_FIRST = ("avx512", "avx2", "sse2", "neon64")
ROW = re.compile(r"\w+(/still)?/\w+/(soa|aos)/f(32|64)/\d+")
SMALL, FEW, MANY, HUGE = 1, 16, 1024, 4194304


def row(op, who, n, layout="soa", kind="f32"):
    return f"{op}/{who}/{layout}/{kind}/{n}"


class Rows:
    """Times of rows in ns per call, by name."""

    def __init__(self):
        self.samples = {}
        self.context = {}

    def add(self, document):
        self.context.update(document.get("context", {}))
        for entry in document.get("benchmarks", []):
            if entry.get("run_type", "iteration") != "iteration" or entry.get("error_occurred"):
                continue
            name = entry.get("run_name", entry["name"])
            match = ROW.match(name)
            if not match:
                continue
            name = match[0]
            time = float(entry["cpu_time"]) * UNIT_IN_NS[entry.get("time_unit", "ns")]
            self.samples.setdefault(name, []).append(time)

    def call(self, name):
        """Median ns of one call, or None."""
        return statistics.median(self.samples[name]) if name in self.samples else None

    def element(self, name):
        """Median ns for one element, or None."""
        time = self.call(name)
        return None if time is None else time / int(name.rsplit("/", 1)[1])

    def quickest(self, names):
        """Name of the quickest row of those that are there, or None."""
        there = [name for name in names if name in self.samples]
        return min(there, key=self.call) if there else None


class Target:
    """numerator / denominator, which is to be at least, or at most, a limit."""

    def __init__(self, what, numerator, denominator, at_least=None, at_most=None):
        self.what, self.numerator, self.denominator = what, numerator, denominator
        self.at_least, self.at_most = at_least, at_most

    def rows(self):
        return self.numerator + (self.denominator or [])

    def measure(self, rows):
        """(value, the rows that it was made from), or None where a row is missing."""
        top = rows.quickest(self.numerator)
        if self.denominator is None:
            return None if top is None else (rows.call(top), [top])
        bottom = rows.quickest(self.denominator)
        if top is None or bottom is None:
            return None
        return rows.element(top) / rows.element(bottom), [top, bottom]

    def reached(self, value):
        return value >= self.at_least if self.at_least is not None else value <= self.at_most

    def limit(self):
        unit = " ns" if self.denominator is None else ""
        return f">= {self.at_least:g}{unit}" if self.at_least is not None else f"<= {self.at_most:g}{unit}"


def targets(best):
    """The table; `best` is the best ISA that the machine has."""
    table = []
    for isa, least in (("avx512", 12), ("avx2", 6.5), ("sse2", 2.5)):
        for peer, name in (("eigen", "Eigen"), ("glm", "GLM")):
            table.append(Target(f"decompose: {name} / {isa}", [row("decompose", peer, MANY, "aos")],
                                [row("decompose", isa, MANY)], at_least=least))
    for op, peer, name, least in (("slerp", "eigen", "Eigen", 18), ("slerp", "glm", "GLM", 18),
                                  ("sterp", "eigen", "Eigen and std::", 22), ("power", "eigen", "Eigen and std::", 20),
                                  ("exp", "eigen", "Eigen and std::", 15), ("log", "eigen", "Eigen and std::", 15),
                                  ("sclerp", "eigen", "Eigen and std::", 25)):
        for isa, share in (("avx512", 1), ("avx2", 2)):
            table.append(Target(f"{op}: {name} / {isa}", [row(op, peer, MANY, "aos")], [row(op, isa, MANY)],
                                at_least=least / share))
    table.append(Target("decompose: plain loop / avx512", [row("decompose", "plain", MANY)],
                        [row("decompose", "avx512", MANY)], at_least=1.6))
    table.append(Target("decompose_compact: plain loop / avx512", [row("decompose_compact", "plain", MANY)],
                        [row("decompose_compact", "avx512", MANY)], at_least=1.25))
    for op in ("decompose", "decompose_z", "decompose_compact", "twist", "compose"):
        table.append(Target(f"{op}: AoS / SoA", [row(op, best, MANY, "aos")], [row(op, best, MANY)], at_most=1.6))
    for op in ("decompose", "decompose_compact", "twist", "compose"):
        table.append(Target(f"{op}: n = {HUGE} / copy", [row(op, best, HUGE)],
                            [row(op, "copy", HUGE), row(op, "memcpy", HUGE)], at_most=1.1))
    for op in ("decompose", "decompose_z", "decompose_compact"):
        table.append(Target(f"{op}: call with n = 1", [row(op, best, SMALL)], None, at_most=30))
    for op in ("decompose", "decompose_z", "decompose_compact"):
        table.append(Target(f"{op}: element at n = 16 / n = 1024", [row(op, best, FEW)], [row(op, best, MANY)],
                            at_most=2.5))
    return table


# Shown with the table, without a target: the plain loop at the widest vectors.
INFORMATION = [
    Target("decompose: plain loop, 512 bits / avx512", [row("decompose", "plain512", MANY)],
           [row("decompose", "avx512", MANY)], at_least=0),
    Target("decompose_compact: plain loop, 512 bits / avx512", [row("decompose_compact", "plain512", MANY)],
           [row("decompose_compact", "avx512", MANY)], at_least=0),
]


def best_isa(names):
    present = {name.split("/")[-4] for name in names}
    return next((isa for isa in BEST_FIRST if isa in present), BEST_FIRST[0])


def print_table(header, lines):
    widths = [max(len(line[k]) for line in [header] + lines) for k in range(len(header))]
    for line in [header, ["-" * w for w in widths]] + lines:
        print("  ".join(cell.ljust(w) if k == 0 else cell.rjust(w) for k, (cell, w) in enumerate(zip(line, widths))))


def print_ratios(rows):
    lines = []
    for target, counts in [(t, True) for t in targets(best_isa(rows.samples))] + [(t, False) for t in INFORMATION]:
        measured = target.measure(rows)
        limit = target.limit() if counts else ""
        if measured is None:
            lines.append([target.what, limit, "", "no such row" if counts else "", ""])
            continue
        value, used = measured
        unit = " ns" if target.denominator is None else ""
        verdict = ("reached" if target.reached(value) else "MISSED") if counts else ""
        made_from = " / ".join(f"{rows.call(name) if target.denominator is None else rows.element(name):.3f}"
                               for name in used)
        lines.append([target.what, limit, f"{value:.2f}{unit}", verdict, made_from])
    print_table(["ratio", "target", "measured", "verdict", "ns"], lines)


def print_all(rows):
    """ns per element: a line for each op, peer, layout and type, a column for each n."""
    table, sizes = {}, set()
    for name in rows.samples:
        key, n = name.rsplit("/", 1)
        table.setdefault(key, {})[int(n)] = rows.element(name)
        sizes.add(int(n))
    columns = sorted(sizes)
    lines = [[key] + [f"{cells[n]:.3f}" if n in cells else "" for n in columns] for key, cells in table.items()]
    print_table(["ns per element"] + [f"n={n}" for n in columns], lines)


def run(binary, rounds, seconds):
    """All rows that the table needs once in each round, so that noise hits all of them alike."""
    try:
        listed = subprocess.run([binary, "--benchmark_list_tests"], check=True, capture_output=True, text=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"bench_compare.py: {binary}: {error}")
    there = set(listed.split())
    wanted = {name for t in targets(best_isa(there)) + INFORMATION for name in t.rows()} & there
    if not wanted:
        sys.exit(f"bench_compare.py: {binary}: has none of the rows of the table")
    rows = Rows()
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "round.json")
        for number in range(rounds):
            if sys.stderr.isatty():
                print(f"\rround {number + 1} of {rounds}", end="", file=sys.stderr, flush=True)
            command = [binary, "--benchmark_filter=^(" + "|".join(map(re.escape, sorted(wanted))) + ")$",
                       f"--benchmark_min_time={seconds}", f"--benchmark_out={out}", "--benchmark_out_format=json"]
            result = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            if result.returncode != 0:
                sys.exit(f"bench_compare.py: {binary}: {result.stderr.strip()}")
            with open(out, encoding="utf-8") as file:
                rows.add(json.load(file))
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr)
    return rows


def read(files):
    rows = Rows()
    for path in files:
        try:
            with open(path, encoding="utf-8") as file:
                rows.add(json.load(file))
        except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
            print(f"bench_compare.py: {path}: {error}", file=sys.stderr)
            sys.exit(2)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", metavar="FILE.json")
    parser.add_argument("--run", metavar="BINARY", help="path of swivel_bench")
    parser.add_argument("--rounds", type=int, default=15, help="with --run (default: %(default)s)")
    parser.add_argument("--seconds", type=float, default=0.05, help="per row and round (default: %(default)s)")
    parser.add_argument("--all", action="store_true", help="also a table of ns per element of every row")
    arguments = parser.parse_args()
    if bool(arguments.files) == bool(arguments.run):
        parser.error("either files or --run BINARY")
    if arguments.rounds < 1 or not arguments.seconds > 0:
        parser.error("--rounds and --seconds must be positive")

    rows = run(arguments.run, arguments.rounds, arguments.seconds) if arguments.run else read(arguments.files)
    if not rows.samples:
        print("bench_compare.py: no rows named <op>/<isa>/<layout>/<type>/<n>", file=sys.stderr)
        sys.exit(2)
    for key, what in (("compiler", "library and peers"), ("plain_compiler", "plain loop")):
        if key in rows.context:
            print(f"{what}: {rows.context[key]}")
    repetitions = sorted({len(times) for times in rows.samples.values()})
    print("medians of " + " to ".join(str(count) for count in {repetitions[0]: 0, repetitions[-1]: 0}) + " runs\n")
    print_ratios(rows)
    if arguments.all:
        print()
        print_all(rows)


if __name__ == "__main__":
    main()
