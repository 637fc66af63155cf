#!/bin/sh
# Makes files with the program as users do, for other programs to read; checks their sizes.
#   real_files.sh PROGRAM REPOSITORY FOLDER
set -eu
program=$1
repository=$2
folder=$3
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

for fruit in tomato onion pepper; do
  "$program" grow "$fruit" --quiet -o "$fruit.glb"
  "$program" cut "$fruit" --seed 1 --knife half --knife wedges:3 --quiet -o "$fruit-pieces.glb"
done
"$program" grow tomato --surfaces --quiet -o tomato-surfaces.glb
"$program" cut tomato --knife across --texture 256 --quiet -o tomato-textured.glb
"$program" grow apple --lod 2 --quiet -o apple-levels.glb
"$program" cut kiwi --knife half --lod 3 --quiet -o kiwi-levels.glb
"$program" cut tomato --knife across --texture 256 --lod 2 --quiet -o tomato-textured-levels.glb
"$program" grow tomato --cuttable --quiet -o tomato-cuttable.glb
"$program" scene "$repository/scenes/salad.toml" --quiet -o salad.glb -o salad.pov

# One small scene for all who import: as it is, with instances, with levels, and for an engine.
small() { "$program" scene "$repository/tests/programs/small_scene.toml" --detail 0.4 --quality draft --style plain --quiet "$@"; }
small -o small.glb -o small.usda -o small.pov -o small.png -o small.html -o small.json
small --instances --feature-ids -o small-instances.glb -o small-instances.usda
small --lod 2 -o small-levels.glb -o small-levels.usda
small --engine godot -o small-godot.glb
for shared in none piece file; do small --texture 64 --lod 1 --atlas $shared -o small-atlas-$shared.glb; done
for shared in none piece file; do small --lod 1 --atlas $shared -o small-looks-$shared.glb; done
small --atlas piece -o small-looks.usda && small --texture 64 --atlas file -o small-atlas.usda
mkdir coded && small --compress meshopt -o coded/small.glb
small --up z --hulls 4 -o small-z.usda
cp "$repository/tests/programs/small_crate.toml" "$repository/scenes/dishes/crate.obj" .
crate() { "$program" scene small_crate.toml --detail 0.4 --quality draft --style plain --quiet "$@"; }
crate --engine godot -o small-crate.glb && crate --engine unreal -o small-crate-unreal.glb
"$program" cut tomato --knife half --detail 0.4 --quality draft --texture 256 --maps color --ripeness-variants 0.2,1.8 --quiet -o ripenesses.glb -o ripenesses.usda
small --engine unreal --lod 1 -o small-unreal.glb

# Megabytes that docs and users count on.
at_most() {
  size=$(cat "$2" ${3:+"$3"} | wc -c)
  echo "$2: $size bytes"
  [ "$size" -le $(($1 * 1000000)) ] || { echo "$2 is larger than $1 MB" >&2; exit 1; }
}
at_most 40 salad.glb
at_most 100 salad.pov salad_meshes.inc
