# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Prints the tables of pelage-truth and puts crops of its pictures side by side."""
import argparse
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot

# Left, top, right and bottom of each crop, shares of the picture's sides.
CROPS = [("the parting", "hair", (0.42, 0.10, 0.64, 0.32)),
         ("the chin", "hair", (0.36, 0.54, 0.58, 0.76)),
         ("the head's edge", "hair", (0.54, 0.34, 0.76, 0.56)),
         ("a ball before hair", "ball", (0.55, 0.22, 0.77, 0.44))]
COLUMNS = [("rays", "rays"), ("frame", "frame"), ("difference; white = 0.1", "error")]

arguments = argparse.ArgumentParser()
arguments.add_argument("root", type=pathlib.Path)
arguments.add_argument("--quick", action="store_true", help="the small picture alone, without times and crops")
given = arguments.parse_args()

program = given.root / "build" / "release" / "bench" / "truth" / "pelage-truth"
scratch = given.root / "out" / "bench" / "truth"
pictures = given.root / "bench" / "truth" / "pictures"


def run(*words):
    subprocess.run([str(word) for word in (program, *words)], check=True)


def draw_crops():
    """A row for each crop, its pixels four times as large as the picture's."""
    figure, axes = matplotlib.pyplot.subplots(len(CROPS), len(COLUMNS), figsize=(9.0, 3.1 * len(CROPS)))
    for row, (place, name, (left, top, right, bottom)) in zip(axes, CROPS):
        for axis, (title, kind) in zip(row, COLUMNS):
            picture = matplotlib.image.imread(scratch / f"{name}-{kind}.png")
            height, width = picture.shape[:2]
            crop = picture[int(top * height):int(bottom * height), int(left * width):int(right * width)]
            axis.imshow(crop, interpolation="nearest")
            axis.set_title(f"{place}: {title}", fontsize=9)
            axis.set_axis_off()
    figure.tight_layout(pad=0.4)
    pictures.mkdir(parents=True, exist_ok=True)
    figure.savefig(pictures / "crops.png", dpi=100)


SMALL = ["--strands", 5000, "--size", 160, "--samples", 64]
MIDDLE = ["--strands", 50000, "--size", 320, "--samples", 24]
LARGE = ["--strands", 50000, "--size", 640, "--samples", 24]

run("fibre")
run("ball", "--size", 160)
for size in [SMALL] if given.quick else [SMALL, MIDDLE]:
    for table in ("coverage", "transmittance", "frame"):
        run(table, *size)
if not given.quick:
    run("split", *LARGE)
    run("time", "--samples", 12)
    run("pictures", *LARGE, "--out", scratch)
    draw_crops()
