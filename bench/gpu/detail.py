# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Frames with fewer segments and strands, of one head and of a crowd: milliseconds, memory, and the CPU's time to choose
them."""

HEAD = ["--strands", "114000", "--segments", "60"]
HEAD_ERRORS = [(0, 0), (0.1, 0), (0.25, 0), (0.1, 0.25), (0.1, 0.5), (0.25, 0.5), (0.25, 1)]
CROWD = ["--crowd", "100", "--strands", "100000", "--size", "1920x1080"]
CROWD_ERRORS = [(0.25, 0.5), (0.25, 1), (0.5, 1)]


def table(draw, program, model, errors, frames):
    print(f"\n{' '.join(model)}, K = 16: milliseconds, median of {frames}; thousands of strands and segments, millions"
          " of fragments; the device's MB, the CPU's at most, its seconds for detail")
    print(f"{'segment, strand':>16}{'frame':>9}{'strands':>9}{'segments':>10}{'fragments':>11}{'MB':>8}{'CPU MB':>8}"
          f"{'seconds':>9}   one hash")
    reports = {}
    for segment, strand in errors:
        name = f"{segment}, {strand}"
        options = [*model, "--k", "16", "--segment-error", str(segment), "--strand-error", str(strand)]
        r = reports[name] = draw(program, options, frames, refusable=True)
        if isinstance(r, str):
            print(f"{name:>16}   {r}")
            continue
        print(f"{name:>16}{r['milliseconds']:9.2f}{r['strands_drawn'] / 1e3:9.1f}{r['segments_drawn'] / 1e3:10.0f}"
              f"{sum(v['fragments'] for v in r['views']) / 1e6:11.1f}{r['device_bytes'] / 1e6:8.0f}"
              f"{r['peak_bytes'] / 1e6:8.0f}{r['detail_seconds']:9.2f}   {r['same_hash']} of {r['frames']}")
    return reports


def tables(draw, program, head=tuple(HEAD), crowd=tuple(CROWD), frames=20):
    """draw(program, options, frames, refusable): a report, or what it was refused with as text. Returns all of them."""
    return {
        "head": table(draw, program, head, HEAD_ERRORS, frames),
        "crowd": table(draw, program, crowd, CROWD_ERRORS, frames),
    }
