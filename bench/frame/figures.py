# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Renders the frames of the README's figures with pelage-frame and puts them side by side."""
import argparse
import pathlib

from sheets import sheets

arguments = argparse.ArgumentParser()
arguments.add_argument("root", type=pathlib.Path)
arguments.add_argument("--hair", type=pathlib.Path)
given = arguments.parse_args()
drawing = sheets(given.root)
render, side_by_side, pictures = drawing.render, drawing.side_by_side, drawing.pictures

frame, report = render("frame")
(pictures / "frame.png").write_bytes(frame.read_bytes())
print(f"\ndefault frame: {report['seconds']:.2f} s, {report['peak_bytes'] / 1e6:.0f} MB at most, "
      f"{report['threads']} threads")
for one in report["passes"]:
    print(f"  {one['name']}: {one['fragments'] / 1e6:.1f} million fragments, longest list {one['longest_list']}, "
          f"structure {one['structure_bytes'] / 1e6:.1f} MB, result {one['result_bytes'] / 1e6:.1f} MB")
print()

columns = [("single", "single: opaque, unshadowed"), ("shadows", "shadows"), ("translucency", "translucency"),
           ("full", "full: both")]
side_by_side("components", [
    [(f"{title}, {word}", render(f"{column}-{aa}", "--components", column, "--aa", aa)[0]) for column, title in columns]
    for aa, word in (("off", "aliased"), ("on", "anti-aliased"))
])

# "View only" leaves the shadows out and shows the error of the K nearest fragments and their tail along the view ray;
# the whole frame adds that of the lights' maps.
rows = []
table = ["| alpha | RMS, view only | RMS, whole frame | largest |", "| --- | --- | --- | --- |"]
for alpha in ("0.25", "0.15", "0.03"):
    truth, _ = render(f"truth-{alpha}", "--order", "full_sort", "--alpha", alpha)
    truth_view, _ = render(f"truth-view-{alpha}", "--order", "full_sort", "--alpha", alpha, "--components", "translucency")
    buffer, whole = render(f"k16-{alpha}", "--alpha", alpha, "--compare", truth)
    _, view = render(f"k16-view-{alpha}", "--alpha", alpha, "--components", "translucency", "--compare", truth_view)
    table.append(f"| {alpha} | {view['rms']:.5f} | {whole['rms']:.5f} | {whole['maximum']:.3f} |")
    rows.append([(f"sorted whole, alpha {alpha}", truth), (f"K = 16, alpha {alpha}", buffer),
                 ("difference, white = 0.1", buffer.with_suffix(".error.png"))])
side_by_side("errors", rows)
print("\n" + "\n".join(table))

# Two more lights, behind and beside the head, show what passes through hair.
lights = ["spot:3.57,4.3,4.57:2.0,1.9,1.75:90", "directional:-1.61,1.3,-1.49:1.3,1.4,1.6",
          "directional:0.6,0.9,-2.31:1.1,1.05,1.0"]
models = [("kajiya_kay", "Kajiya-Kay"), ("marschner", "Marschner"), ("chiang", "Chiang"),
          ("dual_scattering", "dual scattering")]
side_by_side("scattering", [
    [(f"{title}, {colour}", render(f"{model}-{colour}", "--size", "400", "--bsdf", model, "--hair-colour", colour,
                                   "--lights", *lights)[0]) for colour in ("blond", "red", "brown", "black")]
    for model, title in models
])

# The built-in hair in a wind, 0.4 s apart.
side_by_side("sway", [
    [(f"{frame / 30:.1f} s", render(f"sway-{frame}", "--size", "400", "--from", "10,4", "--sway", "0.25",
                                    "--frames", str(frame + 1))[0]) for frame in row]
    for row in ((0, 12), (24, 36))
])

if given.hair:
    picture, _ = render("file", "--hair", given.hair, "--follow", "15")
    (pictures / "file.png").write_bytes(picture.read_bytes())
    ways = [["", "--follow 30"], ["--interpolate 30", "--interpolate 30 --clump 0.8"]]
    side_by_side("strands", [
        [(way or "the file's strands",
          render("strands" + way.replace(" ", "_"), "--hair", given.hair, "--size", "560", *way.split())[0])
         for way in row]
        for row in ways
    ])
