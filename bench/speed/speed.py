# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Times frames of pelage-frame, interleaved, and prints medians: per pass, in all, and their ratios."""
import argparse
import json
import os
import pathlib
import statistics
import subprocess

arguments = argparse.ArgumentParser()
arguments.add_argument("root", type=pathlib.Path)
arguments.add_argument("--rounds", type=int, default=5)
given, options = arguments.parse_known_args()

scratch = given.root / "out" / "bench" / "speed"
scratch.mkdir(parents=True, exist_ok=True)
program = given.root / "build" / "release" / "bench" / "frame" / "pelage-frame"
ways = {
    "k_buffer, 2 threads": ["--threads", "2"],
    "k_buffer, 1 thread": ["--threads", "1"],
    "full_sort, 2 threads": ["--threads", "2", "--order", "full_sort"],
}
steps = ["prepare_seconds", "shade_seconds", "bin_seconds", "build_seconds", "resolve_seconds"]


def render(way):
    """Draws one frame; returns its report and the processor's seconds of the whole program, loading included."""
    report = scratch / (way.replace(", ", "-").replace(" ", "-") + ".json")
    command = [program, "--out", scratch / "frame.png", "--report", report, *ways[way], *options]
    child = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        raise SystemExit("speed: pelage-frame failed")
    return json.loads(report.read_text()), usage.ru_utime + usage.ru_stime


runs = {way: [] for way in ways}
for _ in range(given.rounds):
    for way in ways:
        runs[way].append(render(way))


def median(way, value):
    return statistics.median(value(report, seconds) for report, seconds in runs[way])


print("| | seconds | processor seconds | peak MB |")
print("| --- | ---: | ---: | ---: |")
for way in ways:
    print(f"| {way} | {median(way, lambda r, _: r['seconds']):.2f} | {median(way, lambda _, s: s):.2f} "
          f"| {median(way, lambda r, _: r['peak_bytes']) / 1e6:.0f} |")

print("\n| pass | " + " | ".join(step.removesuffix("_seconds") for step in steps) + " |")
print("| --- |" + " ---: |" * len(steps))
for way in ways:
    for i, one in enumerate(runs[way][0][0]["passes"]):
        cells = (f"{median(way, lambda r, _: r['passes'][i][step]):.3f}" for step in steps)
        print(f"| {way}: {one['name']} | " + " | ".join(cells) + " |")

measured = {"unit": "seconds, medians", "groups": {
    "a frame": {way: median(way, lambda r, _: r["seconds"]) for way in ways},
    "processor seconds, the whole program": {way: median(way, lambda _, s: s) for way in ways}}}
(given.root / "out" / "bench" / "speed.json").write_text(json.dumps(measured, indent=1))

fast, alone, sorted_whole = (median(way, lambda r, _: r["seconds"]) for way in ways)
print(f"\nfull_sort / k_buffer: {sorted_whole / fast:.2f}; 1 thread / 2 threads: {alone / fast:.2f}")
