"""Templates of one's own: opened, made of a mesh, drawn in the studio."""

import functools
import os
from pathlib import Path
from typing import Any, Optional

import bpy
import numpy
from bpy_extras.io_utils import ExportHelper, ImportHelper

from .add_fruit import NeedsPomona, made, new_root, set_knives, short_name
from .doors import INSTALL, ProgramDoor, find_program
from .frames import points_for_pomona
from .scene_text import obj_text
from .serve import evaluated
from .settings import root_of
from .studio import Studio, open_studio
from .template_text import hex_color, template_name, template_text
from .workshop import workshop


class POMONA_OT_open_template(NeedsPomona, bpy.types.Operator, ImportHelper):
    """Grow a template of your own"""

    bl_idname, bl_label, bl_options = "pomona.open_template", "Template File", {"REGISTER", "UNDO"}

    filename_ext = ".toml"
    filter_glob: bpy.props.StringProperty(default="*.toml", options={"HIDDEN"})

    def execute(self, context: Any) -> set[str]:
        return made(self, new_root(context, short_name(self.filepath), "cut", self.filepath))


class POMONA_OT_from_mesh(NeedsPomona, bpy.types.Operator, ExportHelper):
    """Write a template of the active mesh: a skin, and flesh of one colour within. Then it can be cut"""

    bl_idname, bl_label, bl_options = "pomona.from_mesh", "Make Mesh Cuttable", {"REGISTER", "UNDO"}

    filename_ext = ".toml"
    filter_glob: bpy.props.StringProperty(default="*.toml", options={"HIDDEN"})
    knives: bpy.props.StringProperty(name="Knives", default="half")
    depth: bpy.props.FloatProperty(name="Rim", description="How deep its colour passes into the inner one",
                                   default=0.006, min=0.0, soft_max=0.1, unit="LENGTH", precision=4)
    grain: bpy.props.FloatProperty(name="Grain", description="How far colours stray", default=0.03, min=0.0,
                                   max=0.2)
    outside: bpy.props.FloatVectorProperty(name="Outside", subtype="COLOR", size=3, min=0, max=1,
                                           default=(0.35, 0.16, 0.06))
    rim: bpy.props.FloatVectorProperty(name="Rim Colour", subtype="COLOR", size=3, min=0, max=1,
                                       default=(0.55, 0.33, 0.15))
    inside: bpy.props.FloatVectorProperty(name="Inside", subtype="COLOR", size=3, min=0, max=1,
                                          default=(0.85, 0.74, 0.53))

    @classmethod
    def poll(cls, context: Any) -> bool:
        return super().poll(context) and context.object is not None and context.object.type == "MESH"

    def execute(self, context: Any) -> set[str]:
        thing, path = context.object, Path(self.filepath)
        name = template_name(thing.name)
        write_mesh(thing, path.with_name(f"{name}.obj"), self.depth, context)
        colors = [hex_color(color) for color in (self.outside, self.rim, self.inside)]
        text = template_text(thing.name, f"{name}.obj", colors, max(thing.dimensions), self.grain)
        path.write_text(text, encoding="utf-8")
        root = new_root(context, name, "cut", os.fspath(path))
        root.location = (0, 0, 0)  # the mesh's points are the world's
        set_knives(root.pomona, self.knives.split())
        result = made(self, root)
        if "FINISHED" in result:
            thing.hide_set(True)
            thing.hide_render = True
        return result


def write_mesh(thing: Any, path: Path, depth: float, context: Any) -> None:
    """Its skin, and the same moved inwards by a depth, metres: the second only gives colour."""
    points, triangles = evaluated(thing, context)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    across = numpy.cross(b - a, c - a)
    outwards = numpy.stack([numpy.bincount(triangles.ravel(), numpy.repeat(across[:, k], 3), len(points))
                            for k in range(3)], axis=1)
    # Whichever way the mesh faces: Pomona turns its skin, too.
    turned = -1 if (a * numpy.cross(b, c)).sum() < 0 else 1
    inner = points - turned * depth * outwards / numpy.maximum(numpy.linalg.norm(outwards, axis=1), 1e-20)[:, None]
    skin = obj_text(points_for_pomona(points), triangles, "skin")
    inside = obj_text(points_for_pomona(inner), triangles + len(points), "inside")
    path.write_text(skin + inside, encoding="utf-8")


class POMONA_OT_studio(bpy.types.Operator):
    """Draw the fruit's template in the browser; what is saved there is grown here"""

    bl_idname, bl_label = "pomona.studio", "Open Studio"

    @classmethod
    def poll(cls, context: Any) -> bool:
        root = root_of(context.object)
        return root is not None and bool(root.pomona.what) and root.pomona.verb == "cut"

    def execute(self, context: Any) -> set[str]:
        program = studio_program()
        if program is None:
            self.report({"ERROR"}, INSTALL)
            return {"CANCELLED"}
        root = root_of(context.object)
        folder = Path(bpy.path.abspath("//") or bpy.app.tempdir)
        studio = open_studio(program, root.pomona.what, folder, shows=not bpy.app.background)
        if not root.pomona.what.endswith(".toml"):
            root.pomona.copy = os.fspath(folder / f"{root.pomona.what}.toml")  # there once it is saved
        if bpy.app.background:
            studio.wait()
            return told(self, studio)
        bpy.app.timers.register(functools.partial(told_later, root.name, studio), first_interval=0.1)
        return {"FINISHED"}


NOT_STARTED = "The studio did not start: "


def told(operator: Any, studio: Studio) -> set[str]:
    """What the operator returns once the studio is there, or is not."""
    if studio.address is None:
        operator.report({"ERROR"}, NOT_STARTED + studio.last_words)
        return {"CANCELLED"}
    operator.report({"INFO"}, studio.address)
    return {"FINISHED"}


def told_later(root_name: str, studio: Studio) -> Optional[float]:
    """Blender's timer: says what went wrong, where the fruit's messages stand."""
    if not studio.is_told:
        return 0.1
    root = bpy.data.objects.get(root_name)
    if studio.address is None and root is not None:
        root.pomona.message = NOT_STARTED + studio.last_words
    return None


def studio_program() -> Optional[str]:
    """The studio is in the program alone."""
    door = workshop().door
    return door.program if isinstance(door, ProgramDoor) else find_program()
