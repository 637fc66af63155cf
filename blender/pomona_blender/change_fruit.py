"""Operators on fruit that are there."""

from typing import Any

import bpy

from .add_fruit import NeedsPomona
from .keeper import PATIENCE, keeper, redraw, settings_changed
from .serve import renewed_scene
from .settings import root_of
from .workshop import workshop


class OnFruit(NeedsPomona):
    """Operators on the fruit that the active object is, or belongs to."""

    @classmethod
    def poll(cls, context: Any) -> bool:
        return super().poll(context) and root_of(context.object) is not None


def brought_up_to_date(operator: Any, root: Any) -> set[str]:
    """What an operator returns that has changed settings."""
    keeper().make_now(root, None if bpy.app.background else PATIENCE)
    if root.pomona.message:
        operator.report({"WARNING"}, root.pomona.message)
    return {"FINISHED"}


class POMONA_OT_make(OnFruit, bpy.types.Operator):
    """Make it by its settings"""

    bl_idname, bl_label, bl_options = "pomona.make", "Make", {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        root = root_of(context.object)
        if root.pomona.dish is not None:
            root.pomona.what = renewed_scene(root, context)
        return brought_up_to_date(self, root)


class POMONA_OT_another_seed(OnFruit, bpy.types.Operator):
    """The next variant: another fruit of the same kind, cut the same way"""

    bl_idname, bl_label, bl_options = "pomona.another_seed", "Another Seed", {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        root = root_of(context.object)
        root.pomona.options.seed += 1
        root.pomona.options.property_unset("index")
        if root.pomona.dish is not None:
            root.pomona.what = renewed_scene(root, context)
        return brought_up_to_date(self, root)


class POMONA_OT_add_knife(OnFruit, bpy.types.Operator):
    """One knife more: in words, or a plane that cuts where it stands"""

    bl_idname, bl_label, bl_options = "pomona.add_knife", "Add Knife", {"REGISTER", "UNDO"}

    words: bpy.props.StringProperty(default="half", options={"SKIP_SAVE"})
    is_plane: bpy.props.BoolProperty(options={"SKIP_SAVE"})

    def execute(self, context: Any) -> set[str]:
        root = root_of(context.object)
        knife = root.pomona.knives.add()
        knife.is_plane = self.is_plane
        if self.is_plane:
            knife.plane = chosen_plane(context, root) or new_plane(context, root)
        else:
            knife.words = self.words
        root.pomona.active_knife = len(root.pomona.knives) - 1
        return brought_up_to_date(self, root)


def chosen_plane(context: Any, root: Any) -> Any:
    """A selected object that is no piece: with it a person says what is the knife. None if there is none."""
    return next((thing for thing in context.selected_objects if root_of(thing) is None and thing.type == "MESH"), None)


def new_plane(context: Any, root: Any) -> Any:
    """A plane through the middle of the fruit, upright and a little wider than it."""
    corners = [child.matrix_world @ bpy_vector(corner) for child in root.children if child.type == "MESH"
               for corner in child.bound_box]
    low = [min(corner[k] for corner in corners) for k in range(3)] if corners else [-0.05] * 3
    high = [max(corner[k] for corner in corners) for k in range(3)] if corners else [0.05] * 3
    half = 0.7 * max(high[k] - low[k] for k in range(3))
    mesh = bpy.data.meshes.new("knife")
    mesh.from_pydata([(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)], [], [(0, 1, 2, 3)])
    plane = bpy.data.objects.new("knife", mesh)
    context.collection.objects.link(plane)
    plane.location = [(low[k] + high[k]) / 2 for k in range(3)]
    plane.rotation_euler = (1.5707963, 0.0, 0.0)
    plane.display_type, plane.hide_render = "WIRE", True
    context.view_layer.update()
    return plane


def bpy_vector(corner: Any) -> Any:
    from mathutils import Vector

    return Vector(corner)


class POMONA_OT_remove_knife(OnFruit, bpy.types.Operator):
    """Take the chosen knife away"""

    bl_idname, bl_label, bl_options = "pomona.remove_knife", "Remove Knife", {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        root = root_of(context.object)
        fruit = root.pomona
        if not fruit.knives:
            return {"CANCELLED"}
        fruit.knives.remove(min(fruit.active_knife, len(fruit.knives) - 1))
        fruit.active_knife = max(0, fruit.active_knife - 1)
        return brought_up_to_date(self, root)


class POMONA_OT_unset(OnFruit, bpy.types.Operator):
    """Leave this to the template"""

    bl_idname, bl_label, bl_options = "pomona.unset", "Unset", {"UNDO", "INTERNAL"}

    keyword: bpy.props.StringProperty(options={"SKIP_SAVE"})

    def execute(self, context: Any) -> set[str]:
        root_of(context.object).pomona.options.property_unset(self.keyword)
        settings_changed(None, context)
        return {"FINISHED"}


class POMONA_OT_watch(bpy.types.Operator):
    """Show how far work is; Escape stops it"""

    bl_idname, bl_label, bl_options = "pomona.watch", "Pomona at Work", {"INTERNAL"}

    def invoke(self, context: Any, _event: Any) -> set[str]:
        manager = context.window_manager
        manager.pomona_is_watched = True
        self._timer = manager.event_timer_add(0.1, window=context.window)
        manager.progress_begin(0, 100)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        if event.type == "ESC" and event.value == "PRESS":
            workshop().stop_all()
            return {"RUNNING_MODAL"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if not keeper().is_busy:
            return self._ended(context)
        for name, job in workshop().jobs.items():
            context.window_manager.progress_update(100 * job.share)
            context.workspace.status_text_set(f"Pomona: {name}, {job.stage} {100 * job.share:.0f} %.  Esc stops it.")
        return {"PASS_THROUGH"}

    def _ended(self, context: Any) -> set[str]:
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        manager.progress_end()
        manager.pomona_is_watched = False
        context.workspace.status_text_set(None)
        redraw()
        return {"FINISHED"}
