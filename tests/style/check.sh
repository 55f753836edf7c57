#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# check.sh [FILE...]: every C++ file is as clang-format 14 writes it, and clang-tidy finds nothing in the library's
# headers, read as one unit, nor in the given files. Some ten seconds of processor time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
. tests/packages.sh
pelage_install "${pelage_style_packages[@]}"

mapfile -d '' -t sources < <(git ls-files -z '*.hpp' '*.cpp')
clang-format --dry-run --Werror "${sources[@]}"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd include && find pelage -name '*.hpp' ! -path pelage/glsl.hpp | sort) | sed 's,.*,#include <&>,' >"$work/headers.cpp"
[[ -s $work/headers.cpp ]]
clang-tidy --quiet --warnings-as-errors='*' --config-file=.clang-tidy "$work/headers.cpp" "$@" -- -std=c++20 -Iinclude \
  -Ibench -Itests -isystem /usr/include/stb 2>&1 | { grep -v 'warnings generated' || true; }
echo "${#sources[@]} files are formatted, $(wc -l <"$work/headers.cpp") headers are tidy"
