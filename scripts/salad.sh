#!/bin/sh
# Makes the salad with the given program, says where its files are and how long each stage took.
set -eu
program=$1
stats=$(mktemp)
trap 'rm -f "$stats"' EXIT

mkdir -p out
"$program" scene scenes/salad.toml -o out/salad.png -o out/salad.glb -o out/salad.pov --stats "$stats"

echo "Stages, in milliseconds (pieces are made in parallel; theirs are summed over threads):"
sed -n '/"stages"/,/}/p' "$stats" | sed -n 's/^ *"\([a-z_]*\)": *\([0-9]*\)\(\.[0-9]*\)\{0,1\},\{0,1\}$/  \1\t\2/p' | expand -t 16
echo "Made:"
ls -sh out/salad.png out/salad.glb out/salad.pov out/salad_meshes.inc | sed 's/^ */  /'
