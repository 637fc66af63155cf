#!/usr/bin/env python3
"""Shows a picture and its ground truth (`--aov FOLDER`) side by side, for docs/guides/data.md:
the picture, instances, parts, depth, normals, and the whole mask of an instance that others hide.

    truth_sheet.py PICTURE.png FOLDER SHEET.png [WIDTH]      WIDTH of each, in pixels; 400
"""

import json
import pathlib
import sys

from PIL import Image


def numbers(path):
    """A grey 16-bit picture as rows of numbers, one after another."""
    return list(Image.open(path).convert("I").getdata())


def as_picture(size, colors):
    picture = Image.new("RGB", size)
    picture.putdata(colors)
    return picture


def color_of(number):
    """Neighbouring numbers far apart: hues by the golden ratio, in three lightnesses, muted as print wants them."""
    if number == 0:
        return (255, 255, 255)
    hue = int(255 * ((0.12 + number * 0.618034) % 1))
    saturation, value = 80 + 35 * (number % 3), 232 - 38 * (number // 3 % 3)
    return Image.new("HSV", (1, 1), (hue, saturation, value)).convert("RGB").getpixel((0, 0))


def colored(path):
    image = Image.open(path)
    values = numbers(path)
    known = {n: color_of(n) for n in set(values)}
    return as_picture(image.size, [known[n] for n in values])


def depths(path):
    values = numbers(path)
    seen = [v for v in values if v]
    near, far = (min(seen), max(seen)) if seen else (0, 1)
    shade = lambda v: 255 if v == 0 else round(225 - 200 * (v - near) / max(1, far - near))
    return as_picture(Image.open(path).size, [(shade(v),) * 3 for v in values])


def normals(path):
    """Eight bits of them; paper stays white."""
    image = Image.open(path).convert("RGB")
    return as_picture(image.size, [(255, 255, 255) if n == (0, 0, 0) else n for n in image.getdata()])


def half_hidden(folder, annotations):
    """The largest instance of those that are hidden by some half: what of it shows, and what does not."""
    size = Image.open(folder / "instance.png").size
    ids = numbers(folder / "instance.png")
    hidden_by_half = lambda a: a["amodal_area"] * a["occlusion"] * (1 - a["occlusion"]) if a["occlusion"] > 0.35 else 0
    pieces = [a for a in annotations["annotations"] if a["amodal_area"] < 0.25 * size[0] * size[1]]
    one = max(pieces or annotations["annotations"], key=hidden_by_half)["id"]
    bits = numbers(folder / f"amodal_{(one - 1) // 16 + 1}.png")
    bit = 1 << (one - 1) % 16
    paint = lambda n, b: (214, 69, 65) if n == one else (245, 190, 80) if b & bit else (205, 205, 205) if n else (255, 255, 255)
    return as_picture(size, [paint(n, b) for n, b in zip(ids, bits)])


def main():
    picture, folder, sheet = (pathlib.Path(word) for word in sys.argv[1:4])
    width = int(sys.argv[4]) if len(sys.argv) > 4 else 400
    annotations = json.loads((folder / "annotations.json").read_text())
    views = [
        Image.open(picture).convert("RGB"),
        colored(folder / "instance.png"),
        colored(folder / "part.png"),
        depths(folder / "depth.png"),
        normals(folder / "normal.png"),
        half_hidden(folder, annotations),
    ]
    height = round(width * views[0].height / views[0].width)
    gap = max(2, width // 100)
    whole = Image.new("RGB", (3 * width + 2 * gap, 2 * height + gap), (255, 255, 255))
    for i, view in enumerate(views):
        whole.paste(view.resize((width, height), Image.LANCZOS), (i % 3 * (width + gap), i // 3 * (height + gap)))
    whole.save(sheet, optimize=True)


if __name__ == "__main__":
    main()
