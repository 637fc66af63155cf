#!/bin/sh
# Pages of a fruit with a stone: cut in half, and in six wedges.
#   pages_to_use.sh build/pomona FOLDER
set -eu
mkdir -p "$2"
"$1" cut avocado --quality draft --knife half -o "$2/half.html"
"$1" cut avocado --quality draft --knife wedges:6 -o "$2/wedges.html"
