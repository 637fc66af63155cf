#!/usr/bin/env python3
"""Unreal's importer binds shapes to meshes by their names (UCX_MESH_00): each piece of a scene, and each dish, has its
own there, and they begin outside each other. Copies share the arrays that are drawn.

    unreal_shapes_test.py FILE.glb
"""

import re
import sys

from glb import Glb
from glb_shapes import deepest, shape

OVERLAPPING = 1e-4  # metres by which shapes overlap at the start

glb = Glb(sys.argv[1])
meshes = glb.json["meshes"]
wrong = []

names = [mesh["name"] for mesh in meshes]
wrong += [f"two meshes are called {name}" for name in set(names) if names.count(name) > 1]
drawn = [mesh for mesh in meshes if not mesh["name"].startswith("UCX_")]

# What the importer knows: of each mesh the shapes that are named after it, in its frame; and where the mesh stands.
shapes_of = {mesh["name"]: [] for mesh in drawn}
for number, mesh in enumerate(meshes):
    if not mesh["name"].startswith("UCX_"):
        continue
    body = re.fullmatch(r"UCX_(.*)_\d+", mesh["name"])
    if body is None or body[1] not in shapes_of:
        wrong.append(f"{mesh['name']} is of no mesh")
    else:
        shapes_of[body[1]].append({"mesh": number})
nodes = {name: node for name, node in glb.nodes_with_meshes().items() if not name.startswith("UCX_")}
placed = {name: [shape(glb, node, hull) for hull in shapes_of[names[node["mesh"]]]] for name, node in nodes.items()}
wrong += [f"{name} has no shape" for name, shapes in placed.items() if not shapes]
overlap, one, other = deepest(placed)
if overlap > OVERLAPPING:
    wrong.append(f"{one} and {other} begin {1000 * overlap:.2f} mm within each other")

# Each mesh takes its place on the screen from arrays of the file: of a piece and its copies these are the same.
arrays = {str(mesh["primitives"]) for mesh in drawn}
solids = {re.sub(r"_copy-\d+", "", name) for name in nodes}
if len(arrays) != len(solids):
    wrong.append(f"{len(solids)} solids have {len(arrays)} arrays")
if wrong:
    sys.exit("\n".join(wrong))
print(f"unreal: {len(nodes)} things, {len(drawn)} meshes of {len(arrays)} solids; they begin {1000 * overlap:.2f} mm deep")
