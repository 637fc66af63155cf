"""Renders a .glb with maps by Blender's Cycles, on a table in a room with one large window:
docs/reference/textures.md. Runs within Blender:

    blender -b --factory-startup --python-exit-code 1 -P scripts/maps_blender.py -- FILE.glb PICTURE.png [VIEW]

VIEW is nothing, for one piece whose cut face leans back towards the eye; "rim", from close by at the edge between that
face and the skin, at 45 degrees to either; or "scene", for pieces that stay as they lie, by the camera of the file.

Light under the surface, which Blender's reader of glTF does not know, is taken from the materials' extras.
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



def scatter(material):
    """Subsurface weight and radius (metres) of a material that has them, its tint the base colour."""
    inside = material.get("subsurface")
    if inside is None or not material.use_nodes:
        return
    nodes, links = material.node_tree.nodes, material.node_tree.links
    for shader in [node for node in nodes if node.type == "BSDF_PRINCIPLED"]:
        shader.subsurface_method = "RANDOM_WALK"
        shader.inputs["Subsurface"].default_value = inside["weight"]
        shader.inputs["Subsurface Radius"].default_value = [max(way, 1e-5) for way in inside["radius"]]
        base, inner = shader.inputs["Base Color"], shader.inputs["Subsurface Color"]
        if base.is_linked:
            links.new(base.links[0].from_socket, inner)
        else:
            inner.default_value = base.default_value
    # What the volume of glTF says of straight ways is the same light once more.
    for output in [node for node in nodes if node.type == "OUTPUT_MATERIAL"]:
        for link in list(output.inputs["Volume"].links):
            links.remove(link)


for one in {slot.material for thing in fruit for slot in thing.material_slots if slot.material}:
    scatter(one)

# The cut face looks to the front, -Y of Blender. The piece leans back until the face looks up, as a half lies on a table.
lean = Matrix.Rotation(math.radians(-70), 4, "X") if view != ["scene"] else Matrix.Identity(4)
for thing in fruit:
    if thing.parent is None or view != ["scene"]:
        thing.matrix_world = lean @ thing.matrix_world
bpy.context.view_layer.update()
places = [thing.matrix_world @ corner.co for thing in fruit for corner in thing.data.vertices]
low = Vector([min(place[k] for place in places) for k in range(3)])
high = Vector([max(place[k] for place in places) for k in range(3)])
middle, reach = (low + high) / 2, (high - low).length / 2

# A table of pale, faintly polished wood or stone under it.
bpy.ops.mesh.primitive_plane_add(size=40 * reach, location=(middle.x, middle.y, 0 if view == ["scene"] else low.z))
table = bpy.data.materials.new("table")
table.use_nodes = True
table.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.74, 0.70, 0.64, 1)
table.node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.55
bpy.context.object.data.materials.append(table)

known = [thing for thing in bpy.data.objects if thing.type == "CAMERA"]
if view == ["scene"] and known:
    camera = known[0]
else:
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    at, camera.location, camera.data.angle = middle, middle + Vector((0.25, -1, 0.9)).normalized() * 4.6 * reach, 0.46
    if view == ["rim"]:
        face = lean.to_3x3() @ Vector((0, -1, 0))
        at = max(places, key=lambda place: 1000 * place.dot(face) + place.x - place.y)  # on the face, right in front
        out = at - middle
        out = (out - out.dot(face) * face).normalized()
        camera.location, camera.data.angle = at + (face + out).normalized() * 1.1 * reach, 0.35
    camera.rotation_euler = (at - camera.location).to_track_quat("-Z", "Y").to_euler()
    camera.data.clip_start = 0.01 * reach
scene.camera = camera


def pane(name, way, size, strength, color):
    """A rectangle of light, looking at the fruit from `way`, of size times its reach."""
    light = bpy.data.objects.new(name, bpy.data.lights.new(name, "AREA"))
    scene.collection.objects.link(light)
    light.data.shape, light.data.size, light.data.size_y = "RECTANGLE", size[0] * reach, size[1] * reach
    light.data.energy, light.data.color = strength * reach * reach, color
    light.location = middle + Vector(way).normalized() * 4 * reach
    light.rotation_euler = (middle - light.location).to_track_quat("-Z", "Y").to_euler()


# A window behind and to the left, whose mirror image lies on a part of the wet face; a pale wall across the room.
pane("window", (-0.52, 0.42, 0.95), (2.0, 1.5), 215, (1.0, 0.965, 0.90))
scene.world = bpy.data.worlds.new("room")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.80, 0.86, 0.95, 1)
scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0.32

scene.render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.seed, scene.cycles.use_denoising = 48, 0, False
scene.cycles.use_adaptive_sampling, scene.cycles.adaptive_threshold, scene.cycles.adaptive_min_samples = True, 0.02, 16
scene.render.resolution_x, scene.render.resolution_y = 480, 384
scene.view_settings.view_transform, scene.view_settings.look = "Filmic", "Medium High Contrast"
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
