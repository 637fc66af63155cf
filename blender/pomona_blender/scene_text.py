"""Scene files for Pomona from what stands in Blender: a dish or a ground, and what shall lie in or on it. Pomona's
scenes do the settling: docs/reference/formats.md."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Sequence

from .build_objects import DISH


@dataclass(frozen=True)
class Serving:
    """Fruit of one kind. count: of fruit, each cut by the knives; pieces: of each, the largest; 0 = all."""

    template: str
    knives: tuple[str, ...] = ()
    count: int = 4
    pieces: int = 0
    size: float = 1.0
    face_up: bool = False


# How servings lie: words of a scene file.
WAYS = {"FILL": f'in = "{DISH}"', "HEAP": f'on = "{DISH}"',
        "STREW": f'on = "{DISH}"\nwhere = {{ kind = "scatter" }}'}


def scene_text(servings: Sequence[Serving], way: str, seed: int, mesh_file: str) -> str:
    """The file. way: FILL the hollow, HEAP on the upper side, or STREW evenly over it, upright."""
    said = [f'format = 1\nname = "blender"\nseed = {seed}\nground = false\n',
            f'[[dishes]]\nname = "{DISH}"\nmesh = {json.dumps(mesh_file)}\nunit = "1m"\n']
    for number, serving in enumerate(servings, 1):
        said.append(serving_text(number, serving, way))
    return "\n".join(said)


def serving_text(number: int, serving: Serving, way: str) -> str:
    lines = ["[[pieces]]", f'name = "serving-{number}"', f"template = {json.dumps(serving.template)}",
             f"count = {serving.count}", f"size = {serving.size:.6g}"]
    if serving.knives:
        lines += [f"knives = {json.dumps(list(serving.knives))}", f"take = {serving.pieces}"]
    if serving.face_up:
        lines.append("face_up = true")
    return "\n".join([*lines, WAYS[way], ""])


def obj_text(points: Any, triangles: Any, name: str) -> str:
    """Wavefront OBJ: points in metres, +Y up, n x 3; triangles count from 0, m x 3."""
    lines = [f"o {name}", *(f"v {x:.7g} {y:.7g} {z:.7g}" for x, y, z in points.tolist()),
             *(f"f {a} {b} {c}" for a, b, c in (triangles + 1).tolist())]
    return "\n".join(lines) + "\n"
