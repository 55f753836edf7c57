# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Svoboda's lines against exact coverage, as the camera moves away and as lights' maps are finer. [§1.2.3]"""
import matplotlib.pyplot

from drawing import print_table, save, tile

PRIMITIVES = ["segment", "line"]
DISTANCES = [1, 2, 4, 8, 16]
SHOWN = [1, 4, 8]
FIBRES = {"thin": "0.0004", "thick": "0.007"}  # 0.06 and 1.1 pixels wide at distance 1


def darkness(room, model, primitive, radius, distance):
    """What hair takes from the background's light, in pixels of the distance 1; the picture."""
    options = [*model, "--components", "translucency", "--distance", distance, "--fibre-radius", radius, "--primitive",
               primitive]
    picture, hair = room.frame(f"{primitive}-{radius}-{distance}", *options)
    _, none = room.frame("none", *options, "--alpha", "0")
    return (sum(none["mean"]) - sum(hair["mean"])) * distance**2, picture


def shadow(room, model, primitive, texels):
    """The share of the picture's light that shadows take."""
    options = [*model, "--primitive", primitive]
    _, lit = room.frame("lit", *options, "--components", "translucency")
    _, dark = room.frame("dark", *options, "--map-size", texels)
    return 1 - sum(dark["mean"]) / sum(lit["mean"])


def show(axis, pictures, distance):
    """The middle that the camera saw from distance 1: its left half of segments, its right half of lines."""
    for left, picture in zip((0.0, 0.5), pictures):
        whole = tile(picture)
        side = max(int(whole.shape[0] / distance), 8)
        first = (whole.shape[0] - side) // 2
        start = first if left == 0.0 else first + side // 2
        half = whole[first:first + side, start:start + side // 2]
        axis.imshow(half, extent=(left, left + 0.5, 0, 1), interpolation="nearest")
    axis.set(xlim=(0, 1), ylim=(0, 1))
    axis.set_title(f"distance {distance}: segments | lines", fontsize=9)
    axis.set_axis_off()


def plot(axis, title, label, x, rows, top):
    for primitive, values in rows.items():
        axis.plot(x, values, marker="o", label=primitive)
    axis.set_title(title, fontsize=9)
    axis.set_xlabel(label)
    axis.set_xscale("log", base=2)
    axis.set_ylim(0, top)
    axis.legend(loc="lower right")


def lines(room):
    strands, many, size = ("100", "100", "64") if room.quick else ("3000", "20000", "320")
    maps = [32, 64] if room.quick else [64, 128, 256, 512, 1024, 2048]
    model = ["--strands", strands, "--size", size]
    figure, axes = matplotlib.pyplot.subplots(2, 3, figsize=(10.5, 7))
    table = []
    for axis, (name, radius) in zip(axes[1], FIBRES.items()):
        seen = {p: [darkness(room, model, p, radius, d) for d in DISTANCES] for p in PRIMITIVES}
        unit = seen["segment"][0][0]
        taken = {p: [value / unit for value, _ in seen[p]] for p in PRIMITIVES}
        table += [[f"{name}, {p}", *(f"{value:.3f}" for value in taken[p])] for p in PRIMITIVES]
        plot(axis, f"light taken, {name} fibres (1: segments at distance 1)", "camera's distance", DISTANCES, taken, 1.3)
    for axis, d in zip(axes[0], SHOWN):
        show(axis, [seen[p][DISTANCES.index(d)][1] for p in PRIMITIVES], d)
    print_table(["fibre, primitive, by distance", *DISTANCES], table)

    model = ["--strands", many, "--size", size]
    taken = {p: [shadow(room, model, p, m) for m in maps] for p in PRIMITIVES}
    print_table(["light taken by shadows, by map's side", *maps],
                [[p, *(f"{value:.3f}" for value in taken[p])] for p in PRIMITIVES])
    plot(axes[1][2], "light taken by shadows", "map's side, texels", maps, taken, None if room.quick else 0.08)
    save(figure, room.pictures / "lines.png")
