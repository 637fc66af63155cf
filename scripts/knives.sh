#!/bin/sh
# Makes the pictures of docs/knives.md with the given program, by the commands it shows.
#   scripts/knives.sh build/pomona
set -eu
program=$(realpath "$1")
cd "$(dirname "$0")/.."
mkdir -p docs/pictures/knives
sed -n 's/^    pomona \(cut .*\)$/\1/p' docs/knives.md | while read -r command; do
  # shellcheck disable=SC2086
  "$program" $command --quiet
done
pngquant --force --ext .png --speed 1 256 docs/pictures/knives/*.png
