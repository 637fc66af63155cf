#!/usr/bin/env python3
"""The thumbnails of a batch, or the pictures of a data set, on one picture, in the order of its manifest.

    draw_thumbnails.py BATCH_FOLDER PICTURE.png [COLUMNS [MOST]]     at most MOST of them, 8 a row unless said
"""

import json
import pathlib
import subprocess
import sys
import tempfile

SIZES = {"thumbnail.png": (128, 128), "picture.png": (160, 120)}  # pixels on the picture
PAPER = "#f4f0e6"


def main():
    folder, picture = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    columns = int(sys.argv[3]) if len(sys.argv) > 3 else 8
    items = [item for item in json.loads((folder / "manifest.json").read_text())["items"] if item["files"]]
    items = items[:int(sys.argv[4])] if len(sys.argv) > 4 else items
    shown = next(name for name in SIZES if any(file["name"] == name for file in items[0]["files"]))
    across, down = SIZES[shown]
    width, height = columns * across, -(-len(items) // columns) * down
    images = "".join(
        f'<image x="{n % columns * across}" y="{n // columns * down}" width="{across}" height="{down}" '
        f'xlink:href="{item["item"]}/{shown}"/>' for n, item in enumerate(items))
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="{width}" '
           f'height="{height}"><rect width="100%" height="100%" fill="{PAPER}"/>{images}</svg>')

    # Drawn from the batch's folder: an SVG may name what lies beside it or below.
    with tempfile.NamedTemporaryFile("w", suffix=".svg", dir=folder) as file:
        file.write(svg)
        file.flush()
        subprocess.run(["rsvg-convert", "-o", picture.resolve(), file.name], check=True)


if __name__ == "__main__":
    main()
