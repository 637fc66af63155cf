#!/usr/bin/env python3
"""Ground truth, computed again: every number of annotations.json from the pictures, and every picture from the meshes in the
.ply of the same scene, by this file's own rasteriser.

    truth_test.py PROGRAM SOURCE
"""

import json
import pathlib
import shutil
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from boxes import Program  # noqa: E402
from png import Picture  # noqa: E402
from read_meshes import Glb, ply_rows, read_glb, read_ply  # noqa: E402
from vectors import add, dot, furthest, length, sub, times, turned, unit  # noqa: E402

WIDTH, HEIGHT = 128, 96
ENTRIES = """[view]
eye = [0.02, 0.11, 0.3]
target = [0.002, 0.012, 0.0]
field = 17
[[pieces]]
name = "half"
template = "cherry.toml"
count = 2
knives = ["half"]
[[pieces]]
name = "box"
template = "box.toml"
as_drawn = true
copies = 3
"""


def box_at(turn, middle):
    """The pose that puts the box's middle there."""
    return turn, sub(middle, turned(turn, (0.014, 0.002, 0.025)))


# Two fruit in halves beside each other; a box before one of them, one farther away behind that, and one behind another half.
EYE, BOX, TIPPED = (0.02, 0.11, 0.3), (-0.012, 0.012, 0.05), unit((0.8, 0.1, 0.5, -0.2))
POSES = [(unit((1, -0.1, 0.1, 0)), (-0.032, 0.005, -0.01)), (unit((0.1, 0, 1, -0.1)), (0.014, 0.0, -0.02)),
         (unit((0.6, 0, 0.8, 0)), (0.034, -0.01, -0.02)), (unit((0.8, 0.3, 0, -0.6)), (0.02, 0.0, 0.02)), box_at(TIPPED, BOX),
         box_at(TIPPED, add(EYE, times(sub(BOX, EYE), 1.3))), box_at(unit((0.5, 0.5, -0.5, 0.5)), (0.022, 0.012, -0.05))]


def unpacked(mask):
    """The pixels of COCO's compressed run lengths, as a set of (x, y)."""
    height, width = mask["size"]
    runs, at, text = [], 0, mask["counts"]
    while at < len(text):
        value, shift, more = 0, 0, True
        while more:
            c = ord(text[at]) - 48
            at += 1
            value |= (c & 31) << shift
            shift += 5
            more = bool(c & 32)
            if not more and c & 16:
                value -= 1 << shift
        runs.append(value + (runs[-2] if len(runs) > 2 else 0))
    pixels, i = set(), 0
    for number, run in enumerate(runs):
        if number % 2:
            pixels.update(((i + k) // height, (i + k) % height) for k in range(run))
        i += run
    assert i == width * height, "runs that fill the picture"
    return pixels


def box_of(pixels):
    """COCO's: left, top, width, height."""
    if not pixels:
        return [0, 0, 0, 0]
    x, y = [p[0] for p in pixels], [p[1] for p in pixels]
    return [min(x), min(y), max(x) - min(x) + 1, max(y) - min(y) + 1]


class Truth(Program):
    def make(self):
        for kind in ("toml", "svg"):
            shutil.copy(self.source / f"templates/cherry.{kind}", self.path)
        names = self.scene(ENTRIES, POSES, size=[WIDTH, HEIGHT], seed=4)
        self.pomona("scene", "s.toml", "--detail", "0.3", "--quality", "draft", "-o", "s.png", "--aov", "truth", "-o", "s.glb", "-o", "s.ply")
        layers = ("instance", "fruit", "part", "depth", "normal", "section", "amodal_1")
        return {"names": names, "told": json.loads((self.path / "truth/annotations.json").read_text()),
                "layer": {name: Picture((self.path / f"truth/{name}.png").read_bytes()) for name in layers},
                "pixels": [(x, y) for y in range(HEIGHT) for x in range(WIDTH)]}

    def seen(self, number):
        return {p for p in self.pixels if self.layer["instance"].at(*p) == number}

    def covered(self, number):
        return {p for p in self.pixels if self.layer["amodal_1"].at(*p) >> (number - 1) & 1}

    def test_numbers_are_those_of_the_pictures(self):
        told, = self.told["images"]
        self.assertEqual((told["width"], told["height"], told["file_name"], told["seed"]), (WIDTH, HEIGHT, "s.png", 4))
        shown, hidden = self.told["annotations"], self.told["hidden"]
        self.assertEqual({one["id"] for one in shown}, {self.layer["instance"].at(*p) for p in self.pixels} - {0})
        self.assertTrue(hidden, "one box stands behind another")
        for one in shown + hidden:
            number = one["id"]
            seen, covered = self.seen(number), self.covered(number)
            self.assertEqual(bool(seen), one in shown)
            self.assertLessEqual(seen, covered)
            self.assertEqual((one["area"], one["bbox"], unpacked(one["segmentation"])), (len(seen), box_of(seen), seen), one["name"])
            self.assertEqual((one["amodal_area"], one["amodal_bbox"], unpacked(one["amodal_segmentation"])),
                             (len(covered), box_of(covered), covered), one["name"])
            self.assertAlmostEqual(one["occlusion"], 1 - len(seen) / len(covered), 9)
            self.assertEqual({self.layer["fruit"].at(*p) for p in seen}, {one["fruit_id"]} if seen else set())
        partly = [one for one in shown if 0.05 < one["occlusion"] < 0.95]
        self.assertGreaterEqual(len(partly), 2, "pieces that are hidden in part")

    def test_names_are_those_of_the_scene(self):
        kind = {one["id"]: one["name"] for one in self.told["categories"]}
        fruit = {one["id"]: one for one in self.told["fruits"]}
        whole = {"half-1.piece-1": "half-1", "half-1.piece-2": "half-1", "half-2.piece-1": "half-2", "half-2.piece-2": "half-2"}
        for one in self.told["annotations"] + self.told["hidden"]:
            self.assertEqual(one["name"], self.names[one["id"] - 1])
            self.assertEqual(kind[one["category_id"]], "cherry" if one["name"].startswith("half") else "box")
            self.assertEqual(fruit[one["fruit_id"]]["name"], whole.get(one["name"], "box-1"))
            self.assertEqual(fruit[one["fruit_id"]]["category_id"], one["category_id"])
        # Part numbers belong to a kind of fruit.
        part = {one["id"]: one for one in self.told["parts"]}
        category = {one["id"]: one["category_id"] for one in self.told["annotations"]}
        for p in self.pixels:
            number, which = self.layer["instance"].at(*p), self.layer["part"].at(*p)
            self.assertEqual(which == 0, number == 0)
            if which:
                self.assertEqual(part[which]["category_id"], category[number])

    def test_facts_are_those_of_the_meshes(self):
        glb = Glb(self.path / "s.glb").json
        node = {n["name"]: n for n in glb["nodes"] if "mesh" in n}
        for one in self.told["annotations"] + self.told["hidden"]:
            facts, (turn, shift) = glb["meshes"][node[one["name"]]["mesh"]]["extras"], POSES[one["id"] - 1]
            self.assertEqual((one["volume"], one["mass"]), (facts["volume"], facts["mass"]), one["name"])
            self.assertLess(furthest(one["rotation"], turn), 2e-6)
            self.assertLess(furthest(one["translation"], shift), 2e-6)
            self.assertLess(furthest(one["center_of_mass"], add(turned(turn, facts["center"]), shift)), 1e-6)
            self.assertLess(furthest(one["center_of_mass"], node[one["name"]]["translation"]), 1e-6)
        # A box's centre is known.
        boxes = [one for one in self.told["annotations"] + self.told["hidden"] if one["name"].startswith("box")]
        for one in boxes:
            turn, shift = POSES[one["id"] - 1]
            self.assertLess(furthest(one["center_of_mass"], add(turned(turn, (0.014, 0.002, 0.025)), shift)), 1e-6)
            self.assertAlmostEqual(one["mass"] / (900 * 6e-6), 1, 5)

    def test_pictures_are_those_of_the_meshes(self):
        camera = self.told["images"][0]["camera"]
        step = self.told["images"][0]["metres_per_depth_step"]
        part_name = {one["id"]: one["name"] for one in self.told["parts"]}
        placed = read_ply(self.path / "s.ply")
        cut = [[] for _ in placed]
        for face in ply_rows(self.path / "s.ply")[1]["face"]:
            cut[face["piece"]].append(face["cut"] >= 0)
        self.assertEqual([one.name for one in placed], self.names)
        hits = [rasterised(one.triangles, camera) for one in placed]

        count = {"instance": 0, "depth": 0, "normal": 0, "part": 0, "section": 0, "amodal": 0}
        inside = 0
        for p in self.pixels:
            near = min(((hit[p][0], number) for number, hit in enumerate(hits) if p in hit), default=None)
            number = self.layer["instance"].at(*p)
            count["instance"] += number != (near[1] + 1 if near else 0)
            count["amodal"] += self.layer["amodal_1"].at(*p) != sum(1 << k for k, hit in enumerate(hits) if p in hit)
            if not near or number != near[1] + 1:
                continue
            inside += 1
            depth, which, weights = hits[near[1]][p]
            triangle = placed[near[1]].triangles[which]
            normal = unit(tuple(sum(w * corner[1][k] for w, corner in zip(weights, triangle)) for k in range(3)))
            told = tuple(v / 65535 * 2 - 1 for v in self.layer["normal"].at(*p))
            self.assertAlmostEqual(length(told), 1, 3)
            count["depth"] += abs(self.layer["depth"].at(*p) * step - depth) > 1.5 * step
            count["normal"] += min(length(sub(told, normal)), length(add(told, normal))) > 0.02
            count["section"] += (self.layer["section"].at(*p) == 65535) != cut[near[1]][which]
            count["part"] += part_name[self.layer["part"].at(*p)] != placed[near[1]].parts[which]
        self.assertGreater(inside, 1500)
        self.assertGreater(sum(self.layer["section"].at(*p) > 0 for p in self.pixels), 150, "cut faces are seen")
        # If two meshes or triangles meet at a pixel's middle, either may be shown.
        for what, wrong in count.items():
            self.assertLessEqual(wrong, {"part": 0.03, "normal": 0.02}.get(what, 0.01) * inside, (what, count, inside))


def rasterised(triangles, camera):
    """By pixel: the depth along the middle's line of sight, the number of the triangle that is nearest, and its weights."""
    eye, right, down, forward = (camera[key] for key in ("eye", "right", "down", "forward"))
    focal, (cx, cy) = camera["focal_length"], camera["principal_point"]
    found = {}
    for number, triangle in enumerate(triangles):
        away = [sub(corner[0], eye) for corner in triangle]
        depth = [dot(forward, d) for d in away]
        x = [cx + focal * dot(right, d) / z for d, z in zip(away, depth)]
        y = [cy + focal * dot(down, d) / z for d, z in zip(away, depth)]
        whole = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
        if whole == 0:
            continue
        for py in range(max(0, int(min(y) - 0.5)), min(HEIGHT, int(max(y) + 1.5))):
            for px in range(max(0, int(min(x) - 0.5)), min(WIDTH, int(max(x) + 1.5))):
                u, v = px + 0.5, py + 0.5
                share = [((x[(k + 1) % 3] - u) * (y[(k + 2) % 3] - v) - (x[(k + 2) % 3] - u) * (y[(k + 1) % 3] - v)) / whole
                         for k in range(3)]
                if min(share) < 0:
                    continue
                near = sum(s / z for s, z in zip(share, depth))
                if (px, py) not in found or 1 / near < found[px, py][0]:
                    found[px, py] = (1 / near, number, [s / z / near for s, z in zip(share, depth)])
    return found


if __name__ == "__main__":
    Program.program, Program.source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
