#!/usr/bin/env python3
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""rejected.py PELAGE_GLSL FILE...: each file holds constructs outside of the subset. Where a line ends in
`// error: reason | reason` the program must say just that of it, of every such line in one run, and write nothing."""

import pathlib
import re
import subprocess
import sys
import tempfile


def expected_errors(source: pathlib.Path) -> set[tuple[int, str]]:
    errors = set()
    for number, line in enumerate(source.read_text(encoding="utf-8").splitlines(), 1):
        _, marked, reasons = line.partition("// error: ")
        if marked:
            errors.update((number, reason) for reason in reasons.split(" | "))
    return errors


def main() -> int:
    program, *sources = sys.argv[1:]
    failures = 0
    total = 0
    for source in map(pathlib.Path, sources):
        expected = expected_errors(source)
        total += len(expected)
        with tempfile.TemporaryDirectory() as scratch:
            out = pathlib.Path(scratch) / "out"
            command = [program, "--instantiate", str(source), "--out", str(out)]
            result = subprocess.run(command, capture_output=True, text=True, check=False)
            written = out.exists()
        got = set()
        for line in result.stderr.splitlines():
            place = re.match(r"(.*):(\d+): error: (.*)", line)
            if place and place[1].endswith(source.name):
                got.add((int(place[2]), place[3]))
            else:
                got.add((0, line))
        for number, reason in sorted(expected - got):
            print(f"{source}:{number}: not said: {reason}")
        for number, reason in sorted(got - expected):
            print(f"{source}:{number}: said, but not expected: {reason}")
        if written or result.returncode == 0 or not expected:
            print(f"{source}: exit status {result.returncode}, {'files' if written else 'nothing'} written")
        failures += bool(expected != got or written or result.returncode == 0 or not expected)
    print(f"{total} rejected constructs in {len(sources)} files, {failures} files fail")
    return 1 if failures or total < 40 else 0


sys.exit(main())
