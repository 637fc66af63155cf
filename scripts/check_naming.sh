#!/bin/sh
# Checks the names in our own headers (.clang-tidy): all of them in one unit, so that it takes seconds.
set -eu
cd "$(dirname "$0")/.."
unit=$(mktemp --suffix=.cpp)
found=$(mktemp)
trap 'rm -f "$unit" "$found"' EXIT
find generator render cli -name '*.h' | sort | sed 's/.*/#include "&"/' >"$unit"
if ! clang-tidy --quiet --config-file=.clang-tidy --header-filter="^$(pwd)/(generator|render|cli)/" \
  --warnings-as-errors='*' "$unit" -- -std=c++20 -I"$(pwd)" >"$found" 2>&1; then
  cat "$found" >&2
  exit 1
fi
