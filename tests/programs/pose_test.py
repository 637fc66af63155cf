#!/usr/bin/env python3
"""Every mesh of a .glb, placed by the annotations, by the layout and by its node, lies at one place.

    pose_test.py PROGRAM SCENE.toml FOLDER
"""

import json
import pathlib
import shutil
import struct
import subprocess
import sys

from glb import Glb

PROGRAM, SCENE, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
subprocess.run([PROGRAM, "scene", SCENE, "--detail", "0.4", "--quality", "draft", "--quiet", "--aov", FOLDER / "truth", "-o", FOLDER / "s.png",
                "-o", FOLDER / "s.glb", "-o", FOLDER / "s.json"], check=True)


def turned(wxyz, p):
    """The point turned by a unit quaternion."""
    w, x, y, z = wxyz
    t = [2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])]
    return [p[0] + w * t[0] + y * t[2] - z * t[1], p[1] + w * t[1] + z * t[0] - x * t[2], p[2] + w * t[2] + x * t[1] - y * t[0]]


def placed(pose, p):
    """rotation * p + translation, as annotations and layouts have them: w first."""
    return [a + b for a, b in zip(turned(pose["rotation"], p), pose["translation"])]


glb = Glb(FOLDER / "s.glb")
truth = json.loads((FOLDER / "truth" / "annotations.json").read_text())
layout = {place["name"]: place for key, places in json.loads((FOLDER / "s.json").read_text()).items() if isinstance(places, list) for place in places}
nodes, seen, largest = glb.nodes_with_meshes(), 0, 0.0
for annotation in truth["annotations"] + truth["hidden"]:
    node = nodes[annotation["name"]]
    mesh = glb.json["meshes"][node["mesh"]]
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    own = {"rotation": [w, x, y, z], "translation": node.get("translation", [0, 0, 0])}
    accessor = glb.json["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]]
    view = glb.json["bufferViews"][accessor["bufferView"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    for i in range(0, accessor["count"], max(1, accessor["count"] // 50)):
        p = struct.unpack_from("<3f", glb.buffer, start + i * view.get("byteStride", 12))
        in_fruit = [a + b for a, b in zip(p, mesh["extras"]["center"])]
        places = [placed(own, p), placed(annotation, in_fruit), placed(layout[annotation["name"]], in_fruit)]
        # The mesh about its centre of mass, as poses of six degrees of freedom are told elsewhere.
        places.append([a + b for a, b in zip(turned(annotation["rotation"], p), annotation["center_of_mass"])])
        largest = max([largest] + [abs(a - b) for other in places[1:] for a, b in zip(places[0], other)])
    seen += 1
if seen != len(layout) or largest > 2e-7:
    sys.exit(f"{seen} of {len(layout)} pieces; up to {largest} m apart")
print(f"{seen} pieces, within {largest:.1e} m")
