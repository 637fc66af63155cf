#!/bin/sh
# The tool of OpenImageIO reads the OpenEXR file of a picture's ground truth: layers, and Cryptomatte's entries.
#   truth_exr.sh PROGRAM FOLDER
set -eu
program=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

"$program" cut cherry --knife half --detail 0.4 --quality draft --size 160x120 --quiet -o cherry.png --aov truth --aov-format exr
oiiotool --info -v truth/truth.exr > info
for word in "160 x  120" Instance.X Depth.Z Normal.Y Amodal1.X CryptoObject00.R CryptoMaterial01.A MurmurHash3_32 \
  uint32_to_float32 cherry.flesh; do
  grep -q -F "$word" info || { echo "oiiotool does not find $word" >&2; cat info >&2; exit 1; }
done

# Its channels are those of the PNGs: ids as they are.
"$program" cut cherry --knife half --detail 0.4 --quality draft --size 160x120 --quiet -o cherry.png --aov truth
oiiotool truth/truth.exr --ch Instance.X --mulc 0.0000152590219 -d uint16 -o instance.png
idiff -q instance.png truth/instance.png
