"""What a .glb holds, read without any library."""

import json
import pathlib
import struct


class Glb:
    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        length, = struct.unpack_from("<I", data, 12)
        self.json = json.loads(data[20:20 + length])
        self.buffer = data[28 + length:]

    def triangles(self, mesh):
        """All triangles of a mesh, as numbers of its vertices."""
        found = []
        for primitive in mesh["primitives"]:
            accessor = self.json["accessors"][primitive["indices"]]
            at = self.json["bufferViews"][accessor["bufferView"]]["byteOffset"]
            kind = {5123: "H", 5125: "I"}[accessor["componentType"]]
            numbers = struct.unpack_from(f"<{accessor['count']}{kind}", self.buffer, at)
            found += [numbers[i:i + 3] for i in range(0, len(numbers), 3)]
        return found

    def values(self, number):
        """The values of an accessor, a tuple each."""
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        kind = struct.Struct(f"<{width}" + {5121: "B", 5123: "H", 5125: "I", 5126: "f"}[accessor["componentType"]])
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", kind.size)
        return [kind.unpack_from(self.buffer, begin + i * stride) for i in range(accessor["count"])]

    def nodes_with_meshes(self):
        """The nodes of the scene that show a mesh: name to node."""
        shown, waiting = {}, list(self.json["scenes"][0]["nodes"])
        while waiting:
            node = self.json["nodes"][waiting.pop()]
            waiting += node.get("children", [])
            if "mesh" in node:
                shown[node["name"]] = node
        return shown
