#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# stack.sh INCLUDE_DIR COMPILER [FLAG...]: k_select<64> takes no more stack than it says, for SSE2 and AVX2, or for FLAGs
# alone. The sum of the deepest calls' frames, as the compiler tells them.
set -euo pipefail
include=$1 compiler=$2
shift 2
allowed_one=6144 allowed_lists=16384

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/k.cpp" <<'CPP'
#include <pelage/order/k_select.hpp>
std::uint32_t one(std::span<const pelage::fragment> list, std::span<pelage::fragment, 64> nearest) {
  return pelage::k_select<64>(list, nearest);
}
void lists(std::span<const pelage::fragment> all, std::span<const std::uint32_t> first,
           std::span<pelage::fragment> nearest) {
  pelage::k_select<64>(all, first, nearest);
}
CPP

check() {
  "$compiler" -std=c++20 -O2 "$@" -ffp-contract=off -DPELAGE_CONTRACTION_OFF -Wno-psabi -I"$include" -fstack-usage \
    -c "$work/k.cpp" -o "$work/k.o"
  # Lists take select_each() and no select_from_many(); all small frames count, and 8 bytes for each return address.
  awk -F'\t' -v flags="$compiler $*" -v allowed_one=$allowed_one -v allowed_lists=$allowed_lists '
    function greater(a, b) { return a > b ? a : b }
    { bytes = $2 + 8; frames++ }
    $1 ~ /select_each/ { each = bytes; next }
    $1 ~ /select_from_many/ { many = greater(many, bytes); next }
    $1 ~ /select_from_few/ { few = greater(few, bytes); next }
    $1 ~ /tighten/ { tighten = greater(tighten, bytes); next }
    { small += bytes }
    END {
      if (!each || !many || !few || !tighten) { print flags ": a function is missing"; exit 1 }
      one = small + greater(many + tighten, few)
      lists = small + each + greater(tighten, few)
      print flags ": " one " bytes of stack for a list, " lists " for lists"
      if (one > allowed_one || lists > allowed_lists) { print "more than k_select.hpp says"; exit 1 }
    }' "$work/k.su"
}

if (($# > 0)); then
  check "$@"
elif [[ $("$compiler" -dumpmachine) == x86_64* ]]; then
  check -msse2
  check -mavx2 -mbmi2
fi
