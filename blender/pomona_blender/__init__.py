"""Grows fruit and vegetables that can be cut anywhere, and fills dishes with them: Pomona in Blender."""

bl_info = {
    "name": "Pomona",
    "author": "The Pomona developers",
    "version": (0, 0, 0),  # make_addon.py writes the program's
    "blender": (3, 4, 0),
    "location": "Add > Mesh > Pomona; Sidebar > Pomona",
    "description": "Fruit and vegetables that can be cut anywhere",
    "category": "Add Mesh",
}

import numpy

if "bool" not in vars(numpy):
    setattr(numpy, "bool", bool)  # what Debian's Blender 3.4 asks of its numpy, which has it no more

from .registration import register, unregister  # noqa: E402

__all__ = ["register", "unregister"]
