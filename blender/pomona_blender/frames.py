"""Pomona's frame and Blender's: both right-handed and in metres, but Pomona's +Y is up, and Blender's +Z."""

from __future__ import annotations

from typing import Any, Sequence

import numpy

# Takes a point of Pomona's frame to Blender's: (x, y, z) to (x, -z, y).
TO_BLENDER = numpy.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])


def points_for_blender(points: Any) -> Any:
    """n x 3 points or normals."""
    turned = numpy.empty((len(points), 3), numpy.float32)
    turned[:, 0], turned[:, 1], turned[:, 2] = points[:, 0], -points[:, 2], points[:, 1]
    return turned


def place_for_blender(place: Any) -> Any:
    """4 x 4 that places a mesh of Pomona, for the same mesh in Blender's frame."""
    return TO_BLENDER @ place @ TO_BLENDER.T


def points_for_pomona(points: Any) -> Any:
    """n x 3 points of Blender's frame."""
    return numpy.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=1)


def for_pomona(vector: Sequence[float]) -> tuple[float, float, float]:
    """A point or a normal of Blender's frame."""
    x, y, z = vector
    return (x, z, -y)
