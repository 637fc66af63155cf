#!/bin/sh
# Opens what `pomona sketch` writes in Inkscape, edits and saves it there, and reads it back.
#   inkscape_sketch.sh PROGRAM FOLDER
set -eu
program=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

"$program" grow tomato --size 200x200 --quiet -o picture.png
"$program" sketch fig.toml --folds 5 --picture picture.png --picture picture.png --quiet
"$program" grow fig.toml --quiet -o drawn.ply
mv fig.svg drawn.svg

fail() {
  echo "$1" >&2
  cat log >&2
  exit 1
}

# saved NAME ACTIONS [OPTION]: fig.svg is the drawing after these edits.
saved() {
  inkscape drawn.svg --actions="$2" --export-filename=fig.svg ${3:-} >log 2>&1 || fail "$1: inkscape fails"
  [ -s fig.svg ] || fail "$1: inkscape wrote nothing"
}

# It can be checked, and its colours sampled.
is_good() {
  "$program" check fig.toml >log 2>&1 || fail "$1: not understood"
  ! grep warning log || fail "$1: warned of"
  cp fig.toml sampled.toml
  "$program" sketch sampled.toml --sample --quiet >log 2>&1 || fail "$1: no colours"
  echo "$1: good"
}

is_the_same() {
  is_good "$1"
  "$program" grow fig.toml --quiet -o now.ply
  cmp drawn.ply now.ply || fail "$1: another fruit"
}

is_refused() {
  if "$program" check fig.toml >log 2>&1; then fail "$1: taken"; fi
  grep -q "$2" log || fail "$1: not told"
  echo "$1: refused"
}

# What does not change the fruit.
saved "saved anew" "" && is_the_same "saved anew"
saved grouped "select-by-id:side-skin,side-flesh;selection-group" && is_the_same grouped
saved "another page" "select-all;fit-canvas-to-selection" && is_the_same "another page"
saved "axis as path" "select-by-id:top-axis;object-to-path" && is_the_same "axis as path"

# What does: transforms on paths, groups and layers, and clones.
saved turned "select-by-id:top-skin;transform-rotate:12" && is_good turned
saved "layer turned" "select-by-id:layer-side;transform-rotate:10" && is_good "layer turned"
saved "folds turned" "select-by-id:layer-top;transform-rotate:12" && is_good "folds turned"
saved larger "select-all:all;selection-group;transform-scale:1.5;selection-ungroup" && is_good larger
saved simplified "select-by-id:top-skin;path-simplify" && is_good simplified
saved cloned "select-by-id:chamber-1;clone;transform-rotate:5" && is_refused cloned "lies in fold 1, where"

# What loses the names, or is no text.
saved plain "" --export-plain-svg && is_refused plain "save it as \"Inkscape SVG\""
gzip -c drawn.svg >fig.svg && is_refused compressed "compressed"
