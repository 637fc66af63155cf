"""Reads the .glb files that Pomona writes: docs/reference/formats.md. Arrays are views of the file's bytes where its
numbers are as Blender wants them. Axes stay those of the file: metres, +Y up."""

from __future__ import annotations

import hashlib
import json
import struct
from dataclasses import dataclass, field
from typing import Any, Optional

import numpy

COMPONENTS = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


@dataclass(frozen=True)
class Look:
    """How a part takes light, apart from its colour. Lengths are metres.

    sheen  colour, linear; black means none
    """

    roughness: float = 0.5
    specular: float = 1.0
    coat: float = 0.0
    coat_roughness: float = 0.0
    sheen: tuple[float, ...] = (0.0, 0.0, 0.0)
    sheen_roughness: float = 0.0
    transmission: float = 0.0
    subsurface: float = 0.0
    subsurface_radius: tuple[float, ...] = (0.0, 0.0, 0.0)
    opacity: float = 1.0


@dataclass(frozen=True)
class Material:
    """A look with its maps: indices of images, or None.

    part  what it is of, as "gel" or "skin cut"; "" if the fruit has one material alone
    """

    name: str
    part: str
    look: Look
    color: Optional[int] = None
    normal: Optional[int] = None
    roughness: Optional[int] = None
    coat: Optional[int] = None


@dataclass
class Mesh:
    """A piece.

    positions, normals  n x 3; metres from the piece's centre of mass
    colors              n x 4, linear; None where `uv` (n x 2, the origin above) is in their place
    parts               n numbers in extras["parts"]
    triangles           m x 3; `materials` says which one each triangle has
    """

    name: str
    positions: Any
    normals: Any
    colors: Any
    uv: Any
    parts: Any
    triangles: Any
    materials: Any
    extras: dict[str, Any]


@dataclass
class Placed:
    """A mesh where it lies. place: 4 x 4. levels: meshes of its further levels of detail, the finest first."""

    name: str
    mesh: int
    place: Any
    levels: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class Image:
    """data: of a PNG. digest: of the data, made where the file is read, off the main thread."""

    name: str
    data: bytes
    digest: str


@dataclass
class Model:
    """All that a file holds."""

    meshes: list[Mesh]
    placed: list[Placed]
    materials: list[Material]
    images: list[Image]

    @property
    def size(self) -> int:
        """Bytes, about."""
        arrays = sum(mesh.positions.nbytes + mesh.normals.nbytes + mesh.triangles.nbytes for mesh in self.meshes)
        return int(2 * arrays) + sum(len(image.data) for image in self.images)


class GlbReader:
    """The two chunks of a file, and what they hold."""

    def __init__(self, data: bytes) -> None:
        magic, version, _ = struct.unpack_from("<4sII", data)
        if magic != b"glTF" or version != 2:
            raise ValueError("not a .glb file")
        length = struct.unpack_from("<I", data, 12)[0]
        self.json: dict[str, Any] = json.loads(data[20:20 + length])
        self.binary = memoryview(data)[28 + length:]

    def view(self, index: int) -> memoryview:
        view = self.json["bufferViews"][index]
        start = view.get("byteOffset", 0)
        return self.binary[start:start + view["byteLength"]]

    def array(self, index: int) -> Any:
        """n x width numbers; shares of the largest number where they are normalized."""
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        kind, width = numpy.dtype(COMPONENTS[accessor["componentType"]]), WIDTHS[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        row = view.get("byteStride", width * kind.itemsize)
        array: Any = numpy.ndarray((accessor["count"], width), kind, self.binary, start, (row, kind.itemsize))
        if accessor.get("normalized"):
            array = array.astype(numpy.float32) / numpy.float32(numpy.iinfo(kind).max)
        return array

    def optional(self, attributes: dict[str, int], name: str) -> Any:
        return self.array(attributes[name]) if name in attributes else None

    def mesh(self, index: int) -> Mesh:
        told = self.json["meshes"][index]
        primitives = told["primitives"]
        attributes = primitives[0]["attributes"]
        triangles = [self.array(one["indices"]).reshape(-1, 3) for one in primitives]
        materials = [numpy.full(len(own), one.get("material", 0), numpy.int32)
                     for own, one in zip(triangles, primitives)]
        return Mesh(told["name"], self.array(attributes["POSITION"]), self.array(attributes["NORMAL"]),
                    self.optional(attributes, "COLOR_0"), self.optional(attributes, "TEXCOORD_0"),
                    self.optional(attributes, "_PART"), numpy.concatenate(triangles).astype(numpy.int32),
                    numpy.concatenate(materials), told.get("extras", {}))

    def image_of(self, texture: Optional[dict[str, Any]]) -> Optional[int]:
        if texture is None:
            return None
        source: int = self.json["textures"][texture["index"]]["source"]
        return source

    def material(self, told: dict[str, Any]) -> Material:
        metal, more = told.get("pbrMetallicRoughness", {}), told.get("extensions", {})
        coat, sheen = more.get("KHR_materials_clearcoat", {}), more.get("KHR_materials_sheen", {})
        inside = told.get("extras", {}).get("subsurface", {})
        look = Look(
            roughness=metal.get("roughnessFactor", 1.0),
            specular=more.get("KHR_materials_specular", {}).get("specularFactor", 1.0),
            coat=coat.get("clearcoatFactor", 0.0), coat_roughness=coat.get("clearcoatRoughnessFactor", 0.0),
            sheen=tuple(sheen.get("sheenColorFactor", (0.0, 0.0, 0.0))),
            sheen_roughness=sheen.get("sheenRoughnessFactor", 0.0),
            transmission=more.get("KHR_materials_transmission", {}).get("transmissionFactor", 0.0),
            subsurface=inside.get("weight", 0.0), subsurface_radius=tuple(inside.get("radius", (0.0, 0.0, 0.0))),
            opacity=metal.get("baseColorFactor", (1, 1, 1, 1))[3])
        color = self.image_of(metal.get("baseColorTexture"))
        # "tomato.piece-2 skin cut" has the texture "tomato.piece-2"; without textures it is "tomato skin cut".
        name = told["name"]
        before = self.json["images"][color]["name"] if color is not None else name.split(" ")[0]
        return Material(name, name[len(before):].strip(), look, color, self.image_of(told.get("normalTexture")),
                        self.image_of(metal.get("metallicRoughnessTexture")),
                        self.image_of(coat.get("clearcoatTexture")))

    def placed(self) -> list[Placed]:
        """All nodes of the scene with a mesh, in the order of the file."""
        nodes, found = self.json["nodes"], []

        def visit(index: int, above: Any) -> None:
            node = nodes[index]
            place = above @ place_of(node)
            if "mesh" in node:
                levels = node.get("extensions", {}).get("MSFT_lod", {}).get("ids", [])
                found.append(Placed(node["name"], node["mesh"], place, [nodes[one]["mesh"] for one in levels]))
            for child in node.get("children", []):
                visit(child, place)

        for root in self.json["scenes"][self.json.get("scene", 0)].get("nodes", []):
            visit(root, numpy.eye(4))
        return found

    def model(self) -> Model:
        images = [read_image(one["name"], bytes(self.view(one["bufferView"]))) for one in self.json.get("images", [])]
        return Model([self.mesh(index) for index in range(len(self.json.get("meshes", [])))], self.placed(),
                     [self.material(one) for one in self.json.get("materials", [])], images)


def read_image(name: str, data: bytes) -> Image:
    return Image(name, data, hashlib.sha256(data).hexdigest())


def place_of(node: dict[str, Any]) -> Any:
    """4 x 4 of a node's rotation and translation."""
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    place = numpy.eye(4)
    place[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    place[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return place


def read_glb(data: bytes) -> Model:
    """A file that Pomona has written. ValueError if it is no .glb."""
    return GlbReader(data).model()
