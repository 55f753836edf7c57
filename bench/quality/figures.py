# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Measures with pelage-quality, prints the README's tables and draws its plots of visibility and blending."""
import argparse
import json
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot

arguments = argparse.ArgumentParser()
arguments.add_argument("root", type=pathlib.Path)
arguments.add_argument("--report", type=pathlib.Path, help="draw from this JSON file instead of measuring")
given, passed_on = arguments.parse_known_args()

pictures = given.root / "bench" / "quality" / "pictures"
pictures.mkdir(parents=True, exist_ok=True)
report = given.report
if report is None:
    report = given.root / "out" / "quality.json"
    report.parent.mkdir(parents=True, exist_ok=True)
    program = given.root / "build" / "release" / "bench" / "quality" / "pelage-quality"
    subprocess.run([str(program), "--out", str(report), *passed_on], check=True)
measured = json.loads(report.read_text())
titles = {"lines": "lines of a pixel's width", "thin": "thin fibres"}
print(f"{measured['model']}: {measured['strands']} strands, {measured['size']}x{measured['size']} pixels\n")


def errors_by_alpha(kind, columns):
    """A table of one kind of error, a row a method and a column a drawing and alpha."""
    heads = [f"{titles[part]}, {one['alpha']:.2f}" for part in titles for one in measured[part][kind]]
    print("| " + " | ".join(["method", *(head for _, head in columns), *heads]) + " |")
    print("| --- |" + " ---: |" * (len(columns) + len(heads)))
    for i, first in enumerate(measured["lines"][kind][0]["methods"]):
        values = [f"{first[key]:.0f}" for key, _ in columns]
        for part in titles:
            for one in measured[part][kind]:
                method = one["methods"][i]
                values.append(f"{method['rms']:.4f} / {method['maximum']:.3f}")
        print(f"| {first['name']} | " + " | ".join(values) + " |")
    print()


print("RMS / maximum error of visibility:\n")
errors_by_alpha("visibility", [("bytes_per_texel", "bytes a texel")])
print("RMS / maximum error of blending:\n")
errors_by_alpha("blending", [])
print("| map of 512x512 | MiB |\n| --- | ---: |")
for row in measured["memory"]:
    print(f"| {row['name']} | {row['bytes'] / 2**20:.0f} |")

# Visibility along the ray that has most fragments.
ray = measured["lines"]["visibility"][2]["ray"]
groups = [("occupancy 128/4", "density clusters 4", "deep shadow map 0.03"),
          ("deep opacity 4", "deep opacity 16", "deep opacity 32"), ("opacity 16", "opacity 128", "opacity 256")]
figure, axes = matplotlib.pyplot.subplots(1, 3, figsize=(12, 3.6), sharey=True)
for axis, names in zip(axes, groups):
    axis.plot(ray["depth"], ray["truth"], color="black", linewidth=1.6, label="truth")
    for name in names:
        axis.plot(ray["depth"], ray["methods"][name], linewidth=1.1, label=name)
    axis.set_xlabel("depth")
    axis.legend(fontsize=8)
axes[0].set_ylabel("visibility")
dark = next((z for z, passed in zip(ray["depth"], ray["truth"]) if passed < 0.003), ray["depth"][-1])
for axis in axes:
    axis.set_xlim(ray["depth"][0], dark)
figure.tight_layout(pad=0.5)
figure.savefig(pictures / "ray.png", dpi=110)

# Error against memory, and the blendings.
figure, axes = matplotlib.pyplot.subplots(1, 2, figsize=(12, 4.6))
colours = matplotlib.pyplot.get_cmap("tab20").colors[::2] + matplotlib.pyplot.get_cmap("tab20b").colors[::5]
for colour, method in zip(colours, measured["lines"]["visibility"][1]["methods"]):
    axes[0].plot(method["bytes_per_texel"], method["rms"], "o", color=colour, label=method["name"])
axes[0].legend(fontsize=7, loc="lower right")
axes[0].set(xscale="log", yscale="log", xlabel="bytes a texel", ylabel="RMS error of visibility, alpha 0.15")
for colour, method in zip(colours, zip(*(one["methods"] for one in measured["lines"]["blending"]))):
    alphas = [one["alpha"] for one in measured["lines"]["blending"]]
    axes[1].plot(alphas, [m["rms"] for m in method], "o-", color=colour, linewidth=1, label=method[0]["name"])
axes[1].set(yscale="log", xlabel="alpha", ylabel="RMS error of colour")
axes[1].legend(fontsize=7)
figure.tight_layout(pad=0.5)
figure.savefig(pictures / "errors.png", dpi=110)
