#!/bin/sh
# Makes the pictures of README.md and templates/README.md with the given program; each line is a command a
# user could type.
#   scripts/gallery.sh build/pomona docs/pictures
set -eu
program=$1
folder=$2
mkdir -p "$folder"

for fruit in tomato onion pepper; do
  "$program" grow "$fruit" --size 360x360 --quiet -o "$folder/${fruit}_whole.png"
  "$program" grow "$fruit" --surfaces --size 360x360 --quiet -o "$folder/${fruit}_surfaces.png"
  "$program" cut "$fruit" --knife half --section --size 360x360 --quiet -o "$folder/${fruit}_half.png"
  "$program" cut "$fruit" --knife across --section --size 360x360 --quiet -o "$folder/${fruit}_across.png"
  for seed in 1 2 3; do
    "$program" cut "$fruit" --seed "$seed" --knife across --section --size 180x180 --quiet \
      -o "$folder/${fruit}_seed_$seed.png"
  done
done
for fruit in $("$program" list | cut -f1); do
  "$program" cut "$fruit" --knife across --section --size 220x220 --quiet -o "$folder/${fruit}_inside.png"
done
"$program" scene scenes/salad.toml --size 880x660 --quiet -o "$folder/salad.png"
