#!/usr/bin/env python3
"""Godot imports a scene written for it: every piece is there, with a convex shape to collide with and nothing else. Of the
same scene with an atlas, images have the colours of the vertices.

    godot_test.py FILE.glb FOLDER ATLAS.glb
"""

import pathlib
import re
import sys

from glb import Glb
from godot import imported, printed

FILE, FOLDER, ATLAS = (pathlib.Path(word).resolve() for word in sys.argv[1:])
imported(FILE, FOLDER, ATLAS)
out = printed(FOLDER, "godot_check.gd")
nodes = re.findall(r"^NODE (\w+) (.*)$", out, re.M)
shapes = re.findall(r"^SHAPE (\w+) (\d+)$", out, re.M)

glb = Glb(FILE)
pieces = [name for name in glb.nodes_with_meshes() if not name.endswith("-convcolonly")]
seen = [path.split("/")[-1] for kind, path in nodes if kind == "MeshInstance"]
wrong = []
if sorted(seen) != sorted(pieces):
    wrong.append(f"meshes {sorted(seen)} in place of {sorted(pieces)}")
if len(shapes) != len(pieces) or any(kind != "ConvexPolygonShape" or not 4 <= int(points) <= 64 for kind, points in shapes):
    wrong.append(f"shapes {shapes} for {len(pieces)} pieces")


def srgb(value):
    """Of 255, from 16 bits of linear light."""
    value /= 65535
    return 255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055)


def word(name):
    """Of a mesh, without what names for engines have in place of dots."""
    return name.replace("_", "").replace(".", "")


# Godot 3.2 takes 16-bit colours of vertices for white, so they are read here.
colors = {}
for node, shown in glb.nodes_with_meshes().items():
    for primitive in glb.json["meshes"][shown["mesh"]]["primitives"]:
        if "COLOR_0" not in primitive["attributes"]:
            continue  # to collide with
        places, linear = (glb.values(primitive["attributes"][which]) for which in ("POSITION", "COLOR_0"))
        for place, color in zip(places, linear):
            key = tuple(round(1e6 * value) for value in place)
            colors.setdefault(word(node), {}).setdefault(key, []).append([srgb(one) for one in color[:3]])
off = {}
for name, *numbers in re.findall(r"^TEXEL (\S+)" + 6 * r" (-?\d+)" + "$", out, re.M):
    *place, red, green, blue = map(int, numbers)
    near = colors.get(word(name), {}).get(tuple(place))  # further levels have other vertices
    if near:
        off.setdefault(name, []).append(min(sum(abs(a - b) for a, b in zip(one, (red, green, blue))) / 3 for one in near))
for name, found in off.items():
    if sum(found) / len(found) > (50 if name.startswith("onion") else 13):  # texels blur an onion's skins
        wrong.append(f"{name}: images are off the vertices' colours by {sum(found) / len(found)} of 255")
if set(map(word, off)) != set(colors):
    wrong.append(f"images of {sorted(off)} alone were looked into")
if wrong:
    sys.exit("\n".join(wrong) + "\n" + out[-2000:] + (FOLDER / "import.log").read_text()[-2000:])
print(f"godot: {len(pieces)} pieces, {len(shapes)} convex shapes; {sum(map(len, off.values()))} colours of {len(off)} meshes")
