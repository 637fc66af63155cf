#!/usr/bin/env python3
"""The texture of a .glb's first piece, as a picture: glb_texture.py FILE.glb PICTURE.png"""

import json
import pathlib
import struct
import sys


def chunks(data):
    """Of a .glb: (kind, bytes), after its header of 12 bytes."""
    at = 12
    while at < len(data):
        length, kind = struct.unpack_from("<I4s", data, at)
        yield kind, data[at + 8:at + 8 + length]
        at += 8 + length


def main(source, picture):
    parts = dict(chunks(pathlib.Path(source).read_bytes()))
    scene = json.loads(parts[b"JSON"])
    if not scene.get("images"):
        sys.exit(f"glb_texture: error: {source} has no texture: --texture makes one")
    view = scene["bufferViews"][scene["images"][0]["bufferView"]]
    begin = view.get("byteOffset", 0)
    pathlib.Path(picture).write_bytes(parts[b"BIN\0"][begin:begin + view["byteLength"]])


if len(sys.argv) != 3:
    sys.exit(__doc__)
main(*sys.argv[1:])
