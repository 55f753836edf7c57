#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# units.sh INCLUDE_DIR COMPILER: two units of one program, compiled for different vectors or instructions for bits,
# share no function of Pelage's (those of GLM and std they share where nothing is inlined), and have the same bits.
set -euo pipefail
include=$1 compiler=$2

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sweep=$(dirname "${BASH_SOURCE[0]}")/sweep.cpp
wide=(-march=x86-64-v3 -ffp-contract=off -DPELAGE_CONTRACTION_OFF)

# shared INCLUDE_DIR LEVEL: the names of what both units define and the linker takes once.
shared() {
  "$compiler" -std=c++20 -I"$1" "$2" -Dmain=sweep_base -c "$sweep" -o "$work/base.o" &
  "$compiler" -std=c++20 -I"$1" "$2" "${wide[@]}" -Dmain=sweep_wide -c "$sweep" -o "$work/wide.o"
  wait $!
  for unit in base wide; do
    nm --defined-only "$work/$unit.o" | awk '$2 ~ /[WVu]/ { print $3 }' | sort >"$work/$unit.names"
  done
  comm -12 "$work/base.names" "$work/wide.names"
}

# Each extension that a unit can have of its own names a namespace of its own.
extensions=(-m{no-,}sse4.1 -mpopcnt -mbmi "-mbmi -mpopcnt" -mavx -mavx2 "-mavx2 -mbmi2" -mavx512f "-mavx512f -mavx512vl")
for flags in "${extensions[@]}"; do
  # shellcheck disable=SC2086
  "$compiler" -std=c++20 -E -P -I"$include" $flags -x c++ - <<<'#include <pelage/version.hpp>
PELAGE_ABI' | tail -n 1
done | sort | uniq -d >"$work/twice"
[[ ! -s $work/twice ]] || { echo "$compiler: units of two kinds are called $(cat "$work/twice")" >&2; exit 1; }

cp -r "$include" "$work/one"
sed -i 's/^#define PELAGE_\(VECTORS\|COUNTS\) .*/#define PELAGE_\1/' "$work/one/pelage/version.hpp"
[[ $(shared "$work/one" -O0) == *pelage* ]] || { echo "$compiler: shared functions would not be noticed" >&2; exit 1; }

for level in -O0 -O2; do
  names=$(shared "$include" "$level")
  ! grep pelage <<<"$names" || { echo "$compiler $level: both units define these" >&2; exit 1; }
done

cat >"$work/main.cpp" <<'EOF'
int sweep_base();
int sweep_wide();
int main(int argc, char**) { return argc > 1 ? sweep_wide() : sweep_base(); }
EOF
"$compiler" -O2 "$work/main.cpp" "$work/wide.o" "$work/base.o" -o "$work/both"
base=$("$work/both")
if grep -q avx2 /proc/cpuinfo; then
  [[ $("$work/both" wide) == "$base" ]] || { echo "$compiler: the units differ in bits" >&2; exit 1; }
fi
