# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Draws the papers' figures and prints their tables: figures.py ROOT [NAME...] [--quick]. See run beside it."""
import argparse
import pathlib

import sintorn
import svoboda
import yu
from drawing import Room
from lines import lines
from slices import slices

FIGURES = {"check": yu.check, "translucency": yu.translucency, "lights": yu.lights, "rays": sintorn.rays,
           "steps": sintorn.steps, "sweeps": svoboda.sweeps, "slices": slices, "lines": lines}

arguments = argparse.ArgumentParser()
arguments.add_argument("root", type=pathlib.Path)
arguments.add_argument("names", nargs="*", metavar="NAME", help=", ".join(FIGURES))
arguments.add_argument("--quick", action="store_true", help="small models and pictures, into out/bench/papers")
given = arguments.parse_intermixed_args()

unknown = [name for name in given.names if name not in FIGURES]
if unknown:
    arguments.error(f"{unknown[0]}: not one of {', '.join(FIGURES)}")
room = Room(given.root, given.quick)
for name in given.names or FIGURES:
    FIGURES[name](room)
