#!/usr/bin/env python3
"""Godot lets the pieces of a full crate move for two seconds: the crate collides by its triangles, and stays full.
Their shapes begin outside each other.

    godot_crate_test.py FILE.glb FOLDER
"""

import itertools
import pathlib
import re
import sys

from glb import Glb
from godot import imported, printed

OVERLAPPING = 1e-4  # metres by which shapes overlap at the start


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def placed(node, point):
    """A point of the node's, in the scene."""
    *axis, w = node.get("rotation", (0, 0, 0, 1))
    twice = [2 * one for one in cross(axis, point)]
    moved = zip(point, twice, cross(axis, twice), node.get("translation", (0, 0, 0)))
    return tuple(p + w * t + c + place for p, t, c, place in moved)


def shape(glb, node, hull):
    """The points of a hull where it stands, and the normals of its faces."""
    mesh = glb.json["meshes"][hull["mesh"]]
    points = [placed(node, p) for p in glb.values(mesh["primitives"][0]["attributes"]["POSITION"])]
    normals = [cross(minus(points[b], points[a]), minus(points[c], points[a])) for a, b, c in glb.triangles(mesh)]
    return points, [tuple(one / dot(n, n) ** 0.5 for one in n) for n in normals if dot(n, n) > 0]


def depth(a, b):
    """How deep two shapes lie within each other, along the normals of their faces."""
    least = float("inf")
    for sign, normals in ((1, a[1]), (-1, b[1])):
        for normal in normals:
            along = [sign * one for one in normal]
            least = min(least, max(dot(along, p) for p in a[0]) - min(dot(along, p) for p in b[0]))
            if least <= 0:
                return 0
    return least


def deepest(glb):
    """The two pieces whose shapes lie deepest within each other, and how deep."""
    shapes = {}
    for name, node in glb.nodes_with_meshes().items():
        hulls = [glb.json["nodes"][child] for child in node.get("children", [])]
        shapes[name] = [shape(glb, node, hull) for hull in hulls if "convcolonly" in hull["name"]]
    pairs = itertools.combinations(shapes, 2)
    return max((max((depth(a, b) for a in shapes[one] for b in shapes[other]), default=0), one, other) for one, other in pairs)


FILE, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
imported(FILE, FOLDER)
out = printed(FOLDER, "godot_crate.gd")
still = re.findall(r"^STILL (\S+) (\w+)$", out, re.M)
places = {word: {name: tuple(map(float, p.split())) for name, p in re.findall(rf"^{word} (\S+) (.*)$", out, re.M)} for word in ("BEGIN", "END")}

# Where the crate is: its box, which it is not turned out of, from the file.
glb = Glb(FILE)
crate = glb.nodes_with_meshes()["crate"]
position = glb.json["accessors"][glb.json["meshes"][crate["mesh"]]["primitives"][0]["attributes"]["POSITION"]]
at = crate.get("translation", [0, 0, 0])
low, high = ([position[end][k] + at[k] for k in range(3)] for end in ("min", "max"))
high[1] += 0.05  # they may be heaped over its rim


def is_inside(place):
    return all(low[k] < place[k] < high[k] for k in range(3))


pieces = [name for name, node in glb.nodes_with_meshes().items() if "col" not in name and name != "crate"]
wrong = []
if set(still) != {("crate", "ConcavePolygonShape")}:
    wrong.append(f"what stands still: {still}")
for word, found in places.items():
    if len(found) != len(pieces):
        wrong.append(f"{word}: {len(found)} of {len(pieces)} pieces move")
    wrong += [f"{word}: {name} is out of the crate, at {place}" for name, place in found.items() if not is_inside(place)]
overlap, one, other = deepest(glb)
if overlap > OVERLAPPING:
    wrong.append(f"{one} and {other} begin {1000 * overlap:.2f} mm within each other")
if wrong:
    sys.exit("\n".join(wrong) + "\n" + out[-2000:])
print(f"godot: {len(pieces)} pieces stay in the crate; they begin {1000 * overlap:.2f} mm deep")
