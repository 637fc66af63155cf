"""Python writes what the program writes, byte for byte: every fruit cut once, all items of a batch, a scene.

    bytes_test.py PROGRAM SOURCE [--full]

Quick, with coarse fruit; --full at the usual detail, with every format and more cuts.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
FULL = "--full" in sys.argv
FOLDER = tempfile.TemporaryDirectory(prefix="pomona-test-")
os.chdir(FOLDER.name)

import pomona

COARSE = {} if FULL else {"detail": 0.4}
KNIVES = ("half", "across", "wedges:6", "ball:24mm", "slices:5") if FULL else ("half", "across", "wedges:4")
ENDINGS = ("glb", "usda", "obj", "stl", "ply", "pov", "svg", "png", "html", "pomona") if FULL else ("glb", "ply")
BATCH = """
[batch]
format = 1
name = "few"
title = "A few"
seed = 5
quality = "draft"
detail = 0.4
[[entry]]
name = "cut"
templates = ["lemon", "cherry"]
count = 2
ripeness = [0.3, 1.5]
knives = ["half", "wedges:3"]
[[entry]]
name = "browned"
templates = "avocado"
seeds = [0, 1]
browning = [0, 1]
knives = [["half", "across"]]
texture = 64
"""


def run_program(*words):
    subprocess.run([PROGRAM, *map(str, words), "--quiet"], check=True)


def words_of(options):
    return [word for name, value in options.items() for word in (f"--{name}", value)]


class SameBytes(unittest.TestCase):
    maxDiff = 300

    def compare(self, what):
        for folder in ("program", "python"):
            self.assertTrue(any(pathlib.Path(folder).iterdir()))
        files = {path.name: path for path in pathlib.Path("program").iterdir()}
        self.assertEqual(set(files), {path.name for path in pathlib.Path("python").iterdir()}, what)
        for name, path in files.items():
            self.assertTrue(path.read_bytes() == pathlib.Path("python", name).read_bytes(), f"{what}: {name} differs")

    def setUp(self):
        for folder in ("program", "python"):
            pathlib.Path(folder).mkdir(exist_ok=True)
            for file in pathlib.Path(folder).iterdir():
                file.unlink()

    def paths(self, folder, stem):
        return [f"{folder}/{stem}.{ending}" for ending in ENDINGS]

    def outputs(self, stem):
        return [word for path in self.paths("program", stem) for word in ("-o", path)]

    def knives(self, number):
        """In the quick run each fruit is cut by one of the knives."""
        return KNIVES if FULL else KNIVES[number % len(KNIVES):][:1]

    def test_of_every_fruit(self):
        names = sorted(file.stem for file in (SOURCE / "templates").glob("*.toml"))
        self.assertGreaterEqual(len(names), 24)
        for seed, name in enumerate(names):
            for knife in self.knives(seed):
                self.setUp()
                options = {"seed": seed, "quality": "draft", **COARSE}
                planes = [e for e in ENDINGS if not (e in ("html", "pomona") and knife.startswith("ball"))]
                wanted = [f"{name}.{ending}" for ending in planes]
                run_program("cut", name, *words_of(options), "--knife", knife, *(w for one in wanted for w in ("-o", f"program/{one}")))
                pomona.grow(name, **options).cut(knife).write(*(f"python/{one}" for one in wanted))
                self.compare(f"{name} by {knife}")

    def test_of_a_whole_fruit_a_section_and_a_row(self):
        run_program("grow", "pepper", "--seed", 3, *words_of(COARSE), *self.outputs("whole"))
        pomona.grow("pepper", seed=3, **COARSE).write(*self.paths("python", "whole"))
        run_program("cut", "pepper", "--seed", 3, *words_of(COARSE), "--knife", "half", "--section", "-o", "program/section.svg", "-o", "program/section.ply")
        pomona.grow("pepper", seed=3, **COARSE).section("half").write("python/section.svg", "python/section.ply")
        run_program("cut", "cherry", "--seeds", "1-3", *words_of(COARSE), "--knife", "half", "-o", "program/row.glb")
        pomona.grow("cherry", seeds="1-3", **COARSE).cut("half").write("python/row.glb")
        self.compare("a pepper")

    def test_of_a_page_beside_a_mesh(self):
        endings = ("glb", "html", "pomona")
        run_program("cut", "cherry", *words_of(COARSE), "--knife", "half", *(w for e in endings for w in ("-o", f"program/cut.{e}")))
        written = pomona.grow("cherry", **COARSE).cut("half").write(*(f"python/cut.{ending}" for ending in endings))
        self.assertEqual({path.name for path in written}, {f"cut.{ending}" for ending in endings})
        self.compare("a page")

    def test_of_textures_levels_and_ground_truth(self):
        options = {"seed": 2, "ripeness": 0.4, "texture": 64, "maps": "all", "lod": 1}
        run_program("cut", "tomato", *words_of({**options, **COARSE}), "--knife", "half", "-o", "program/textured.glb")
        growing = {"seed": 2, "ripeness": 0.4, **COARSE}
        pomona.grow("tomato", **growing).cut("half", texture=64, maps="all").write("python/textured.glb", lod=1)
        self.compare("textures")

    def test_of_every_item_of_a_batch(self):
        pathlib.Path("few.toml").write_text(BATCH)
        run_program("batch", "few.toml", "-o", "few")
        keywords = {option.keyword: option for option in pomona.options()}
        made = 0
        for record in pathlib.Path("few").glob("*/*/item.json"):
            item = json.loads(record.read_text())
            given = {name: value for name, value in item.items() if name in keywords}
            given.pop("pieces")
            steps = {step: {k: v for k, v in given.items() if keywords[k].step == step} for step in ("grow", "cut", "write")}
            cut = {**steps["cut"], **steps["write"], **({"texture": 64, "maps": "color"} if item["entry"] == "browned" else {})}
            fruit = pomona.grow(item["template"], **{**steps["grow"], "detail": 0.4})
            for path in fruit.cut(*item["knives"], **cut).write(*(f"python/{file['name']}" for file in item["files"])):
                made += 1
                self.assertTrue(path.read_bytes() == (record.parent / path.name).read_bytes(), f"{item['item']}: {path.name} differs")
        self.assertEqual(made, 20)

    def test_of_a_scene(self):
        names = ["salad", "fruit_bowl", "chopping_board"] if FULL else ["ripeness"]
        endings = ("glb", "json", "svg", "ply", "png") if FULL else ("glb", "json", "svg")
        for name in names:
            self.setUp()
            options = {"seed": 2, "quality": "draft", **({} if FULL else {"detail": 0.3})}
            run_program("scene", name, *words_of(options), *(w for e in endings for w in ("-o", f"program/scene.{e}")))
            pomona.scene(name, **options).write(*(f"python/scene.{e}" for e in endings))
            self.compare(name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
