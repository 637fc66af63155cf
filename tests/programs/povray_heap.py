#!/usr/bin/env python3
"""POV-Ray reads ten thousand pieces of few meshes in less than 4 GB: each instance costs it as many textures as the mesh
has.

    povray_heap.py PROGRAM FOLDER
"""

import json
import pathlib
import re
import resource
import subprocess
import sys

PROGRAM, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
VARIANTS, PIECES, COPIES = 5, 4, 500
MOST_BYTES = 4_000_000_000

SCENE = f"""format = 1
name = "heap"
paper = "#ffffff"
layout = "layout.json"
[[pieces]]
name = "wedges"
template = "tomato"
count = {VARIANTS}
knives = ["wedges:6"]
take = {PIECES}
copies = {COPIES}
"""

# Rows on the table: nothing has to fall for this.
FOLDER.mkdir(parents=True, exist_ok=True)
instances = []
for variant in range(1, VARIANTS + 1):
    for piece in range(1, PIECES + 1):
        solid = f"wedges-{variant}.piece-{piece}"
        for copy in range(1, COPIES + 1):
            number = len(instances)
            instances.append({"name": solid + (f".copy-{copy}" if copy > 1 else ""), "solid": solid, "rotation": [1, 0, 0, 0],
                              "translation": [0.08 * (number % 100), 0, 0.08 * (number // 100)]})
(FOLDER / "layout.json").write_text(json.dumps({"format": 1, "instances": instances}))
(FOLDER / "heap.toml").write_text(SCENE)
subprocess.run([PROGRAM, "scene", "heap.toml", "--detail", "0.3", "--quality", "draft", "--style", "plain", "--quiet",
                "-o", "heap.pov", "-o", "heap.glb"], cwd=FOLDER, check=True)

scene, meshes = (FOLDER / "heap.pov").read_text(), (FOLDER / "heap_meshes.inc").read_text()
placed, told = len(re.findall(r"^object \{ Mesh_", scene, re.M)), meshes.count("#declare Mesh_")
if placed != len(instances) or told != VARIANTS * PIECES:
    sys.exit(f"{placed} objects of {told} meshes")
glb = (FOLDER / "heap.glb").stat().st_size
if glb > 15_000_000:
    sys.exit(f"heap.glb has {glb} bytes: are its meshes shared?")

result = subprocess.run(["povray", "heap.pov", "+W64", "+H48", "-D", "-GA"], cwd=FOLDER, capture_output=True, text=True,
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (MOST_BYTES, MOST_BYTES)))
peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
if result.returncode != 0 or peak > MOST_BYTES:
    sys.exit(f"povray: {result.returncode}, {peak} bytes\n{result.stderr[-2000:]}")
warnings = [line for line in result.stderr.splitlines() if "Warning" in line]
if warnings:
    sys.exit("\n".join(warnings))
print(f"{placed} objects of {told} meshes: {peak / 1e6:.0f} MB of POV-Ray; heap.glb {glb / 1e6:.1f} MB")
