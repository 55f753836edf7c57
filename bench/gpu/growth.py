# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""The default device frame against the number of strands and of pixels, with its memory; beyond that, what it says."""

THOUSANDS = [10, 50, 114, 250, 500]
SIZES = ["640x640", "1920x1080", "3840x2160"]


def sum_of(report, names):
    return sum(p["milliseconds"] for p in report["passes"] if p["name"].startswith(names))


def tables(draw, program, thousands=THOUSANDS, sizes=SIZES, frames=20):
    """draw(program, options, frames, refusable): a report, or what it was refused with as text. Returns all of them."""
    reports = {}
    print(f"\n60 segments a strand, K = 16: milliseconds, median of {frames}; millions of fragments")
    print(f"{'strands':>10}{'size':>12}{'frame':>9}{'count':>9}{'scatter':>9}{'select':>9}{'shade':>9}{'fragments':>11}"
          f"{'ns each':>9}{'MB':>8}   one hash")
    for n in thousands:
        for size in sizes:
            options = ["--strands", str(1000 * n), "--segments", "60", "--size", size, "--k", "16"]
            r = reports[f"{n} {size}"] = draw(program, options, frames, refusable=True)
            if isinstance(r, str):
                print(f"{n:7}000{size:>12}   {r}")
                continue
            fragments = sum(v["fragments"] for v in r["views"])
            parts = [sum_of(r, names) for names in (("count", "allocate"), "scatter", "select", "shade")]
            print(f"{n:7}000{size:>12}{r['milliseconds']:9.2f}" + "".join(f"{part:9.2f}" for part in parts)
                  + f"{fragments / 1e6:11.1f}{1e6 * r['milliseconds'] / fragments:9.3f}{r['device_bytes'] / 1e6:8.0f}"
                  f"   {r['same_hash']} of {r['frames']}")
    return reports
