# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""bars.py IN.json OUT.png: what bench/results.hpp wrote, one panel a group, one bar a method."""
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLUMNS = 3


def draw(axes, title, values):
    """The values of one group from top to bottom, each written beside its bar."""
    names = list(values)
    axes.barh(range(len(names)), list(values.values()), color="#3f7fbf", height=0.65)
    axes.set_yticks(range(len(names)), names, fontsize=8)
    axes.invert_yaxis()
    longest = max(values.values())
    axes.set_xlim(0.0, 1.2 * longest)
    for place, value in enumerate(values.values()):
        axes.text(value + 0.02 * longest, place, f"{value:.3g}", va="center", fontsize=8)
    axes.set_title(title, fontsize=10)
    axes.spines[["top", "right"]].set_visible(False)


def main(source, target):
    with open(source, encoding="utf-8") as file:
        measured = json.load(file)
    groups = measured["groups"]
    columns = min(COLUMNS, len(groups))
    rows = -(-len(groups) // columns)
    tallest = max(len(values) for values in groups.values())
    figure, axes = plt.subplots(rows, columns, squeeze=False, layout="constrained",
                                figsize=(5.6 * columns, rows * (0.24 * tallest + 0.8) + 0.4))
    for place in axes.flat[len(groups):]:
        place.set_visible(False)
    for place, (title, values) in zip(axes.flat, groups.items()):
        draw(place, title, values)
    figure.suptitle(measured["unit"], fontsize=11)
    figure.savefig(target, dpi=110)


if __name__ == "__main__":
    main(*sys.argv[1:])
