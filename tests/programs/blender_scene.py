"""Imports a .glb into Blender, says as JSON what has become of it, and renders it small. Runs within Blender:

    blender -b --factory-startup --python-exit-code 1 -t 2 -P blender_scene.py -- FILE.glb PICTURE.png [ATLAS.glb...]

Of further files of the same scene, whose colours stand in images, it says how far these are from the vertices' colours.
"""

import json
import sys

import numpy

numpy.bool = bool  # what Debian's Blender asks of its numpy, which has it no more

import bpy  # noqa: E402

source, picture, *others = sys.argv[sys.argv.index("--") + 1:]
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


def srgb(linear):
    return numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * numpy.maximum(linear, 0) ** (1 / 2.4) - 0.055)


def values(mesh_data, name, width):
    """An attribute of a mesh as an array of rows."""
    flat = numpy.empty(width * len(mesh_data), numpy.float32)
    mesh_data.foreach_get(name, flat)
    return flat.reshape(-1, width)


def corner_places(mesh):
    """Where each corner of each face lies, in micrometres."""
    places = numpy.rint(values(mesh.vertices, "co", 3) * 1e6).astype(int)
    return [tuple(places[loop.vertex_index]) for loop in mesh.loops]


def corner_colors(mesh):
    """Each corner's colour from the vertices, sRGB."""
    attribute = mesh.color_attributes[0]
    color = srgb(values(attribute.data, "color", 4)[:, :3])
    return color if attribute.domain == "CORNER" else color[[loop.vertex_index for loop in mesh.loops]]


def base_texture(material):
    """The image that a material has its colour from, if there is one."""
    waiting = [link.from_node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED"
               for link in node.inputs["Base Color"].links]
    while waiting:
        node = waiting.pop()
        if node.type == "TEX_IMAGE":
            return node.image
        waiting += [link.from_node for socket in node.inputs for link in socket.links]
    return None


def shown_colors(mesh):
    """Each corner's colour, sRGB: from the material's image, or else from the vertices."""
    image = base_texture(mesh.materials[0])
    if image is None:
        return corner_colors(mesh)
    width, height = image.size
    texels = numpy.array(image.pixels[:]).reshape(height, width, 4)[..., :3]
    at = (values(mesh.uv_layers[0].data, "uv", 2) * (width, height)).astype(int)
    return texels[numpy.clip(at[:, 1], 0, height - 1), numpy.clip(at[:, 0], 0, width - 1)]


def colors_by_place(mesh):
    """All colours that vertices have at a place: skin and cut faces meet there."""
    found = {}
    for place, color in zip(corner_places(mesh), corner_colors(mesh)):
        found.setdefault(place, []).append(color)
    return found


def difference(mesh, by_place):
    """The mean difference of what a mesh shows at its corners from the nearest colour there."""
    off = [min(float(numpy.abs(color - one).mean()) for one in by_place[place])
           for place, color in zip(corner_places(mesh), shown_colors(mesh))]
    return float(numpy.mean(off))


by_vertices = {thing.name: colors_by_place(thing.data) for thing in things if thing.type == "MESH"}
differences = {}
for other in others:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=other)
    meshes = {thing.name: thing.data for thing in bpy.data.objects if thing.name in by_vertices}
    differences[other] = {name: difference(mesh, by_vertices[name]) for name, mesh in meshes.items()}
print("COLORS " + json.dumps(differences))
