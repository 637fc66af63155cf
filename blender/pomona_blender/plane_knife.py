"""An object as the knife: it cuts along its own x and y, endlessly, as the plane that it looks like."""

from __future__ import annotations

from typing import Any

from mathutils import Vector

from .frames import for_pomona

# What a hand cannot mean: places are rounded to a micrometre, so that the same place is the same knife.
DIGITS = 6


def plane_words(root: Any, plane: Any) -> str:
    """plane:NX,NY,NZ,D in the frame of the fruit that hangs below the root."""
    to_world = root.matrix_world
    point = to_world.inverted_safe() @ plane.matrix_world.translation
    normal = plane.matrix_world.to_3x3().inverted_safe().transposed() @ Vector((0, 0, 1))
    within = (to_world.to_3x3().transposed() @ normal).normalized()
    distance = within.dot(point)
    numbers = [*for_pomona(within), distance]
    return "plane:" + ",".join(f"{round(number, DIGITS) + 0.0:.{DIGITS}g}" for number in numbers)
