#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# check.sh INCLUDE_DIR COMPILER [all]: the float kernels have one and the same hash under a stranger's flags, from a bare
# -I, or the compiler says in one line what is missing. Three optimisations and three instruction sets; with `all`, every
# pair.
set -euo pipefail
include=$1 compiler=$2 all=${3-}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sweep=$(dirname "${BASH_SOURCE[0]}")/sweep.cpp
compile=("$compiler" -std=c++20 -I"$include" "$sweep" -o "$work/sweep")
is_clang=$("$compiler" -dM -E -x c++ /dev/null | grep __clang__ || true)

expected=
builds=0
check() {
  "${compile[@]}" "$@"
  if [[ $* == *x86-64-v4* ]] && ! grep -q avx512bw /proc/cpuinfo; then return; fi
  local hash
  hash=$("$work/sweep") || { echo "$compiler $*: not the same bits everywhere" >&2; exit 1; }
  expected=${expected:-$hash}
  [[ $hash == "$expected" ]] || { echo "$compiler $*: hash $hash, not $expected" >&2; exit 1; }
  builds=$((builds + 1))
}

refused() {
  local said
  if said=$("${compile[@]}" -fsyntax-only "$@" 2>&1); then
    echo "$compiler $*: compiles" >&2
    exit 1
  fi
  [[ $(grep -c 'error:' <<<"$said") == 1 && $said == *'error:'*pelage:* ]] ||
    { printf '%s\n' "$compiler $*: not one line but" "$said" >&2; exit 1; }
}

with_fma=()
if [[ -z $is_clang ]]; then
  with_fma=(-ffp-contract=off -DPELAGE_CONTRACTION_OFF)
  refused -O2 -march=x86-64-v3
fi
refused -O2 -ffast-math
refused -O2 -ffinite-math-only
if [[ $all == all ]]; then
  for level in -O0 -O1 -O2 -O3; do
    for set in x86-64 x86-64-v2 x86-64-v3 x86-64-v4; do
      check "$level" "-march=$set" "${with_fma[@]}"
    done
  done
fi
check -O0
check -O2 -march=x86-64-v3 "${with_fma[@]}"
check -O3 -march=x86-64-v4 "${with_fma[@]}"
check -O3

# The check itself: where contraction is let in, bits differ.
"${compile[@]}" -O2 -march=x86-64-v3 -DPELAGE_ALLOW_CONTRACTION -ffp-contract=fast
if "$work/sweep" >"$work/contracted" 2>/dev/null && [[ $(<"$work/contracted") == "$expected" ]]; then
  echo "$compiler: contracted products would not be noticed" >&2
  exit 1
fi
echo "$compiler: $builds builds, hash $expected"
