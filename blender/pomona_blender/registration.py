"""What Blender is told of when the add-on is switched on, and forgets when it is switched off."""

from typing import Any

import bpy

from . import add_fruit, change_fruit, own_templates, panels, serve, studio
from .doors import INSTALL, find_door
from .keeper import end_keeping, keeper, settings_changed, start_keeping
from .pictures import forget_pictures, load_pictures
from .settings import option_properties, suggested_knives
from .workshop import close_workshop, open_workshop, workshop


def find_again(_preferences: Any, _context: Any) -> None:
    """Another place was told: what the other Pomona has may differ, so all is told to Blender anew."""
    bpy.app.timers.register(register_again, first_interval=0.1)


def register_again() -> None:
    unregister()
    register()


class PomonaPreferences(bpy.types.AddonPreferences):
    """Where Pomona is, if not where it is looked for."""

    bl_idname = __package__

    program: bpy.props.StringProperty(
        name="Program", subtype="FILE_PATH", update=find_again,
        description="The program pomona; empty: on PATH, else where it is installed")
    module: bpy.props.StringProperty(
        name="Python Module", subtype="DIR_PATH", update=find_again,
        description="The folder that holds the package pomona; empty: where Blender's Python finds it")

    def draw(self, _context: Any) -> None:
        door = workshop().door
        self.layout.label(text=f"At work: {door.name}" if door else INSTALL, icon="CHECKMARK" if door else "ERROR")
        self.layout.prop(self, "program")
        self.layout.prop(self, "module")


class PomonaKnife(bpy.types.PropertyGroup):
    """A knife in words, or a plane."""

    is_plane: bpy.props.BoolProperty(update=settings_changed)
    words: bpy.props.StringProperty(name="Knife", update=settings_changed, search=suggested_knives,
                                    search_options={"SUGGESTION"}, description="As half, wedges:6 or slices:4mm")
    plane: bpy.props.PointerProperty(name="Plane", type=bpy.types.Object, update=settings_changed,
                                     description="Cuts along its own x and y")


class PomonaServing(bpy.types.PropertyGroup):
    """Fruit of one kind to serve."""

    template: bpy.props.StringProperty(name="Template", default="strawberry",
                                       search=add_fruit.suggested_templates, search_options={"SUGGESTION"})
    knives: bpy.props.StringProperty(name="Knives", search=suggested_knives, search_options={"SUGGESTION"})
    count: bpy.props.IntProperty(name="Fruit", default=4, min=1, max=1000)
    pieces: bpy.props.IntProperty(name="Pieces of Each", min=0, max=1000,
                                  description="The largest ones; 0 = all")
    size: bpy.props.FloatProperty(name="Size", default=1.0, min=0.05, max=20.0)
    face_up: bpy.props.BoolProperty(name="Face Up")


def options_group() -> Any:
    """The table's options as properties."""
    return type("PomonaOptions", (bpy.types.PropertyGroup,),
                {"__annotations__": option_properties(workshop().asked, settings_changed)})


def fruit_group(options: Any) -> Any:
    """All that a root has."""
    props = bpy.props
    return type("PomonaFruit", (bpy.types.PropertyGroup,), {"__annotations__": {
        "verb": props.StringProperty(),
        "what": props.StringProperty(name="Template", update=settings_changed, search=add_fruit.suggested_templates,
                                     search_options={"SUGGESTION"}),
        "copy": props.StringProperty(),  # the studio's, of a template of the program's own; there once it is saved
        "knives": props.CollectionProperty(type=PomonaKnife),
        "active_knife": props.IntProperty(),
        "options": props.PointerProperty(type=options),
        "face_up": props.BoolProperty(name="Face Up", update=laid_anew,
                                      description="Lay the pieces side by side, cut faces up"),
        "follow": props.BoolProperty(name="Follow", default=True, update=settings_changed,
                                     description="Make it anew as soon as something changes"),
        "made": props.StringProperty(),
        "message": props.StringProperty(),
        "dish": props.PointerProperty(type=bpy.types.Object),
        "way": props.StringProperty(),
        "servings": props.CollectionProperty(type=PomonaServing)}})


def laid_anew(fruit: Any, _context: Any) -> None:
    """The same pieces, elsewhere: the order of the settings is the same, so it counts as not made."""
    fruit.made = ""
    keeper().look_at(fruit.id_data.name)


STILL = (PomonaPreferences, PomonaKnife, PomonaServing, add_fruit.POMONA_OT_add_scene, add_fruit.POMONA_OT_make_again,
         change_fruit.POMONA_OT_make, change_fruit.POMONA_OT_another_seed, change_fruit.POMONA_OT_add_knife,
         change_fruit.POMONA_OT_remove_knife, change_fruit.POMONA_OT_unset, change_fruit.POMONA_OT_watch,
         serve.POMONA_OT_serve, serve.POMONA_OT_add_serving, serve.POMONA_OT_remove_serving,
         own_templates.POMONA_OT_open_template, own_templates.POMONA_OT_from_mesh, own_templates.POMONA_OT_studio,
         panels.POMONA_MT_add, panels.POMONA_MT_scenes, panels.POMONA_UL_knives, panels.POMONA_UL_servings,
         panels.POMONA_PT_fruit, panels.POMONA_PT_knives, panels.POMONA_PT_more, panels.POMONA_PT_serve)

_registered: list[Any] = []


def register() -> None:
    bpy.utils.register_class(PomonaPreferences)
    _registered.append(PomonaPreferences)
    addon = bpy.context.preferences.addons.get(__package__)
    told = addon.preferences if addon else None
    open_workshop(find_door(told.program if told else "", told.module if told else ""))
    options = options_group()
    for one in (*STILL[1:3], options, fruit_group(options), *STILL[3:], add_fruit.fruit_operator()):
        bpy.utils.register_class(one)
        _registered.append(one)
    fruit = next(one for one in _registered if one.__name__ == "PomonaFruit")
    bpy.types.Object.pomona = bpy.props.PointerProperty(type=fruit)
    bpy.types.Scene.pomona_servings = bpy.props.CollectionProperty(type=PomonaServing)
    bpy.types.Scene.pomona_serving = bpy.props.IntProperty()
    bpy.types.WindowManager.pomona_is_watched = bpy.props.BoolProperty()
    load_pictures()
    bpy.types.VIEW3D_MT_mesh_add.append(panels.add_menu)
    start_keeping()


def unregister() -> None:
    end_keeping()
    bpy.types.VIEW3D_MT_mesh_add.remove(panels.add_menu)
    forget_pictures()
    del bpy.types.Object.pomona, bpy.types.Scene.pomona_servings, bpy.types.Scene.pomona_serving
    del bpy.types.WindowManager.pomona_is_watched
    while _registered:
        bpy.utils.unregister_class(_registered.pop())
    studio.end_studios()
    close_workshop()
