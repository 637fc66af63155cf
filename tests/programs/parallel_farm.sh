#!/bin/sh
# A batch by GNU parallel, from the lines of `pomona farm commands`; the tree must be that of a run by itself.
#   parallel_farm.sh build/pomona FOLDER
set -eu
program=$(realpath "$1")
rm -rf "$2"
mkdir -p "$2/it's here"
cd "$2/it's here"

cat >batch.toml <<'BATCH'
[batch]
format = 1
name = "parallel"
title = "By GNU parallel"
detail = 0.1

[[entry]]
name = "cut"
templates = ["radish", "cherry", "tomato"]
count = 2
knives = ["half", "across"]
BATCH

"$program" farm commands batch.toml -o out --tasks 4 >shards.txt
parallel --will-cite --jobs 2 --retries 3 --joblog log <shards.txt 2>parallel.log || { cat parallel.log; exit 1; }
[ "$(awk 'NR > 1 && $7 == 0' log | wc -l)" -eq 4 ] || { cat log; exit 1; }
"$program" merge out --quiet
"$program" batch batch.toml -o alone --quiet
diff -r alone out
