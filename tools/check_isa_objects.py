#!/usr/bin/env python3
"""Checks that the kernels of one ISA cannot be run by a processor that lacks it.

The linker keeps one copy of a symbol that several objects define, and runs constructors before any choice of ISA is
made. So an object of kernels, NAME.ISA.cpp.o, may define no external symbols but kernel tables of its ISA, and none
that is weak, unique or in a COMDAT group, may share none with another object, and may have no constructors. All other
objects of the library must be free of AVX instructions.

usage: check_isa_objects.py [--library LIBRARY.a] [--avx ISA]... [--objdump PROGRAM] OBJECT...
  --avx ISA   one whose objects may hold AVX instructions
"""

import argparse
import collections
import os
import re
import struct
import subprocess
import sys

SHT_SYMTAB, SHT_INIT_ARRAY, SHT_PREINIT_ARRAY, SHT_GROUP = 2, 14, 16, 17
SHF_ALLOC = 2
STB_LOCAL, STB_GLOBAL = 0, 1
STT_OBJECT = 1
SHN_UNDEF = 0

Section = collections.namedtuple("Section", "name type flags offset size link entry_size")
Symbol = collections.namedtuple("Symbol", "name binding type section")


class Elf:
    """Sections and symbols of a 64-bit little-endian object file."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        if self.data[:6] != b"\x7fELF\x02\x01":
            raise ValueError("not a 64-bit little-endian ELF file")
        (start,) = struct.unpack_from("<Q", self.data, 0x28)
        size, count, names = struct.unpack_from("<HHH", self.data, 0x3A)
        count = count or struct.unpack_from("<Q", self.data, start + 0x20)[0]
        raw = [struct.unpack_from("<IIQQQQIIQQ", self.data, start + i * size) for i in range(count)]
        self.sections = [
            Section(self.text(raw[names][4] + name), kind, flags, offset, length, link, entry_size)
            for name, kind, flags, _, offset, length, link, _, _, entry_size in raw
        ]

    def text(self, offset):
        return self.data[offset : self.data.index(b"\0", offset)].decode()

    def symbols(self):
        for table in self.sections:
            if table.type != SHT_SYMTAB:
                continue
            names = self.sections[table.link].offset
            for at in range(table.offset, table.offset + table.size, table.entry_size):
                name, info, _, section = struct.unpack_from("<IBBH", self.data, at)
                yield Symbol(self.text(names + name), info >> 4, info & 15, section)

    def groups(self):
        """Sections that the linker keeps one copy of, debug information aside."""
        for group in self.sections:
            if group.type == SHT_GROUP:
                members = struct.unpack_from(f"<{group.size // 4 - 1}I", self.data, group.offset + 4)
                yield from (self.sections[m].name for m in members if self.sections[m].flags & SHF_ALLOC)


def isa_of(name):
    """avx2 of decompose.avx2.cpp.o."""
    return name.split(".")[1] if name.count(".") > 2 else "no ISA"


def object_faults(elf, isa):
    external = [s for s in elf.symbols() if s.section != SHN_UNDEF and s.binding != STB_LOCAL]
    strong = [s for s in external if s.binding == STB_GLOBAL]
    for symbol in external:
        if symbol.binding != STB_GLOBAL:
            yield f"weak or unique symbol {symbol.name}"
    named = {s.name for s in external}
    for section in elf.groups():
        if not any(section.endswith("." + name) for name in named):
            yield f"COMDAT section {section}"
    if not strong:
        yield "no table"
    # kernels_on<..., ISA>::table, mangled.
    table = re.compile(rf"_ZN6swivel10kernels_onI.*NS_{len(isa)}{isa}EE5tableE$")
    for symbol in strong:
        if symbol.type != STT_OBJECT or not table.match(symbol.name):
            yield f"external symbol {symbol.name} is no table of {isa}"
    for section in elf.sections:
        if section.type in (SHT_INIT_ARRAY, SHT_PREINIT_ARRAY) or re.match(r"\.(init|ctors)\b", section.name):
            yield f"section {section.name}: code that runs before main"


# VEX and EVEX encodings: mnemonics in v (but for those of virtual machines and segments), wide and mask registers,
# and the bit manipulation of the processors that brought AVX2.
AVX = re.compile(
    r"\t(?!verr|verw|vm(call|clear|func|launch|load|mcall|ptr|read|resume|run|save|write|xo))v[a-z]"
    r"|%[yz]mm\d|%k[0-7]\b"
    r"|\t(andn|bextr|blsi|blsmsk|blsr|bzhi|mulx|pdep|pext|rorx|sarx|shlx|shrx)[lq]?\s"
)


def library_faults(objdump, library, avx):
    """The first AVX instruction of each function that may not have any."""
    command = [objdump, "-d", "--no-show-raw-insn", library]
    listing = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    member, function, told, members = "", "", None, set()
    for line in listing.splitlines():
        # GNU names the member alone, LLVM "library.a(member)".
        if match := re.match(r"(?:.*\()?([^()]+)\)?:\s+file format", line):
            member = match[1]
            members.add(member)
        elif match := re.match(r"[0-9a-f]+ <(.*)>:$", line):
            function = match[1]
        elif member not in avx and (member, function) != told and AVX.search(line):
            yield f"{member}: {function}: AVX instruction{line[line.find(':') + 1:]}"
            told = (member, function)
    for missing in sorted(avx - members):
        yield f"no object {missing} in the library"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--library")
    parser.add_argument("--avx", action="append", default=[], metavar="ISA")
    parser.add_argument("--objdump", default="objdump")
    parser.add_argument("objects", nargs="+", metavar="OBJECT")
    arguments = parser.parse_args()

    faults = []
    owners = collections.defaultdict(list)
    for path in arguments.objects:
        name = os.path.basename(path)
        elf = Elf(path)
        faults += [f"{name}: {fault}" for fault in object_faults(elf, isa_of(name))]
        for symbol in elf.symbols():
            if symbol.section != SHN_UNDEF and symbol.binding == STB_GLOBAL:
                owners[symbol.name].append(name)
    faults += [f"{symbol}: defined in {' '.join(names)}" for symbol, names in owners.items() if len(names) > 1]
    if arguments.library:
        avx = {name for name in map(os.path.basename, arguments.objects) if isa_of(name) in arguments.avx}
        faults += [
            f"{os.path.basename(arguments.library)}: {fault}"
            for fault in library_faults(arguments.objdump, arguments.library, avx)
        ]

    for fault in faults:
        print(fault)
    print(f"{len(faults)} fault{'' if len(faults) == 1 else 's'} in {len(arguments.objects)} objects")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
