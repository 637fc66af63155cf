#!/usr/bin/env python3
"""Godot imports a scene written for it: every piece is there, with a convex shape to collide with and nothing else.

    godot_test.py FILE.glb FOLDER
"""

import pathlib
import re
import sys

from glb import Glb
from godot import imported, printed

FILE, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
imported(FILE, FOLDER)
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
if wrong:
    sys.exit("\n".join(wrong) + "\n" + out[-2000:] + (FOLDER / "import.log").read_text()[-2000:])
print(f"godot: {len(pieces)} pieces, {len(shapes)} convex shapes")
