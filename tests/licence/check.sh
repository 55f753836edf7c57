#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# check.sh ROOT: every file begins with the two lines of the licence, after the #! of a script, except those that have
# no place for them or are data.
set -euo pipefail
cd "$1"
mapfile -t sources < <(find . \( -path ./.git -o -path ./build -o -path ./out -o -path './.?*/*' -not -path './.ci/*' -o \
  -path ./fuzz/corpus -o -name __pycache__ \) -prune -o -type f -not \( -name LICENSE -o -name '*.md' -o -name '*.csv' -o \
  -name '*.json' -o -name '*.png' -o -name '*.txt' -not -name CMakeLists.txt \) -print | sort)
if ((${#sources[@]} == 0)); then
  echo "no source under $1" >&2
  exit 1
fi

status=0
for source in "${sources[@]}"; do
  mapfile -t -n 3 lines <"$source"
  [[ ${lines[0]-} != '#!'* ]] || lines=("${lines[@]:1}")
  if [[ ${lines[0]-} != @('// '|'# ')'Copyright (c) 2026 The Pelage authors' ||
    ${lines[1]-} != @('// '|'# ')'SPDX-License-Identifier: MIT' ]]; then
    echo "$source does not begin with the licence" >&2
    status=1
  fi
done
((status)) || echo "${#sources[@]} sources begin with the licence"
exit $status
