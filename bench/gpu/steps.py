# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""The occupancy path of a device frame step by step, and whole frames against the number of strands [Sintorn &
Assarsson 2009, the table of steps and Fig. 10]."""

PATH = ["--shadow", "occupancy", "--blend", "order_weighted"]
THOUSANDS = [5, 10, 20, 50, 114]


def tables(draw, program, thousands=THOUSANDS, frames=50, options=()):
    """draw(program, options, frames): a report. The steps are those of the most strands; returns all reports."""
    reports = {}
    for n in thousands:
        reports[n] = draw(program, ["--strands", str(1000 * n), "--segments", "48", *PATH, *options], frames)
    most = reports[thousands[-1]]
    print(f"\n{thousands[-1]} 000 strands, {' '.join(PATH)}: milliseconds on {most['device']}, median of {frames}")
    for one in most["passes"]:
        print(f"{one['view']:10}{one['name']:24}{one['milliseconds']:8.3f}")
    print("thousands of strands: milliseconds a frame, over the most")
    for n in thousands:
        print(f"{n:10}{reports[n]['milliseconds']:10.3f}{reports[n]['milliseconds'] / most['milliseconds']:10.3f}")
    return reports
