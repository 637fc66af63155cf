#!/usr/bin/env python3
"""Every exporter: boxes that are turned by a quarter and moved, read by this folder's own readers. Each corner has the right
place, normal and colour; faces are outward; names are right.

    exporters_test.py PROGRAM SOURCE
"""

import itertools
import json
import math
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import boxes  # noqa: E402
from boxes import CORNERS, VOLUME, Program, corners_at  # noqa: E402
from read_meshes import Glb, numbers, read_glb, read_obj, read_ply, read_pomona, read_pov, read_stl, read_usda, usd_tree  # noqa: E402
from vectors import add, cross, dot, furthest, length, linear, sub, times, turned, unit  # noqa: E402

HALF = math.sqrt(0.5)
POSES = [((HALF, HALF, 0, 0), (0.05, 0.11, -0.02)), ((HALF, 0, 0, -HALF), (-0.08, 0.03, 0.06)), ((0.5, 0.5, 0.5, 0.5), (0.02, 0.2, -0.1))]
ENTRIES = """[[pieces]]
name = "red"
template = "box.toml"
as_drawn = true
copies = 2
[[pieces]]
name = "blue"
template = "box.toml"
as_drawn = true
"""
STEP = {"place": 2e-7, "normal": 2e-3, "color": 8e-3}  # what formats round to: metres, of a unit, linear


def volume_of(placed):
    return sum(dot(t[0][0], cross(t[1][0], t[2][0])) for t in placed.triangles) / 6


def centre_of(placed):
    """The centre of its volume."""
    sums = [0.0, 0.0, 0.0]
    for (a, *_), (b, *_), (c, *_) in placed.triangles:
        part = dot(a, cross(b, c)) / 24
        sums = [s + part * (a[k] + b[k] + c[k]) for k, s in enumerate(sums)]
    return times(sums, 1 / volume_of(placed))


class Exporters(Program):
    def assert_box(self, placed, pose, about, *, textured=False, smooth=True):
        """Checks that these triangles are the box in this pose."""
        expected = corners_at(*pose)
        self.assertEqual(len(placed.triangles), 12, about)
        seen = set()
        for triangle in placed.triangles:
            which = []
            for place, normal, color in triangle:
                number = min(range(8), key=lambda i, p=place: length(sub(expected[i][0], p)))
                which.append(number)
                self.assertLess(length(sub(expected[number][0], place)), STEP["place"], about)
                if smooth and normal:
                    self.assertLess(length(sub(expected[number][1], normal)), STEP["normal"], about)
                if color and not textured:
                    self.assertLess(furthest(color, expected[number][2]), STEP["color"], (about, CORNERS[number]))
            if textured:
                middle = tuple(sum(expected[i][2][k] for i in which) / 3 for k in range(3))
                self.assertLess(furthest(triangle[0][2], middle), 0.04, (about, which))
            seen.add(frozenset(which))
        self.assertEqual(seen, {frozenset(face) for face in boxes.faces()} if len(seen) == 12 and not textured else seen, about)
        self.assertAlmostEqual(volume_of(placed) / VOLUME, 1, 3, about)

    def assert_boxes(self, found, names, about, **how):
        """Checks that all lie in their poses, by name if there are names."""
        self.assertEqual(sorted(placed.name for placed in found), sorted(names), about)
        for placed in found:
            self.assert_box(placed, POSES[names.index(placed.name)], (about, placed.name), **how)
            self.assertEqual(set(placed.parts) - {"skin"}, set(), about)

    def test_a_scene(self):
        names = self.scene(ENTRIES, POSES)
        files = [f"a.{kind}" for kind in ("glb", "usda", "obj", "ply", "pov", "stl")]
        self.pomona("scene", "s.toml", *(word for file in files for word in ("-o", file)))
        for reader, file in ((read_glb, "a.glb"), (read_usda, "a.usda"), (read_obj, "a.obj"), (read_ply, "a.ply"), (read_pov, "a.pov")):
            self.assert_boxes(reader(self.path / file), names, file)

        # No names and no shared corners: twelve triangles each, with the normals of the faces.
        placed, = read_stl(self.path / "a.stl")
        self.assertEqual(len(placed.triangles), 36)
        for number, pose in enumerate(POSES):
            part = type(placed)("", placed.triangles[12 * number:12 * number + 12])
            self.assert_box(part, pose, ("a.stl", number), smooth=False)
            for triangle in part.triangles:
                a, b, c = (corner[0] for corner in triangle)
                self.assertLess(length(sub(unit(cross(sub(b, a), sub(c, a))), triangle[0][1])), 1e-4)

    def test_parts_of_two_templates_keep_their_names(self):
        """A file counts the parts of all its templates; each piece counts those of its own."""
        for name, words in (("toml", boxes.TEMPLATE), ("ply", boxes.surface_file())):
            for old, new in (("box", "nut"), ("skin", "shell"), ("flesh", "kernel")):
                words = words.replace(old, new)
            (self.path / f"nut.{name}").write_text(words)
        self.scene("".join(f'[[pieces]]\nname = "{name}"\ntemplate = "{name}.toml"\n' for name in ("box", "nut")))
        self.pomona("scene", "s.toml", "-o", "a.ply")
        self.assertEqual([set(placed.parts) for placed in read_ply(self.path / "a.ply")], [{"skin"}, {"shell"}])

    def test_a_layout_says_where_things_lie(self):
        (self.path / "s.toml").write_text('format = 1\nname = "s"\nstyle = "plain"\nseed = 3\n' + ENTRIES)
        self.pomona("scene", "s.toml", "-o", "layout.json", "-o", "a.obj")
        layout = json.loads((self.path / "layout.json").read_text())["instances"]
        for placed, instance in zip(read_obj(self.path / "a.obj"), layout, strict=True):
            self.assertEqual(placed.name, instance["name"])
            self.assertLess(abs(instance["rotation"][0]), 0.9999, "it has come to lie turned")
            expected = [place for place, *_ in corners_at(tuple(instance["rotation"]), tuple(instance["translation"]))]
            for place, *_ in itertools.chain(*placed.triangles):
                self.assertLess(min(length(sub(place, p)) for p in expected), 2e-6)

    def test_a_scene_with_instances(self):
        names = self.scene(ENTRIES, POSES)
        self.pomona("scene", "s.toml", "--instances", "-o", "a.glb", "-o", "a.usda")
        self.assert_boxes(read_glb(self.path / "a.glb"), names, "glb")
        instanced = read_usda(self.path / "a.usda")
        for placed, pose in zip(instanced, POSES, strict=True):
            self.assert_box(placed, pose, "usda")
        self.assertEqual(len(json.loads((self.path / "layout.json").read_text())["instances"]), len(instanced))

    def test_a_scene_with_textures_and_levels(self):
        names = self.scene(ENTRIES, POSES)
        self.pomona("scene", "s.toml", "--texture", "64", "-o", "t.glb", "-o", "t.usda")
        for reader, file in ((read_glb, "t.glb"), (read_usda, "t.usda")):
            self.assert_boxes(reader(self.path / file), names, file, textured=True)

    def test_the_camera(self):
        names = self.scene(ENTRIES, POSES, size=[320, 200])
        text = (self.path / "s.toml").read_text()
        (self.path / "s.toml").write_text(text.replace("[[pieces]]", "[view]\neye = [0.4, 0.3, 0.5]\ntarget = [0.02, 0.1, -0.03]\nfield = 30\n[[pieces]]", 1))
        self.pomona("scene", "s.toml", "-o", "a.glb", "-o", "a.usda", "-o", "a.pov", "-o", "a.png", "--aov", "truth")
        self.assertEqual(len(names), 3)
        eye, forward = (0.4, 0.3, 0.5), unit(sub((0.02, 0.1, -0.03), (0.4, 0.3, 0.5)))
        right = unit(cross(forward, (0, 1, 0)))
        up = cross(right, forward)
        half = math.tan(math.radians(15))

        def same(where, looks, sees_up, tangent, about):
            self.assertLess(length(sub(where, eye)), 1e-6, about)
            self.assertLess(length(sub(looks, forward)), 1e-6, about)
            self.assertLess(length(sub(sees_up, up)), 1e-6, about)
            self.assertAlmostEqual(tangent, half, 6, about)

        glb = Glb(self.path / "a.glb").json
        node = next(n for n in glb["nodes"] if "camera" in n)
        x, y, z, w = node["rotation"]
        same(node["translation"], turned((w, x, y, z), (0, 0, -1)), turned((w, x, y, z), (0, 1, 0)),
             math.tan(glb["cameras"][node["camera"]]["perspective"]["yfov"] / 2), "glb")
        camera = next(p for p in usd_tree((self.path / "a.usda").read_text()).walk() if p.kind == "Camera")
        turn = tuple(camera.value("xformOp:orient"))
        same(camera.value("xformOp:translate"), turned(turn, (0, 0, -1)), turned(turn, (0, 1, 0)),
             camera.value("verticalAperture") / 2 / camera.value("focalLength"), "usda")
        pov = (self.path / "a.pov").read_text()
        metres = float(re.search(r"a unit is (\S+) metres", pov)[1])
        said = {key: numbers(re.search(rf"^  {key} (.*)$", pov, re.M)[1]) for key in ("location", "look_at", "up", "sky", "right")}
        looks = unit(sub(said["look_at"], said["location"]))
        same(times(said["location"], metres), looks, cross(unit(cross(looks, said["sky"])), looks), said["up"][0] / 2, "pov")
        self.assertRegex(pov, r"right -x \*", "POV-Ray's own frame is left-handed")
        told = json.loads((self.path / "truth/annotations.json").read_text())["images"][0]["camera"]
        same(told["eye"], told["forward"], times(told["down"], -1), 100 / told["focal_length"], "annotations")
        self.assertLess(length(sub(told["right"], right)), 1e-6)
        self.assertEqual(told["principal_point"], [160, 100])

    def test_a_dish_that_is_turned(self):
        corner = [sub(p, (0, boxes.LOW[1], 0)) for p in CORNERS]  # it stands on the ground
        shade = [tuple(12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in color) for color in boxes.COLORS]
        (self.path / "board.obj").write_text("".join(f"v {' '.join(map(str, p + c))}\n" for p, c in zip(corner, shade)) +
                                             "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in boxes.faces()))
        self.scene('[[dishes]]\nname = "board"\nmesh = "board.obj"\nat = ["5cm", "2cm", "-3cm"]\nturn = 90\n' + ENTRIES)
        self.pomona("scene", "s.toml", *(word for kind in ("glb", "usda", "obj", "ply", "pov") for word in ("-o", f"a.{kind}")))
        place = [add((0.05, 0.02, -0.03), (p[2], p[1], -p[0])) for p in corner]  # +X comes to -Z
        for reader, kind in ((read_glb, "glb"), (read_usda, "usda"), (read_obj, "obj"), (read_ply, "ply"), (read_pov, "pov")):
            board = next(placed for placed in reader(self.path / f"a.{kind}") if placed.name == "board")
            self.assertAlmostEqual(volume_of(board) / VOLUME, 1, 3, kind)
            for position, _, color in itertools.chain(*board.triangles):
                number = min(range(8), key=lambda i, p=position: length(sub(place[i], p)))
                self.assertLess(length(sub(place[number], position)), 1e-6, kind)
                self.assertLess(furthest(color, boxes.COLORS[number]), 2 * STEP["color"], kind)

    def test_the_surfaces_themselves(self):
        self.pomona("grow", "box.toml", "-o", "a.pomona", "-o", "a.html", "-o", "a.ply")
        placed, = read_pomona(self.path / "a.pomona")
        self.assertEqual((placed.name, set(placed.parts)), ("box", {"skin"}))
        step = placed.facts["spacing"] / placed.facts["units"]
        for place, _, color in itertools.chain(*placed.triangles):
            number = min(range(8), key=lambda i, p=place: length(sub(CORNERS[i], p)))
            self.assertLess(furthest(place, CORNERS[number]), step)
            self.assertLess(furthest(color, boxes.COLORS[number]), STEP["color"])
        self.assertAlmostEqual(volume_of(placed) / VOLUME, 1, 2)

    def test_pieces_that_are_moved_apart(self):
        words = ("cut", "box.toml", "--knife", "plane:0,0,1,25mm", "--style", "plain")
        kinds = ("glb", "usda", "obj", "ply", "pov", "stl")
        self.pomona(*words, *(word for kind in kinds for word in ("-o", f"a.{kind}")))
        self.pomona(*words, "--explode", "1.5", *(word for kind in kinds for word in ("-o", f"b.{kind}")))
        readers = (read_glb, read_usda, read_obj, read_ply, read_pov, read_stl)
        apart = None
        for reader, kind in zip(readers, kinds):
            there, moved = reader(self.path / f"a.{kind}"), reader(self.path / f"b.{kind}")
            self.assertEqual([p.name for p in there], [p.name for p in moved], kind)
            for a, b in zip(there, moved):
                self.assertAlmostEqual(volume_of(a) / volume_of(b), 1, 3)
            low = [min(p[2] for t in placed.triangles for p, *_ in t) for placed in moved]
            if kind == "stl":
                continue
            shift = [sub(b.triangles[0][0][0], a.triangles[0][0][0]) for a, b in zip(there, moved)]
            self.assertGreater(length(sub(shift[0], shift[1])), 0.002, kind)
            apart = apart or low
            self.assertLess(furthest(low, apart), 1e-6, kind)
            middles = [[centre_of(placed) for placed in pieces] for pieces in (there, moved)]
            for k in range(3):
                self.assertAlmostEqual(*(sum(middle[k] for middle in both) / 2 for both in middles), 6, "the middle of all stays")
            for a, b in zip(there, moved):
                self.assertAlmostEqual(volume_of(a) * 2 / VOLUME, 1, 3, kind)
                if a.parts:
                    self.assertEqual(set(a.parts), {"skin", "flesh"}, kind)


if __name__ == "__main__":
    Program.program, Program.source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
