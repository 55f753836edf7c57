# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Hair that moves: its frames beside those of hair that stands still, pass by pass, and whether every structure draws
one sequence of pictures."""

HAIR = ["--strands", "114000", "--segments", "60"]
WIND = ["--sway", "0.1"]
ORDERS = ["k_buffer", "a_buffer", "unrolled_list", "ordered_list", "atomic_k_buffer", "split_k_buffer",
          "partial_selection_sort", "selection_sort"]
SIZES = [16, 64]


def passes_of(report):
    """Milliseconds by view and pass, in the order of the frame."""
    return {(p["view"], p["name"]): p["milliseconds"] for p in report["passes"]}


def side_by_side(still, moving):
    """Prints each pass of both frames, those of the moving hair alone in their place."""
    times = passes_of(still), passes_of(moving)
    print(f"{'':10}{'':24}{'still':>9}{'moving':>9}")
    for view, name in times[1]:
        row = "".join(f"{t[view, name]:9.3f}" if (view, name) in t else f"{'':9}" for t in times)
        print(f"{view:10}{name:24}{row}")
    print(f"{'frame':34}{still['milliseconds']:9.2f}{moving['milliseconds']:9.2f}")
    counts = [sum(v["fragments"] for v in r["views"]) / 1e6 for r in (still, moving)]
    print(f"{'fragments, millions (moving: last)':34}" + "".join(f"{c:9.1f}" for c in counts))
    print(f"{'MB':34}{still['device_bytes'] / 1e6:9.0f}{moving['device_bytes'] / 1e6:9.0f}")


def tables(draw, program, hair=tuple(HAIR), orders=tuple(ORDERS), sizes=tuple(SIZES), frames=100):
    """draw(program, options, frames): a report. Returns all of them."""
    hair = list(hair)
    reports = {"still": draw(program, [*hair, "--k", "16"], frames)}
    moving = reports["moving"] = draw(program, [*hair, *WIND, "--k", "16"], frames)
    print(f"\n{' '.join(hair)}, K = 16, {' '.join(WIND)}: milliseconds on {moving['device']}, median of {frames}")
    side_by_side(reports["still"], moving)
    print(f"\n{frames} frames of the same hair in the wind, drawn twice: frames that are the same, the hash of all, ms")
    for k in sizes:
        first = None
        for order in orders:
            whole = order == "selection_sort"
            if whole and k != sizes[0]:
                continue
            r = draw(program, [*hair, *WIND, "--order", order, "--k", str(k)], frames)
            reports[f"{order} {k}"] = r
            first = first or r["hash"]
            verdict = "no K" if whole else "as the first" if r["hash"] == first else "NOT as the first"
            print(f"{order:24}{'' if whole else f'K = {k}':8}{r['same_hash']:5} of {r['frames']}  {r['hash']}"
                  f"{r['milliseconds']:9.2f}   {verdict}, {r['redrawn']} drawn again with more room,"
                  f" {sum(v['refused'] for v in r['views'])} refused")
    return reports
