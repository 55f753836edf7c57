# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""plot.py IN.json OUT.png: time a pixel over n at K = 16 and over K at n = 256, random depths, a line for each method."""
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

OURS = {"k_select avx512": "#b3261e", "k_select avx2": "#e0662e", "k_select sse2": "#f0a860"}
OTHERS = ["#1f4e79", "#3f7fbf", "#7fb2dd", "#5c5c5c", "#8c8c8c", "#2e7d4f"]


def draw(axes, cells, along, title):
    """One line for each method; `along` is the name of the coordinate."""
    names = list(cells[0]["ns"])
    others = [name for name in names if name not in OURS]
    for name in names:
        ours = name in OURS
        axes.plot([c[along] for c in cells], [c["ns"][name] for c in cells], marker="o", markersize=4,
                  color=OURS[name] if ours else OTHERS[others.index(name) % len(OTHERS)],
                  linewidth=2.2 if ours else 1.2, linestyle="-" if ours else "--", label=name)
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.set_xticks([c[along] for c in cells], [str(c[along]) for c in cells])
    axes.set_xlabel("fragments in the pixel, n" if along == "n" else "fragments kept, K")
    axes.set_title(title, fontsize=11)
    axes.grid(True, which="major", color="#dddddd", linewidth=0.6)


def main(source, target):
    with open(source, encoding="utf-8") as file:
        cells = [c for c in json.load(file)["cells"] if c["case"] == "uniform"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.4), sharey=True)
    draw(left, [c for c in cells if c["k"] == 16], "n", "K = 16")
    draw(right, [c for c in cells if c["n"] == 256], "k", "n = 256")
    left.set_ylabel("nanoseconds a pixel, random depths")
    figure.legend(*left.get_legend_handles_labels(), loc="center left", bbox_to_anchor=(0.79, 0.5), frameon=False,
                  fontsize=9)
    figure.tight_layout(rect=(0.0, 0.0, 0.79, 1.0))
    figure.savefig(target, dpi=130)


if __name__ == "__main__":
    main(*sys.argv[1:])
