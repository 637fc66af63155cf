"""Dishes filled and meshes strewn over: a scene file is written, and Pomona settles it."""

import hashlib
import os
from pathlib import Path
from typing import Any

import bpy
import numpy

from .add_fruit import NeedsPomona, made, new_root
from .frames import points_for_pomona
from .orders import spelled
from .scene_text import Serving, obj_text, scene_text


class POMONA_OT_serve(NeedsPomona, bpy.types.Operator):
    """Fill the active mesh, or strew over it, with what is listed in the sidebar; Pomona lets it settle"""

    bl_idname, bl_label, bl_options = "pomona.serve", "Fill or Strew", {"REGISTER", "UNDO"}

    way: bpy.props.EnumProperty(name="Way", items=[
        ("FILL", "Fill", "Into its hollow"), ("HEAP", "Heap", "Dropped onto it"),
        ("STREW", "Strew", "Evenly over its upper side, upright")], options={"SKIP_SAVE"})
    seed: bpy.props.IntProperty(name="Seed", min=0, options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context: Any) -> bool:
        return super().poll(context) and context.object is not None and context.object.type == "MESH"

    def execute(self, context: Any) -> set[str]:
        dish = context.object
        if not context.scene.pomona_servings:
            self.report({"ERROR"}, "The list of what to serve is empty: add to it in the sidebar, tab Pomona")
            return {"CANCELLED"}
        root = new_root(context, f"{dish.name} served", "scene", "served")
        root.pomona.dish, root.pomona.way, root.pomona.options.seed = dish, self.way, self.seed
        root.pomona.options.quality = "draft"
        for row in context.scene.pomona_servings:
            kept = root.pomona.servings.add()
            for name in ("template", "knives", "count", "pieces", "size", "face_up"):
                setattr(kept, name, getattr(row, name))
        root.pomona.what = renewed_scene(root, context)
        return made(self, root)


class POMONA_OT_add_serving(bpy.types.Operator):
    """One kind of fruit more to serve"""

    bl_idname, bl_label, bl_options = "pomona.add_serving", "Add Serving", {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        context.scene.pomona_servings.add()
        context.scene.pomona_serving = len(context.scene.pomona_servings) - 1
        return {"FINISHED"}


class POMONA_OT_remove_serving(bpy.types.Operator):
    """Serve this kind no more"""

    bl_idname, bl_label, bl_options = "pomona.remove_serving", "Remove Serving", {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        rows = context.scene.pomona_servings
        if not rows:
            return {"CANCELLED"}
        rows.remove(min(context.scene.pomona_serving, len(rows) - 1))
        context.scene.pomona_serving = max(0, context.scene.pomona_serving - 1)
        return {"FINISHED"}


def servings_of(rows: Any) -> list[Serving]:
    return [Serving(row.template, tuple(row.knives.split()), row.count, row.pieces,
                    float(spelled(row.size)), row.face_up) for row in rows]


def renewed_scene(root: Any, context: Any) -> str:
    """Writes the scene of a root with a dish, as the dish stands now, and puts the root below it. The file's path; the
    same scene has the same path."""
    dish, fruit = root.pomona.dish, root.pomona
    points, triangles = evaluated(dish, context)
    if fruit.way != "FILL":
        points, triangles = closed_below(points, triangles)
    foot = (dish.matrix_world.translation.x, dish.matrix_world.translation.y, float(points[:, 2].min()))
    root.location = foot
    context.view_layer.update()
    mesh = obj_text(points_for_pomona(points - foot), triangles, "dish")
    text = scene_text(servings_of(fruit.servings), fruit.way, fruit.options.seed, "dish.obj")
    key = hashlib.sha256((mesh + text).encode()).hexdigest()[:16]
    folder = Path(bpy.app.tempdir, f"pomona-{key}")
    os.makedirs(folder, exist_ok=True)
    written(folder / "dish.obj", mesh)
    return os.fspath(written(folder / "scene.toml", text))


def closed_below(points: Any, triangles: Any) -> tuple[Any, Any]:
    """A sheet that is open, as a hill of one side, with a bottom and walls: else what lies on it could be pressed
    through. What is closed stays as it is."""
    count = len(points)
    a, b = triangles.ravel(), numpy.roll(triangles, -1, axis=1).ravel()
    is_rim = ~numpy.isin(a * count + b, b * count + a)
    if not is_rim.any():
        return points, triangles
    a, b = a[is_rim], b[is_rim]
    bottom = points.copy()
    bottom[:, 2] = points[:, 2].min() - 0.05
    walls = numpy.concatenate([numpy.stack([b, a, a + count], 1), numpy.stack([b, a + count, b + count], 1)])
    return numpy.concatenate([points, bottom]), numpy.concatenate([triangles, triangles[:, ::-1] + count, walls])


def written(path: Path, text: str) -> Path:
    """Leaves a file that says so already as it is, and so its stamp."""
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")
    return path


def evaluated(thing: Any, context: Any) -> tuple[Any, Any]:
    """Of an object with its modifiers: points in the world, n x 3, and triangles, m x 3."""
    whole = thing.evaluated_get(context.evaluated_depsgraph_get())
    mesh = whole.to_mesh()
    mesh.calc_loop_triangles()
    points, triangles = numpy.empty(3 * len(mesh.vertices)), numpy.empty(3 * len(mesh.loop_triangles), numpy.int64)
    mesh.vertices.foreach_get("co", points)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    whole.to_mesh_clear()
    place = numpy.array(thing.matrix_world)
    return points.reshape(-1, 3) @ place[:3, :3].T + place[:3, 3], triangles.reshape(-1, 3)
