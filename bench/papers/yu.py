# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Yu et al. 2012: Fig. 7, Fig. 8, and the table of what Fig. 8 compares."""
from drawing import print_table, sheet, tile

ALPHAS = ["0.25", "0.15", "0.03"]
WIDTHS = {"lines": ("off", "a pixel wide"), "thin": ("on", "as thin as they are")}
BLENDS = [("K = 16 over its tail", ["--k", "16"]), ("K = 16, no tail", ["--k", "16", "--tail", "none"]),
          ("32 deep opacity layers", ["--blend", "deep_opacity:32"])]


def translucency(room):
    """Fig. 8: no shadows, a random colour a fibre; each blending and its difference from sorted lists."""
    size, strands = ("64", "300") if room.quick else ("320", "20000")
    crop = None if room.quick else (112, 42, 252, 182)
    for width, (antialias, words) in WIDTHS.items():
        rows = []
        for alpha in ALPHAS:
            name = f"translucency-{width}-{alpha}"
            common = ["--strands", strands, "--size", size, "--components", "translucency", "--fibre-colours",
                      "random", "--aa", antialias, "--alpha", alpha, "--from", "200,8", "--lights",
                      "directional:-0.3,0.6,-0.9:1,1,1", "--specular", "0"]
            truth, _ = room.frame(f"{name}-exact", *common, "--blend", "exact")
            row = [(f"sorted, alpha {alpha}", tile(truth, crop))]
            for i, (title, options) in enumerate(BLENDS):
                picture, report = room.frame(f"{name}-{i}", *common, *options, "--compare", truth)
                row += [(title, tile(picture, crop)),
                        (f"RMS {report['rms']:.5f}, white = 0.1", tile(picture.with_suffix(".error.png"), crop))]
            rows.append(row)
        print(f"fibres {words}:")
        sheet(room.pictures / f"translucency-{width}.png", rows)


def lights(room):
    """Fig. 7: the light before and behind the hair, with single scattering alone and with all components."""
    size, strands = ("64", "300") if room.quick else ("400", "50000")
    crop = None if room.quick else (70, 58, 340, 372)
    sides = {"front": "directional:0.4,0.3,0.9:2.2,2.1,2.0", "back": "directional:-0.7,0.6,-0.9:3.3,3.1,3.0"}
    rows = []
    for side, light in sides.items():
        row = []
        for shown, title in (("single", "single scattering"), ("full", "shadows and translucency")):
            common = ["--strands", strands, "--size", size, "--bsdf", "marschner", "--hair-colour", "blond"]
            picture, _ = room.frame(f"lights-{side}-{shown}", *common, "--components", shown, "--lights", light)
            row.append((f"{side} light, {title}", tile(picture, crop)))
        rows.append(row)
    sheet(room.pictures / "lights.png", rows, 2.7)


CHECKED = ["K-buffer 16", "K-buffer 16, no tail", "deep opacity 32", "order-weighted, counted"]


def check(room):
    """Fig. 8's errors as one table, beside order-weighted blending as Sintorn & Assarsson have it (§3.2)."""
    size, strands = ("64", "300") if room.quick else ("512", "10000")
    model = room.quality("--strands", strands, "--size", size, "--only", "blending")
    print(f"RMS / largest error of blending against sorted lists: {strands} strands in random colours, {size} x {size} "
          "pixels, fibres a pixel wide and as thin as they are\n")
    parts = [(words, one) for width, (_, words) in WIDTHS.items() for one in model[width]["blending"]]
    rows = []
    for name in CHECKED:
        cells = [name]
        for _, one in parts:
            method = next(m for m in one["methods"] if m["name"] == name)
            cells.append(f"{method['rms']:.4f} / {method['maximum']:.3f}")
        rows.append(cells)
    print_table(["", *(f"{words}, {one['alpha']:.2f}" for words, one in parts)], rows)
