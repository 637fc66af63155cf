#!/usr/bin/env python3
"""Godot imports a scene written for it: every piece is there, with a convex shape to collide with and nothing else.

    godot_test.py FILE.glb FOLDER
"""

import pathlib
import re
import shutil
import subprocess
import sys
import time

from glb import Glb

FILE, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
shutil.copy(FILE, FOLDER / "scene.glb")
shutil.copy(pathlib.Path(__file__).with_name("godot_check.gd"), FOLDER)
(FOLDER / "project.godot").write_text('config_version=4\n[application]\nconfig/name="pomona"\n')

# Godot 3's server imports what is in the folder, and then never ends: so it is ended when the scene is there.
with open(FOLDER / "import.log", "w") as log:
    editor = subprocess.Popen(["godot3-server", "--editor", "--quit", "--path", FOLDER], stdout=log, stderr=log)
    ends = time.monotonic() + 120
    while not list((FOLDER / ".import").glob("scene.glb-*.md5")) and time.monotonic() < ends and editor.poll() is None:
        time.sleep(0.1)
    time.sleep(0.5)
    editor.kill()
    editor.wait()
result = subprocess.run(["godot3-server", "--path", FOLDER, "-s", "godot_check.gd"], capture_output=True, text=True, timeout=60)
nodes = re.findall(r"^NODE (\w+) (.*)$", result.stdout, re.M)
shapes = re.findall(r"^SHAPE (\w+) (\d+)$", result.stdout, re.M)

glb = Glb(FILE)
pieces = [name for name in glb.nodes_with_meshes() if not name.endswith("-convcolonly")]
seen = [path.split("/")[-1] for kind, path in nodes if kind == "MeshInstance"]
wrong = []
if sorted(seen) != sorted(pieces):
    wrong.append(f"meshes {sorted(seen)} in place of {sorted(pieces)}")
if len(shapes) != len(pieces) or any(kind != "ConvexPolygonShape" or not 4 <= int(points) <= 64 for kind, points in shapes):
    wrong.append(f"shapes {shapes} for {len(pieces)} pieces")
if wrong:
    sys.exit("\n".join(wrong) + "\n" + result.stdout[-2000:] + (FOLDER / "import.log").read_text()[-2000:])
print(f"godot: {len(pieces)} pieces, {len(shapes)} convex shapes")
