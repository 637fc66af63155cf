"""What people see: the menu below Add > Mesh, the sidebar's tab, and the preferences."""

from __future__ import annotations

from typing import Any, Iterable

import bpy

from .build_objects import pieces_of
from .doors import INSTALL
from .option_table import Option
from .pictures import icon_of
from .settings import root_of
from .workshop import workshop

# Of the menu of fruit: more would not fit a small screen.
ROWS = 22

# Shown first; all others stand in a panel of their own, in the order of the table.
FIRST = ("seed", "ripeness", "browning", "folds", "scale", "texture", "quality")


class POMONA_MT_add(bpy.types.Menu):
    bl_idname, bl_label = "POMONA_MT_add", "Pomona"

    def draw(self, _context: Any) -> None:
        layout = self.layout
        if workshop().door is None:
            layout.label(text=INSTALL, icon="INFO")
            return
        layout.operator_context = "EXEC_REGION_WIN"
        grid = layout.column_flow(columns=-(-len(workshop().templates) // ROWS))
        for one in workshop().templates:
            grid.operator("pomona.add", text=one.title, icon_value=icon_of(one.name)).template = one.name
        layout.separator()
        layout.menu("POMONA_MT_scenes", icon="OUTLINER_OB_GROUP_INSTANCE")
        layout.operator_context = "INVOKE_REGION_WIN"
        layout.operator("pomona.open_template", text="Template File...", icon="FILE")
        layout.operator("pomona.from_mesh", text="Make Mesh Cuttable...", icon="MESH_DATA")


class POMONA_MT_scenes(bpy.types.Menu):
    bl_idname, bl_label = "POMONA_MT_scenes", "Scene"

    def draw(self, _context: Any) -> None:
        for one in workshop().scenes:
            self.layout.operator("pomona.add_scene", text=one.title).scene = one.name


def add_menu(menu: Any, _context: Any) -> None:
    menu.layout.separator()
    menu.layout.menu("POMONA_MT_add", icon_value=icon_of("tomato"))


class POMONA_UL_knives(bpy.types.UIList):
    def draw_item(self, _context: Any, layout: Any, _data: Any, item: Any, _icon: int, _of: Any, _name: str) -> None:
        if item.is_plane:
            layout.prop(item, "plane", text="", icon="MESH_PLANE")
        else:
            layout.prop(item, "words", text="", emboss=True)


class POMONA_UL_servings(bpy.types.UIList):
    def draw_item(self, _context: Any, layout: Any, _data: Any, item: Any, _icon: int, _of: Any, _name: str) -> None:
        row = layout.row(align=True)
        row.prop(item, "count", text="")
        row.prop(item, "template", text="")
        row.prop(item, "knives", text="")


class Sidebar:
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Pomona"


class OfFruit(Sidebar):
    """Panels of the fruit that the active object is, or belongs to."""

    @classmethod
    def poll(cls, context: Any) -> bool:
        return root_of(context.object) is not None


def draw_options(layout: Any, root: Any, options: Iterable[Option]) -> None:
    """What is not set is grey: the template's own counts."""
    group = root.pomona.options
    for option in options:
        is_set = group.is_property_set(option.keyword)
        row = layout.row(align=True)
        own = row.row()
        own.active = is_set
        own.prop(group, option.keyword)
        if is_set:
            row.operator("pomona.unset", text="", icon="X").keyword = option.keyword


class POMONA_PT_fruit(Sidebar, bpy.types.Panel):
    bl_label = "Pomona"

    def draw(self, context: Any) -> None:
        layout, root = self.layout, root_of(context.object)
        if workshop().door is None:
            for line in wrapped(INSTALL):
                layout.label(text=line)
            return
        if root is None:
            layout.menu("POMONA_MT_add", text="Add Fruit", icon_value=icon_of("tomato"))
            return
        self._draw_root(layout, root)

    def _draw_root(self, layout: Any, root: Any) -> None:
        fruit = root.pomona
        if fruit.verb == "cut":
            layout.prop(fruit, "what", text="", icon_value=icon_of(fruit.what))
        row = layout.row(align=True)
        row.operator("pomona.another_seed", icon="FILE_REFRESH")
        row.operator("pomona.make_again", text="Again", icon="DUPLICATE")
        self._draw_state(layout, root)
        column = layout.column()
        column.use_property_split = True
        known = {option.keyword: option for option in workshop().asked}
        draw_options(column, root, [known[name] for name in FIRST if name in known and taken(root, known[name])])

    def _draw_state(self, layout: Any, root: Any) -> None:
        job = workshop().jobs.get(root.name)
        if job is not None:
            layout.label(text=f"{job.stage} {100 * job.share:.0f} %, Esc stops it", icon="TIME")
        elif not pieces_of(root) or root.pomona.verb == "scene":
            layout.operator("pomona.make", icon="PLAY")
        for line in wrapped(root.pomona.message):
            layout.label(text=line, icon="ERROR")


def taken(root: Any, option: Option) -> bool:
    return root.pomona.verb in option.takers


class POMONA_PT_knives(OfFruit, bpy.types.Panel):
    bl_label, bl_parent_id = "Knives", "POMONA_PT_fruit"

    @classmethod
    def poll(cls, context: Any) -> bool:
        return super().poll(context) and root_of(context.object).pomona.verb == "cut"

    def draw(self, context: Any) -> None:
        layout, fruit = self.layout, root_of(context.object).pomona
        row = layout.row()
        row.template_list("POMONA_UL_knives", "", fruit, "knives", fruit, "active_knife", rows=2)
        column = row.column(align=True)
        column.operator("pomona.add_knife", text="", icon="ADD")
        column.operator("pomona.add_knife", text="", icon="MESH_PLANE").is_plane = True
        column.operator("pomona.remove_knife", text="", icon="REMOVE")
        layout.prop(fruit, "face_up")
        layout.prop(fruit, "follow")


class POMONA_PT_more(OfFruit, bpy.types.Panel):
    bl_label, bl_parent_id, bl_options = "All Options", "POMONA_PT_fruit", {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        root = root_of(context.object)
        self.layout.use_property_split = True
        draw_options(self.layout, root, [option for option in workshop().asked
                                         if option.keyword not in FIRST and taken(root, option)])
        self.layout.operator("pomona.studio", icon="URL")


class POMONA_PT_serve(Sidebar, bpy.types.Panel):
    bl_label, bl_options = "Fill a Dish, Strew over a Mesh", {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        layout, scene = self.layout, context.scene
        row = layout.row()
        row.template_list("POMONA_UL_servings", "", scene, "pomona_servings", scene, "pomona_serving", rows=2)
        column = row.column(align=True)
        column.operator("pomona.add_serving", text="", icon="ADD")
        column.operator("pomona.remove_serving", text="", icon="REMOVE")
        if scene.pomona_servings:
            chosen = scene.pomona_servings[min(scene.pomona_serving, len(scene.pomona_servings) - 1)]
            for name in ("pieces", "size", "face_up"):
                layout.prop(chosen, name)
        row = layout.row(align=True)
        row.operator_context = "EXEC_REGION_WIN"
        for way, words in (("FILL", "Fill"), ("HEAP", "Heap"), ("STREW", "Strew")):
            row.operator("pomona.serve", text=words).way = way


def wrapped(words: str, width: int = 44) -> list[str]:
    """Lines that fit the sidebar."""
    import textwrap

    return [line for part in words.splitlines() for line in textwrap.wrap(part, width)]
