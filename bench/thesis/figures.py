# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Tables and the figure of bench/thesis/run: figures.py PROGRAM ROOT."""
import json
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot

PROGRAM, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
SCRATCH = ROOT / "out" / "bench" / "thesis"
PRIMITIVES = ["segment", "line"]
DISTANCES = [1, 2, 4, 8, 16]
MAPS = [64, 128, 256, 512, 1024, 2048]
ROUNDS = 3
THIN, THICK = "0.0004", "0.007"  # 0.06 and 1.1 pixels wide at distance 1


def draw(name, *options):
    """One frame; its picture and report."""
    picture, report = SCRATCH / f"{name}.png", SCRATCH / "frame.json"
    command = [PROGRAM, "--out", picture, "--report", report, *options]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
    return picture, json.loads(report.read_text())


def seconds(report):
    """Of order and blending, with the slices' sort."""
    camera = report["passes"][-1]
    return (camera["bin_seconds"] + camera["build_seconds"] + camera["resolve_seconds"]
            + report["slice_sort_seconds"])


def print_slices():
    """Errors and shortest times of `ROUNDS` in turns."""
    model = ["--strands", "20000", "--size", "400"]
    blends = ["exact", "k_buffer", *(f"{way}:{n}" for way in ("sliced", "sliced_clipped") for n in (16, 64, 256, 1024))]
    shortest = {}
    reports = {}
    for _ in range(ROUNDS):
        for blend in blends:
            truth = [] if blend == "exact" else ["--compare", SCRATCH / "exact.png"]
            _, report = draw("exact" if blend == "exact" else "slices", *model, "--blend", blend, *truth)
            shortest[blend] = min(shortest.get(blend, 1e9), seconds(report))
            reports[blend] = report
    print("| `--blend` | RMS | largest | order and blend / exact's |\n| --- | ---: | ---: | ---: |")
    for blend in blends[1:]:
        report = reports[blend]
        print(f"| `{blend}` | {report['rms']:.5f} | {report['maximum']:.3f} | "
              f"{shortest[blend] / shortest['exact']:.2f} |")

    print("\n| turned by, degrees | sorts | RMS, sliced:256 | sorted for each frame |\n| ---: | ---: | ---: | ---: |")
    for degrees in (5, 10, 15, 18, 19):
        there = ["--from", f"{23 + degrees},8"]
        truth, _ = draw("turned", *model, *there, "--blend", "exact")
        _, fresh = draw("slices", *model, *there, "--blend", "sliced", "--compare", truth)
        _, kept = draw("slices", *model, "--from", "23,8", "--turn", degrees, "--frames", "2", "--blend", "sliced",
                       "--compare", truth)
        print(f"| {degrees} | {kept['slice_sorts']} | {kept['rms']:.5f} | {fresh['rms']:.5f} |")


def darkness(primitive, radius, distance):
    """What hair takes from the background's light, in pixels of the distance 1."""
    options = ["--strands", "3000", "--size", "320", "--components", "translucency", "--distance", distance,
               "--fibre-radius", radius, "--primitive", primitive]
    picture, hair = draw(f"{primitive}-{radius}-{distance}", *options)
    _, none = draw("none", *options, "--alpha", "0")
    return (sum(none["mean"]) - sum(hair["mean"])) * distance**2, picture


def shadow(primitive, texels):
    """The share of the picture's light that shadows take."""
    options = ["--strands", "20000", "--size", "320", "--primitive", primitive]
    _, lit = draw("lit", *options, "--components", "translucency")
    _, dark = draw("dark", *options, "--map-size", texels)
    return 1 - sum(dark["mean"]) / sum(lit["mean"])


def print_row(name, values):
    print(f"| {name} | " + " | ".join(f"{value:.3f}" for value in values) + " |")


def plot_lines():
    figure, axes = matplotlib.pyplot.subplots(2, 3, figsize=(10.5, 7))
    head = " | ".join(f"{d:g}" for d in DISTANCES)
    print(f"\n| fibre, primitive, by distance | {head} |\n| --- |" + " ---: |" * len(DISTANCES))
    for axis, (radius, name) in zip(axes[1], ((THIN, "thin"), (THICK, "thick"))):
        unit = None
        for primitive in PRIMITIVES:
            seen = [darkness(primitive, radius, d) for d in DISTANCES]
            unit = unit or seen[DISTANCES.index(1)][0]
            values = [value / unit for value, _ in seen]
            print_row(f"{name}, {primitive}", values)
            axis.plot(DISTANCES, values, marker="o", label=primitive)
            for column, d in enumerate((1, 4, 8)):
                if name == "thick":
                    crop(axes[0][column], primitive, d, seen[DISTANCES.index(d)][1])
        axis.set_title(f"light taken, {name} fibres (1: segments at distance 1)", fontsize=9)
        axis.set_xlabel("camera's distance")
        axis.set_xscale("log", base=2)
        axis.set_ylim(0, 1.3)
        axis.legend(loc="lower right")

    head = " | ".join(str(m) for m in MAPS)
    print(f"\n| light taken by shadows, by map's side | {head} |\n| --- |" + " ---: |" * len(MAPS))
    for primitive in PRIMITIVES:
        values = [shadow(primitive, m) for m in MAPS]
        print_row(primitive, values)
        axes[1][2].plot(MAPS, values, marker="o", label=primitive)
    axes[1][2].set_title("light taken by shadows", fontsize=9)
    axes[1][2].set_xlabel("map's side, texels")
    axes[1][2].set_xscale("log", base=2)
    axes[1][2].set_ylim(0, 0.08)
    axes[1][2].legend(loc="lower right")
    figure.tight_layout()
    figure.savefig(ROOT / "bench" / "thesis" / "pictures" / "lines.png", dpi=100)


def crop(axis, primitive, distance, picture):
    """Left half of segments, right half of lines, the middle that the camera saw from distance 1."""
    pixels = matplotlib.image.imread(picture)
    side = max(int(pixels.shape[0] / distance), 8)
    first = (pixels.shape[0] - side) // 2
    part = pixels[first:first + side, first:first + side]
    half = part[:, :side // 2] if primitive == "segment" else part[:, side // 2:]
    left, right = (0, 0.5) if primitive == "segment" else (0.5, 1)
    axis.imshow(half, extent=(left, right, 0, 1), interpolation="nearest")
    axis.set_xlim(0, 1)
    axis.set_ylim(0, 1)
    axis.set_title(f"distance {distance}: segments | lines", fontsize=9)
    axis.set_axis_off()


SCRATCH.mkdir(parents=True, exist_ok=True)
print_slices()
plot_lines()
