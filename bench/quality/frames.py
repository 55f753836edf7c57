# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""The built-in model as pelage-frame draws it by every method of shadows and of blending, against the exact ones."""
import json
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot

import plots

SHADOWS = ["exact", "k_buffer", "occupancy", "opacity:16", "opacity:128", "deep_opacity:4", "deep_opacity:8",
           "deep_opacity:16", "deep_opacity:32", "deep_opacity_growing:4", "deep_opacity_growing:8",
           "deep_opacity_growing:16", "deep_opacity_growing:32", "deep:0.01", "deep:0.1"]
BLENDS = ["exact", "depth_peeling", "k_buffer", "k_buffer --tail none", "k_buffer --tail sliced:16", "order_weighted",
          "weighted_average", "weighted_blended", "deep_opacity:32", "deep_opacity_corrected:32", "stochastic:8",
          "stochastic:32", "moments:4", "moments:6", "trigonometric:2", "trigonometric:3", "layers:4", "layers:16"]
SIDE = 400
MODEL = ["--strands", "20000", "--size", str(SIDE)]


def compare(program, scratch, pictures, rounds):
    """Draws all in turn, `rounds` times, so that what disturbs the machine disturbs all; prints tables with each one's
    shortest times."""
    frames = [("shadow", method) for method in SHADOWS] + [("blend", method) for method in BLENDS]
    reports = {frame: [] for frame in frames}
    for _ in range(rounds):
        for kind, method in frames:
            reports[kind, method].append(draw(program, scratch, kind, method))
    print_shadows(reports)
    print_blends(reports)
    draw_sheet(scratch, "shadow", SHADOWS, reports, pictures / "shadows.png")
    draw_sheet(scratch, "blend", BLENDS, reports, pictures / "blends.png")


def name_of(scratch, kind, method):
    return scratch / f"{kind}-{method.replace(':', '-').replace(' ', '')}.png"


def draw(program, scratch, kind, method):
    """One frame by one method, all else as by default; its report."""
    report = scratch / "frame.json"
    command = [program, *MODEL, f"--{kind}", *method.split(), "--out", name_of(scratch, kind, method), "--report", report]
    if method != "exact":
        command += ["--compare", name_of(scratch, kind, "exact")]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
    return json.loads(report.read_text())


def seconds(one):
    return one["bin_seconds"] + one["build_seconds"] + one["resolve_seconds"]


def shortest(reports, kind, method, passes):
    """Seconds of some passes of a frame together."""
    return min(sum(seconds(one) for one in report["passes"][passes]) for report in reports[kind, method])


def error_of(report):
    return f"{report['rms']:.5f} | {report['maximum']:.3f}" if "rms" in report else "0 | 0"


def print_shadows(reports):
    print(f"The built-in model, {MODEL[1]} strands, {SIDE}x{SIDE} pixels and texels, two lights. Time is the "
          "shortest of the rounds: of both lights' maps, and of the camera's pass, which looks them up.\n")
    print("| --shadow | bytes a texel | RMS | largest | maps, s | camera, s |\n| --- |" + " ---: |" * 5)
    for method in SHADOWS:
        report = reports["shadow", method][0]
        size = sum(one["result_bytes"] for one in report["passes"][:-1]) / (len(report["passes"]) - 1) / SIDE ** 2
        maps = shortest(reports, "shadow", method, slice(0, -1))
        camera = shortest(reports, "shadow", method, slice(-1, None))
        print(f"| `{method}` | {size:.0f} | {error_of(report)} | {maps:.2f} | {camera:.2f} |")
    print()


def print_blends(reports):
    print("| --blend | RMS | largest | camera, s |\n| --- | ---: | ---: | ---: |")
    for method in BLENDS:
        report = reports["blend", method][0]
        print(f"| `{method}` | {error_of(report)} | {shortest(reports, 'blend', method, slice(-1, None)):.2f} |")
    print()


def draw_sheet(scratch, kind, methods, reports, path):
    """Each method's picture with what differs from the exact one below it."""
    columns = (len(methods) + 1) // 2
    figure, axes = matplotlib.pyplot.subplots(4, columns, figsize=(2.5 * columns, 10.6), squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for i, method in enumerate(methods):
        picture = name_of(scratch, kind, method)
        row, column = 2 * (i // columns), i % columns
        axes[row][column].imshow(matplotlib.image.imread(picture))
        axes[row][column].set_title(f"{kind} {method}", fontsize=9)
        if method != "exact":
            axes[row + 1][column].imshow(matplotlib.image.imread(picture.with_suffix(".error.png")))
            rms = reports[kind, method][0]["rms"]
            axes[row + 1][column].set_title(f"RMS {rms:.5f}; white = 0.1", fontsize=8)
    plots.save(figure, path)
