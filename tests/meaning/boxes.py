"""A box with eight different corners, as a template, and folders with such boxes.

It has three different edges, lies away from its origin, and every corner has its own colour: any wrong turn, mirror, move,
exchange or conversion changes a place or a colour.
"""

import itertools
import json
import pathlib
import subprocess
import tempfile
import unittest

from vectors import add, times, turned, unit

LOW, HIGH = (0.004, -0.003, 0.010), (0.024, 0.007, 0.040)  # metres
CORNERS = [tuple((HIGH if i >> k & 1 else LOW)[k] for k in range(3)) for i in range(8)]
COLORS = [(0.9, 0.1, 0.1), (0.1, 0.8, 0.1), (0.1, 0.2, 0.9), (0.9, 0.8, 0.1), (0.8, 0.1, 0.7), (0.1, 0.7, 0.8), (0.9, 0.9, 0.9),
          (0.2, 0.15, 0.1)]  # linear
EDGES = tuple(h - l for l, h in zip(LOW, HIGH))
VOLUME = EDGES[0] * EDGES[1] * EDGES[2]
# The normal of a corner is weighted by the areas of its faces.
NORMALS = [unit(tuple((1 if i >> k & 1 else -1) * EDGES[(k + 1) % 3] * EDGES[(k + 2) % 3] for k in range(3))) for i in range(8)]


def faces():
    """Twelve triangles, counter-clockwise seen from outside."""
    for k, side in itertools.product(range(3), (0, 1)):
        u, v = (k + 1) % 3, (k + 2) % 3
        a, b, c, d = [(side << k) | (p << u) | (q << v) for p, q in ((0, 0), (1, 0), (1, 1), (0, 1))][::1 if side else -1]
        yield from ((a, b, c), (a, c, d))


def surface_file(low_scale=1.0):
    head = ["ply", "format ascii 1.0", "comment part 0 skin", "comment part 1 flesh", "comment surface 0 skin", "element vertex 8"]
    head += [f"property float {name}" for name in "x y z front_r front_g front_b back_r back_g back_b blur".split()]
    head += ["property uchar front_hidden", "property uchar back_hidden", "element face 12", "property list uchar int vertex_indices",
             "property int surface", "property int front_part", "property int back_part", "end_header"]
    rows = [" ".join(map(str, times(p, low_scale) + c + (0.5, 0.4, 0.3, 0, 1, 0))) for p, c in zip(CORNERS, COLORS)]
    return "\n".join(head + rows + [f"3 {a} {b} {c} 0 0 1" for a, b, c in faces()]) + "\n"


TEMPLATE = """format = 1
name = "box"
title = "Box"
density = 900
densities = { flesh = 900 }
parts = ["skin", "flesh"]
[symmetry]
kind = "none"
[[mesh]]
name = "box"
file = "box.ply"
"""


class Program(unittest.TestCase):
    """A folder with a box in it, and the program."""

    program = source = None  # set by the file that runs

    made_once = None  # of tests that look at the same files: what make() left

    def setUp(self):
        cls = type(self)
        if cls.made_once:
            self.path, kept = cls.made_once
            vars(self).update(kept)
            return
        folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.path = pathlib.Path(folder.name)
        self.write_box()
        if hasattr(self, "make"):
            cls.addClassCleanup(folder.cleanup)
            cls.made_once = (self.path, self.make())
            vars(self).update(cls.made_once[1])
        else:
            self.addCleanup(folder.cleanup)

    def write_box(self):
        (self.path / "box.toml").write_text(TEMPLATE)
        (self.path / "box.ply").write_text(surface_file())

    def pomona(self, *words, status=0):
        done = subprocess.run([self.program, *map(str, words), "--quiet"], cwd=self.path, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, " ".join(map(str, words)) + "\n" + done.stderr)
        return done

    def scene(self, entries, poses=(), **keys):
        """Writes s.toml; `poses` are those of the instances, in order. Returns the instances' names."""
        head = "".join(f"{key} = {json.dumps(value)}\n" for key, value in {"format": 1, "name": "s", "style": "plain", **keys}.items())
        (self.path / "s.toml").write_text(head + entries)
        if not poses:
            return []
        self.pomona("scene", "s.toml", "-o", "layout.json")
        layout = json.loads((self.path / "layout.json").read_text())
        self.assertEqual(len(layout["instances"]), len(poses))
        for instance, (turn, shift) in zip(layout["instances"], poses):
            instance["rotation"], instance["translation"] = list(turn), list(shift)
        (self.path / "layout.json").write_text(json.dumps(layout))
        (self.path / "s.toml").write_text(head + 'layout = "layout.json"\n' + entries)
        return [instance["name"] for instance in layout["instances"]]


def corners_at(turn, shift):
    """The place of each corner of a box, with its normal and its colour."""
    return [(add(turned(turn, p), shift), turned(turn, n), c) for p, n, c in zip(CORNERS, NORMALS, COLORS)]
