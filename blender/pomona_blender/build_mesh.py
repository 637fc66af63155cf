"""A mesh of Blender from a piece of a file."""

from __future__ import annotations

from typing import Any

import numpy

from .build_material import Materials, fruit_of
from .frames import points_for_blender
from .glb_file import Mesh

# What a piece tells of itself, as custom properties of its mesh.
TOLD = ("template", "seed", "index", "knife", "piece", "command", "volume", "density", "mass", "center", "closed")


def fill_mesh(mesh: Any, piece: Mesh, materials: Materials) -> None:
    """Gives a mesh of Blender the shape, colours and materials of a piece in place of its own."""
    mesh.clear_geometry()
    corners = piece.triangles.ravel()
    mesh.vertices.add(len(piece.positions))
    mesh.loops.add(len(corners))
    mesh.polygons.add(len(piece.triangles))
    mesh.vertices.foreach_set("co", points_for_blender(piece.positions).ravel())
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, len(corners), 3, dtype=numpy.int32))
    if len(mesh.polygons) and not mesh.polygons[0].loop_total:  # Blender 3: later ones know it from the starts
        mesh.polygons.foreach_set("loop_total", numpy.full(len(piece.triangles), 3, numpy.int32))
    mesh.polygons.foreach_set("use_smooth", numpy.ones(len(piece.triangles), bool))
    set_materials(mesh, piece, materials)
    set_attributes(mesh, piece, corners)
    mesh.update(calc_edges=True)
    if hasattr(mesh, "use_auto_smooth"):  # Blender 3: else it ignores normals of its own
        mesh.use_auto_smooth = True
    mesh.normals_split_custom_set_from_vertices(points_for_blender(piece.normals))
    for name in TOLD:
        if name in piece.extras:
            mesh[name] = kept_value(piece.extras[name])


def kept_value(value: Any) -> Any:
    """As a custom property: whole numbers have 32 bits there, and an index may have more."""
    return str(value) if isinstance(value, int) and value.bit_length() > 31 else value


def set_materials(mesh: Any, piece: Mesh, materials: Materials) -> None:
    """A slot for each material that a triangle has."""
    fruit = fruit_of(piece.extras.get("template"), piece.name)
    used, slots = numpy.unique(piece.materials, return_inverse=True)
    mesh.materials.clear()
    for index in used:
        mesh.materials.append(materials.of(int(index), fruit))
    mesh.polygons.foreach_set("material_index", slots.astype(numpy.int32).ravel())


def set_attributes(mesh: Any, piece: Mesh, corners: Any) -> None:
    """Colours or texture coordinates, and parts."""
    if piece.colors is not None:
        colors = mesh.color_attributes.new("Color", "FLOAT_COLOR", "POINT")
        colors.data.foreach_set("color", numpy.ascontiguousarray(piece.colors, numpy.float32).ravel())
    if piece.uv is not None:
        layer = mesh.uv_layers.new(name="uv")
        uv = piece.uv[corners].astype(numpy.float32)
        uv[:, 1] = 1 - uv[:, 1]
        layer.data.foreach_set("uv", uv.ravel())
    if piece.parts is not None:
        mesh.attributes.new("part", "INT", "POINT").data.foreach_set("value", piece.parts.ravel().astype(numpy.int32))
