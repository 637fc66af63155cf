"""Renders a .glb with maps by Blender's Cycles, under a soft sky and one window: docs/textures.md. Runs within Blender:

    blender -b --factory-startup --python-exit-code 1 -P scripts/maps_blender.py -- FILE.glb PICTURE.png
"""

import sys

import numpy

numpy.bool = bool  # what Debian's Blender asks of its numpy, which has it no more

import bmesh  # noqa: E402
import bpy  # noqa: E402
from mathutils import Vector  # noqa: E402

source, picture = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=source)
scene = bpy.context.scene
fruit = [thing for thing in bpy.data.objects if thing.type == "MESH"]

# A cut face inside two bodies, as where a stem is sunk in the fruit, lies there once for each, so that each is closed.
# A path tracer would take either for the other's shadow: one is enough.
for thing in fruit:
    mesh = bmesh.new()
    mesh.from_mesh(thing.data)
    known, doubled = set(), []
    for face in mesh.faces:
        place = frozenset(tuple(corner.vert.co) for corner in face.loops)
        if place in known:
            doubled.append(face)
        known.add(place)
    bmesh.ops.delete(mesh, geom=doubled, context="FACES_ONLY")
    mesh.to_mesh(thing.data)
    mesh.free()

corners = [thing.matrix_world @ Vector(corner) for thing in fruit for corner in thing.bound_box]
low = Vector([min(corner[k] for corner in corners) for k in range(3)])
high = Vector([max(corner[k] for corner in corners) for k in range(3)])
middle, reach = (low + high) / 2, (high - low).length / 2

# The piece's cut face looks to the front, -Y of Blender.
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(camera)
camera.location = middle + Vector((0.45, -1, 0.62)).normalized() * 4.6 * reach
camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
camera.data.angle = 0.5
scene.camera = camera

# A window of one fruit's width to the upper left, and a pale sky.
light = bpy.data.objects.new("window", bpy.data.lights.new("window", "AREA"))
scene.collection.objects.link(light)
light.data.size, light.data.energy = 2.5 * reach, 900 * reach * reach
light.location = middle + Vector((-1.2, -1.1, 1.9)) * 2.6 * reach
light.rotation_euler = (middle - light.location).to_track_quat("-Z", "Y").to_euler()
scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.75, 0.78, 0.82, 1)
scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0.6

scene.render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.seed, scene.cycles.use_denoising = 24, 0, False
scene.render.resolution_x, scene.render.resolution_y = 400, 320
scene.view_settings.view_transform = "Standard"
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
