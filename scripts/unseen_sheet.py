#!/usr/bin/env python3
"""Draws the worst fruits that `make unseen` has found, by each of its numbers, on one sheet.

  scripts/unseen_sheet.py PROGRAM out/unseen_worst.json out/unseen.png

Each picture is the section of a half, with the number, the template and the seed above it.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw

SIZE, TITLE, COLUMNS = 220, 16, 5


def picture(program, entry, folder):
    """The section of the half of one fruit."""
    file = pathlib.Path(folder) / "half.png"
    command = [program, "cut", entry["fruit"], "--seed", str(entry["seed"]), "--knife", "half", "--section"]
    command += ["--style", "plain", "--quality", "draft", "--size", f"{SIZE}x{SIZE}", "--quiet", "-o", str(file)]
    subprocess.run(command, check=True)
    with Image.open(file) as image:
        return image.convert("RGB")


def sheet_of(program, worst):
    """All of them in rows, each with its title."""
    rows = -(-len(worst) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * SIZE, max(rows, 1) * (SIZE + TITLE)), "white")
    draw = ImageDraw.Draw(sheet)
    with tempfile.TemporaryDirectory() as folder:
        for place, entry in enumerate(worst):
            x, y = place % COLUMNS * SIZE, place // COLUMNS * (SIZE + TITLE)
            draw.text((x + 4, y + 2), f"{entry['number']} {entry['by']:.3g}: {entry['fruit']} {entry['seed']}", fill="black")
            sheet.paste(picture(program, entry, folder), (x, y + TITLE))
    return sheet


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    program, worst, out = sys.argv[1:]
    sheet_of(program, json.loads(pathlib.Path(worst).read_text(encoding="utf-8"))).save(out)


if __name__ == "__main__":
    main()
