"""Photographs a .glb with maps by Blender's Cycles, on a table in a room with one large window:
docs/reference/style.md. Runs within Blender:

    blender -b --factory-startup --python-exit-code 1 -P scripts/photograph.py -- FILE.glb PICTURE.jpg [VIEW [SAMPLES]]

VIEW is "halves", for two pieces, of which the first leans against the other so that its cut face is seen (usual);
"piece", for one piece that lies on its back; "rim", from close by at the edge between cut face and skin, at 45 degrees
to either; or "scene", for pieces that stay as they lie. SAMPLES is per pixel, 24 if not said. PICTURE may be a .png.

Light under the surface, which Blender's reader of glTF does not know, is taken from the materials' extras.
"""

import math
import pathlib
import sys

import numpy

numpy.bool = bool  # what Debian's Blender asks of its numpy, which has it no more

import bmesh  # noqa: E402
import bpy  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402
from mathutils.bvhtree import BVHTree  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from developing import developed  # noqa: E402

source, picture, *more = sys.argv[sys.argv.index("--") + 1:]
view, samples = (more + ["halves", "24"][len(more):])[:2]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=source)
scene = bpy.context.scene
fruit = [thing for thing in bpy.data.objects if thing.type == "MESH"]


def without_doubles(mesh):
    """A cut face inside two bodies, as where a stem is sunk in the fruit, lies there once for each, so that each is
    closed. A path tracer would take either for the other's shadow: one is enough."""
    edited = bmesh.new()
    edited.from_mesh(mesh)
    known, doubled = set(), []
    for face in edited.faces:
        place = frozenset(tuple(corner.vert.co) for corner in face.loops)
        if place in known:
            doubled.append(face)
        known.add(place)
    bmesh.ops.delete(edited, geom=doubled, context="FACES_ONLY")
    edited.to_mesh(mesh)
    edited.free()


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


def cut_normal(thing):
    """Of the widest flat face: areas are summed by direction."""
    areas = {}
    for face in thing.data.polygons:
        way = tuple(round(50 * part) for part in face.normal)
        areas[way] = areas.get(way, 0) + face.area
    return Vector(max(areas, key=areas.get)).normalized()


def places(things):
    return [thing.matrix_world @ corner.co for thing in things for corner in thing.data.vertices]


def laid(thing, face, up):
    """Turns a piece so that its cut face looks along `face` and the fruit's axis, seen on it, along `up`; then lets it
    down on the table."""
    normal, axis = cut_normal(thing), Vector((0, 0, 1))
    if abs(normal.dot(axis)) > 0.9:  # cut across: any direction will do
        axis = Vector((0, 1, 0))
    def frame(z, y):
        x = y.cross(z).normalized()
        return Matrix((x, z.cross(x), z)).transposed()
    turn = frame(Vector(face).normalized(), Vector(up)) @ frame(normal, axis).transposed()
    thing.parent = None
    thing.matrix_world = turn.to_4x4()
    thing.location.z -= min(place.z for place in places([thing]))
    bpy.context.view_layer.update()


def tree(thing):
    return BVHTree.FromPolygons([thing.matrix_world @ corner.co for corner in thing.data.vertices],
                                [tuple(face.vertices) for face in thing.data.polygons])


def pushed(thing, way, others):
    """Moves a piece out along a way until it touches no other."""
    step = Vector(way).normalized() * max(thing.dimensions) / 100
    known = [tree(other) for other in others]
    while any(tree(thing).overlap(one) for one in known):
        thing.location += step
        bpy.context.view_layer.update()


def arranged():
    """Lays the pieces down; what the camera looks at."""
    if view == "scene":
        return fruit
    if view == "halves":
        first, second = fruit[:2]
        laid(first, (0.10, -0.52, 0.85), (-0.35, 0.55, 0.5))
        laid(second, (0, 0, -1), (0.75, 0.66, 0))
        second.location += Vector((0.3, 0.55, 0)) * max(first.dimensions)
        bpy.context.view_layer.update()
        pushed(second, (0.45, 1, 0), [first])
        return [first, second]
    laid(fruit[0], (0, -0.34, 0.94), (0, 0.94, 0.34))
    return fruit[:1]


def nodes_of(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    return material, material.node_tree.nodes, material.node_tree.links


def wood(reach):
    """Planks of dark, oiled wood: noise that is drawn out along the grain, in colour, gloss and height."""
    material, nodes, links = nodes_of("wood")
    shader = nodes["Principled BSDF"]
    place, grain, fine = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeMapping")
    grain.inputs["Scale"].default_value = (1.1 / reach, 9 / reach, 1)
    fine.inputs["Scale"].default_value = (3 / reach, 120 / reach, 1)
    bands, pores = nodes.new("ShaderNodeTexNoise"), nodes.new("ShaderNodeTexNoise")
    bands.inputs["Scale"].default_value = pores.inputs["Scale"].default_value = 1
    bands.inputs["Detail"].default_value, bands.inputs["Distortion"].default_value = 6, 0.9
    pores.inputs["Detail"].default_value = 5
    ramp, mix, bump = nodes.new("ShaderNodeValToRGB"), nodes.new("ShaderNodeMixRGB"), nodes.new("ShaderNodeBump")
    ramp.color_ramp.elements[0].position, ramp.color_ramp.elements[0].color = 0.33, (0.060, 0.028, 0.013, 1)
    ramp.color_ramp.elements[1].position, ramp.color_ramp.elements[1].color = 0.70, (0.22, 0.115, 0.052, 1)
    mix.blend_type, mix.inputs["Fac"].default_value = "OVERLAY", 0.7
    bump.inputs["Strength"].default_value, bump.inputs["Distance"].default_value = 0.35, 0.006 * reach
    for mapping, noise in ((grain, bands), (fine, pores)):
        links.new(place.outputs["Object"], mapping.inputs["Vector"])
        links.new(mapping.outputs["Vector"], noise.inputs["Vector"])
    links.new(bands.outputs["Fac"], ramp.inputs["Fac"])
    links.new(ramp.outputs["Color"], mix.inputs["Color1"])
    links.new(pores.outputs["Fac"], mix.inputs["Color2"])
    links.new(mix.outputs["Color"], shader.inputs["Base Color"])
    links.new(pores.outputs["Fac"], bump.inputs["Height"])
    links.new(bump.outputs["Normal"], shader.inputs["Normal"])
    shader.inputs["Roughness"].default_value, shader.inputs["Specular"].default_value = 0.42, 0.4
    return material


def camera_on(seen):
    """Frames these points."""
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    low = Vector([min(place[k] for place in seen) for k in range(3)])
    high = Vector([max(place[k] for place in seen) for k in range(3)])
    at, size = (low + high) / 2, (high - low).length
    way, fill = Vector((0.0, -0.80, 0.62)).normalized(), 0.84
    if view == "scene":
        way, fill = Vector((0.10, -0.72, 0.80)).normalized(), 0.92
    if view == "rim":
        normal = Vector((0, -0.34, 0.94))
        rim = max(seen, key=lambda place: 1000 * place.dot(normal) + place.x - place.y)  # on the face, right in front
        out = rim - at
        out = (out - out.dot(normal) * normal).normalized()
        span = 0.1 * size * (out - normal)
        seen, at, way, size = [rim + span, rim - span], rim, normal + out, size / 3
    camera.rotation_euler = (-way).to_track_quat("-Z", "Y").to_euler()
    camera.location = at + way.normalized() * 5 * size
    camera.data.clip_start, camera.data.clip_end = 0.1 * size, 1000 * size
    bpy.context.view_layer.update()
    aspect = scene.render.resolution_x / scene.render.resolution_y
    for _ in range(3):  # the middle of what is seen into the middle of the picture
        turned = [camera.matrix_world.inverted() @ place for place in seen]
        flat = [(-place.x / place.z, -place.y / place.z) for place in turned]
        across, along = ([pair[k] for pair in flat] for k in range(2))
        middle = Vector(((min(across) + max(across)) / 2, (min(along) + max(along)) / 2, 0)) * 5 * size
        camera.location += camera.matrix_world.to_3x3() @ middle
        bpy.context.view_layer.update()
    half = max(max(map(abs, across)), aspect * max(map(abs, along)))
    camera.data.angle = 2 * math.atan(half / fill)
    return camera


def pane(name, at, way, size, strength, color, reach):
    """A rectangle of light that looks at a place from `way`, of size times its reach."""
    light = bpy.data.objects.new(name, bpy.data.lights.new(name, "AREA"))
    scene.collection.objects.link(light)
    light.data.shape, light.data.size, light.data.size_y = "RECTANGLE", size[0] * reach, size[1] * reach
    light.data.energy, light.data.color = strength * reach * reach, color
    light.location = at + Vector(way)
    light.rotation_euler = (at - light.location).to_track_quat("-Z", "Y").to_euler()


def lit(at, front, reach):
    """A window of four panes behind and to the left, a pale wall to the right that returns a little, a dim room."""
    way = Vector((-0.62, 0.50, 0.80)).normalized() * 4 * reach
    across = way.cross(Vector((0, 0, 1))).normalized()
    up = across.cross(way).normalized()
    for i in (-1, 1):
        for j in (-1, 1):
            pane("window", at, way + reach * (0.62 * i * across + 0.62 * j * up), (1.1, 1.1), 62, (1.0, 0.95, 0.87),
                 reach)
    if view == "halves":  # one more, high up, whose mirror image lies on a part of the wet face
        face = Vector((0.10, -0.52, 0.85)).normalized()
        on = front + face * max(face.dot(place - front) for place in places(fruit[:1]))
        on += 0.22 * reach * Vector((-0.85, 0.45, 0.37))
        to = (on - scene.camera.location).normalized()
        pane("skylight", on, (to - 2 * to.dot(face) * face) * 4 * reach, (0.5, 0.34), 6, (0.95, 0.97, 1.0), reach)
    pane("wall", at, (3.2 * reach, -1.6 * reach, 1.8 * reach), (3.0, 2.5), 26, (0.92, 0.95, 1.0), reach)
    scene.world = bpy.data.worlds.new("room")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.72, 0.80, 0.95, 1)
    scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0.2


def photographed(focus, reach):
    """Develops it, with the depth of field of a small aperture."""
    camera = scene.camera.data
    if view in ("halves", "piece"):
        camera.dof.use_dof, camera.dof.focus_distance = True, (scene.camera.location - focus).length
        camera.dof.aperture_fstop = 0.5 * camera.lens / 1000 / (0.045 * reach)
    scene.view_settings.view_transform, scene.view_settings.look = "Filmic", "Very High Contrast"
    scene.view_settings.exposure = 0.4
    developed(scene, int(samples), picture)


scene.render.resolution_x, scene.render.resolution_y = 640, 480
for thing in fruit:
    without_doubles(thing.data)
for one in {slot.material for thing in fruit for slot in thing.material_slots if slot.material}:
    scatter(one)
shown = arranged()
seen = places(shown)
low = Vector([min(place[k] for place in seen) for k in range(3)])
high = Vector([max(place[k] for place in seen) for k in range(3)])
middle, reach = (low + high) / 2, (high - low).length / 2
bpy.ops.mesh.primitive_plane_add(size=60 * reach, location=(middle.x, middle.y, 0))
bpy.context.object.data.materials.append(wood(reach))
scene.camera = camera_on(seen)
front = sum(places(shown[:1]), Vector()) / len(places(shown[:1]))
lit(middle, front, reach)
photographed(front, reach)
