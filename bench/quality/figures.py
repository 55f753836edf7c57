# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Measures with pelage-quality and pelage-frame, prints the README's tables and draws its plots."""
import argparse
import json
import pathlib
import subprocess

import frames
import light_paths
import plots

arguments = argparse.ArgumentParser()
arguments.add_argument("root", type=pathlib.Path)
arguments.add_argument("files", nargs="*", type=pathlib.Path, help=".hair or .tfx files to measure as well")
arguments.add_argument("--strands", default="10000", help="of the built-in model")
arguments.add_argument("--size", default="512", help="pixels a side that lists are taken from")
arguments.add_argument("--rounds", type=int, default=3, help="of all frames; the shortest time counts")
given = arguments.parse_intermixed_args()

pictures = given.root / "bench" / "quality" / "pictures"
scratch = given.root / "out" / "bench" / "quality"
pictures.mkdir(parents=True, exist_ok=True)
scratch.mkdir(parents=True, exist_ok=True)
programs = given.root / "build" / "release" / "bench"

report = scratch / "quality.json"
subprocess.run([programs / "quality" / "pelage-quality", "--out", report, "--strands", given.strands,
                "--size", given.size, *given.files], check=True)
for model in json.loads(report.read_text())["models"]:
    print(f"{model['model']}: {model['strands']} strands, {model['size']}x{model['size']} pixels\n")
    plots.print_tables(model)
    suffix = "" if model["model"] == "built-in" else f"-{model['model']}"
    plots.draw_ray(model, pictures / f"ray{suffix}.png")
    plots.draw_errors(model, pictures / f"errors{suffix}.png")

frames.compare(programs / "frame" / "pelage-frame", scratch, pictures, given.rounds)
light_paths.compare(programs / "frame" / "pelage-frame", scratch, pictures)
