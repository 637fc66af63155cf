#!/usr/bin/env python3
"""One order, one delivery: every file of every command names its seed, and a batch writes, in every format and with every
option, the same as `pomona cut`.

    delivery_test.py PROGRAM SOURCE
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
ONE_RADISH = '''
format = 1
name = "one"
seed = 7
[[pieces]]
name = "a"
template = "radish"
detail = 0.3
knives = ["half"]
'''


class Sandbox(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def run_pomona(self, *words):
        result = subprocess.run([PROGRAM, *words], cwd=self.path, capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stderr

    def makers_in(self, *files):
        return {file: set(re.findall(rb"pomona [0-9.]+, seeds? [0-9,-]+", (self.path / file).read_bytes())) for file in files}


class Seeds(Sandbox):
    def assert_said(self, seeds, *files):
        for file, makers in self.makers_in(*files).items():
            self.assertEqual(len(makers), 1, (file, makers))
            self.assertTrue(makers.pop().endswith(seeds), file)

    def test_of_a_scene_are_in_every_file(self):
        (self.path / "one.toml").write_text(ONE_RADISH)
        files = ("x.glb", "x.usda", "x.pov", "x.html", "x.svg")
        self.run_pomona("scene", "one.toml", "--quality", "draft", *(word for file in files for word in ("-o", file)))
        self.assert_said(b", seed 7", *files)

    def test_of_a_family_are_in_every_file(self):
        files = ("x.glb", "x.usda", "x.pov", "x.html")
        self.run_pomona("grow", "radish", "--seeds", "1-2", "--detail", "0.3", *(word for file in files for word in ("-o", file)))
        self.assert_said(b", seeds 1-2", *files)

    def test_of_a_fruit_are_in_every_file(self):
        files = ("x.glb", "x.usda", "x.pov", "x.pomona", "x.svg")
        self.run_pomona("cut", "radish", "--seed", "5", "--knife", "half", "--quality", "draft", "--detail", "0.3",
                        *(word for file in files for word in ("-o", file)))
        self.assert_said(b", seed 5", "x.glb", "x.usda", "x.pov", "x.svg")


# A TOML value for each option of a batch.
VALUES = {
    "as_drawn": "true", "variation": "0.5", "curves_only": "true", "scale": "1.5", "detail": "0.5", "faces": '"coarse"',
    "piece": "2", "explode": "1.5", "crumbs": "true", "diffuser": '"harmonic"', "style": '"plain"', "texel": '"4mm"',
    "maps": '"all"', "ripeness_variants": '"0.5,1"', "engine": '"unity"', "instances": "true", "feature_ids": "true",
    "size": '"320x240"', "dpi": "150", "view": '"30,20"',
    "compress": '"meshopt"', "up": '"z"', "hulls": "3", "atlas": '"file"',
}
FORMATS = ("ply", "glb", "usda", "obj", "stl", "pov", "svg", "html", "pomona", "xml", "urdf")


class Batches(Sandbox):
    def options(self):
        import json
        listed = json.loads(subprocess.run([PROGRAM, "pages", "options"], capture_output=True, check=True).stdout)
        return [option for option in listed if option["batch_key"]]

    def assert_same(self, keys, formats, fruit="tomato"):
        """The item of a batch with these keys, and the files of `cut` with the same options."""
        textures = "texture = 64\n" if keys.keys() & {"maps", "ripeness_variants", "atlas"} else ""
        lines = "".join(f"{key} = {value}\n" for key, value in keys.items())
        (self.path / "b.toml").write_text(
            f'[batch]\nformat = 1\nname = "b"\n[[entry]]\nname = "a"\ntemplates = "{fruit}"\nseeds = 3\n'
            f'knives = "half"\nformats = {list(formats)}\n{textures}{lines}')
        self.run_pomona("batch", "b.toml", "-o", "out")
        words = ["cut", fruit, "--seed", "3", "--knife", "half", "--quality", "draft"]
        if textures:
            words += ["--texture", "64"]
        if (textures or "texel" in keys) and "maps" not in keys:
            words += ["--maps", "color"]
        for key, value in keys.items():
            value = tomllib.loads("x = " + value)["x"]
            words += ["--" + key.replace("_", "-")] + ([] if value is True else [str(value)])
        (self.path / "by_hand").mkdir()
        self.run_pomona(*words, *(word for format in formats for word in ("-o", f"by_hand/{fruit}.{format}")))
        made = {path.name: path.read_bytes() for path in (self.path / "out/a/000").iterdir() if path.name != "item.json"}
        by_hand = {path.name: path.read_bytes() for path in (self.path / "by_hand").iterdir()}
        self.assertEqual(sorted(made), sorted(by_hand), keys)
        for name, content in made.items():
            self.assertTrue(content == by_hand[name], f"{name} differs with {keys}")

    def test_write_every_format(self):
        self.assert_same({}, FORMATS)

    def test_heed_every_option(self):
        for option in self.options():
            key = option["key"]
            self.assertIn(key, VALUES, "a value for the new option")
            with self.subTest(key), tempfile.TemporaryDirectory() as folder:
                self.path = pathlib.Path(folder)
                heeded = [name for name in ("glb", "svg") if not option["formats"] or name in option["formats"]]
                fruit = {"detail": '0.4'} if key != "detail" else {}
                self.assert_same({**fruit, key: VALUES[key]}, heeded or option["formats"][:1])


class Hulls(Sandbox):
    def test_have_the_same_bytes_each_time(self):
        # CGAL divided flat faces by addresses, which differ from run to run: one in four files was another.
        files = []
        for run in range(5):
            self.run_pomona("cut", "tomato", "--knife", "wedges:6", "--detail", "0.4", "--quality", "draft", "--hulls", "3",
                            "-o", f"{run}.xml")
            files.append((self.path / f"{run}.xml").read_bytes())
        self.assertEqual(len(set(files)), 1)


class Table(unittest.TestCase):
    def test_is_what_documents_and_schemas_say(self):
        result = subprocess.run([SOURCE / "scripts/option_docs.py", "check", PROGRAM], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
