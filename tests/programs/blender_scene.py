"""Imports a .glb into Blender, says as JSON what has become of it, and renders it small. Runs within Blender:

    blender -b --factory-startup --python-exit-code 1 -t 2 -P blender_scene.py -- FILE.glb PICTURE.png
"""

import json
import sys

import numpy

numpy.bool = bool  # what Debian's Blender asks of its numpy, which has it no more

import bpy  # noqa: E402

source, picture = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=source)
things = list(bpy.data.objects)


def triangles(mesh):
    mesh.calc_loop_triangles()
    return len(mesh.loop_triangles)


def told(mesh):
    return {key: mesh[key] for key in mesh.keys() if isinstance(mesh[key], (int, float, str))}


print("SAID " + json.dumps({
    "objects": {thing.name: {"mesh": thing.data.name, "place": list(thing.matrix_world.translation),
                             "in": thing.parent.name if thing.parent else None} for thing in things if thing.type == "MESH"},
    "meshes": {mesh.name: {"triangles": triangles(mesh), "extras": told(mesh), "colors": len(mesh.color_attributes),
                           "materials": [material.name for material in mesh.materials]} for mesh in bpy.data.meshes},
    "cameras": [thing.name for thing in things if thing.type == "CAMERA"],
}))

# White all around, and nothing behind: what is opaque is fruit.
scene = bpy.context.scene
scene.camera = next(thing for thing in things if thing.type == "CAMERA")
scene.world = bpy.data.worlds.new("white")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[0].default_value = (1, 1, 1, 1)
scene.render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.seed, scene.cycles.use_denoising = 8, 0, False
scene.render.resolution_x, scene.render.resolution_y = 160, 120
scene.render.film_transparent = True
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)

pixels = numpy.array(bpy.data.images.load(picture).pixels[:]).reshape(-1, 4)
fruit = pixels[pixels[:, 3] > 0.5]
print("SEEN " + json.dumps({"share": len(fruit) / len(pixels), "color": [float(c) for c in fruit[:, :3].mean(axis=0)]}))
