"""The largest flat face of a piece, by which it is laid down. Which triangles a knife made a .glb does not say; but no
skin is flat over a wide area."""

from __future__ import annotations

from typing import Any, Optional

import numpy

# Triangles lie in one plane whose normals agree to this, and whose distances from the middle to a share of its reach.
SAME_NORMAL, SAME_DISTANCE = 0.01, 0.004
# A face that has less of the surface than this is no cut.
LEAST_SHARE = 0.03


def largest_flat_face(positions: Any, triangles: Any) -> Optional[Any]:
    """Its outward normal, of unit length; None if nothing wide is flat.

    positions  n x 3; triangles  m x 3, counter-clockwise from outside
    """
    first, second, third = (positions[triangles[:, corner]].astype(numpy.float64) for corner in range(3))
    across = numpy.cross(second - first, third - first)
    doubled = numpy.linalg.norm(across, axis=1)
    real = doubled > 0
    if not real.any():
        return None
    across, doubled, first = across[real], doubled[real], first[real]
    normals = across / doubled[:, None]
    reach = numpy.abs(positions).max()
    distances = (normals * first).sum(axis=1) / (SAME_DISTANCE * reach)
    cells = numpy.column_stack([numpy.round(normals / SAME_NORMAL), numpy.round(distances)])
    _, plane = numpy.unique(cells.astype(numpy.int64), axis=0, return_inverse=True)
    areas = numpy.bincount(plane.ravel(), weights=doubled)
    widest = int(areas.argmax())
    if areas[widest] < LEAST_SHARE * doubled.sum():
        return None
    mean: Any = across[plane.ravel() == widest].sum(axis=0)
    return mean / numpy.linalg.norm(mean)


def turn_face_up(normal: Any) -> Any:
    """3 x 3: takes this unit normal to +Z, and what was up as near to +Y as it goes, so that halves look one way."""
    upright = numpy.array([0.0, 0, 1]) - normal[2] * normal
    if numpy.linalg.norm(upright) < 0.05:  # a level face
        upright = numpy.array([0.0, 1, 0]) - normal[1] * normal
    upright /= numpy.linalg.norm(upright)
    turn: Any = numpy.stack([numpy.cross(upright, normal), upright, normal])
    return turn
