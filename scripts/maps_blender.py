"""Renders a .glb with maps by Blender's Cycles, on a table under a soft sky and one window:
docs/reference/textures.md. Runs within Blender:

    blender -b --factory-startup --python-exit-code 1 -P scripts/maps_blender.py -- FILE.glb PICTURE.png [rim]

"rim" looks from close by at the edge between the cut face and the skin, at 45 degrees to either.
"""

import math
import sys

import numpy

numpy.bool = bool  # what Debian's Blender asks of its numpy, which has it no more

import bmesh  # noqa: E402
import bpy  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

source, picture, *view = sys.argv[sys.argv.index("--") + 1:]
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

# The cut face looks to the front, -Y of Blender. The piece leans back until the face looks up, as a half lies on a table.
lean = Matrix.Rotation(math.radians(-70), 4, "X")
for thing in fruit:
    thing.matrix_world = lean @ thing.matrix_world
bpy.context.view_layer.update()
places = [thing.matrix_world @ corner.co for thing in fruit for corner in thing.data.vertices]
low = Vector([min(place[k] for place in places) for k in range(3)])
high = Vector([max(place[k] for place in places) for k in range(3)])
middle, reach = (low + high) / 2, (high - low).length / 2

# A table of pale paper under it.
bpy.ops.mesh.primitive_plane_add(size=40 * reach, location=(middle.x, middle.y, low.z))
paper = bpy.data.materials.new("paper")
paper.use_nodes = True
paper.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.86, 0.82, 0.74, 1)
paper.node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.9
bpy.context.object.data.materials.append(paper)

camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(camera)
at, camera.location, camera.data.angle = middle, middle + Vector((0.3, -1, 0.8)).normalized() * 3.9 * reach, 0.5
if view == ["rim"]:
    face = lean.to_3x3() @ Vector((0, -1, 0))
    at = max(places, key=lambda place: 1000 * place.dot(face) + place.x - place.y)  # on the face, to the right in front
    out = at - middle
    out = (out - out.dot(face) * face).normalized()
    camera.location, camera.data.angle = at + (face + out).normalized() * 1.1 * reach, 0.35
    camera.data.clip_start = 0.01 * reach
camera.rotation_euler = (at - camera.location).to_track_quat("-Z", "Y").to_euler()
scene.camera = camera

# A window to the upper left, whose mirror image lies on a part of the wet face, and a pale sky.
light = bpy.data.objects.new("window", bpy.data.lights.new("window", "AREA"))
scene.collection.objects.link(light)
light.data.size, light.data.energy = 0.8 * reach, 130 * reach * reach
light.location = middle + Vector((-0.42, 0.42, 0.9)) * 3 * reach
light.rotation_euler = (middle - light.location).to_track_quat("-Z", "Y").to_euler()
scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.75, 0.78, 0.82, 1)
scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0.45

scene.render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.seed, scene.cycles.use_denoising = 64, 0, False
scene.render.resolution_x, scene.render.resolution_y = 480, 384
scene.view_settings.view_transform = "Standard"
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
