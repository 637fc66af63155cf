#!/usr/bin/env python3
"""Godot lets the pieces of a full crate move for two seconds: the crate stands there once, collides by its triangles, and
stays full. Shapes of pieces begin outside each other.

    godot_crate_test.py FILE.glb FOLDER
"""

import pathlib
import re
import sys

from glb import Glb
from glb_shapes import deepest, shape
from godot import imported, places, printed

OVERLAPPING = 1e-4  # metres by which shapes overlap at the start
RESTING = 0.1  # metres a second at the end


def shapes_of(glb):
    """The pieces' shapes, which are children of their nodes."""
    shapes = {}
    for name, node in glb.nodes_with_meshes().items():
        hulls = [glb.json["nodes"][child] for child in node.get("children", [])]
        shapes[name] = [shape(glb, node, hull) for hull in hulls if "convcolonly" in hull["name"]]
    return shapes


FILE, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
imported(FILE, FOLDER)
out = printed(FOLDER, "godot_crate.gd")
still = re.findall(r"^STILL (\S+) (\w+)$", out, re.M)
at = {word: places(out, word) for word in ("BEGIN", "END")}

# Where the crate is: its box, which it is not turned out of, from the file.
glb = Glb(FILE)
crate = glb.nodes_with_meshes()["crate"]
position = glb.json["accessors"][glb.json["meshes"][crate["mesh"]]["primitives"][0]["attributes"]["POSITION"]]
origin = crate.get("translation", [0, 0, 0])
low, high = ([position[end][k] + origin[k] for k in range(3)] for end in ("min", "max"))
high[1] += 0.05  # they may be heaped over its rim


def is_inside(place):
    return all(low[k] < place[k] < high[k] for k in range(3))


pieces = [name for name, node in glb.nodes_with_meshes().items() if "col" not in name and name != "crate"]
wrong = []
if still != [("crate", "ConcavePolygonShape")]:
    wrong.append(f"what stands still: {still}")
for word, found in at.items():
    if len(found) != len(pieces):
        wrong.append(f"{word}: {len(found)} of {len(pieces)} pieces move")
    wrong += [f"{word}: {name} is out of the crate, at {place}" for name, place in found.items() if not is_inside(place)]
overlap, one, other = deepest(shapes_of(glb))
if overlap > OVERLAPPING:
    wrong.append(f"{one} and {other} begin {1000 * overlap:.2f} mm within each other")
fastest = float(re.search(r"^FASTEST (\S+)$", out, re.M)[1])
if fastest > RESTING:
    wrong.append(f"a piece still moves at {fastest} m/s")
if wrong:
    sys.exit("\n".join(wrong) + "\n" + out[-2000:])
print(f"godot: {len(pieces)} pieces stay in the crate; they begin {1000 * overlap:.2f} mm deep")
