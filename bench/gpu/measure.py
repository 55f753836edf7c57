# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Times pelage-frame --device vulkan: measure.py PROGRAM FOLDER. See run beside it."""

import json
import pathlib
import subprocess
import sys
import tempfile

import detail
import growth
import steps
import sway

HAIR = ["--strands", "50000", "--segments", "48"]
HEADLINE = ["--strands", "114000", "--segments", "60"]
# --order and --tail, and what they are. "none" is a K-buffer as the papers have it, which loses what lies behind K.
METHODS = {
    ("k_buffer", "mean"): "count, allocate, scatter; a subgroup a pixel selects",
    ("k_buffer", "none"): "the same, truncated",
    ("a_buffer", "mean"): "two-pass [Yu12]: lists; an invocation a pixel replaces in registers",
    ("a_buffer", "none"): "the same, truncated: as Yu has it",
    ("unrolled_list", "mean"): "two-pass, lists of blocks; a subgroup a pixel replaces in registers",
    ("unrolled_list", "none"): "the same, truncated",
    ("ordered_list", "mean"): "single-pass [Yu12]: lists sorted while they are built",
    ("atomic_k_buffer", "mean"): "one pass of 64-bit minima: cascade_k_buffer",
    ("split_k_buffer", "mean"): "two passes of 32-bit minima: depths, ids",
    ("partial_selection_sort", "mean"): "runs; selection stopped after K rounds",
    ("selection_sort", "mean"): "runs; selection of whole lists [Yang10], no K",
}
SIZES = [8, 16, 32, 64]
MODELS = ["--bsdf kajiya_kay", "--attenuation fresnel", "--lookup jittered", "--bsdf marschner", "--bsdf chiang",
          "--bsdf dual_scattering"]
FRAMES = 50
BASELINE_SHADOWS = ["occupancy", "opacity:16", "opacity:128", "opacity:256", "deep_opacity:4", "deep_opacity:8",
                    "deep_opacity:16", "deep_opacity:32", "deep_opacity_growing:4", "deep_opacity_growing:8",
                    "deep_opacity_growing:16"]
BASELINE_BLENDS = ["order_weighted", "weighted_average", "weighted_blended", "deep_opacity:32",
                   "deep_opacity_corrected:32", "sliced:256", "moments:4", "moments:6", "trigonometric:2",
                   "trigonometric:3"]


def draw(program, options, frames, picture=None, refusable=False):
    """The program's report of some frames; with `refusable` what it says instead, if it does not draw them."""
    with tempfile.TemporaryDirectory() as scratch:
        report = pathlib.Path(scratch) / "report.json"
        out = picture or pathlib.Path(scratch) / "frame.png"
        command = [program, "--device", "vulkan", "--frames", str(frames), "--out", str(out), "--report", str(report)]
        done = subprocess.run(command + options, capture_output=True, text=True, check=False)
        if done.returncode != 0 and refusable:
            return done.stderr.strip()
        if done.returncode != 0:
            sys.exit(done.stderr.strip())
        return json.loads(report.read_text())


def methods_table(program):
    """Frames by method and K."""
    all_reports = {}
    print(f"50 000 strands, 2.4 million segments, 640 x 640: milliseconds a frame, median of {FRAMES}")
    print(f"{'--order, --tail':30}" + "".join(f"{'K = ' + str(k):>10}" for k in SIZES) + "   one picture, one hash")
    for (order, tail), what in METHODS.items():
        whole = order == "selection_sort"
        options = HAIR + ["--order", order, "--tail", tail]
        sizes, frames = (SIZES[:1], 10) if whole else (SIZES, FRAMES)
        reports = [draw(program, options + ["--k", str(k)], frames) for k in sizes]
        all_reports[f"{order} {tail}"] = reports
        same = all(r["same_hash"] == r["frames"] for r in reports)
        agree = all(r["hash"] == first["hash"] for r, first in zip(reports, all_reports[f"k_buffer {tail}"]))
        verdict = ("as k_buffer" if agree else "its own") + (", in all frames" if same else ", NOT in all frames")
        times = "".join(f"{r['milliseconds']:10.2f}" for r in reports)
        print(f"{order + ', ' + tail:30}{times:40}   {verdict}; {what}")
    for slow, fast in [
        ("selection_sort mean", "k_buffer mean"),
        ("selection_sort mean", "a_buffer none"),
        ("selection_sort mean", "unrolled_list none"),
        ("partial_selection_sort mean", "a_buffer none"),
        ("partial_selection_sort mean", "unrolled_list none"),
        ("a_buffer none", "unrolled_list none"),
        ("a_buffer mean", "k_buffer mean"),
    ]:
        slower = all_reports[slow] * (len(SIZES) if len(all_reports[slow]) == 1 else 1)
        pairs = [(s["milliseconds"], f["milliseconds"], f["k"]) for s, f in zip(slower, all_reports[fast])]
        print(f"{slow} / {fast}: " + ", ".join(f"{s / f:.1f} at K = {k}" for s, f, k in pairs))
    return all_reports


def blending(report):
    """Milliseconds of the camera's passes that bring fragments in order and together; None where one dispatch does some
    of that for all views."""
    if any(p["view"] == "all" and p["name"] == "count" for p in report["passes"]):
        return None
    others = ("opaque", "shade", "background", "clear reports", "clear maps")
    passes = [p for p in report["passes"] if p["view"] == "camera"]
    return sum(p["milliseconds"] for p in passes if not p["name"].startswith(others))


def peeling_table(program, folder):
    """Occupancy maps against depth peeling, and the error of each picture."""
    truth = folder / "gpu_sorted.png"
    all_reports = {"sorted": draw(program, HAIR + ["--order", "selection_sort"], 2, truth)}
    print("\n50 000 strands, 640 x 640: milliseconds; RMS and largest difference from the picture of sorted lists")
    print(f"{'--shadow':12}{'--blend':18}{'frame':>8}{'blending':>10}{'MB':>8}{'RMS':>10}{'largest':>10}   one hash")
    for shadow in ["k_buffer", "occupancy"]:
        for blend in ["k_buffer", "order_weighted", "depth_peeling"]:
            options = ["--shadow", shadow, "--blend", blend, "--k", "16", "--compare", str(truth)]
            frames = FRAMES if blend != "depth_peeling" else 10
            r = draw(program, HAIR + options, frames)
            all_reports[f"{shadow} {blend}"] = r
            alone = blending(r)
            print(
                f"{shadow:12}{blend:18}{r['milliseconds']:8.2f}{f'{alone:.2f}' if alone is not None else '':>10}"
                f"{r['device_bytes'] / 1e6:8.0f}"
                f"{r['rms']:10.5f}{r['maximum']:10.3f}   {r['same_hash']} of {r['frames']}"
            )
    by_maps, by_layers = all_reports["occupancy order_weighted"], all_reports["occupancy depth_peeling"]
    print(
        f"depth_peeling / order_weighted: {by_layers['milliseconds'] / by_maps['milliseconds']:.1f} a frame, "
        f"{blending(by_layers) / blending(by_maps):.1f} blending alone, {by_layers['views'][-1]['longest_list']} layers"
    )
    return all_reports


def models_table(program, folder):
    """What a fibre's model, attenuation and look-ups cost, and how far a device's pictures are from the processor's."""
    print("\n50 000 strands, 640 x 640, K = 16, blond: milliseconds; RMS and largest difference from the CPU's picture")
    print(f"{'':23}{'frame':>8}{'shade':>8}{'cover':>8}{'MB':>8}{'RMS':>10}{'largest':>10}   one hash")
    all_reports = {}
    for model in MODELS:
        options = HAIR + [*model.split(), "--hair-colour", "blond"]
        truth = folder / f"cpu_{model.split()[1]}.png"
        command = [program, "--shading-spacing", "inf", "--out", str(truth)] + options
        subprocess.run(command, check=True, capture_output=True)
        r = draw(program, options + ["--compare", str(truth)], FRAMES)
        all_reports[model] = r
        shade, cover = (
            sum(p["milliseconds"] for p in r["passes"] if p["name"].startswith(name)) for name in ("shade", "cover")
        )
        print(
            f"{model:23}{r['milliseconds']:8.2f}{shade:8.2f}{cover:8.2f}{r['device_bytes'] / 1e6:8.0f}"
            f"{r['rms']:10.5f}{r['maximum']:10.3f}   {r['same_hash']} of {r['frames']}"
        )
    return all_reports


def mapping(report):
    """Milliseconds of the passes that make the lights' maps and no other; None where one dispatch does some for all
    views."""
    if blending(report) is None:
        return None
    passes = [p for p in report["passes"] if p["view"].startswith("light")]
    return sum(p["milliseconds"] for p in passes)


def baselines_table(program, folder):
    """What the papers compare with: the other maps under the same blending, and the other blendings over the same
    maps. After peeling_table(), whose sorted picture they are compared with."""
    truth = folder / "gpu_sorted.png"
    rows = [(shadow, "order_weighted") for shadow in BASELINE_SHADOWS]
    rows += [("k_buffer", blend) for blend in BASELINE_BLENDS]
    all_reports = {}
    print("\n50 000 strands, 640 x 640: milliseconds; RMS and largest difference from the picture of sorted lists")
    heads = f"{'frame':>8}{'maps':>8}{'blending':>10}{'MB':>8}{'RMS':>10}{'largest':>10}"
    print(f"{'--shadow':26}{'--blend':28}{heads}   one hash")
    for shadow, blend in rows:
        options = ["--shadow", shadow, "--blend", blend, "--k", "16", "--compare", str(truth)]
        r = draw(program, HAIR + options, FRAMES)
        all_reports[f"{shadow} {blend}"] = r
        print(
            f"{shadow:26}{blend:28}{r['milliseconds']:8.2f}{mapping(r):8.2f}{blending(r):10.2f}"
            f"{r['device_bytes'] / 1e6:8.0f}{r['rms']:10.5f}{r['maximum']:10.3f}   {r['same_hash']} of {r['frames']}"
        )
    return all_reports


def headline(program, picture):
    """The large model by passes, 100 frames."""
    report = draw(program, HEADLINE + ["--k", "16"], 100, picture)
    views = list(dict.fromkeys(p["view"] for p in report["passes"]))
    names = list(dict.fromkeys(p["name"].replace("_light_16", "").replace("_camera_16", "") for p in report["passes"]))
    print(f"\n114 000 strands, 6.8 million segments, 640 x 640, K = 16 on {report['device']}")
    print(f"{'milliseconds':20}" + "".join(f"{v:>10}" for v in views))
    for name in names:
        row = []
        for view in views:
            of_view = [p for p in report["passes"] if p["view"] == view and p["name"].startswith(name)]
            exact = [p for p in of_view if p["name"] in (name, name + "_light_16", name + "_camera_16")]
            row.append(f"{sum(p['milliseconds'] for p in exact):10.3f}" if exact else f"{'':10}")
        print(f"{name:20}" + "".join(row))
    print("millions of fragments, view by view: " + ", ".join(f"{v['fragments'] / 1e6:.1f}" for v in report["views"]))
    print(
        f"{report['milliseconds']:.2f} ms a frame, {report['same_hash']} of {report['frames']} frames are "
        f"{report['hash']}, {report['device_bytes'] / 1e6:.0f} MB"
    )
    return report


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    reports = {
        "methods": methods_table(program),
        "peeling": peeling_table(program, folder),
        "models": models_table(program, folder),
        "baselines": baselines_table(program, folder),
        "headline": headline(program, folder / "gpu.png"),
        "steps": steps.tables(draw, program),
        "growth": growth.tables(draw, program),
        "sway": sway.tables(draw, program),
        "detail": detail.tables(draw, program),
    }
    (folder / "gpu.json").write_text(json.dumps(reports, indent=2) + "\n")


main()
