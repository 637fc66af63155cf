"""Broken .ply files, as text and in both orders of bytes; and other meshes that are not read."""

import re
import struct

from .box import COLORS, CORNERS, TRIANGLES
from .case import Case

HEADER = """ply
format {format} 1.0
comment a box
element vertex 8
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 12
property list uchar int vertex_indices
end_header
"""


def packed(kind, header=HEADER, corners=None, colors=None, faces=None):
    corners, faces = corners or CORNERS, faces or TRIANGLES
    colors = colors or [[int(255 * c) for c in color] for color in COLORS]
    head = header.replace("{format}", kind).encode("latin-1")
    if kind == "ascii":
        rows = [*(p + c for p, c in zip(corners, colors)), *([len(f), *f] for f in faces)]
        return head + "".join(" ".join(f"{v:g}" if isinstance(v, float) else str(v) for v in row) + "\n" for row in rows).encode()
    order = "<" if "little" in kind else ">"
    data = b"".join(struct.pack(order + "3f3B", *p, *c) for p, c in zip(corners, colors))
    return head + data + b"".join(struct.pack(f"{order}B{len(f)}i", len(f), *f) for f in faces)


def of_headers(kind, whole):
    lines = HEADER.splitlines()
    name = f"PLY: headers, {kind}"
    for number, line in enumerate(lines):
        if line.startswith("comment"):
            continue
        # Colours that are not there are asked for by nobody but the template.
        is_color = re.search("red|green|blue", line) is not None
        without = "\n".join(lines[:number] + lines[number + 1:]) + "\n"
        twice = "\n".join(lines[:number] + [line] + lines[number:]) + "\n"
        # In bytes a header may say something else without a mistake.
        yield Case(name, f"without {line!r}", packed(kind, without), "ply", "told", whole)
        if line != "end_header":
            yield Case(name, f"{line!r} twice", packed(kind, twice), "ply", "told", whole)
        for word in line.split():
            for other in ("", "7", "-1", "x", "4294967297", "\x1b[2J", "list", "ascii"):
                if word in ("list", "x") and other == word or word == "red" or is_color and word != "uchar":
                    continue
                if word == "uchar" and other == "ascii" or other == "ascii" and word == "{format}":
                    continue
                broken = line.replace(word, other, 1)
                yield Case(name, f"{broken!r} for {line!r}", packed(kind, "\n".join(lines[:number] + [broken] + lines[number + 1:]) + "\n"),
                           "ply", "told", whole)
    for done, old, new in (("a float count of a list", "list uchar", "list float"), ("a vertex of 7", "vertex 8", "vertex 7"),
                           ("a vertex of 9", "vertex 8", "vertex 9"), ("11 faces", "face 12", "face 11"), ("13 faces", "face 12", "face 13"),
                           ("two lists of corners", "property list uchar int vertex_indices", "property list uchar int vertex_indices\nproperty list uchar int vertex_index"),
                           ("x as a list", "property float x", "property list uchar float x"), ("no version", " 1.0", ""), ("version 2.0", "1.0", "2.0"),
                           ("no corners", "vertex_indices", "corners"), ("5000 properties", "element face", "property float a\n" * 5000 + "element face")):
        yield Case(name, done, packed(kind, HEADER.replace(old, new)), "ply", "told", whole)
    for done, old, new in (("float32 and int32", "float", "float32"), ("vertex_index", "vertex_indices", "vertex_index"),
                           ("a comment in Latin-1", "a box", "b\xf6x"), ("a comment of control characters", "a box", "\x1b[2J"),
                           ("a long comment", "a box", "x" * 100000)):
        yield Case(name, done, packed(kind, HEADER.replace(old, new)), "ply", "whole", whole)


def of_values(kind, whole):
    name = f"PLY: values, {kind}"
    for text, value in (("nan", float("nan")), ("inf", float("inf")), ("1e30", 1e30), ("-1e30", -1e30)):
        for axis in range(3):
            corners = [list(corner) for corner in CORNERS]
            corners[4][axis] = value
            yield Case(name, f"{text} as {'xyz'[axis]}", packed(kind, corners=corners), "ply")
    for done, face in {"a corner of 8": [0, 1, 8], "a corner of -1": [0, 1, -1], "a corner of 2^31 - 1": [0, 1, 2**31 - 1], "no corner": [],
                       "one corner": [0], "two corners": [0, 1], "a crossing": [0, 2, 1, 3]}.items():
        yield Case(name, f"a face with {done}", packed(kind, faces=[*TRIANGLES[:5], face, *TRIANGLES[6:]]), "ply")
    yield Case(name, "a face too few", packed(kind, HEADER.replace("face 12", "face 11"), faces=TRIANGLES[:11]), "ply")
    yield Case(name, "a face twice", packed(kind, HEADER.replace("face 12", "face 13"), faces=[*TRIANGLES, TRIANGLES[0]]), "ply")
    yield Case(name, "all at one place", packed(kind, corners=[[0.0, 0.0, 0.0]] * 8), "ply")
    yield Case(name, "all in a plane", packed(kind, corners=[[x, y, 0.0] for x, y, _ in CORNERS]), "ply")
    for length in sorted({0, 1, 3, 10, 50, *(len(whole) * k // 20 for k in range(20)), len(whole) - 3}):
        yield Case(f"PLY: cut short, {kind}", f"the first {length} bytes", whole[:length], "ply")
    yield Case(name, "bytes behind its end", whole + b"3 0 1 2\n" * 3, "ply")
    yield Case(name, "a line end behind its end", whole + b"\n", "ply", "whole", whole)


def of_texts(whole):
    kind = "PLY: texts"
    def replaced(old, new):
        assert old in whole, old
        return whole.replace(old, new, 1)
    for word in (b"x", b"1,5", b"0x10", b"--1", b"1e", b"\xff", b"\0", b"1.#IND", b"1_0", b"''"):
        yield Case(kind, f"{word!r} as a number", replaced(b"0.02 ", word + b" "), "ply")
    for word in (b"256", b"-1", b"1.5", b"1000000"):
        yield Case(kind, f"a byte of {word!r}", replaced(b" 255 ", b" " + word + b" "), "ply")
    for word in (b"2", b"4", b"-3", b"3.5", b"1e9", b"x"):
        yield Case(kind, f"a list of {word!r}", replaced(b"\n3 ", b"\n" + word + b" "), "ply")
    yield Case(kind, "with CR LF", whole.replace(b"\n", b"\r\n"), "ply", "whole", whole)
    yield Case(kind, "with CR", whole.replace(b"\n", b"\r"), "ply", "whole", whole)
    yield Case(kind, "with a mark", b"\xef\xbb\xbf" + whole, "ply", "whole", whole)
    yield Case(kind, "all in one line", replaced(b"end_header\n", b"end_header\v").replace(b"\n", b" ").replace(b"\v", b"\n"), "ply")
    for code in ("utf-16", "utf-16-le", "utf-32"):
        yield Case(kind, f"as {code}", whole.decode().encode(code), "ply")


def cases():
    for kind in ("ascii", "binary_little_endian", "binary_big_endian"):
        whole = packed(kind)
        if "big" not in kind:
            yield from of_headers(kind, whole)
        yield from of_values(kind, whole)
    yield from of_texts(packed("ascii"))
    for ending, data in {"stl": b"solid box\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "gltf": b'{"asset": {"version": "2.0"}}',
                         "fbx": b"Kaydara FBX Binary  \0", "dae": b"<COLLADA/>", "3mf": b"PK\3\4", "off": b"OFF\n8 6 0\n", "usda": b"#usda 1.0\n",
                         "blend": b"BLENDER-v300", "x": b"", "PLy2": b"ply\n"}.items():
        yield Case("other endings", f".{ending}", data, ending)
