# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Sintorn & Assarsson 2009: Fig. 5, the table of steps, and Fig. 10's scaling."""
import matplotlib.pyplot

from drawing import print_table, save

RAYS = {"ray": "the deepest texel", "stray_ray": "a stray strand first"}
METHODS = ["occupancy 128/4", "deep opacity 4", "deep opacity 16"]
PATH = ["--shadow", "occupancy", "--blend", "order_weighted"]
STEPS = ["prepare", "shade", "bin", "build", "resolve"]


def rays(room):
    """Fig. 5: visibility along two rays of the key light, fibres a pixel wide."""
    size, strands = ("64", "300") if room.quick else ("512", "10000")
    lit = room.quality("--strands", strands, "--size", size, "--only", "visibility")["lines"]["visibility"][1]
    figure, axes = matplotlib.pyplot.subplots(1, 2, figsize=(9, 3.4), sharey=True)
    rows = []
    for axis, (key, title) in zip(axes, RAYS.items()):
        ray = lit[key]
        axis.plot(ray["depth"], ray["truth"], color="black", linewidth=1.6, label="truth")
        for name in METHODS:
            axis.plot(ray["depth"], ray["methods"][name], linewidth=1.1, label=name)
            errors = [abs(a - b) for a, b in zip(ray["methods"][name], ray["truth"])]
            rows.append([f"{title}, {name}", f"{(sum(e * e for e in errors) / len(errors)) ** 0.5:.4f}",
                         f"{max(errors):.3f}"])
        axis.set(xlabel="depth", title=f"{title}, {ray['fragments']} fragments")
        dark = next((z for z, passed in zip(ray["depth"], ray["truth"]) if passed < 0.003), ray["depth"][-1])
        axis.set_xlim(ray["depth"][0], dark)
        axis.legend(fontsize=8)
    axes[0].set_ylabel(f"visibility, alpha {lit['alpha']:.2f}")
    print_table([f"alpha {lit['alpha']:.2f}", "RMS", "largest"], rows)
    save(figure, room.pictures / "rays.png")


def steps(room):
    """The occupancy path step by step, and whole frames against the number of strands."""
    size, thousands, rounds = ("64", [1, 2], 1) if room.quick else ("640", [5, 10, 20, 50, 114], 3)

    def options(n):
        return ["--strands", str(1000 * n), "--size", size, *PATH]

    def parts(report):
        return [[one["name"], *(one[f"{step}_seconds"] for step in STEPS)] for one in report["passes"]]

    whole = room.medians({n: options(n) for n in thousands}, rounds, lambda report: report["seconds"])
    longest = thousands[-1]
    passes = parts(room.frame("steps", *options(longest))[1])
    total = sum(sum(row[1:]) for row in passes)
    print(f"{longest},000 strands, {size} x {size}, {' '.join(PATH)}: per cent of a frame's passes\n")
    print_table(["", *STEPS], [[row[0], *(f"{100 * x / total:.1f}" for x in row[1:])] for row in passes])
    print_table(["thousands of strands", "seconds", f"of {longest},000"],
                [[n, f"{whole[n]:.3f}", f"{whole[n] / whole[longest]:.3f}"] for n in thousands])
    figure, axis = matplotlib.pyplot.subplots(figsize=(4.6, 3.4))
    axis.plot(thousands, [whole[n] / whole[longest] for n in thousands], "o-")
    axis.plot([0, longest], [0, 1], color="grey", linewidth=0.8, label="in proportion")
    axis.set(xlabel="thousands of strands", ylabel=f"seconds of a frame / of {longest},000 strands")
    axis.legend()
    save(figure, room.pictures / "scaling.png")
