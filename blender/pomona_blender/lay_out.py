"""Pieces laid down with their faces up, side by side. All in Blender's frame, metres."""

from __future__ import annotations

from typing import Any, Sequence

import numpy

from .flat_faces import largest_flat_face, turn_face_up
from .frames import points_for_blender
from .glb_file import Mesh

# Of the widest piece: how far pieces lie apart.
GAP = 0.12


def laid_face_up(meshes: Sequence[Mesh]) -> list[Any]:
    """4 x 4 for each: its largest flat face looks up, its lowest point is at z = 0. The first piece is on the left;
    more than six make rows."""
    turned = [turned_up(mesh) for mesh in meshes]
    if not turned:
        return []
    widths = numpy.array([high[:2] - low[:2] for _, low, high in turned])
    columns = len(turned) if len(turned) <= 6 else int(numpy.ceil(numpy.sqrt(1.5 * len(turned))))
    gap = GAP * widths.max()
    places = []
    y = 0.0
    for start in range(0, len(turned), columns):
        row = range(start, min(start + columns, len(turned)))
        length = sum(widths[n, 0] for n in row) + gap * (len(row) - 1)
        x = -length / 2
        for n in row:
            turn, low, high = turned[n]
            place = numpy.eye(4)
            place[:3, :3] = turn
            place[:3, 3] = [x - low[0], y - (low[1] + high[1]) / 2, -low[2]]
            places.append(place)
            x += widths[n, 0] + gap
        y -= max(widths[n, 1] for n in row) + gap
    return places


def turned_up(mesh: Mesh) -> tuple[Any, Any, Any]:
    """3 x 3 that turns its face up, and the corners of its box then."""
    points = points_for_blender(mesh.positions)
    normal = largest_flat_face(points, mesh.triangles)
    turn = numpy.eye(3) if normal is None else turn_face_up(normal)
    turned = points @ turn.T
    return turn, turned.min(axis=0), turned.max(axis=0)
