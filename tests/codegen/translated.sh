#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# translated.sh FILE.cpp EXPECTED PELAGE_GLSL ARGUMENT...: translates FILE.cpp into a scratch folder and compares the
# result with what EXPECTED holds, a folder, or a single .glsl file.
set -euo pipefail
source=$1 expected=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
begin=$(date +%s%N)
"$@" --instantiate "$source" --out "$scratch/pelage/glsl"
echo "translated in $((($(date +%s%N) - begin) / 1000000)) ms"
if [[ -d $expected ]]; then
  diff -ru "$expected" "$scratch/pelage/glsl"
else
  diff -u "$expected" "$scratch/pelage/glsl/$(basename "$expected")"
fi
