# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Svoboda 2012: time of a frame against map resolution, number of lights and number of layers."""
import matplotlib.pyplot

from drawing import print_table, save

LIGHTS = ["spot:1.5,4.3,5.6:1.55,1.47,1.36:90", "directional:-0.9,1.3,-2.0:0.80,0.88,1.0",
          "directional:2.0,1.0,0.5:0.5,0.5,0.5", "directional:-2.0,1.0,0.5:0.5,0.5,0.5",
          "directional:0.0,3.0,0.1:0.3,0.3,0.3", "directional:1.0,-0.5,2.0:0.2,0.2,0.2",
          "directional:-1.0,-0.5,2.0:0.2,0.2,0.2", "directional:1.5,2.0,-1.5:0.2,0.2,0.2"]


def sweeps(room):
    """Medians of frames drawn in turns, each over the first of its kind."""
    size, strands, rounds = ("64", "300", 1) if room.quick else ("640", "20000", 3)
    common = ["--strands", strands, "--size", size, "--shadow", "deep_opacity:8"]
    kinds = {
        "texels a side of each map": {n: [*common, "--map-size", str(n)] for n in (256, 512, 1024, 2048)},
        "lights": {n: [*common, "--lights", *LIGHTS[:n]] for n in (1, 2, 4, 8)},
        "layers": {n: [*common[:-1], f"deep_opacity:{n}"] for n in (4, 8, 16, 32, 64)},
    }
    ways = {(kind, n): options for kind, some in kinds.items() for n, options in some.items()}
    seconds = room.medians(ways, rounds, lambda report: report["seconds"])
    figure, axes = matplotlib.pyplot.subplots(1, 3, figsize=(10, 3.2), sharey=True)
    for axis, (kind, some) in zip(axes, kinds.items()):
        values = [seconds[kind, n] for n in some]
        ratios = [value / values[0] for value in values]
        print_table([kind, "seconds", "ratio"],
                    [[n, f"{value:.3f}", f"{ratio:.2f}"] for n, value, ratio in zip(some, values, ratios)])
        axis.plot(list(some), ratios, "o-")
        axis.set_xscale("log", base=2)
        axis.set_xticks(list(some), labels=map(str, some))
        axis.set_xlabel(kind)
    axes[0].set(ylabel="seconds of a frame / of the first", ylim=(0, None))
    save(figure, room.pictures / "sweeps.png")
