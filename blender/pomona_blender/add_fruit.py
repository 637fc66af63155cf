"""Operators that put fruit and scenes into Blender's scene."""

import os
from typing import Any, Optional

import bpy

from .doors import INSTALL
from .keeper import PATIENCE, keeper
from .orders import Order, order_from_command
from .settings import option_properties, said_options, set_options, suggested_knives
from .workshop import workshop


def new_root(context: Any, name: str, verb: str, what: str) -> Any:
    """An empty at the 3D cursor, active and alone selected, that pieces will hang below."""
    root = bpy.data.objects.new(name, None)
    root.empty_display_size, root.empty_display_type = 0.04, "SPHERE"
    root.location = context.scene.cursor.location
    context.collection.objects.link(root)
    root.pomona.verb, root.pomona.what = verb, what
    for thing in context.selected_objects:
        thing.select_set(False)
    root.select_set(True)
    context.view_layer.objects.active = root
    context.view_layer.update()
    return root


def set_knives(fruit: Any, words: list[str] | tuple[str, ...]) -> None:
    fruit.knives.clear()
    for word in words:
        fruit.knives.add().words = word


def made(operator: Any, root: Any) -> set[str]:
    """What an operator returns that has made a root: at once where it goes, and else the window goes on. In the
    background it waits."""
    keeper().make_now(root, None if bpy.app.background else PATIENCE)
    if root.pomona.message and not root.pomona.made:
        operator.report({"ERROR"}, root.pomona.message)
        bpy.data.objects.remove(root)
        return {"CANCELLED"}
    return {"FINISHED"}


class NeedsPomona:
    """Operators that are greyed out where Pomona is not installed."""

    @classmethod
    def poll(cls, context: Any) -> bool:
        if workshop().door is None:
            cls.poll_message_set(INSTALL)
            return False
        return bool(context.mode == "OBJECT")


def short_name(what: str) -> str:
    """Of a template's name or path."""
    return os.path.basename(what).removesuffix(".toml")


class AddFruit(NeedsPomona):
    """Grow a fruit and cut it. Everything can be changed later in the sidebar, tab Pomona"""

    bl_idname, bl_label, bl_options = "pomona.add", "Fruit", {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        root = new_root(context, short_name(self.template), "cut", self.template)
        set_knives(root.pomona, self.knives.split())
        root.pomona.face_up = self.face_up
        try:
            set_options(root.pomona.options, said_options(self.properties, workshop().asked),
                        workshop().asked)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return made(self, root)

    def draw(self, _context: Any) -> None:
        layout = self.layout
        layout.use_property_split = True
        for name in ("template", "knives", "face_up"):
            layout.prop(self, name)
        for option in workshop().asked:
            row = layout.row()
            row.active = self.properties.is_property_set(option.keyword)
            row.prop(self, option.keyword)


def suggested_templates(_operator: Any, _context: Any, typed: str) -> list[str]:
    return [one.name for one in workshop().templates if typed.lower() in (one.name + one.title).lower()]


def fruit_operator() -> Any:
    """The operator with the table's options as its properties."""
    own = {"template": bpy.props.StringProperty(name="Template", default="tomato", search=suggested_templates,
                                                description="A fruit by name, or the path of a template",
                                                options={"SKIP_SAVE"}),
           "knives": bpy.props.StringProperty(name="Knives", search=suggested_knives, options={"SKIP_SAVE"},
                                              search_options={"SUGGESTION"},
                                              description="One after another, with blanks between: half wedges:6"),
           "face_up": bpy.props.BoolProperty(name="Face up", options={"SKIP_SAVE"},
                                             description="Lay the pieces side by side, cut faces up")}
    return type("POMONA_OT_add", (AddFruit, bpy.types.Operator),
                {"__annotations__": {**own, **option_properties(workshop().asked, None)}, "__doc__": AddFruit.__doc__})


class POMONA_OT_add_scene(NeedsPomona, bpy.types.Operator):
    """Compose one of Pomona's scenes: many fruits, cut and settled"""

    bl_idname, bl_label, bl_options = "pomona.add_scene", "Scene", {"REGISTER", "UNDO"}

    scene: bpy.props.StringProperty(name="Scene", default="salad", options={"SKIP_SAVE"})
    seed: bpy.props.IntProperty(name="Seed", min=0, options={"SKIP_SAVE"})

    def execute(self, context: Any) -> set[str]:
        root = new_root(context, short_name(self.scene), "scene", self.scene)
        if self.properties.is_property_set("seed"):
            root.pomona.options.seed = self.seed
        root.pomona.options.quality = "draft"
        return made(self, root)


class POMONA_OT_make_again(NeedsPomona, bpy.types.Operator):
    """Make the active piece once more by its own command, as a fruit of its own"""

    bl_idname, bl_label, bl_options = "pomona.make_again", "Make Again", {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        return super().poll(context) and command_of(context.object) is not None

    def execute(self, context: Any) -> set[str]:
        try:
            order = order_from_command(command_of(context.object) or "", workshop().table)
            root = root_by_order(context, order)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return made(self, root)


def command_of(thing: Any) -> Optional[str]:
    """By which the program makes this piece."""
    return thing.data.get("command") or None if thing is not None and thing.type == "MESH" else None


def root_by_order(context: Any, order: Order) -> Any:
    """A root whose settings say the same. ValueError where they cannot."""
    root = new_root(context, short_name(order.what), "scene" if order.verb == "scene" else "cut", order.what)
    set_knives(root.pomona, order.knives)
    names = {option.name for option in workshop().asked}
    set_options(root.pomona.options, [one for one in order.options if one[0] in names], workshop().asked)
    return root
