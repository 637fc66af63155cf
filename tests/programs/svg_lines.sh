#!/bin/sh
# What rsvg-convert and Inkscape make of an .svg is the picture that the program draws itself.
#   svg_lines.sh PROGRAM FOLDER
set -eu
program=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

"$program" cut tomato --knife half --section --size 800x600 --quiet -o section.png -o section.svg
"$program" cut tomato --knife half --size 800x600 --quiet -o pieces.svg

# They blend in sRGB, the program in linear light, and colours are patches: lines and the finest noise differ a little.
rsvg-convert section.svg -o rsvg.png
"$program" compare section.png rsvg.png --usual 6 --exceptions 3 --never 255 --flip 0.035
inkscape section.svg --export-filename=inkscape.png >log 2>&1 || { cat log >&2; exit 1; }
"$program" compare rsvg.png inkscape.png --usual 3 --exceptions 0.5 --never 255 --flip 0.002

# A plate's letters and lines are in it, as outlines, where they are in the picture.
"$program" cut lemon --knife across --section --style plate --size 500x600 --quiet -o plate.png -o plate.svg
rsvg-convert plate.svg -o rsvg_plate.png
"$program" compare plate.png rsvg_plate.png --usual 8 --exceptions 9 --never 255 --flip 0.035
for word in Lemon "Citrus limon" pith cm; do
  grep -q "aria-label=\"[^\"]*$word" plate.svg || { echo "plate.svg does not say $word" >&2; exit 1; }
done
if grep -q "<text" plate.svg; then echo "plate.svg depends on a font" >&2; exit 1; fi

# Every piece has a layer that Inkscape finds.
for layer in ink-1 ink-2; do
  inkscape pieces.svg --query-id="$layer" --query-width 2>log | grep -q '^[1-9][0-9]*' || { cat log >&2; exit 1; }
done
