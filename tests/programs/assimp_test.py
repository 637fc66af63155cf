#!/usr/bin/env python3
"""assimp reads a .glb: as many triangles and materials as are in it.

    assimp_test.py FILE.glb
"""

import re
import subprocess
import sys

from glb import Glb

glb = Glb(sys.argv[1])
told = subprocess.run(["assimp", "info", sys.argv[1]], capture_output=True, text=True, timeout=60)
if told.returncode != 0:
    sys.exit(told.stdout + told.stderr)


def count(what):
    return int(re.search(rf"^{what}: *(\d+)$", told.stdout, re.M).group(1))


expected = {"Meshes": sum(len(mesh["primitives"]) for mesh in glb.json["meshes"]),
            "Faces": sum(len(glb.triangles(mesh)) for mesh in glb.json["meshes"]),
            "Cameras": 1}
for what, number in expected.items():
    if count(what) != number:
        sys.exit(f"assimp: {what}: {count(what)}, and {number} are in the file")
# It joins materials that are the same to it; the first one stays.
if f"'{glb.json['materials'][0]['name']}'" not in told.stdout:
    sys.exit(f"assimp lost the material {glb.json['materials'][0]['name']}:\n{told.stdout}")
print(f"assimp: {expected}")
