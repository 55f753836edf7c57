# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""What fibres let pass of light on its way to them and to the eye, and how they read the lights' maps: the built-in
model as pelage-frame draws it by each --attenuation and --lookup. Alone: light_paths.py ROOT [PROGRAM]."""
import json
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot

import plots

MODEL = ["--strands", "20000", "--size", "400"]
ATTENUATIONS = [("constant", []), ("fresnel", ["--attenuation", "fresnel"]),
                ("fresnel, index 2", ["--attenuation", "fresnel", "--eta", "2"])]
METHODS = [("K = 16", []), ("K = 16, 16 slices", ["--tail", "sliced:16"]), ("K = 16, no tail", ["--tail", "none"]),
           ("occupancy, order-weighted", ["--shadow", "occupancy", "--blend", "order_weighted"])]
EXACT = ["--shadow", "exact", "--blend", "exact"]
MAPS = [("exact", "400"), ("exact", "128"), ("k_buffer", "400"), ("occupancy", "400")]

# Few thick strands, in which one look-up is seen, and the pixels that the figure shows of them.
THICK = ["--strands", "3000", "--size", "400", "--fibre-radius", "0.008", "--alpha", "0.8"]
SHOWN = (slice(60, 260), slice(200, 340))


class Frames:
    """Draws frames of the model with a program, and compares them."""

    def __init__(self, program, scratch):
        self.program = program
        self.scratch = scratch

    def draw(self, name, options, other=None, model=MODEL):
        """One frame: its picture's path, and RMS and largest difference from another, if there is one."""
        picture, report = self.scratch / f"{name}.png", self.scratch / f"{name}.json"
        compared = ["--compare", other] if other else []
        command = [self.program, *model, *options, *compared, "--out", picture, "--report", report]
        subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
        found = json.loads(report.read_text())
        return picture, found.get("rms", 0.0), found.get("maximum", 0.0)


def compare_attenuations(frames, path):
    print(f"Each --attenuation against its own exact lists, {MODEL[1]} strands, {MODEL[3]}x{MODEL[3]}:\n")
    print("| --attenuation |" + "".join(f" {title} |" for title, _ in METHODS))
    print("| --- |" + " ---: |" * len(METHODS))
    rows = []
    for i, (title, options) in enumerate(ATTENUATIONS):
        exact, _, _ = frames.draw(f"passing-{i}-exact", [*EXACT, *options])
        drawn = [frames.draw(f"passing-{i}-{j}", [*options, *method], exact) for j, (_, method) in enumerate(METHODS)]
        print(f"| {title} |" + "".join(f" {rms:.5f}, {most:.3f} |" for _, rms, most in drawn))
        nearest = drawn[0]
        rows.append([(f"{title}: exact lists", exact), (f"K = 16; RMS {nearest[1]:.5f}", nearest[0]),
                     ("difference, white = 0.1", nearest[0].with_suffix(".error.png"))])
    print("\n(RMS, largest difference.)\n")
    draw_sheet(rows, path)


def compare_lookups(frames, path):
    """Fibres are lit at every pixel of their length, each place by a look-up of its own."""
    each = ["--shading-spacing", "1"]
    print("| --shadow, texels a side | --lookup filtered | jittered | jittered from filtered |")
    print("| --- | ---: | ---: | ---: |")
    exact, _, _ = frames.draw("lookup-exact", [*each, "--shadow", "exact", "--map-size", "1600"])
    for shadow, side in MAPS:
        options = [*each, "--shadow", shadow, "--map-size", side]
        filtered = frames.draw(f"filtered-{shadow}-{side}", options, exact)
        jittered = frames.draw(f"jittered-{shadow}-{side}", [*options, "--lookup", "jittered"], exact)
        apart = frames.draw(f"apart-{shadow}-{side}", [*options, "--lookup", "jittered"], filtered[0])
        print(f"| `{shadow}`, {side} | {filtered[1]:.5f}, {filtered[2]:.3f} | {jittered[1]:.5f}, {jittered[2]:.3f} | "
              f"{apart[1]:.5f}, {apart[2]:.3f} |")
    print("\n(RMS, largest difference; the first two from exact maps of 1600 texels a side, filtered.)\n")
    rows = []
    for side in ("48", "192"):
        options = [*each, "--shadow", "occupancy", "--map-size", side]
        filtered, _, _ = frames.draw(f"thick-filtered-{side}", options, model=THICK)
        jittered, rms, _ = frames.draw(f"thick-jittered-{side}", [*options, "--lookup", "jittered"], filtered, THICK)
        rows.append([(f"occupancy, {side} texels a side, filtered", filtered),
                     (f"jittered: RMS {rms:.5f} from it", jittered),
                     ("difference, white = 0.1", jittered.with_suffix(".error.png"))])
    draw_sheet(rows, path, SHOWN)


def draw_sheet(rows, path, shown=(slice(None), slice(None))):
    height, width = matplotlib.image.imread(rows[0][0][1])[shown].shape[:2]
    figure, axes = matplotlib.pyplot.subplots(
        len(rows), 3, figsize=(9.6, len(rows) * (3.2 * height / width + 0.15)), squeeze=False)
    for line, row in zip(axes, rows):
        for axis, (title, picture) in zip(line, row):
            axis.imshow(matplotlib.image.imread(picture)[shown])
            axis.set_title(title, fontsize=9)
            axis.set_axis_off()
    plots.save(figure, path)


def compare(program, scratch, pictures):
    frames = Frames(program, scratch)
    compare_attenuations(frames, pictures / "attenuations.png")
    compare_lookups(frames, pictures / "lookups.png")


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1])
    its_program = sys.argv[2] if len(sys.argv) > 2 else root / "build" / "release" / "bench" / "frame" / "pelage-frame"
    its_scratch = root / "out" / "bench" / "quality"
    its_scratch.mkdir(parents=True, exist_ok=True)
    compare(its_program, its_scratch, root / "bench" / "quality" / "pictures")
