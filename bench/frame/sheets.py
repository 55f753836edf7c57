# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""What the scripts of the README's figures share: frames by pelage-frame, and sheets of them."""
import json
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot


class sheets:
    def __init__(self, root):
        self.program = root / "build" / "release" / "bench" / "frame" / "pelage-frame"
        self.scratch = root / "out" / "figures"
        self.pictures = root / "bench" / "frame" / "pictures"
        self.scratch.mkdir(parents=True, exist_ok=True)
        self.pictures.mkdir(parents=True, exist_ok=True)

    def render(self, name, *options):
        """Draws one frame; returns its picture's path and its report."""
        picture, report = self.scratch / f"{name}.png", self.scratch / f"{name}.json"
        command = [self.program, "--out", picture, "--report", report, *options]
        subprocess.run([str(word) for word in command], check=True)
        return picture, json.loads(report.read_text())

    def side_by_side(self, name, rows):
        """rows: lists of (title, picture); one figure of them all."""
        columns = max(len(row) for row in rows)
        figure, axes = matplotlib.pyplot.subplots(
            len(rows), columns, figsize=(3.2 * columns, 3.45 * len(rows)), squeeze=False)
        for row, line in zip(axes, rows):
            for axis, (title, picture) in zip(row, line):
                axis.imshow(matplotlib.image.imread(picture))
                axis.set_title(title, fontsize=9)
                axis.set_axis_off()
        figure.tight_layout(pad=0.4)
        figure.savefig(self.pictures / f"{name}.png", dpi=110)
