#!/bin/sh
# Renders the salad's .pov without options, as its documentation says.
#   povray_salad.sh FOLDER
set -eu
cd "$1"
rm -f salad.png
if ! povray salad.pov >povray.log 2>&1; then
  tail -30 povray.log >&2
  exit 1
fi
grep -E 'Parse Time|Trace Time' povray.log
# A picture of paper alone would compress to a few kilobytes.
size=$(wc -c <salad.png)
echo "salad.png: $size bytes"
[ "$size" -gt 100000 ]
