"""Templates of one's own: opened, made of a mesh, drawn in the studio."""

import os
import re
import subprocess
import threading
from pathlib import Path
from typing import Any, Optional

import bpy
from bpy_extras.io_utils import ExportHelper, ImportHelper

from .add_fruit import NeedsPomona, made, new_root, set_knives, short_name
from .doors import INSTALL, ProgramDoor, find_program
from .frames import for_pomona
from .scene_text import obj_text
from .serve import evaluated
from .settings import root_of
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
    inwards = [(0.0, 0.0, 0.0)] * len(points)
    for a, b, c in triangles:
        across = (points[b] - points[a]).cross(points[c] - points[a])
        for corner in (a, b, c):
            inwards[corner] = tuple(inwards[corner][k] - across[k] for k in range(3))
    # Whichever way the mesh faces: Pomona turns its skin, too.
    turned = -1 if sum(points[a].dot(points[b].cross(points[c])) for a, b, c in triangles) < 0 else 1
    inner = []
    for point, way in zip(points, inwards):
        length = max(sum(part * part for part in way) ** 0.5, 1e-20)
        inner.append([point[k] + turned * depth * way[k] / length for k in range(3)])
    count = len(points)
    later = [tuple(corner + count for corner in triangle) for triangle in triangles]
    skin = obj_text([for_pomona(point) for point in points], triangles, "skin")
    inside = obj_text([for_pomona(point) for point in inner], later, "inside")
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
        fruit = root_of(context.object).pomona
        folder = Path(bpy.path.abspath("//") or bpy.app.tempdir)
        address = open_studio(program, fruit.what, folder)
        if address is None:
            self.report({"ERROR"}, "The studio did not start")
            return {"CANCELLED"}
        if not fruit.what.endswith(".toml"):
            fruit.what = os.fspath(folder / f"{fruit.what}.toml")  # the studio's own copy
        if not bpy.app.background:
            bpy.ops.wm.url_open(url=address)
        self.report({"INFO"}, address)
        return {"FINISHED"}


def studio_program() -> Optional[str]:
    """The studio is in the program alone."""
    door = workshop().door
    return door.program if isinstance(door, ProgramDoor) else find_program()


def open_studio(program: str, template: str, folder: Path) -> Optional[str]:
    """Its address; None if it does not tell one. It ends with Blender."""
    child = subprocess.Popen([program, "studio", template], cwd=folder, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    told: list[str] = []
    heard = threading.Event()

    def listen() -> None:
        assert child.stdout is not None
        for line in child.stdout:
            if found := re.search(r"http://\S+", line):
                told.append(found.group(0))
                heard.set()
        heard.set()

    threading.Thread(target=listen, daemon=True).start()
    heard.wait(5)
    if told:
        started_studios().append(child)
        return told[0]
    child.terminate()
    return None


_studios: list[subprocess.Popen[str]] = []


def started_studios() -> list[subprocess.Popen[str]]:
    """Those that are ended with the add-on."""
    return _studios


def end_studios() -> None:
    while _studios:
        child = _studios.pop()
        child.terminate()
        child.wait(5)
