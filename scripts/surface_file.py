"""Reads the .ply files that Pomona writes: surfaces and sections (docs/reference/formats.md)."""

import struct

TYPES = {"float": "f", "int": "i", "uchar": "B"}


def read(path):
    """Vertices as dictionaries by property, faces as lists of indices."""
    with open(path, "rb") as file:
        data = file.read()
    header, body = data.split(b"end_header\n", 1)
    counts, properties = {}, {}
    for line in header.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element], properties[element] = int(words[2]), []
        elif words[0] == "property":
            properties[element].append(words[1:])

    # Vertices all have one size; faces are triangles.
    vertex = struct.Struct("<" + "".join(TYPES[kind] for kind, _ in properties["vertex"]))
    names = [name for _, name in properties["vertex"]]
    end = vertex.size * counts["vertex"]
    vertices = [dict(zip(names, values)) for values in vertex.iter_unpack(body[:end])]
    face = struct.Struct("<B3i" + "i" * (len(properties["face"]) - 1))
    return vertices, [list(values[1:4]) for values in face.iter_unpack(body[end:end + face.size * counts["face"]])]


def srgb(linear):
    """#rrggbb of a linear colour."""
    def encoded(x):
        x = min(max(x, 0.0), 1.0)
        return round(255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055))
    return "#%02x%02x%02x" % tuple(encoded(x) for x in linear)
