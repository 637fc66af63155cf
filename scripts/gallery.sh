#!/bin/sh
# Makes the pictures of README.md and templates/README.md with the given program; `scripts/gallery.py commands` shows
# by which commands.
#   scripts/gallery.sh build/pomona docs/pictures              all of them
#   scripts/gallery.sh build/pomona docs/pictures okra salad   those of one template, and the salad
set -eu
here=$(dirname "$0")
program=$1
folder=$2
shift 2

commands=$("$here/gallery.py" commands "$program" "$folder" "$@")
pictures=$(echo "$commands" | sed 's/.* -o //')
echo "$pictures" | xargs -n 1 dirname | sort -u | xargs mkdir -p
echo "$commands" | tr '\n' '\0' | xargs -0 -P "$(nproc)" -n 1 sh -c

# Painted paper does not pack well: 256 colours, dithered, take a third of the room. Scenes keep all of theirs: they
# have too many, and the dither would show.
palette=$(echo "$commands" | grep -v ' scene ' | sed 's/.* -o //') || exit 0
echo "$palette" | xargs -r -P "$(nproc)" -n 8 pngquant --force --ext .png --speed 1 256
