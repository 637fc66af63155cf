#!/usr/bin/env python3
"""Units: for a fruit twice as large every number in every file grows by its dimension: lengths twice, areas four times, volumes
and masses eight times, inertia thirty-two times, dimensionless numbers stay. And all numbers of a box are known.

    units_test.py PROGRAM SOURCE
"""

import itertools
import json
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import boxes  # noqa: E402
from boxes import Program  # noqa: E402
from png import Picture  # noqa: E402
from read_meshes import Glb, ply_rows, read_glb, read_obj, read_ply, read_pomona, read_pov, read_stl, read_usda  # noqa: E402
from vectors import cross, length, sub, times  # noqa: E402

# Powers of the length, by key.
DIMENSION = {"volume": 3, "mass": 3, "density": 0, "center": 1, "inertia": 5, "low": 1, "high": 1, "triangles": 0, "piece": 0, "seed": 0,
             "index": 0, "physics:mass": 3, "physics:density": 0, "physics:centerOfMass": 1, "physics:diagonalInertia": 5}
WORDS = ("--knife", "half", "--quality", "draft", "--detail", "0.3", "--style", "plain")
CLOSE = 2e-5


def flat(value):
    return [x for part in value for x in flat(part)] if isinstance(value, list) else [value]


class Units(Program):
    def assert_scaled(self, small, large, power, about):
        """Numbers of two files, the second of twice the size."""
        a, b = flat(small), flat(large)
        self.assertEqual(len(a), len(b), about)
        most = max(map(abs, a), default=0)
        for x, y in zip(a, b):
            self.assertLessEqual(abs(y - x * 2 ** power), CLOSE * most * 2 ** power, (about, x, y))

    def assert_facts(self, small, large, about):
        compared = set()
        for key, value in small.items():
            if key in DIMENSION and not isinstance(value, str):
                self.assert_scaled(value, large[key], DIMENSION[key], (about, key))
                compared.add(key)
            elif isinstance(value, (int, float)) and not isinstance(value, bool):
                self.fail(f"{about}: {key} has no dimension here")
        return compared

    def assert_places(self, small, large, about, close=CLOSE):
        for a, b in zip(small, large, strict=True):
            self.assertEqual((a.name, len(a.triangles)), (b.name, len(b.triangles)), about)
            span = max(length(p) for t in a.triangles for p, *_ in t)
            for s, t in zip(a.triangles, b.triangles):
                for (p, n, c), (q, m, d) in zip(s, t):
                    self.assertLess(length(sub(times(p, 2), q)), 2 * close * span, about)
                    if n and "stl" not in about:
                        self.assertLess(length(sub(n, m)), 0.02, about)
                    if c:
                        self.assertLess(length(sub(c, d)), 0.1, about)

    def test_a_fruit_twice_as_large(self):
        kinds = ("glb", "usda", "obj", "ply", "stl", "pov")
        for size in (1, 2):
            self.pomona("cut", self.source / "templates/avocado.toml", *WORDS, "--scale", size, "--pieces", f"{size}.json",
                        *(word for kind in kinds for word in ("-o", f"{size}.{kind}")))
            self.pomona("cut", self.source / "templates/avocado.toml", *WORDS, "--scale", size, "--section", "-o", f"section{size}.ply")
            self.pomona("grow", self.source / "templates/avocado.toml", "--detail", "0.3", "--scale", size, "-o", f"{size}.pomona")
        readers = (read_glb, read_usda, read_obj, read_ply, read_stl, read_pov)
        both = {kind: [reader(self.path / f"{size}.{kind}") for size in (1, 2)] for reader, kind in zip(readers, kinds)}
        for kind, (small, large) in both.items():
            self.assert_places(small, large, kind, 2e-4 if kind == "usda" else CLOSE)
        # All formats have the same place, so units agree.
        middle = {kind: [sum(p[k] for t in small[0].triangles for p, *_ in t) / 3 / len(small[0].triangles) for k in range(3)]
                  for kind, (small, _) in both.items() if kind != "stl"}
        for kind, place in middle.items():
            self.assertLess(length(sub(place, middle["obj"])), 1e-6, kind)

        lists = [json.loads((self.path / f"{size}.json").read_text())["pieces"] for size in (1, 2)]
        for a, b in zip(*lists, strict=True):
            self.assertGreaterEqual(self.assert_facts(a, b, "--pieces"),
                                    {"volume", "density", "mass", "center", "inertia", "low", "high", "triangles"})
        for a, b in zip(*both["glb"], strict=True):
            self.assertGreaterEqual(self.assert_facts(a.facts, b.facts, "glb"), {"volume", "mass", "center", "inertia", "low", "high"})
        for a, b in zip(*both["usda"], strict=True):
            self.assertGreaterEqual(self.assert_facts(a.facts, b.facts, "usda"), {"volume", "physics:mass", "physics:density"})
        # All files have the same data of a piece.
        for listed, glb, usd in zip(lists[0], both["glb"][0], both["usda"][0], strict=True):
            for key in ("volume", "density", "mass", "center", "inertia", "low", "high", "triangles"):
                self.assertEqual(listed[key], glb.facts[key], key)
            self.assertEqual((listed["mass"], listed["volume"]), (usd.facts["physics:mass"], usd.facts["volume"]))
            self.assertAlmostEqual(listed["mass"] / listed["volume"] / listed["density"], 1, 9)

        area = []
        for size in (1, 2):
            rows = ply_rows(self.path / f"section{size}.ply")[1]
            place = [(v["x"], v["y"], v["z"]) for v in rows["vertex"]]
            area.append(sum(length(cross(sub(place[b], place[a]), sub(place[c], place[a]))) / 2
                            for a, b, c in (face["vertex_indices"] for face in rows["face"])))
        self.assertAlmostEqual(area[1] / area[0], 4, 3)
        assets = [read_pomona(self.path / f"{size}.pomona") for size in (1, 2)]
        step = assets[1][0].facts["spacing"] / assets[1][0].facts["units"]
        for (p, *_), (q, *_) in zip(itertools.chain(*assets[0][0].triangles), itertools.chain(*assets[1][0].triangles)):
            self.assertLess(length(sub(times(p, 2), q)), 4 * step)

    def test_a_scene_twice_as_large(self):
        told = []
        for size in (1, 2):
            entries = f'[view]\neye = [{0.1 * size}, {0.05 * size}, {0.2 * size}]\ntarget = [{0.01 * size}, 0.0, 0.0]\nfield = 50\n'
            entries += f'[[pieces]]\nname = "a"\ntemplate = "box.toml"\nas_drawn = true\nsize = {size}\nknives = ["plane:0,0,1,{20 * size}mm"]\n'
            self.scene(entries, [((0.8, 0, 0.6, 0), (0.01 * size, 0, 0)), ((0.6, 0.8, 0, 0), (0.0, -0.03 * size, 0.01 * size))], size=[64, 48])
            self.pomona("scene", "s.toml", "-o", "s.png", "--aov", f"truth{size}")
            told.append(json.loads((self.path / f"truth{size}/annotations.json").read_text()))
        powers = {"volume": 3, "mass": 3, "center_of_mass": 1, "rotation": 0, "translation": 1, "area": 0, "amodal_area": 0, "bbox": 0,
                  "amodal_bbox": 0, "occlusion": 0, "id": 0}
        self.assertEqual(len(told[0]["annotations"]), 2)
        for a, b in zip(told[0]["annotations"], told[1]["annotations"], strict=True):
            for key, power in powers.items():
                self.assert_scaled(a[key], b[key], power, key)
        cameras = [one["images"][0]["camera"] for one in told]
        for key, power in {"eye": 1, "right": 0, "down": 0, "forward": 0, "focal_length": 0, "principal_point": 0}.items():
            self.assert_scaled(cameras[0][key], cameras[1][key], power, key)
        depth = [Picture((self.path / f"truth{size}/depth.png").read_bytes()) for size in (1, 2)]
        steps = [one["images"][0]["metres_per_depth_step"] for one in told]
        for x, y in itertools.product(range(64), range(48)):
            self.assertLess(abs(2 * depth[0].at(x, y) * steps[0] - depth[1].at(x, y) * steps[1]), 2 * steps[0] + steps[1])

    def test_of_a_box_all_is_known(self):
        a, b, c = boxes.EDGES
        self.pomona("cut", "box.toml", "--knife", "plane:0,0,1,20mm", "--style", "plain", "--pieces", "p.json", "-o", "p.glb")
        listed = json.loads((self.path / "p.json").read_text())["pieces"]
        self.assertEqual(len(listed), 2)
        for piece in listed:
            near = piece["center"][2] < 0.02
            low, high = (0.010, 0.020) if near else (0.020, 0.040)
            depth = high - low
            volume, mass = a * b * depth, 900 * a * b * depth
            for key, right in {"volume": volume, "mass": mass, "density": 900}.items():
                self.assertAlmostEqual(piece[key] / right, 1, 5, key)
            self.assert_near(piece["center"], [0.014, 0.002, (low + high) / 2], 1e-7, "center")
            self.assert_near(piece["low"], [*boxes.LOW[:2], low], 1e-7, "low")
            self.assert_near(piece["high"], [*boxes.HIGH[:2], high], 1e-7, "high")
            moments = [mass / 12 * (y * y + z * z) for y, z in ((b, depth), (depth, a), (a, b))]
            for i, j in itertools.product(range(3), range(3)):
                self.assertLess(abs(piece["inertia"][i][j] - (moments[i] if i == j else 0)), 1e-4 * max(moments), "inertia")
        self.assertEqual([one.facts["triangles"] for one in Glb(self.path / "p.glb").placed()], [piece["triangles"] for piece in listed])

    def assert_near(self, told, right, close, about):
        self.assertLess(max(abs(x - y) for x, y in zip(told, right, strict=True)), close, about)

    def test_parts_weigh_by_their_names(self):
        """A heavy core in a light shell: every number depends on the right densities."""
        def surface(k, low, high, front, back):
            place = [tuple((high if i >> axis & 1 else low)[axis] for axis in range(3)) for i in range(8)]
            return [" ".join(map(str, p + (0.5,) * 6 + (0, 1 if k == 0 else 0, 0))) for p in place], \
                [f"3 {8 * k + p} {8 * k + q} {8 * k + r} {k} {front} {back}" for p, q, r in boxes.faces()]
        core_low, core_high = (0.006, -0.001, 0.012), (0.012, 0.005, 0.020)
        shell, core = surface(0, boxes.LOW, boxes.HIGH, 0, 1), surface(1, core_low, core_high, 1, 2)
        text = boxes.surface_file().replace("comment surface 0 skin", "comment part 2 core\ncomment surface 0 skin\ncomment surface 1 core")
        head = text[:text.index("end_header\n") + 11].replace("vertex 8", "vertex 16").replace("face 12", "face 24")
        (self.path / "box.ply").write_text(head + "\n".join(shell[0] + core[0] + shell[1] + core[1]) + "\n")
        parts = 'parts = ["skin", "flesh", "core"]'
        for order in (parts, 'parts = ["core", "skin", "flesh"]'):
            (self.path / "box.toml").write_text(boxes.TEMPLATE.replace('parts = ["skin", "flesh"]', order)
                                                .replace("{ flesh = 900 }", "{ core = 5000, flesh = 800 }"))
            self.pomona("grow", "box.toml", "--style", "plain", "-o", "p.glb")
            facts = read_glb(self.path / "p.glb")[0].facts
            inner = 0.006 * 0.006 * 0.008
            mass = 800 * (boxes.VOLUME - inner) + 5000 * inner
            middle = [(800 * boxes.VOLUME * p + 4200 * inner * q) / mass for p, q in zip((0.014, 0.002, 0.025), (0.009, 0.002, 0.016))]
            self.assertAlmostEqual(facts["volume"] / boxes.VOLUME, 1, 4)
            self.assertLess(abs(facts["mass"] / mass - 1), 0.01, order)
            self.assert_near(facts["center"], middle, 1e-4, order)

    def test_sheets_say_their_size(self):
        """The size of a section in millimetres follows from its dpi: twice the dpi, half the size."""
        for dpi in (72, 144):
            self.pomona("cut", "box.toml", "--knife", "across", "--section", "--size", "200x100", "--dpi", dpi, "-o", f"{dpi}.svg", "-o", f"{dpi}.png")
            head = (self.path / f"{dpi}.svg").read_text()[:600]
            width, height = (float(re.search(rf'{side}="([\d.]+)mm"', head)[1]) for side in ("width", "height"))
            self.assertAlmostEqual(width, 200 * 25.4 / dpi, 1)
            self.assertAlmostEqual(height, 100 * 25.4 / dpi, 1)
            data = (self.path / f"{dpi}.png").read_bytes()
            at = data.index(b"pHYs") + 4
            across, down = (int.from_bytes(data[at + k:at + k + 4], "big") for k in (0, 4))
            self.assertEqual((across, down, data[at + 8]), (round(dpi / 0.0254),) * 2 + (1,))


if __name__ == "__main__":
    Program.program, Program.source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
