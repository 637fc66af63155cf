"""Materials of Blender from those of a file. How a part takes light is a node group, "tomato gel", which all pieces
share, textured or not, in all their objects: who changes it changes them all. A material joins it with a colour."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional

import bpy

from .glb_file import Image, Look, Material
from .new_data import NewData

# What a group or material was made from: another look of the same name is another group.
MADE_FROM = "pomona_made_from"

# The inputs of a Principled BSDF, as Blender 3 and 4 call them.
NAMES = {
    "specular": ("Specular", "Specular IOR Level"),
    "coat": ("Clearcoat", "Coat Weight"),
    "coat_roughness": ("Clearcoat Roughness", "Coat Roughness"),
    "coat_normal": ("Clearcoat Normal", "Coat Normal"),
    "sheen": ("Sheen", "Sheen Weight"),
    "transmission": ("Transmission", "Transmission Weight"),
    "subsurface": ("Subsurface", "Subsurface Weight"),
    "subsurface_radius": ("Subsurface Radius",),
}


def shader_input(shader: Any, name: str) -> Any:
    """By one of its names; None if this Blender has none such."""
    return next((shader.inputs[word] for word in NAMES.get(name, (name,)) if word in shader.inputs), None)


def set_input(shader: Any, name: str, value: Any) -> None:
    socket = shader_input(shader, name)
    if socket is not None:
        socket.default_value = value


def add_socket(tree: Any, name: str, kind: str, is_input: bool) -> Any:
    """Of a node group, in Blender 3 or 4."""
    if hasattr(tree, "interface"):
        return tree.interface.new_socket(name, in_out="INPUT" if is_input else "OUTPUT", socket_type=kind)
    return (tree.inputs if is_input else tree.outputs).new(kind, name)


def look_group(name: str, look: Look, new: NewData) -> Any:
    """The node group of this look: the one that is there, or a new one.

    Files without textures say nothing of light under the surface, and files with textures have roughness in a map. So
    these two do not tell looks apart, and a group learns of the first when a file tells it."""
    made_from = repr(dataclasses.replace(look, roughness=0.0, subsurface=0.0, subsurface_radius=()))
    for group in bpy.data.node_groups:
        if group.name.split(".")[0] == name and group.get(MADE_FROM) == made_from:
            learn_subsurface(group, look)
            return group
    group = new.kept(bpy.data.node_groups.new(name, "ShaderNodeTree"))
    group[MADE_FROM] = made_from
    for word, kind in (("Color", "NodeSocketColor"), ("Roughness", "NodeSocketFloat"), ("Coat", "NodeSocketFloat"),
                       ("Normal", "NodeSocketVector")):
        socket = add_socket(group, word, kind, True)
        if word == "Coat":
            socket.default_value = 1.0
        if word == "Normal":
            socket.hide_value = True
    add_socket(group, "Shader", "NodeSocketShader", False)
    wire_look(group, look)
    learn_subsurface(group, look)
    return group


def wire_look(group: Any, look: Look) -> None:
    """The nodes within."""
    nodes, links = group.nodes, group.links
    given, shader, out = (nodes.new(kind) for kind in ("NodeGroupInput", "ShaderNodeBsdfPrincipled", "NodeGroupOutput"))
    given.location, out.location = (-500, 0), (400, 0)
    links.new(given.outputs["Color"], shader.inputs["Base Color"])
    links.new(given.outputs["Roughness"], shader.inputs["Roughness"])
    links.new(given.outputs["Normal"], shader.inputs["Normal"])
    links.new(shader.outputs[0], out.inputs["Shader"])
    set_input(shader, "specular", 0.5 * look.specular)
    set_input(shader, "transmission", look.transmission)
    set_input(shader, "Alpha", look.opacity)
    if look.coat > 0:
        times = nodes.new("ShaderNodeMath")
        times.operation, times.location = "MULTIPLY", (-250, -300)
        times.inputs[1].default_value = look.coat
        links.new(given.outputs["Coat"], times.inputs[0])
        links.new(times.outputs[0], shader_input(shader, "coat"))
        set_input(shader, "coat_roughness", look.coat_roughness)
    if max(look.sheen) > 0:
        set_input(shader, "sheen", max(look.sheen))
        set_input(shader, "Sheen Roughness", look.sheen_roughness)


def learn_subsurface(group: Any, look: Look) -> None:
    """Light under the surface, if the group has none yet: what a person has changed stays."""
    nodes, links = group.nodes, group.links
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    if look.subsurface == 0 or shader_input(shader, "subsurface").default_value > 0:
        return
    shader.subsurface_method = "RANDOM_WALK"
    set_input(shader, "subsurface", look.subsurface)
    set_input(shader, "Subsurface Scale", 1.0)  # Blender 4: then the radius is in metres, as in Blender 3
    set_input(shader, "subsurface_radius", [max(way, 1e-5) for way in look.subsurface_radius])
    if "Subsurface Color" in shader.inputs:  # Blender 3: else its own grey
        given = next(node for node in nodes if node.type == "GROUP_INPUT")
        links.new(given.outputs["Color"], shader.inputs["Subsurface Color"])


class Materials:
    """The materials of one file, made when first asked for. new: told of all that is made."""

    def __init__(self, materials: list[Material], images: list[Image], new: NewData) -> None:
        self._materials, self._images, self._new = materials, images, new
        self._made: dict[tuple[int, str], Any] = {}
        self._loaded: dict[int, Any] = {}

    def of(self, index: int, fruit: str) -> Any:
        """The material of this number for a fruit of this name."""
        key = (index, fruit)
        if key not in self._made:
            told = self._materials[index]
            group = look_group(f"{fruit} {told.part}".strip(), told.look, self._new)
            self._made[key] = self._coloured(told, group) if told.color is None else self._textured(told, group)
        return self._made[key]

    def _coloured(self, told: Material, group: Any) -> Any:
        """Shared by all pieces of all fruits with this look."""
        for known in bpy.data.materials:
            if known.get(MADE_FROM) == f"vertices {group.name}":
                return known
        material, nodes, joined = self._begun(group.name, group)
        joined.inputs["Roughness"].default_value = told.look.roughness
        material[MADE_FROM] = f"vertices {group.name}"
        color = nodes.new("ShaderNodeVertexColor")
        color.layer_name, color.location = "Color", (-300, 0)
        material.node_tree.links.new(color.outputs["Color"], joined.inputs["Color"])
        return material

    def _textured(self, told: Material, group: Any) -> Any:
        """Of one piece: its texture is its own. The same texture once more is the same material."""
        assert told.color is not None
        made_from = f"{self._images[told.color].digest} {group.name}"
        for known in bpy.data.materials:
            if known.get(MADE_FROM) == made_from:
                return known
        material, nodes, joined = self._begun(told.name, group)
        joined.inputs["Roughness"].default_value = told.look.roughness
        material[MADE_FROM] = made_from
        links = material.node_tree.links
        links.new(self._texture(nodes, told.color, True, 0).outputs["Color"], joined.inputs["Color"])
        if told.roughness is not None:
            self._channel(material, self._texture(nodes, told.roughness, False, 1), "Green", joined.inputs["Roughness"])
        if told.coat is not None:
            self._channel(material, self._texture(nodes, told.coat, False, 2), "Red", joined.inputs["Coat"])
        if told.normal is not None:
            normal = nodes.new("ShaderNodeNormalMap")
            normal.uv_map, normal.location = "uv", (-250, -900)
            links.new(self._texture(nodes, told.normal, False, 3).outputs["Color"], normal.inputs["Color"])
            links.new(normal.outputs["Normal"], joined.inputs["Normal"])
        return material

    def _begun(self, name: str, group: Any) -> tuple[Any, Any, Any]:
        """A material, its nodes, and the node that is the group."""
        material = self._new.kept(bpy.data.materials.new(name))
        material.use_nodes = True
        nodes = material.node_tree.nodes
        nodes.clear()
        joined, out = nodes.new("ShaderNodeGroup"), nodes.new("ShaderNodeOutputMaterial")
        joined.node_tree, out.location = group, (300, 0)
        material.node_tree.links.new(joined.outputs["Shader"], out.inputs["Surface"])
        if told_opacity(group) < 1:
            material.blend_method = "BLEND"
        return material, nodes, joined

    def _texture(self, nodes: Any, index: int, is_color: bool, row: int) -> Any:
        node = nodes.new("ShaderNodeTexImage")
        node.image, node.location, node.extension = self._image(index, is_color), (-600, -300 * row), "EXTEND"
        return node

    def _channel(self, material: Any, texture: Any, channel: str, to: Any) -> None:
        split = material.node_tree.nodes.new("ShaderNodeSeparateColor")
        split.location = (-250, texture.location[1])
        material.node_tree.links.new(texture.outputs["Color"], split.inputs["Color"])
        material.node_tree.links.new(split.outputs[channel], to)

    def _image(self, index: int, is_color: bool) -> Any:
        """Packed into the .blend file."""
        if index not in self._loaded:
            told = self._images[index]
            image = self._new.kept(bpy.data.images.new(told.name, 8, 8))
            image.source = "FILE"
            image.pack(data=told.data, data_len=len(told.data))
            image.colorspace_settings.name = "sRGB" if is_color else "Non-Color"
            self._loaded[index] = image
        return self._loaded[index]


def told_opacity(group: Any) -> float:
    """Of a group that look_group() made."""
    shader = next(node for node in group.nodes if node.type == "BSDF_PRINCIPLED")
    value: float = shader.inputs["Alpha"].default_value
    return value


def fruit_of(template: Optional[str], name: str) -> str:
    """What a part's look is named after: "tomato" of the template "fruits/tomato.toml", else of the piece
    "tomato.piece-2"."""
    if template:
        return template.replace("\\", "/").rsplit("/", 1)[-1].removesuffix(".toml")
    return name.split(".")[0]
