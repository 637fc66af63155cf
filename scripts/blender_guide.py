"""The pictures of docs/guides/blender.md, each made as a person makes it, by the add-on's operators. Runs within
Blender, with the add-on's .zip and the program:

    PATH=/usr/bin:/bin xvfb-run -a -s "-screen 0 1280x800x24" blender --factory-startup \\
        --enable-event-simulate -P scripts/blender_guide.py -- ADDON.zip build/pomona FOLDER window
    PATH=/usr/bin:/bin blender -b --factory-startup -P scripts/blender_guide.py -- ADDON.zip build/pomona FOLDER bowl

`window` leaves menu.png, sidebar.png and plane.png; `bowl`, `strewn` and `loaf` leave a picture of this name by Cycles.
"""

import math
import os
import pathlib
import sys

import bpy
from mathutils import Euler, Vector

ADDON, PROGRAM, FOLDER, STEP = sys.argv[sys.argv.index("--") + 1:]
FOLDER = pathlib.Path(FOLDER).resolve()
FOLDER.mkdir(parents=True, exist_ok=True)
os.environ["PATH"] = os.path.dirname(os.path.abspath(PROGRAM)) + ":" + os.environ["PATH"]
bpy.context.preferences.view.show_splash = False
bpy.ops.preferences.addon_install(filepath=os.path.abspath(ADDON), overwrite=True)
bpy.ops.preferences.addon_enable(module="pomona_blender")

from pomona_blender.keeper import keeper  # noqa: E402

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from developing import developed  # noqa: E402


def plain(name, color, roughness):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1)
    shader.inputs["Roughness"].default_value = roughness
    return material


def turned(name, profile, material):
    """A dish: a profile of (radius, height), metres, turned about the axis."""
    points, faces, around = [], [], 96
    for radius, height in profile:
        points += [(radius * math.cos(2 * math.pi * k / around), radius * math.sin(2 * math.pi * k / around), height)
                   for k in range(around)]
    for ring in range(len(profile) - 1):
        for k in range(around):
            a, b = ring * around + k, ring * around + (k + 1) % around
            faces.append((a, b, b + around, a + around))
    return solid(name, points, faces, material)


def solid(name, points, faces, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    mesh.materials.append(material)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    active(thing)
    return thing


def active(thing):
    bpy.ops.object.select_all(action="DESELECT")
    thing.select_set(True)
    bpy.context.view_layer.objects.active = thing


def serve(way, seed, *rows):
    """Rows of the sidebar's list, and its button."""
    for words in rows:
        bpy.ops.pomona.add_serving()
        row = bpy.context.scene.pomona_servings[-1]
        for name, value in words.items():
            setattr(row, name, value)
    bpy.ops.pomona.serve(way=way, seed=seed)
    root = bpy.context.object
    root.pomona.options.texture = 512
    bpy.ops.pomona.make()


def lit(at, eye, reach, field):
    """A table in a room with one large window, and a camera."""
    scene = bpy.context.scene
    bpy.ops.mesh.primitive_plane_add(size=20 * reach)
    bpy.context.object.data.materials.append(plain("table", (0.60, 0.53, 0.45), 0.5))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.location, camera.data.angle, scene.camera = eye, field, camera
    camera.rotation_euler = (Vector(at) - Vector(eye)).to_track_quat("-Z", "Y").to_euler()
    camera.data.clip_start = 0.01
    window = bpy.data.objects.new("window", bpy.data.lights.new("window", "AREA"))
    scene.collection.objects.link(window)
    window.data.shape, window.data.size, window.data.size_y = "RECTANGLE", 2.2 * reach, 1.6 * reach
    window.data.energy, window.data.color = 190 * reach * reach, (1.0, 0.965, 0.90)
    window.location = Vector(at) + Vector((-0.55, 0.5, 0.9)).normalized() * 4 * reach
    window.rotation_euler = (Vector(at) - window.location).to_track_quat("-Z", "Y").to_euler()
    scene.world = bpy.data.worlds.new("room")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.80, 0.86, 0.95, 1)
    scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0.32


def drawn(name):
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 480, 360
    scene.view_settings.view_transform, scene.view_settings.look = "Filmic", "High Contrast"
    developed(scene, 48, str(FOLDER / f"{name}.png"))


def bowl():
    turned("bowl", [(0.0, 0.0), (0.05, 0.0), (0.055, 0.006), (0.09, 0.025), (0.118, 0.055), (0.13, 0.085),
                    (0.127, 0.087), (0.114, 0.058), (0.086, 0.030), (0.05, 0.014), (0.0, 0.012)],
           plain("stoneware", (0.10, 0.22, 0.24), 0.3))
    serve("FILL", 3, {"template": "kiwi", "knives": "half", "count": 2, "face_up": True},
          {"template": "fig", "knives": "half", "count": 2, "face_up": True},
          {"template": "strawberry", "knives": "half", "count": 3, "face_up": True})
    lit((0, 0, 0.05), (0.06, -0.40, 0.46), 0.16, 0.50)


def strewn():
    points, faces, side = [], [], 40
    for j in range(side):
        for i in range(side):
            x, y = 0.4 * (i / (side - 1) - 0.5), 0.4 * (j / (side - 1) - 0.5)
            hill, waves = 0.05 * math.exp(-(x * x + y * y) / 0.012), math.sin(40 * x) * math.sin(34 * y)
            points.append((x, y, hill + 0.005 + 0.004 * waves))  # above the table
    for j in range(side - 1):
        faces += [(j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i) for i in range(side - 1)]
    solid("ice", points, faces, plain("ice", (0.80, 0.87, 0.90), 0.25))
    serve("STREW", 5, {"template": "strawberry", "count": 8}, {"template": "strawberry", "knives": "half", "count": 5,
                                                               "pieces": 1, "face_up": True},
          {"template": "cherry", "count": 6})
    lit((0, 0, 0.02), (0.08, -0.42, 0.36), 0.2, 0.50)


def loaf():
    points, faces, around, along = [], [], 48, 32
    for j in range(along + 1):
        for k in range(around):
            u, v = math.pi * (j / along - 0.5), 2 * math.pi * k / around
            wide = abs(math.cos(u)) ** 0.45
            x = 0.13 * math.copysign(abs(math.sin(u)) ** 0.75, math.sin(u))
            y = 0.055 * wide * math.copysign(abs(math.cos(v)) ** 0.7, math.cos(v))
            z = 0.048 * wide * math.copysign(abs(math.sin(v)) ** 0.8, math.sin(v))
            points.append((x, y, 0.035 + (z if z > 0 else 0.7 * z)))
    faces = [(j * around + k, (j + 1) * around + k, (j + 1) * around + (k + 1) % around, j * around + (k + 1) % around)
             for j in range(along) for k in range(around)]
    thing = solid("loaf", points, faces, plain("dough", (0.5, 0.3, 0.1), 0.6))
    weld = thing.modifiers.new("poles", "WELD")
    weld.merge_threshold = 1e-5
    bpy.ops.pomona.from_mesh(filepath=str(FOLDER / "loaf.toml"), depth=0.004, grain=0.05,
                             knives=" ".join(f"plane:1,0,0,{x}mm" for x in (10, 28, 46, 64)))
    root = bpy.context.object
    root.pomona.options.texture = 1024
    bpy.ops.pomona.make()
    for number, piece in enumerate(sorted(root.children, key=lambda child: child.location.x)):
        if number:  # slices lie down towards the right, one on the other
            piece.location.x += 0.012 * number + 0.018
            piece.location.z -= 0.006 * number
            piece.rotation_euler = (0, 0.16 * number, 0)
    lit((0.02, 0, 0.03), (0.36, -0.34, 0.26), 0.17, 0.62)


def shot(name):
    bpy.ops.screen.screenshot(filepath=str(FOLDER / f"{name}.png"))


def in_view(operator, *words, **options):
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        return operator(*words, **options)


def click(x, y):
    """Of the left button, pixels from the lower left."""
    window = bpy.context.window_manager.windows[0]
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=x, y=y)
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=x, y=y)


def window_steps():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    area = next(area for area in bpy.context.window_manager.windows[0].screen.areas if area.type == "VIEW_3D")
    view = area.spaces.active
    view.show_region_ui, view.show_region_toolbar, view.clip_start = True, False, 0.001
    view.shading.color_type, view.overlay.show_floor = "VERTEX", False
    view.region_3d.view_rotation = Euler((0.95, 0, 0.25)).to_quaternion()
    yield 10
    in_view(bpy.ops.pomona.add, "EXEC_DEFAULT", True, template="tomato", knives="half", ripeness=0.7, seed=3,
            face_up=True)
    yield 60
    in_view(bpy.ops.view3d.view_selected)
    view.region_3d.view_distance, view.region_3d.view_location = 0.2, (0.02, 0, 0.01)
    yield 10
    click(1044, 550)  # the tab Pomona
    yield 40
    shot("sidebar")
    root = bpy.context.object
    root.pomona.face_up = False
    root.pomona.options.ripeness = 1
    in_view(bpy.ops.pomona.remove_knife, "EXEC_DEFAULT", True)
    yield 60
    in_view(bpy.ops.pomona.add_knife, "EXEC_DEFAULT", True, is_plane=True)
    root.pomona.options.explode = 3
    plane = root.pomona.knives[0].plane
    plane.rotation_euler = (1.1, 0.1, 0.5)
    view.region_3d.view_distance, view.region_3d.view_location = 0.26, (0.02, 0, 0.03)
    view.region_3d.view_rotation = Euler((1.0, 0, 1.5)).to_quaternion()
    yield 80
    shot("plane")
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    in_view(bpy.ops.wm.call_menu, name="POMONA_MT_add")
    yield 20
    shot("menu")


def drive():
    steps, state = window_steps(), {"left": 20}

    def tick():
        state["left"] -= 1
        if state["left"] <= 0 and not keeper().is_busy:
            try:
                state["left"] = next(steps)
            except StopIteration:
                os._exit(0)
            except Exception:
                __import__("traceback").print_exc()
                os._exit(1)
        return 0.05

    bpy.app.timers.register(tick, first_interval=1.0)


if STEP == "window":
    drive()
else:
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.preferences.addon_enable(module="pomona_blender")
    {"bowl": bowl, "strewn": strewn, "loaf": loaf}[STEP]()
    drawn(STEP)
