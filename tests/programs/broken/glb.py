"""Broken .glb files: one box, read from a node within a node, with colours; some with a skin, instances, a morph target or
sparse values."""

import base64
import copy
import json
import math
import struct

from .box import CORNERS, COLORS, TRIANGLES
from .case import Case

OTHER_TYPES = {"a text": "text", "true": True, "null": None, "a list": [], "an object": {}, "a fraction": 1.5, "below 0": -1,
               "1e300": 1e300, "2^40": 2**40}
NUMBERS = {"a text": "text", "true": True, "null": None, "a list": [], "an object": {}}


def packed(model, data, with_json=None):
    text = with_json if with_json is not None else json.dumps(model).encode()
    text += b" " * (-len(text) % 4)
    data = data + b"\0" * (-len(data) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


class Model:
    """A glTF model whose accessors are appended one by one."""

    def __init__(self):
        self.data = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                     "nodes": [{"name": "brick", "children": [1], "translation": [0.01, 0, 0], "scale": [1, 1, 1]},
                               {"name": "box", "mesh": 0, "rotation": [0, 0, 0, 1]}],
                     "meshes": [{"name": "box", "primitives": [{"attributes": {}, "mode": 4}]}],
                     "accessors": [], "bufferViews": [], "buffers": [{"byteLength": 0}]}
        attributes = self.primitive["attributes"]
        attributes["POSITION"] = self.add("VEC3", 5126, "f", CORNERS)
        attributes["COLOR_0"] = self.add("VEC4", 5123, "H", [[int(65535 * c) for c in color] + [65535] for color in COLORS],
                                         normalized=True)
        self.primitive["indices"] = self.add("SCALAR", 5123, "H", [[corner] for triangle in TRIANGLES for corner in triangle])

    @property
    def primitive(self):
        return self.json["meshes"][0]["primitives"][0]

    def add(self, kind, component, letter, rows, **more):
        data = b"".join(struct.pack(f"<{len(row)}{letter}", *row) for row in rows)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
        self.data += data + b"\0" * (-len(data) % 4)
        self.json["buffers"][0]["byteLength"] = len(self.data)
        view = len(self.json["bufferViews"]) - 1
        self.json["accessors"].append({"bufferView": view, "byteOffset": 0, "componentType": component, "count": len(rows),
                                       "type": kind, **more})
        return len(self.json["accessors"]) - 1

    def bytes(self):
        return packed(self.json, self.data)


def plain():
    model = Model()
    model.json["bufferViews"][0]["byteStride"] = 12
    return model


def skinned():
    model = Model()
    model.json["nodes"][0]["children"] = [1, 2]
    model.json["nodes"].append({"name": "bone"})
    model.json["nodes"][1]["skin"] = 0
    model.primitive["attributes"]["JOINTS_0"] = model.add("VEC4", 5121, "B", [[0, 0, 0, 0]] * 8)
    model.primitive["attributes"]["WEIGHTS_0"] = model.add("VEC4", 5126, "f", [[1, 0, 0, 0]] * 8)
    one = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    model.json["skins"] = [{"joints": [2], "inverseBindMatrices": model.add("MAT4", 5126, "f", [one])}]
    return model


def morphed():
    model = Model()
    model.primitive["targets"] = [{"POSITION": model.add("VEC3", 5126, "f", [[0.001, 0, 0]] * 8)}]
    model.json["meshes"][0]["weights"] = [0.5]
    return model


def sparse():
    model = Model()
    index = model.add("SCALAR", 5123, "H", [[0], [7]])
    place = model.add("VEC3", 5126, "f", [CORNERS[0], CORNERS[7]])
    model.json["accessors"][0]["sparse"] = {"count": 2, "indices": {"bufferView": index, "byteOffset": 0, "componentType": 5123},
                                            "values": {"bufferView": place, "byteOffset": 0}}
    model.json["accessors"] = model.json["accessors"][:3]
    return model


def instanced():
    model = Model()
    places = model.add("VEC3", 5126, "f", [[0, 0, 0], [0.1, 0, 0]])
    turns = model.add("VEC4", 5126, "f", [[0, 0, 0, 1], [0, 0, 0, 1]])
    model.json["nodes"][1]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places, "ROTATION": turns}}}
    model.json["extensionsUsed"] = model.json["extensionsRequired"] = ["EXT_mesh_gpu_instancing"]
    return model


def paths_of(value, path=()):
    """Every key and index within the JSON, as a path."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield path + (key,)
        yield from paths_of(item, path + (key,))


def words_of(path):
    return ".".join(str(key) for key in path)


def changed(model, path, value):
    """The model with another value at a path; left out where the value is `paths_of` itself."""
    text = copy.deepcopy(model.json)
    at = text
    for key in path[:-1]:
        at = at[key]
    if value is paths_of:
        del at[path[-1]]
    else:
        at[path[-1]] = value
    return packed(text, model.data)


def of_keys(what, model, whole, known=frozenset()):
    """Each key left out, and of another type; each index out of range; but for the paths that are known already."""
    is_plain = not known
    # Without these the file says the same.
    spare = {"scene", "name", "normalized", "mode", "translation", "scale", "rotation", "byteStride", "extensionsUsed",
             "extensionsRequired", "inverseBindMatrices"}
    # Without these it says something else, which is no mistake.
    other = {"COLOR_0", "WEIGHTS_0", "JOINTS_0", "skin", "targets", "weights", "sparse", "extensions", "indices", "byteOffset",
             "EXT_mesh_gpu_instancing", "TRANSLATION", "ROTATION", "attributes", "buffer"}
    for path in paths_of(model.json):
        if path in known:
            continue
        key, words = path[-1], f"{what}{words_of(path)}"
        if isinstance(key, str) and key not in other and "targets" not in path[:-1]:
            wanted = "either" if key in spare or words == "scenes" else "told"
            if words != "nodes.0.translation":  # somewhere else, which is no mistake
                yield Case("glTF: keys left out", f"without {words}", changed(model, path, paths_of), "glb", wanted, whole)
        at = model.json
        for step in path:
            at = at[step]
        if key == "name":
            continue
        is_number = isinstance(at, (int, float)) and not isinstance(at, bool)
        is_vector = len(path) > 1 and path[-2] in ("translation", "rotation", "scale", "weights")
        others = NUMBERS if is_vector else OTHER_TYPES
        for name in others if is_plain else ("a text", "null", "an object"):
            value = others[name]
            if type(value) is type(at) or (value is None and not isinstance(at, (int, list, dict, str))):
                if not is_number or isinstance(value, bool):
                    continue
            yield Case("glTF: values of another type", f"{words}: {name}", changed(model, path, value), "glb",
                       "either" if name == "a list" and isinstance(at, list) else "told", whole)
        is_index = path[-2:-1] in [("nodes",), ("children",), ("joints",), ("attributes",)] or key in (
            "scene", "mesh", "skin", "indices", "bufferView", "buffer", "inverseBindMatrices")
        if is_number and is_index:
            for value in (99, 2**31 - 1, 2**31, 2**32) if is_plain else (99,):
                yield Case("glTF: indices out of range", f"{words}: {value}", changed(model, path, value), "glb", "told", whole)


def of_accessors(model, whole):
    kind = "glTF: accessors, views and strides"
    for stride in (1, 2, 3, 4, 5, 7, 8, 10, 11, 13, 16, 20, 252, 253, 256, 65535):
        yield Case(kind, f"a stride of {stride}", changed(model, ("bufferViews", 0, "byteStride"), stride), "glb")
    for path, values in {("bufferViews", 0, "byteLength"): (0, 1, 95, 4096, 2**31 - 1), ("bufferViews", 1, "byteOffset"): (4096, 2**31),
                         ("bufferViews", 2, "byteLength"): (0, 70, 71, 4096), ("accessors", 0, "byteOffset"): (1, 96, 4096, 2**31),
                         ("accessors", 2, "byteOffset"): (1, 72, 4096), ("accessors", 0, "count"): (0, 1, 7, 9, 4096, 2**31),
                         ("accessors", 1, "count"): (0, 1, 7, 9), ("accessors", 2, "count"): (0, 1, 2, 34, 35, 37, 2**31),
                         ("buffers", 0, "byteLength"): (0, 1, 100, 4096, 2**31)}.items():
        for value in values:
            yield Case(kind, f"{words_of(path)}: {value}", changed(model, path, value), "glb", "told", whole)
    for accessor, types in ((0, (5120, 5121, 5122, 5123, 5124, 5125, 5130, 0)), (1, (5120, 5122, 5124, 5125, 5126, 5130, 0)),
                            (2, (5120, 5122, 5124, 5125, 5126, 5130, 0))):
        for component in types:
            yield Case("glTF: component types", f"accessor {accessor} of {component}",
                       changed(model, ("accessors", accessor, "componentType"), component), "glb")
    for accessor, right in ((0, "VEC3"), (1, "VEC4"), (2, "SCALAR")):
        for name in ("SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4", "vec3", "VEC5", ""):
            # Colours of three channels are colours, of other values.
            if name != right and (accessor, name) != (1, "VEC3"):
                yield Case("glTF: component types", f"accessor {accessor} of {name or 'no type'}",
                           changed(model, ("accessors", accessor, "type"), name), "glb")
    yield Case("glTF: component types", "indices that are normalized", changed(model, ("accessors", 2, "normalized"), True), "glb")
    yield Case("glTF: component types", "colours that are not", changed(model, ("accessors", 1, "normalized"), False), "glb")
    for mode in (-1, 0, 1, 2, 3, 7, 255):
        yield Case("glTF: primitives", f"mode {mode}", changed(model, ("meshes", 0, "primitives", 0, "mode"), mode), "glb")


def of_numbers(whole):
    kind = "glTF: numbers"
    for what, value in (("NaN", math.nan), ("inf", math.inf), ("-inf", -math.inf), ("3e38", 3e38)):
        for accessor, name, row in ((0, "a position", struct.pack("<f", value)),):
            model = plain()
            model.data = model.data[:4] + row + model.data[8:]
            yield Case(kind, f"{what} in {name}", model.bytes(), "glb")
        if what == "3e38":  # light may be brighter than white, and weights are shares of their sum
            continue
        model = plain()
        model.json["accessors"][1].update(componentType=5126, bufferView=3, normalized=False)
        model.add("VEC4", 5126, "f", [[value] * 4] * 8)
        yield Case(kind, f"{what} in a colour", model.bytes(), "glb")
        for make, name, view in ((skinned, "a weight", 4), (skinned, "a bind matrix", 5), (morphed, "a morph target", 3),
                                 (sparse, "a sparse value", 4), (instanced, "an instance's place", 3), (instanced, "its turn", 4)):
            model = make()
            at = model.json["bufferViews"][view]["byteOffset"]
            model.data = model.data[:at] + struct.pack("<f", value) + model.data[at + 4:]
            yield Case(kind, f"{what} in {name}", model.bytes(), "glb")
    for key, values in {"translation": ([1e300, 0, 0], [1e10, 0, 0], [0, 0], [0, 0, 0, 0], []),
                        "rotation": ([0, 0, 0, 0], [0, 0, 0, 2], [1, 1, 1, 1], [0, 0, 0], [0, 0, 0, 1, 0], []),
                        "scale": ([0, 0, 0], [1e300, 1, 1], [1, 1], [1], []),
                        "matrix": ([0] * 16, [1] * 16, [1] * 15, [1] * 17, [1e300] * 16, [])}.items():
        for value in values:
            yield Case(kind, f"a node's {key} of {value if len(value) < 6 else f'{len(value)} x {value[0]}'}",
                       changed(plain(), ("nodes", 0, key), value), "glb")
    both = plain()
    both.json["nodes"][0]["matrix"] = [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]
    yield Case(kind, "a node with a matrix and a translation", both.bytes(), "glb")
    for token in ("NaN", "Infinity", "1e999", "0x10", "01", "+1", ".5"):
        text = json.dumps(plain().json).replace("0.01", token).encode()
        yield Case(kind, f"{token} in the JSON", packed(None, plain().data, text), "glb")


def of_nodes(whole):
    kind = "glTF: nodes, cycles and duplicates"
    def with_nodes(roots, *nodes):
        model = plain()
        model.json["scenes"][0]["nodes"], model.json["nodes"] = roots, list(nodes)
        return model.bytes()
    yield Case(kind, "a node is its own child", with_nodes([0], {"children": [0], "mesh": 0}), "glb")
    yield Case(kind, "two nodes hold each other", with_nodes([0], {"children": [1]}, {"children": [0], "mesh": 0}), "glb")
    yield Case(kind, "a ring of three", with_nodes([0], {"children": [1]}, {"children": [2]}, {"children": [0], "mesh": 0}), "glb")
    yield Case(kind, "a ring that no scene shows", with_nodes([0], {"mesh": 0}, {"children": [2]}, {"children": [1]}), "glb", "either",
               with_nodes([0], {"mesh": 0}))
    yield Case(kind, "two parents", with_nodes([0, 1], {"children": [2]}, {"children": [2]}, {"mesh": 0}), "glb")
    yield Case(kind, "a child twice", with_nodes([0], {"children": [1, 1]}, {"mesh": 0}), "glb")
    yield Case(kind, "a root twice", with_nodes([0, 0], {"mesh": 0}), "glb")
    yield Case(kind, "a root that is a child", with_nodes([0, 1], {"children": [1]}, {"mesh": 0}), "glb")
    yield Case(kind, "a doubling tree", with_nodes([0], *({"children": [n + 1, n + 1]} for n in range(30)), {"mesh": 0}), "glb")
    yield Case(kind, "100 levels", with_nodes([0], *({"children": [n + 1]} for n in range(100)), {"mesh": 0}), "glb")
    for key in ("nodes", "meshes", "buffers", "asset", "scene"):
        text = json.dumps(plain().json)
        text = text[:-1] + f', "{key}": {json.dumps(plain().json[key])}}}'
        yield Case(kind, f"the key {key} twice", packed(None, plain().data, text.encode()), "glb")
    for key, old in (("mesh", '"mesh": 0'), ("POSITION", '"POSITION": 0'), ("count", '"count": 8')):
        text = json.dumps(plain().json).replace(old, f"{old}, {old}", 1)
        yield Case(kind, f"the key {key} twice", packed(None, plain().data, text.encode()), "glb")


def of_texts(whole):
    kind = "glTF: names and texts"
    def named(name):
        return packed(None, plain().data, json.dumps(plain().json).encode().replace(b'"box"', b'"' + name + b'"'))
    for what, name in {"Latin-1": b"b\xf6x", "a byte too few": b"b\xc3", "a surrogate": b"\xed\xa0\x80", "overlong": b"\xc0\xaf",
                       "a raw control character": b"\x1b[2J", "a raw line break": b"a\nb", "a raw NUL": b"a\0b",
                       "half an escape": b"\\u12", "half a surrogate pair": b"\\ud800", "an unknown escape": b"\\q"}.items():
        yield Case(kind, f"a name in {what}", named(name), "glb")
    for what, name in {"an escaped control character": b"\\u001b[2J", "an escaped NUL": b"\\u0000", "100 000 letters": b"x" * 100000,
                       "markup": b"<svg onload=x>", "a path": b"../../etc/passwd"}.items():
        yield Case(kind, f"a name of {what}", named(name), "glb", "whole", whole)
    text = json.dumps(plain().json)
    for what, broken in {"a comma too many": text[:-1] + ",}", "a comment": "/* box */" + text, "single quotes": text.replace('"', "'"),
                         "half": text[:len(text) // 2], "a brace too many": text + "}", "a list": f"[{text}]", "nothing": "",
                         "only braces": "{}", "null": "null", "a number": "7", "a text": '"glTF"', "a second value": text + text,
                         "1000 levels": "[" * 1000 + "]" * 1000}.items():
        yield Case(kind, f"JSON with {what}" if "a" in what[:2] else f"JSON: {what}", packed(None, plain().data, broken.encode()), "glb")
    yield Case(kind, "JSON as UTF-16", packed(None, plain().data, text.encode("utf-16")), "glb")
    yield Case(kind, "JSON with a mark", packed(None, plain().data, b"\xef\xbb\xbf" + text.encode()), "glb", "either", whole)


def of_extensions(whole):
    kind = "glTF: extensions and versions"
    for name in ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression", "MSFT_packing", "EXT_unheard_of",
                 "khr_materials_unlit", "", "KHR_node_hoverability", "KHR_gaussian_splatting", "\u001b[2J", "x" * 5000):
        yield Case(kind, f"requires {name[:30]!r}", changed(plain(), ("extensionsRequired",), [name]), "glb")
    for what, value in (("a text", "EXT_unheard_of"), ("an object", {"EXT_unheard_of": True}), ("a list of numbers", [1]),
                        ("a list of lists", [["EXT_unheard_of"]]), ("null", None)):
        yield Case(kind, f"requires {what}", changed(plain(), ("extensionsRequired",), value), "glb")
    yield Case(kind, "uses what nobody knows", changed(plain(), ("extensionsUsed",), ["EXT_unheard_of"]), "glb", "whole", whole)
    for version in ("1.0", "1.1", "3.0", "20", "2", "", "two", "2.0.0.0"):
        yield Case(kind, f"version {version!r}", changed(plain(), ("asset", "version"), version), "glb",
                   "told" if not version.startswith("2") or version == "20" else "either", whole)
    for version in ("2.1", "3.0", "99"):
        yield Case(kind, f"at least version {version}", changed(plain(), ("asset", "minVersion"), version), "glb")
    yield Case(kind, "later, but readable by 2.0", packed({**plain().json, "asset": {"version": "2.1", "minVersion": "2.0"}}, plain().data),
               "glb", "whole", whole)


def of_buffers(whole):
    kind = "glTF: buffers elsewhere"
    model = plain()
    data = base64.b64encode(model.data).decode()
    for what, uri, wanted in (("as it should be", f"data:application/octet-stream;base64,{data}", "whole"),
                              ("of another type", f"data:application/gltf-buffer;base64,{data}", "whole"),
                              ("half", f"data:application/octet-stream;base64,{data[:len(data) // 2]}", "told"),
                              ("with other letters", f"data:application/octet-stream;base64,{'!' * len(data)}", "told"),
                              ("without its data", "data:application/octet-stream;base64,", "told"),
                              ("of no known kind", f"data:text/html,{data}", "told"), ("beside it", "box.bin", "told"),
                              ("above it", "../../../../etc/passwd", "told"), ("anywhere", "file:///etc/passwd", "told"),
                              ("a device", "/dev/zero", "told"), ("on the web", "http://localhost/box.bin", "told"), ("nowhere", "", "told")):
        yield Case(kind, f"a buffer {what}", changed(model, ("buffers", 0, "uri"), uri), "glb", wanted, whole)
    two = plain()
    two.json["buffers"].append({"byteLength": 96})
    yield Case(kind, "a second buffer without bytes", two.bytes(), "glb")


def of_containers(whole):
    kind = "glTF: cut short, lengths and chunks"
    data = plain().bytes()
    for length in sorted({*range(0, 32, 3), 12, 19, 20, *(len(data) * k // 23 for k in range(23)), len(data) - 4, len(data) - 1}):
        yield Case(kind, f"the first {length} bytes", data[:length], "glb")
        if length > 12:
            yield Case(kind, f"the first {length} bytes, with that length", data[:8] + struct.pack("<I", length) + data[12:length], "glb")
    text, = struct.unpack_from("<I", data, 12)
    for at, name in ((8, "file"), (12, "JSON"), (20 + text, "BIN")):
        right, = struct.unpack_from("<I", data, at)
        for value in (0, 1, right - 4, right + 4, 2**31, 2**32 - 1):
            yield Case(kind, f"a length of {name} of {value}", data[:at] + struct.pack("<I", value) + data[at + 4:], "glb")
    for at, word in ((0, b"GLTF"), (16, b"BIN\0"), (20 + text + 4, b"JSON"), (20 + text + 4, b"XXXX")):
        yield Case(kind, f"{word!r} at byte {at}", data[:at] + word + data[at + 4:], "glb")
    for version in (0, 1, 3, 2**32 - 1):
        yield Case(kind, f"container version {version}", data[:4] + struct.pack("<I", version) + data[8:], "glb")
    def grown(more):
        return data[:8] + struct.pack("<I", len(data) + len(more)) + data[12:] + more
    yield Case(kind, "a further chunk", grown(struct.pack("<I4s", 4, b"MORE") + b"abcd"), "glb", "whole", whole)
    yield Case(kind, "a second BIN", grown(struct.pack("<I4s", 4, b"BIN\0") + b"abcd"), "glb", "either", whole)
    yield Case(kind, "bytes behind its end", data + b"more", "glb")
    yield Case(kind, "a text of glTF", json.dumps(plain().json).encode(), "glb")


def of_skins():
    kind = "glTF: skins, targets, sparse values, instances"
    def spoilt(make, change):
        model = make()
        change(model)
        return model.bytes()
    changes = {
        "a skin without a joint": (skinned, lambda m: m.json["skins"][0].update(joints=[])),
        "a joint outside the scene": (skinned, lambda m: m.json["nodes"][0].update(children=[1])),
        "joints without weights": (skinned, lambda m: m.primitive["attributes"].pop("WEIGHTS_0")),
        "weights without joints": (skinned, lambda m: m.primitive["attributes"].pop("JOINTS_0")),
        "a joint out of range": (skinned, lambda m: setattr(m, "data", m.data[:at(m, 3)] + b"\5" + m.data[at(m, 3) + 1:])),
        "weights of nothing": (skinned, lambda m: setattr(m, "data", m.data[:at(m, 4)] + b"\0" * 128 + m.data[at(m, 4) + 128:])),
        "too few weights": (skinned, lambda m: m.json["accessors"][4].update(count=7)),
        "more weights than targets": (morphed, lambda m: m.json["meshes"][0].update(weights=[0.5, 0.5])),
        "a node with more weights": (morphed, lambda m: m.json["nodes"][1].update(weights=[0.5, 0.5])),
        "a target of another length": (morphed, lambda m: m.json["accessors"][3].update(count=7)),
        "a sparse place out of range": (sparse, lambda m: setattr(m, "data", m.data[:at(m, 3)] + b"\0\0\x08\0" + m.data[at(m, 3) + 4:])),
        "sparse places that fall": (sparse, lambda m: setattr(m, "data", m.data[:at(m, 3)] + b"\7\0\0\0" + m.data[at(m, 3) + 4:])),
        "a sparse place twice": (sparse, lambda m: setattr(m, "data", m.data[:at(m, 3)] + b"\7\0\7\0" + m.data[at(m, 3) + 4:])),
        "more sparse values than bytes": (sparse, lambda m: m.json["accessors"][0]["sparse"].update(count=100)),
        "no sparse value": (sparse, lambda m: m.json["accessors"][0]["sparse"].update(count=0)),
        "instances of unequal lists": (instanced, lambda m: m.json["accessors"][3].update(count=1)),
        "instances without a list": (instanced, lambda m: m.json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"].update(attributes={})),
        "instances turned by nothing": (instanced, lambda m: setattr(m, "data", m.data[:at(m, 4)] + b"\0" * 16 + m.data[at(m, 4) + 16:])),
        "instances turned by more than all": (instanced, lambda m: setattr(m, "data", m.data[:at(m, 4)] + struct.pack("<4f", 3, 3, 3, 3) + m.data[at(m, 4) + 16:])),
        "an unknown attribute of instances": (instanced, lambda m: m.json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"].update(SHEAR=0)),
    }
    for done, (make, change) in changes.items():
        wanted = "either" if done in ("an unknown attribute of instances", "weights without joints") else "told"
        yield Case(kind, done, spoilt(make, change), "glb", wanted, make().bytes())


def at(model, view):
    return model.json["bufferViews"][view]["byteOffset"]


def cases():
    model = plain()
    whole = model.bytes()
    yield from of_keys("", model, whole)
    for what, make in (("skinned, ", skinned), ("morphed, ", morphed), ("sparse, ", sparse), ("instances, ", instanced)):
        yield from of_keys(what, make(), make().bytes(), frozenset(paths_of(model.json)))
    yield from of_accessors(model, whole)
    yield from of_numbers(whole)
    yield from of_nodes(whole)
    yield from of_texts(whole)
    yield from of_extensions(whole)
    yield from of_buffers(whole)
    yield from of_containers(whole)
    yield from of_skins()
