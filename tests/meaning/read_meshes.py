"""Every mesh format of the program, read without the program's code: named things at their places in the scene.

Each reader gives a list of Placed, in the order of the file. A corner is (position, normal, colour): metres, unit, linear;
None where the format has none.
"""

import json
import re
import struct
import zlib
from dataclasses import dataclass, field

from png import Picture
from vectors import add, cross, linear, sub, times, turned, unit


@dataclass
class Placed:
    name: str
    triangles: list = field(default_factory=list)  # of three corners each
    parts: list = field(default_factory=list)  # the name of each triangle's part, where the format says it
    facts: dict = field(default_factory=dict)  # what stands beside the mesh: glTF's extras, USD's customData


SIZES = {"BYTE": "b", 5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def srgb8(color):
    return tuple(linear(c / 255) for c in color)


class Glb:
    def __init__(self, file):
        data = file.read_bytes()
        size, = struct.unpack_from("<I", data, 12)
        self.json = json.loads(data[20:20 + size])
        self.buffer = data[20 + size + 8:]

    def view(self, number):
        view = self.json["bufferViews"][number]
        at = view.get("byteOffset", 0)
        return self.buffer[at:at + view["byteLength"]], view.get("byteStride")

    def values(self, number):
        accessor = self.json["accessors"][number]
        data, stride = self.view(accessor["bufferView"])
        kind, count = SIZES[accessor["componentType"]], COUNTS[accessor["type"]]
        one = struct.calcsize(f"<{count}{kind}")
        rows = [struct.unpack_from(f"<{count}{kind}", data, accessor.get("byteOffset", 0) + i * (stride or one))
                for i in range(accessor["count"])]
        if accessor.get("normalized"):
            most = (1 << 8 * struct.calcsize(kind)) - 1
            rows = [tuple(v / most for v in row) for row in rows]
        return [row[0] for row in rows] if count == 1 else rows

    def texture(self, primitive):
        """The picture of the base colour."""
        material = self.json["materials"][primitive["material"]]
        index = material["pbrMetallicRoughness"]["baseColorTexture"]["index"]
        return Picture(self.view(self.json["images"][self.json["textures"][index]["source"]]["bufferView"])[0])

    def mesh(self, number):
        """Triangles and their parts, in the mesh's own frame."""
        mesh = self.json["meshes"][number]
        names = mesh.get("extras", {}).get("parts", [])
        triangles, parts = [], []
        for primitive in mesh["primitives"]:
            attributes = primitive["attributes"]
            position, normal = self.values(attributes["POSITION"]), self.values(attributes["NORMAL"])
            part = self.values(attributes["_PART"]) if "_PART" in attributes else None
            color, places = None, None
            if "COLOR_0" in attributes:
                color = [row[:3] for row in self.values(attributes["COLOR_0"])]
            elif "TEXCOORD_0" in attributes:
                places, picture = self.values(attributes["TEXCOORD_0"]), self.texture(primitive)
            index = self.values(primitive["indices"])
            for t in range(0, len(index), 3):
                ids = index[t:t + 3]
                shown = [color[i] for i in ids] if color else [None] * 3
                if places:
                    shown = textured(picture, [places[i] for i in ids], from_below=False)
                triangles.append([(position[i], normal[i], c) for i, c in zip(ids, shown)])
                parts.append(names[part[ids[0]]] if part and part[ids[0]] < len(names) else None)
        return triangles, parts

    def placed(self, level=None):
        """The scene's meshes; with a level, the nodes that MSFT_lod names instead of those in the scene."""
        found = []
        for root in self.json["scenes"][0]["nodes"]:
            self._walk(root, [], found, level)
        return found

    def _walk(self, number, above, found, level):
        node = self.json["nodes"][number]
        way = [node] + above  # from the inside out
        for child in node.get("children", []):
            self._walk(child, way, found, level)
        if "mesh" not in node:
            return
        shown = node["mesh"]
        if level:
            lower = node["extensions"]["MSFT_lod"]["ids"][level - 1]
            shown = self.json["nodes"][lower]["mesh"]
        mesh = self.json["meshes"][node["mesh"]]
        triangles, parts = self.mesh(shown)
        instancing = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
        places, names = [{}], [node["name"]]
        if instancing:
            move, turn = (self.values(instancing["attributes"][key]) for key in ("TRANSLATION", "ROTATION"))
            places = [{"translation": m, "rotation": r} for m, r in zip(move, turn, strict=True)]
            names = node["extras"]["instances"]
            assert len(names) == len(places), "a name for each place"
        for name, place in zip(names, places, strict=True):
            found.append(Placed(name, [moved(t, [place] + way) for t in triangles], parts, mesh.get("extras", {})))


def moved(triangle, nodes):
    """The point transformed by a chain of glTF's nodes, the innermost first."""
    for node in nodes:
        assert "scale" not in node and "matrix" not in node
        x, y, z, w = node.get("rotation", (0, 0, 0, 1))
        shift = node.get("translation", (0, 0, 0))
        triangle = [(add(turned((w, x, y, z), p), shift), turned((w, x, y, z), n), c) for p, n, c in triangle]
    return triangle


def textured(picture, places, *, from_below):
    """The colour of the triangle's middle, for all three corners."""
    u, v = (sum(place[k] for place in places) / 3 for k in (0, 1))
    if from_below:
        v = 1 - v
    texel = picture.at(min(int(u * picture.width), picture.width - 1), min(int(v * picture.height), picture.height - 1))
    return [srgb8(texel[:3])] * 3


def read_glb(file, level=None):
    return Glb(file).placed(level)


def read_obj(file):
    places, colors, normals, found = [], [], [], []
    for line in file.read_text().splitlines():
        words = line.split()
        if line.startswith("o "):
            found.append(Placed(words[1]))
        elif line.startswith("v "):
            values = [float(w) for w in words[1:]]
            places.append(tuple(values[:3]))
            colors.append(tuple(linear(c) for c in values[3:6]) if len(values) > 3 else None)
        elif line.startswith("vn "):
            normals.append(tuple(float(w) for w in words[1:]))
        elif line.startswith("f "):
            corners = [(int(w.split("/")[0]) - 1, int(w.split("/")[2]) - 1) for w in words[1:]]
            found[-1].triangles.append([(places[p], normals[n], colors[p]) for p, n in corners])
    return found


def read_stl(file):
    """Millimetres become metres; one thing without a name."""
    data = file.read_bytes()
    count, = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count
    placed = Placed("")
    for i in range(count):
        v = struct.unpack_from("<12f", data, 84 + 50 * i)
        placed.triangles.append([(times(v[3 * k:3 * k + 3], 1e-3), v[:3], None) for k in (1, 2, 3)])
    return [placed]


def ply_rows(file):
    """The header's comments, and the rows of each element as dictionaries."""
    data = file.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    sizes = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
    comments, elements, at = [], [], end
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "comment":
            comments.append(line[8:])
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    rows = {}
    for name, count, properties in elements:
        rows[name] = []
        for _ in range(count):
            row = {}
            for words in properties:
                if words[0] == "list":
                    n, = struct.unpack_from("<" + sizes[words[1]], data, at)
                    at += struct.calcsize(sizes[words[1]])
                    row[words[3]] = struct.unpack_from(f"<{n}{sizes[words[2]]}", data, at)
                    at += n * struct.calcsize(sizes[words[2]])
                else:
                    row[words[1]], = struct.unpack_from("<" + sizes[words[0]], data, at)
                    at += struct.calcsize(sizes[words[0]])
            rows[name].append(row)
    assert at == len(data)
    return comments, rows


def read_ply(file):
    comments, rows = ply_rows(file)
    named = {kind: {int(n): name for n, name in re.findall(rf"^{kind} (\d+) (.*)$", "\n".join(comments), re.M)}
             for kind in ("piece", "part")}
    found = [Placed(named["piece"][i]) for i in sorted(named["piece"])]
    corners = [((v["x"], v["y"], v["z"]), (v["nx"], v["ny"], v["nz"]), srgb8((v["red"], v["green"], v["blue"])))
               for v in rows["vertex"]]
    for face in rows["face"]:
        ids = face["vertex_indices"]
        found[face["piece"]].triangles.append([corners[i] for i in ids])
        found[face["piece"]].parts.append(named["part"].get(rows["vertex"][ids[0]]["part"]))
    return found


# USD: the text as a tree of prims, as far as the program writes it.

class Prim:
    def __init__(self, kind, name, about):
        self.kind, self.name, self.about = kind, name, about
        self.lines, self.children = [], []

    def child(self, name):
        return next((c for c in self.children if c.name == name), None)

    def value(self, name, default=None):
        """The value after `name =`, with numbers as tuples and lists."""
        for line in self.lines:
            found = re.match(rf"(?:[\w\[\]]+ )+{re.escape(name)} = (.*)$", line)
            if found:
                text = re.sub(r" \(interpolation = \"\w+\"\)$", "", found[1])
                return json.loads(text.replace("(", "[").replace(")", "]"))
        return default

    def shown_name(self):
        found = re.search(r'displayName = "((?:[^"\\]|\\.)*)"', self.about)
        return re.sub(r"\\(.)", r"\1", found[1]) if found else self.name

    def walk(self):
        yield self
        for child in self.children:
            yield from child.walk()


def usd_tree(text):
    root = Prim("", "", "")
    stack, lines = [root], iter(text.splitlines())
    for line in lines:
        line = line.strip()
        begins = re.match(r'(?:def|class|over) (?:(\w+) )?"(\w+)"', line)
        choice = re.match(r'(?:variantSet )?"(\w+)" (?:= )?\{$', line)
        if begins:
            about = line
            for further in lines:  # what is said in brackets, up to a { of its own
                bare = re.sub(r'"(?:[^"\\]|\\.)*"', "", about)
                if further.strip() == "{" and bare.count("(") == bare.count(")"):
                    break
                about += "\n" + further.strip()
            stack.append(Prim(begins[1] or "over", begins[2], about))
            stack[-2].children.append(stack[-1])
        elif choice:
            stack.append(Prim("variant", choice[1], ""))
            stack[-2].children.append(stack[-1])
        elif line == "}" and len(stack) > 1:
            stack.pop()
        else:
            stack[-1].lines.append(line)
    return root


def usd_corners(mesh, folder, material_file):
    points, normals, index = (mesh.value(k) for k in ("points", "normals", "faceVertexIndices"))
    assert set(mesh.value("faceVertexCounts")) == {3}
    colors, places = mesh.value("primvars:displayColor"), mesh.value("primvars:st")
    picture = Picture((folder / material_file).read_bytes()) if places and material_file else None
    triangles = []
    for t in range(0, len(index), 3):
        ids = index[t:t + 3]
        shown = [tuple(colors[i]) for i in ids] if colors else [None] * 3
        if picture:
            shown = textured(picture, [places[i] for i in ids], from_below=True)
        triangles.append([(tuple(points[i]), unit(normals[i]), c) for i, c in zip(ids, shown)])
    return triangles


def read_usda(file, level=None):
    root = usd_tree(file.read_text())
    pieces = {}
    for piece in root.child("Pieces").children:
        meshes = [prim for prim in piece.walk() if prim.kind == "Mesh"]
        mesh = meshes[level or 0]
        named = re.findall(r"inputs:file = @\./([^@]+)@", "\n".join(line for p in piece.walk() for line in p.lines))
        triangles = usd_corners(mesh, file.parent, named[0] if named else None)
        names = json.loads(re.search(r"string\[\] parts = (\[.*\])", piece.about)[1])
        part = mesh.value("primvars:part")
        parts = [names[part[i]] for i in mesh.value("faceVertexIndices")[::3]] if part else []
        pieces[piece.name] = (triangles, parts, usd_facts(piece), piece.shown_name())
    found = []
    for prim in root.child("Scene").walk():
        reference = re.search(r"references = </Pieces/(\w+)>", prim.about)
        if prim.kind == "PointInstancer":
            kinds = [re.search(r"/(\w+)$", w)[1] for w in re.findall(r"<([^>]+)>", next(line for line in prim.lines if "prototypes" in line))]
            for which, place, turn in zip(prim.value("protoIndices"), prim.value("positions"), prim.value("orientationsf"), strict=True):
                triangles, parts, facts, name = pieces[kinds[which]]
                found.append(Placed(name, [usd_moved(t, turn, place) for t in triangles], parts, facts))
        elif reference and any("xformOp:translate" in line for line in prim.lines):
            triangles, parts, facts, _ = pieces[reference[1]]
            place, turn = prim.value("xformOp:translate"), prim.value("xformOp:orient", [1, 0, 0, 0])
            found.append(Placed(prim.shown_name(), [usd_moved(t, turn, place) for t in triangles], parts, facts))
    return found


def usd_facts(piece):
    """customData, and the physical data."""
    facts = {}
    for kind, name, text in re.findall(r"^(double3?|double\[\]|matrix3d|uint64|int|bool|string(?:\[\])?) (\w+) = (.*)$", piece.about, re.M):
        facts[name] = json.loads(text.replace("(", "[").replace(")", "]")) if not kind.startswith("bool") else text
    for line in piece.lines:
        found = re.match(r"\w+ (physics:\w+) = (.*)$", line)
        if found:
            facts[found[1]] = json.loads(found[2].replace("(", "[").replace(")", "]"))
    return facts


def usd_moved(triangle, turn, place):
    return [(add(turned(tuple(turn), p), place), turned(tuple(turn), n), c) for p, n, c in triangle]


def numbers(text):
    return [float(w) for w in re.findall(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?", text)]


def read_pov(file):
    """The .pov and its meshes beside it, in metres."""
    text = file.read_text()
    metres = float(re.search(r"a unit is (\S+) metres", text)[1])
    meshes = {}
    for name, body in re.findall(r"#declare (Mesh_\d+) = mesh2 \{\n(.*?)\n\}", file.with_name(file.stem + "_meshes.inc").read_text(), re.S):
        def rows(key, size, body=body):
            inside = re.search(key + r"\{\d+,\n(.*?)\}\n", body, re.S)[1]
            values = numbers(inside)
            return [tuple(values[i:i + size]) for i in range(0, len(values), size)]
        scale = float(re.search(r"scale (\S+)$", body)[1])
        places, normals = rows("vertex_vectors", 3), rows("normal_vectors", 3)
        colors = [tuple(numbers(t)[:3]) for t in re.findall(r"rgbt?<([^>]*)>", body)]
        faces = numbers(re.search(r"face_indices\{\d+,\n(.*?)\}\n", body, re.S)[1])
        # A face has three corners, and one texture or three.
        count = int(re.search(r"face_indices\{(\d+)", body)[1])
        size = len(faces) // count
        meshes[name] = []
        for f in range(0, len(faces), size):
            ids, shown = faces[f:f + 3], faces[f + 3:f + size]
            shown = shown * 3 if len(shown) == 1 else shown
            meshes[name].append([(times(places[int(i)], scale * metres), unit(normals[int(i)]), colors[int(c)])
                                 for i, c in zip(ids, shown)])
    found = []
    for mesh, matrix, name in re.findall(r"object \{ (Mesh_\d+) matrix <([^>]*)> \} // (.*)$", text, re.M):
        m = numbers(matrix)
        axes, shift = [tuple(m[i:i + 3]) for i in (0, 3, 6)], times(m[9:12], metres)
        def turn(p, axes=axes):
            return add(add(times(axes[0], p[0]), times(axes[1], p[1])), times(axes[2], p[2]))
        found.append(Placed(name, [[(add(turn(p), shift), turn(n), c) for p, n, c in t] for t in meshes[mesh]]))
    return found


def read_pomona(file):
    """An asset's surfaces, in the fruit's frame; colours of the front, linear, and the name of the front's part."""
    data = zlib.decompress(file.read_bytes()[8:])
    size, = struct.unpack_from("<I", data)
    head, at = json.loads(data[4:4 + size]), 4 + size

    def planes(before, width, count, differences=True):
        nonlocal at
        parts = [data[at + k * count:at + (k + 1) * count] for k in range(width)]
        at += count * width
        values, most = [], 1 << 8 * width
        for i in range(count):
            folded = sum(parts[k][i] << 8 * k for k in range(width))
            value = -(folded + 1) // 2 if folded & 1 else folded // 2
            values.append((value + (values[i - before] if differences and i >= before else 0)) % most)
        return values

    vertices, triangles = head["vertices"], head["triangles"]
    axes = [planes(1, 2, vertices) for _ in range(3)]
    front = [planes(1, 1, vertices) for _ in range(3)]
    for _ in range(3):
        planes(1, 1, vertices, differences=False)
    corners = [planes(2, 3, triangles) for _ in range(3)]
    planes(1, 1, triangles)
    part = planes(1, 2, triangles)
    place = [tuple(head["origin"][k] + head["spacing"] * (axes[k][v] + 0.5) / head["units"] for k in range(3))
             for v in range(vertices)]
    color = [srgb8(tuple(front[k][v] for k in range(3))) for v in range(vertices)]
    placed = Placed(head["name"], facts=head)
    for t in range(triangles):
        ids = [corners[k][t] for k in range(3)]
        normal = unit(cross(sub(place[ids[1]], place[ids[0]]), sub(place[ids[2]], place[ids[0]])))
        placed.triangles.append([(place[i], normal, color[i]) for i in ids])
        placed.parts.append(head["parts"][part[t]])
    return [placed]
