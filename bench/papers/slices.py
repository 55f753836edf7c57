# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Svoboda's path: segments in depth slices against sorted lists, for a still and a turning camera. [§1.3.3]"""
from drawing import print_table

FIRST = 23  # degrees of azimuth
TURNS = [5, 10, 15, 18, 19]


def seconds_of(report):
    """Of order and blending, with the slices' sort."""
    camera = report["passes"][-1]
    return sum(camera[part] for part in ("bin_seconds", "build_seconds", "resolve_seconds")) + report["slice_sort_seconds"]


def still(room, model, counts, rounds):
    exact = [*model, "--blend", "exact"]
    truth, _ = room.frame("exact", *exact)
    names = ["k_buffer", *(f"{way}:{n}" for way in ("sliced", "sliced_clipped") for n in counts)]
    ways = {name: [*model, "--blend", name] for name in names}
    seconds = room.medians({"exact": exact, **ways}, rounds, seconds_of)
    rows = []
    for name, options in ways.items():
        _, report = room.frame("slices", *options, "--compare", truth)
        rows.append([f"`{name}`", f"{report['rms']:.5f}", f"{report['maximum']:.3f}",
                     f"{seconds[name] / seconds['exact']:.2f}"])
    print_table(["`--blend`", "RMS", "largest", "order and blend / exact's"], rows)


def turning(room, model):
    rows = []
    for degrees in TURNS:
        there = [*model, "--from", f"{FIRST + degrees},8"]
        truth, _ = room.frame("turned", *there, "--blend", "exact")
        _, fresh = room.frame("slices", *there, "--blend", "sliced", "--compare", truth)
        _, kept = room.frame("slices", *model, "--from", f"{FIRST},8", "--turn", degrees, "--frames", "2", "--blend",
                             "sliced", "--compare", truth)
        rows.append([f"{degrees}°", kept["slice_sorts"], f"{kept['rms']:.5f}", f"{fresh['rms']:.5f}"])
    print_table(["turned by", "sorts", "RMS of `sliced:256`", "sorted for that frame"], rows)


def slices(room):
    model, counts, rounds = ((["--strands", "300", "--size", "64"], (16, 64), 1) if room.quick else
                             (["--strands", "20000", "--size", "400"], (16, 64, 256, 1024), 3))
    still(room, model, counts, rounds)
    turning(room, model)
