# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""macros.py INCLUDE: the table of macros in INCLUDE/pelage/README.md has each file of the mirror that asks for any, what
it or a file that it includes wants defined, and the sizes with their defaults. First the check itself is tested: without
any one of the table's entries it must find a fault.
"""
import pathlib
import re
import sys

ASKED = re.compile(r"^#error .*: define (PELAGE_\w+(?:\(i\))?) before the include$", re.M)
SIZE = re.compile(r"^#define (PELAGE_\w+ \d+)$", re.M)
INCLUDED = re.compile(r'^#include "(.*)"$', re.M)
ROW = re.compile(r"^\| (`\w+/\w+`(?:, `\w+/\w+`)*) \|(.*)$", re.M)


def of_mirror(glsl):
    """The macros of each file by its name without an ending; those with a size, and their defaults, of its own alone."""
    text = {path: path.read_text() for path in glsl.rglob("*.glsl")}

    def asked(path, seen):
        if path in seen:
            return set()
        seen.add(path)
        parts = (asked((path.parent / name).resolve(), seen) for name in INCLUDED.findall(text[path]))
        return set(ASKED.findall(text[path])).union(*parts)

    found = {path.relative_to(glsl).with_suffix("").as_posix(): asked(path, set()) | set(SIZE.findall(text[path]))
             for path in text}
    return {name: macros for name, macros in found.items() if macros}


def of_table(readme):
    return {name: {re.sub("`", "", macro) for macro in re.findall(r"`PELAGE_\w+(?:\(i\))?`(?: \d+)?", macros)}
            for names, macros in ROW.findall(readme) if "`PELAGE_" in macros for name in re.findall(r"[\w/]+", names)}


def main(include):
    folder = pathlib.Path(include).resolve() / "pelage"
    expected, readme = of_mirror(folder / "glsl"), (folder / "README.md").read_text()
    table = of_table(readme)
    for name in sorted(expected.keys() | table.keys()):
        if table.get(name) != expected.get(name):
            print(f"{name} asks for {sorted(expected.get(name, []))}, the table has {sorted(table.get(name, []))}")
    entries = [row.start() + macro.start() for row in ROW.finditer(readme) for macro in re.finditer("`PELAGE_", row[0])]
    blind = [at for at in entries if of_table(readme[:at] + readme[at + len("`PELAGE_"):]) == expected]
    print(f"{len(expected)} files, {len(entries)} entries, {len(blind)} of them not looked at")
    return table != expected or not entries or bool(blind)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
