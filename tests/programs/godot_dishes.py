#!/usr/bin/env python3
"""Godot lets the pieces of scenes with dishes move for two seconds: each dish stands there once, and no piece leaves.

    godot_dishes.py PROGRAM FOLDER SCENE.toml[:SEED]...

Takes minutes for a scene.
"""

import math
import pathlib
import re
import subprocess
import sys

from glb import Glb
from godot import imported, places, printed

FARTHEST = 0.15  # metres that a piece may move
PATIENCE = 900   # seconds for the simulation of a scene


def verdict(program, folder, scene, seed):
    """What is wrong, and a line that tells what was seen."""
    file = folder / "scene.glb"
    words = ["--detail", "0.4", "--quality", "draft", "--style", "plain", "--engine", "godot", "--quiet"]
    subprocess.run([program, "scene", scene, *(["--seed", seed] if seed else []), *words, "-o", file], check=True)
    imported(file, folder / "project")
    out = printed(folder / "project", "godot_crate.gd", PATIENCE)
    still = re.findall(r"^STILL (\S+) (\w+)$", out, re.M)
    begin, end = places(out, "BEGIN"), places(out, "END")

    meshes = Glb(file).nodes_with_meshes()
    dishes = {name.removesuffix("-colonly") for name in meshes if name.endswith("-colonly")}
    pieces = {name for name in meshes if "colonly" not in name} - dishes
    wrong = []
    if sorted(still) != sorted((dish, "ConcavePolygonShape") for dish in dishes):
        wrong.append(f"what stands still: {still}")
    if set(end) != pieces:
        return [*wrong, f"{len(end)} of {len(pieces)} pieces move: {out[-1000:]}"], ""
    moved = sorted((math.dist(begin[name], end[name]), name) for name in end)
    wrong += [f"{name} moves {1000 * way:.0f} mm" for way, name in moved if way > FARTHEST]
    half, (most, farthest) = moved[len(moved) // 2][0], moved[-1]
    return wrong, f"{len(pieces)} pieces move {1000 * half:.1f} mm, {farthest} {1000 * most:.1f} mm"


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    failed = False
    for asked in sys.argv[3:]:
        scene, _, seed = asked.partition(":")
        wrong, seen = verdict(program, folder, scene, seed)
        print(f"{asked}: {'; '.join([seen, *wrong])}", flush=True)
        failed |= bool(wrong)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
