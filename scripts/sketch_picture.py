#!/usr/bin/python3
"""Puts a picture of our own under the side view of a sketch: the template's fruit, drawn by the program.

    sketch_picture.py build/pomona templates/lemon.toml

The picture is embedded in the place of `side-picture` in the SVG beside the template. Along the line "skin colours", if
there is one, it has the colours that the template has taken there, so that taking them again changes nothing.
Needs svgelements and Pillow (Debian: python3-svgelements, python3-pil).
"""

import base64
import io
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import xml.etree.ElementTree as ElementTree

from PIL import Image, ImageChops
from svgelements import Matrix
from svgelements import Path as SketchedPath

SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
HEIGHT = 280  # pixels of what is drawn: enough to draw over, little enough to embed

# Even light, no shadow, no lines: how a fruit looks on a light table.
STYLE = """format = 1
kind = "style"
name = "light-table"
ink = { lines = false }
paint = { gloss = 0.4 }
paper = { color = "#ffffff", grain = 0 }
light = { strength = 0.55, ambient = 1.3 }
shadow = { strength = 0 }
"""


def drawn_fruit(program, template):
    """The fruit from its front, cut out, with transparency around it; and the column of its axis in it."""
    with tempfile.TemporaryDirectory() as folder:
        style, picture = pathlib.Path(folder, "style.toml"), pathlib.Path(folder, "fruit.png")
        style.write_text(STYLE)
        subprocess.run([program, "grow", template, "--style", style, "--view", "front", "--size", "900x1200", "--quiet",
                        "-o", picture], check=True)
        image = Image.open(picture).convert("RGB")
    outside = ImageChops.difference(image, Image.new("RGB", image.size, (255, 255, 255)))
    opaque = outside.convert("L").point(lambda value: 255 if value > 3 else 0)
    box = opaque.getbbox()
    image.putalpha(opaque)
    shrink = HEIGHT / (box[3] - box[1])
    size = (round((box[2] - box[0]) * shrink), HEIGHT)
    return image.crop(box).resize(size, Image.Resampling.BOX), (image.width / 2 - box[0]) * shrink


def curves(drawing):
    """The named paths of the side view."""
    layer = next(group for group in drawing.iter(SVG + "g") if group.get("id") == "layer-side")
    return {path.get(LABEL): SketchedPath(path.get("d")) for path in layer.iter(SVG + "path")}


def picture_to_page(paths, image, axis_column):
    """Where the picture lies: as high as all curves together, upright on the axis, which may lean."""
    bottom, top = paths["axis"].point(0), paths["axis"].point(1)
    lean = math.atan2(top.x - bottom.x, bottom.y - top.y)
    upright = Matrix(f"rotate({-math.degrees(lean)},{bottom.x},{bottom.y})")
    drawn = [abs(path * upright).bbox() for name, path in paths.items()
             if name not in ("axis", "skin colours") and not name.startswith("scale ")]
    high, low = min(box[1] for box in drawn), max(box[3] for box in drawn)
    scale = (low - high) / image.height
    place = {"x": bottom.x - scale * axis_column, "y": high, "width": scale * image.width, "height": low - high}
    return place, f"rotate({math.degrees(lean):.3f},{bottom.x:g},{bottom.y:g})", upright


def color_between(stops, share):
    """The colour at a share of the line: for a while that of the nearest stop, then evenly to the next."""
    at = share * (len(stops) - 1)
    step = min(int(at), len(stops) - 2)
    way = min(1.0, max(0.0, (at - step - 0.25) / 0.5))
    return [a + (b - a) * way for a, b in zip(stops[step], stops[step + 1])]


def paint_line(image, line, stops):
    """Within 3 pixels of the line its colours alone; from there they fade into the picture."""
    samples = [(share / 128, line.point(share / 128)) for share in range(129)]
    for y in range(image.height):
        for x in range(image.width):
            away, share = min((math.hypot(p.x - x - 0.5, p.y - y - 0.5), share) for share, p in samples)
            if away > 20:
                continue
            *color, opacity = image.getpixel((x, y))
            weight = min(1.0, max(0.0, (20 - away) / 17))
            mixed = [round(c + (w - c) * weight) for c, w in zip(color, color_between(stops, share))]
            image.putpixel((x, y), (*mixed, 255 if away < 4 else opacity))


def few_colors(image, kept):
    """As a palette, so that it is small; the colours to be kept are in it as they are."""
    painted = image.convert("RGB").quantize(240 - len(kept), dither=Image.Dither.NONE).getpalette()
    palette = painted[:3 * (240 - len(kept))] + [value for color in kept for value in color]
    like = Image.new("P", (1, 1))
    like.putpalette(palette + palette[-3:] * (256 - len(palette) // 3))
    few = image.convert("RGB").quantize(palette=like, dither=Image.Dither.NONE)
    places = {tuple(color): 240 - len(kept) + index for index, color in enumerate(kept)}  # quantize() is not exact
    for y in range(image.height):
        for x in range(image.width):
            if (index := places.get(image.getpixel((x, y))[:3])) is not None:
                few.putpixel((x, y), index)
    alpha = image.getchannel("A").point(lambda value: 255 if value >= 128 else 0)
    few.paste(255, mask=ImageChops.invert(alpha))
    return few


def main(program, template):
    sketch = pathlib.Path(template).with_suffix(".svg")
    paths = curves(ElementTree.parse(sketch))
    image, axis_column = drawn_fruit(program, template)
    place, turn, upright = picture_to_page(paths, image, axis_column)

    stops = []
    for surface in tomllib.loads(pathlib.Path(template).read_text())["surface"]:
        color = surface.get("front", {}).get("color")
        if isinstance(color, dict) and "sample" in color:
            stops = [[int(value[at:at + 2], 16) for at in (1, 3, 5)] for _, value in color["along"]]
    if stops:
        to_pixels = Matrix(f"scale({image.height / place['height']}) translate({-place['x']},{-place['y']})")
        paint_line(image, abs(abs(paths["skin colours"] * upright) * to_pixels), stops)

    png = io.BytesIO()
    few_colors(image, stops).save(png, "PNG", transparency=255, optimize=True)
    numbers = " ".join(f'{key}="{value:.2f}"' for key, value in place.items())
    element = f'''<image
       inkscape:label="picture"
       id="side-picture"
       sodipodi:insensitive="true"
       preserveAspectRatio="none"
       transform="{turn}"
       {numbers}
       xlink:href="data:image/png;base64,{base64.b64encode(png.getvalue()).decode()}" />'''
    text, count = re.subn(r'<image\s+inkscape:label="picture"\s+id="side-picture".*?/>', element, sketch.read_text(), flags=re.S)
    if count != 1:
        sys.exit(f"sketch_picture: error: {sketch} has no side-picture")
    sketch.write_text(text)


if len(sys.argv) != 3:
    sys.exit(__doc__)
main(*sys.argv[1:])
