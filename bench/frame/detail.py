# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Draws the README's figure of levels of detail, and prints its table."""
import argparse
import pathlib
import statistics

from sheets import sheets

arguments = argparse.ArgumentParser()
arguments.add_argument("root", type=pathlib.Path)
arguments.add_argument("--times", type=int, default=5, help="frames of each setting, whose median time is told")
given = arguments.parse_args()
drawing = sheets(given.root)

settings = [(0.1, 0), (0.25, 0), (0.5, 0), (0, 0.5), (0, 1), (0.25, 0.5)]


def words_of(segment, strand):
    words = [f"--segment-error {segment}"] if segment else []
    return " ".join(words + ([f"--strand-error {strand}"] if strand else []))


def drawn(distance):
    """A table's rows of one distance of the camera, each setting in turns with the full frame."""
    far = ["--distance", str(distance), "--map-size", str(640 // distance)]
    full, first = drawing.render(f"detail-full-{distance}", *far)
    rows, cells = [], []
    for setting in settings:
        words = words_of(*setting)
        name = f"detail-{setting[0]}-{setting[1]}-{distance}"
        ratios = []
        for _ in range(given.times):
            _, whole = drawing.render(f"detail-full-{distance}", *far)
            picture, report = drawing.render(name, *far, *words.split(), "--compare", full)
            ratios.append(report["seconds"] / whole["seconds"])
        rows.append(f"| {distance} | `{words}` | {report['strands_drawn']:,} | {report['segments_drawn']:,} | "
                    f"{report['rms']:.5f} | {report['maximum']:.3f} | {statistics.median(ratios):.2f} |")
        cells += [(words, picture), ("difference, white = 0.1", picture.with_suffix(".error.png"))]
    print(f"full frame at distance {distance}: {first['segments_drawn']:,} segments")
    return rows, full, cells


near, full, cells = drawn(1)
drawing.side_by_side("detail", [[("full", full), *cells[i:i + 4]] for i in range(0, len(cells), 4)])
far, _, _ = drawn(4)
print("\n".join(near + far))
