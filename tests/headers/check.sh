#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# check.sh INCLUDE_DIR GENERATED_DIR COMPILER FLAG...: each public header compiles alone, and twice; all of them together may
# stand in two translation units of one program.
set -euo pipefail
include=$1 generated=$2
shift 2
compile=("$@" -I"$generated" -I"$include")

# exact_end.hpp ends what another file began.
mapfile -t headers < <(find "$include/pelage" "$generated/pelage" -name '*.hpp' ! -name exact_end.hpp -printf 'pelage/%P\n' |
  sort -u)
if ((${#headers[@]} == 0)); then
  echo "no header under $include/pelage" >&2
  exit 1
fi

# shellcheck disable=SC2016
printf '%s\0' "${headers[@]}" | xargs -0 -P2 -I{} sh -c '
  header=$1; shift
  printf "#include <%s>\n#include <%s>\n" "$header" "$header" | "$@" -fsyntax-only -x c++ - &&
    ! printf "#include <%s>\n" "$header" | "$@" -E -x c++ - | grep -q "inline PELAGE_ABI" && exit
  echo "$header does not compile alone, or does not include version.hpp" >&2
  exit 1' sh {} "${compile[@]}"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '#include <%s>\n' "${headers[@]}" >"$work/one.cpp"
{ cat "$work/one.cpp" && echo 'int main() {}'; } >"$work/two.cpp"
"${compile[@]}" -c "$work/one.cpp" -o "$work/one.o" &
"${compile[@]}" -c "$work/two.cpp" -o "$work/two.o"
wait $!
"${compile[@]}" "$work/one.o" "$work/two.o" -o "$work/both"

# GLM's switches, as engines set them.
# shellcheck disable=SC2016
printf '%s\0' INTRINSICS 'INTRINSICS DEFAULT_ALIGNED_GENTYPES' 'XYZW_ONLY EXPLICIT_CTOR' SWIZZLE \
  'LEFT_HANDED DEPTH_ZERO_TO_ONE' | xargs -0 -P2 -I{} sh -c '
  switches=$1 source=$2; shift 2
  "$@" $(printf -- "-DGLM_FORCE_%s " $switches) -fsyntax-only "$source" && exit
  echo "not with GLM_FORCE_ $switches" >&2
  exit 1' sh {} "$work/one.cpp" "${compile[@]}"

# What cannot work is said first, in one line.
refused() {
  local said
  said=$("${compile[@]}" "${@:2}" -fsyntax-only -x c++ - <<<"$1"'#include <pelage/core/fragment.hpp>' 2>&1) &&
    { echo "compiles: $*" >&2; exit 1; }
  [[ $(grep -m 1 'error:' <<<"$said") == *'pelage: needs'* ]] || { printf '%s\n' "$*:" "$said" >&2; exit 1; }
}
refused '' -std=c++17
refused $'#undef __GNUC__\n#undef __clang_major__\n#define __GNUC__ 9\n#define __clang_major__ 9\n'

echo "${#headers[@]} headers compile alone and link together"
