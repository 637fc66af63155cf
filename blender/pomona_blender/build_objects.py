"""Objects of Blender from a file: a root's pieces, and its levels of detail in a hidden collection."""

from __future__ import annotations

from typing import Any, Iterator, Optional, Sequence

import bpy
import numpy
from mathutils import Matrix

from .build_material import MADE_FROM, Materials
from .build_mesh import fill_mesh
from .frames import place_for_blender
from .glb_file import Model, Placed
from .lay_out import laid_face_up
from .new_data import NewData

PIECE = "pomona_piece"  # its number, from 0
PLACED = "pomona_placed"  # where it was put: whoever moves it moves it for good
LEVEL = "pomona_level"  # 1 is the finest
DISH = "blender-dish"  # the name, in scenes that are written here, of what is in Blender already


def pieces_of(root: Any) -> list[Any]:
    """In the order of cutting."""
    return sorted((child for child in root.children if PIECE in child and LEVEL not in child),
                  key=lambda child: int(child[PIECE]))


def levels_of(root: Any) -> list[Any]:
    return [child for child in root.children if LEVEL in child]


def build(root: Any, model: Model, new: NewData, keep_objects: bool) -> Iterator[None]:
    """Gives the root these pieces in place of what it has, a mesh at each step.

    Objects and meshes that are there are used again, so that modifiers and links stay.
    keep_objects  takes none away, so that a moving knife that leaves the fruit may come back
    """
    name = root.name
    materials = Materials(model.materials, model.images, new)
    objects = pieces_of(root)
    shown = [placed for placed in model.placed if placed.name != DISH]
    spare = unique_meshes(objects)
    meshes: dict[int, Any] = {}
    for placed in shown:
        if placed.mesh not in meshes:
            told = model.meshes[placed.mesh]
            meshes[placed.mesh] = mesh = spare.pop(0) if spare else new.kept(bpy.data.meshes.new(told.name))
            mesh.name = told.name
            fill_mesh(mesh, told, materials)
            yield
    for mesh in spare:
        mesh.clear_geometry()
    root = bpy.data.objects[name]  # after a yield it may lie elsewhere
    places = places_of(model, shown, root.pomona.face_up)
    collection = collection_of(root)
    for number, placed in enumerate(shown):
        thing = objects[number] if number < len(objects) else None
        if thing is None:
            thing = new.kept(bpy.data.objects.new(placed.name, meshes[placed.mesh]))
            thing[PIECE] = number
            thing.parent = root
            collection.objects.link(thing)
        elif thing.data != meshes[placed.mesh]:
            thing.data = meshes[placed.mesh]
        put(thing, places[number])
    if not keep_objects:
        for thing in objects[len(shown):]:
            bpy.data.objects.remove(thing)
            new.took_away()
    yield from build_levels(root, model, materials, new)
    clear_unused(spare, new)


def unique_meshes(objects: Sequence[Any]) -> list[Any]:
    """Meshes of these objects that nobody else uses."""
    meshes: dict[str, list[Any]] = {}
    for thing in objects:
        meshes.setdefault(thing.data.name, []).append(thing)
    return [users[0].data for users in meshes.values() if users[0].data.users == len(users)]


def places_of(model: Model, shown: Sequence[Placed], face_up: bool) -> list[Any]:
    """4 x 4 for each piece, in the frame of the root."""
    if face_up:
        return laid_face_up([model.meshes[placed.mesh] for placed in shown])
    return [place_for_blender(placed.place) for placed in shown]


def put(thing: Any, place: Any) -> None:
    """To its place below its root, unless a person has moved it."""
    was = thing.get(PLACED)
    if was is not None and not numpy.allclose(was, numpy.array(thing.matrix_basis).ravel(), atol=1e-6):
        return
    thing.matrix_basis = Matrix(place.tolist())
    thing[PLACED] = numpy.array(thing.matrix_basis).ravel().tolist()


def collection_of(root: Any) -> Any:
    return root.users_collection[0] if root.users_collection else bpy.context.scene.collection


def build_levels(root: Any, model: Model, materials: Materials, new: NewData) -> Iterator[None]:
    """Levels of detail, in a collection beside the root's that neither the window nor a picture shows."""
    for old in levels_of(root):
        mesh = old.data
        bpy.data.objects.remove(old)
        clear_unused([mesh], new)
        new.took_away()
    if not any(placed.levels for placed in model.placed):
        return
    collection = levels_collection(root, new)
    for number, placed in enumerate(model.placed):
        for level, index in enumerate(placed.levels, 1):
            told = model.meshes[index]
            mesh = new.kept(bpy.data.meshes.new(told.name))
            fill_mesh(mesh, told, materials)
            thing = new.kept(bpy.data.objects.new(f"{placed.name}_LOD{level}", mesh))
            thing[PIECE], thing[LEVEL] = number, level
            thing.parent = root
            collection.objects.link(thing)
            put(thing, place_for_blender(placed.place))
            yield


def levels_collection(root: Any, new: NewData) -> Any:
    name = f"{root.name} levels of detail"
    collection: Optional[Any] = bpy.data.collections.get(name)
    if collection is None:
        collection = new.kept(bpy.data.collections.new(name))
        collection_of(root).children.link(collection)
    collection.hide_viewport = collection.hide_render = True
    return collection


def clear_unused(meshes: Sequence[Any], new: NewData) -> None:
    """Takes away what nobody uses any more: these meshes, and materials and textures that this add-on has made."""
    for mesh in meshes:
        if mesh.users == 0:
            bpy.data.meshes.remove(mesh)
            new.took_away()
    for blocks in (bpy.data.materials, bpy.data.node_groups):
        for block in [one for one in blocks if MADE_FROM in one and one.users == 0]:
            images = [node.image for node in getattr(block, "node_tree", block).nodes if node.type == "TEX_IMAGE"]
            blocks.remove(block)
            new.took_away()
            for image in {one.name: one for one in images if one is not None}.values():
                if image.users == 0:
                    bpy.data.images.remove(image)
