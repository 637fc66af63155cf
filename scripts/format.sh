#!/bin/sh
# Formats our C++ sources and scripts; with --check, only says which are not formatted, and fails.
set -eu
cd "$(dirname "$0")/.."
mode=-i
if [ "${1:-}" = --check ]; then mode="--dry-run --Werror"; fi
# shellcheck disable=SC2086
find generator render cli python tests bench scripts -name '*.h' -o -name '*.cpp' -o -name '*.js' -o -name '*.mjs' 2>/dev/null |
  sort | xargs clang-format $mode
