# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""What the figures share: frames by pelage-frame, lists by pelage-quality, sheets of tiles and plots as small files."""
import json
import pathlib
import statistics
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot
import PIL.Image

LARGEST = 300 * 1024  # bytes


class Room:
    """Where the programs are, and where what they draw goes."""

    def __init__(self, root, quick):
        self.quick = quick
        self.programs = pathlib.Path(root) / "build" / "release" / "bench"
        self.scratch = pathlib.Path(root) / "out" / "bench" / "papers"
        self.pictures = self.scratch if quick else pathlib.Path(root) / "bench" / "papers" / "pictures"
        self.scratch.mkdir(parents=True, exist_ok=True)
        self.pictures.mkdir(parents=True, exist_ok=True)

    def frame(self, name, *options):
        """Draws one frame; its picture's path and its report."""
        picture, report = self.scratch / f"{name}.png", self.scratch / f"{name}.json"
        run(self.programs / "frame" / "pelage-frame", "--out", picture, "--report", report, *options)
        return picture, json.loads(report.read_text())

    def quality(self, *options):
        """What pelage-quality finds on the built-in model."""
        report = self.scratch / "quality.json"
        run(self.programs / "quality" / "pelage-quality", "--out", report, *options)
        return json.loads(report.read_text())["models"][0]

    def medians(self, ways, rounds, value):
        """The median of value(report) of each way of drawing {name: options}. All are drawn in turns, so that what
        disturbs the machine disturbs all."""
        found = {name: [] for name in ways}
        for _ in range(rounds):
            for name, options in ways.items():
                found[name].append(value(self.frame("timed", *options)[1]))
        return {name: statistics.median(values) for name, values in found.items()}


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def tile(picture, crop=None):
    """A picture's pixels, or those of (left, top, right, bottom)."""
    pixels = matplotlib.image.imread(picture)[..., :3]
    return pixels if crop is None else pixels[crop[1]:crop[3], crop[0]:crop[2]]


def sheet(path, rows, inches=1.6):
    """rows: lists of (title, pixels), or None for an empty place."""
    columns = max(len(row) for row in rows)
    figure, axes = matplotlib.pyplot.subplots(
        len(rows), columns, figsize=(inches * columns, 1.16 * inches * len(rows)), squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for row, line in zip(axes, rows):
        for axis, one in zip(row, line):
            if one is not None:
                axis.imshow(one[1], interpolation="nearest")
                axis.set_title(one[0], fontsize=7, pad=2)
    save(figure, path, tight={"pad": 0.3, "w_pad": 0.3, "h_pad": 0.4})


def save(figure, path, tight=None):
    """Writes a figure, in at most 256 colours where it would be larger than LARGEST."""
    figure.tight_layout(**(tight or {"pad": 0.5, "w_pad": 1.5}))
    figure.savefig(path, dpi=110)
    matplotlib.pyplot.close(figure)
    picture = PIL.Image.open(path).convert("RGB")
    picture.save(path, optimize=True)
    if path.stat().st_size > LARGEST:
        few = picture.quantize(256, method=PIL.Image.Quantize.MAXCOVERAGE, dither=PIL.Image.Dither.NONE)
        few.save(path, optimize=True)
    print(f"{path.name}: {path.stat().st_size // 1024} KB\n")


def print_table(heads, rows):
    """A Markdown table; the first column is text."""
    print("| " + " | ".join(map(str, heads)) + " |")
    print("| --- |" + " ---: |" * (len(heads) - 1))
    for row in rows:
        print("| " + " | ".join(map(str, row)) + " |")
    print()
