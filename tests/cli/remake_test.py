#!/usr/bin/env python3
"""A .glb's `command` makes a piece again: runs the command in each mesh's extras, and compares vertices and triangles byte by
byte.

    remake_test.py PROGRAM SOURCE
"""

import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()

# Drawn ripeness and browning, folds, strength of variation; bodies as drawn; whole fruit; knives in several files; a
# template of one's own.
SCENE = """
format = 1
name = "small"
seed = 5

[[pieces]]
name = "wedges"
template = "tomato"
count = 2
knives = ["plane:0,1,0,45mm", "wedges:6"]
take = 2
ripeness = [0.6, 1.4]
copies = 2

[[pieces]]
name = "rings"
template = "pepper"
folds = 4
variation = 0.7
knives = ["slices:9mm"]
take = 1

[[pieces]]
name = "brown"
template = "apple"
browning = [0.2, 0.9]
knives = ["half"]
take = 1

[[pieces]]
name = "drawn"
template = "own/cherry two.toml"
as_drawn = true
knives = ["stroke:own/wave.svg#wave"]
take = 1

[[pieces]]
name = "whole"
template = "radish"
"""


def read(glb):
    data = glb.read_bytes()
    length, = struct.unpack_from("<I", data, 12)
    return json.loads(data[20:20 + length]), data[28 + length:]


def arrays(document, buffer, mesh):
    """All bytes of a mesh."""
    def view(accessor):
        part = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
        return buffer[part["byteOffset"]:part["byteOffset"] + part["byteLength"]]
    return [(view(primitive["attributes"]["POSITION"]), view(primitive["indices"])) for primitive in mesh["primitives"]]


class Remake(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def pomona(self, *words):
        subprocess.run([PROGRAM, *words, "--quiet"], cwd=self.path, check=True)

    def by_command(self, command, folder="."):
        """The mesh that a command makes, run by a shell."""
        environment = dict(os.environ, PATH=f"{PROGRAM.parent}:{os.environ['PATH']}")
        result = subprocess.run(["sh", "-c", command + " --quiet"], cwd=self.path / folder, env=environment,
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, command + "\n" + result.stderr)
        document, buffer = read(self.path / folder / command.split(" -o ")[1].strip("'"))
        self.assertEqual(len(document["meshes"]), 1, command)
        return arrays(document, buffer, document["meshes"][0])

    def assert_made_again(self, file, least, folder="."):
        """By commands that are typed in the folder."""
        document, buffer = read(self.path / file)
        self.assertGreaterEqual(len(document["meshes"]), least)
        commands = set()
        for mesh in document["meshes"]:
            command = mesh["extras"]["command"]
            self.assertNotIn(str(self.path), command)
            self.assertIsInstance(mesh["extras"]["seed"], int)
            self.assertIsInstance(mesh["extras"]["index"], int)
            self.assertEqual(self.by_command(command, folder), arrays(document, buffer, mesh), command)
            commands.add(command)
        self.assertEqual(len(commands), len(document["meshes"]))

    def test_the_pieces_of_a_scene(self):
        (self.path / "own").mkdir()
        shutil.copy(SOURCE / "templates/cherry.toml", self.path / "own/cherry two.toml")
        shutil.copy(SOURCE / "templates/cherry.svg", self.path / "own")
        (self.path / "own/wave.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg">'
                                                '<path id="wave" d="M -30 -12 C -10 -16, 10 -6, 30 -10"/></svg>')
        (self.path / "small.toml").write_text(SCENE)
        self.pomona("scene", "small.toml", "--detail", "0.3", "--quality", "draft", "--style", "plain", "-o", "scene.glb")
        self.assert_made_again("scene.glb", 8)

    def test_the_pieces_of_a_cut(self):
        self.pomona("cut", "kiwi", "--seed", "3", "--index", "4", "--knife", "wedges:3", "--detail", "0.3", "-o", "cut.glb")
        self.assert_made_again("cut.glb", 3)

    def test_the_items_of_a_batch(self):
        (self.path / "batch.toml").write_text('[batch]\nformat = 1\nname = "b"\ndetail = 0.3\n[[entry]]\nname = "cut"\n'
                                              'templates = ["tomato"]\ncount = 1\nknives = ["half"]\n')
        self.pomona("batch", "batch.toml", "-o", "out")
        self.assert_made_again(next((self.path / "out").rglob("tomato.glb")).relative_to(self.path), 2)

    def prepare_folder(self):
        """sub/own has a template and a style; looks another style."""
        for folder in ("sub/own", "looks"):
            (self.path / folder).mkdir(parents=True)
            shutil.copy(SOURCE / "styles/gouache.toml", self.path / folder / "mine.toml")
        shutil.copy(SOURCE / "templates/radish.toml", self.path / "sub/own")

    def test_of_a_scene_in_its_folder(self):
        # The scene's template is named from its folder, the style from where the program is called.
        self.prepare_folder()
        scene = ('format = 1\nname = "s"\n{}[[pieces]]\nname = "own"\ntemplate = "own/radish.toml"\n'
                 'knives = ["half"]\ntake = 1\n')
        quick = ["--detail", "0.2", "--quality", "draft"]
        (self.path / "sub/typed.toml").write_text(scene.format(""))
        self.pomona("scene", "sub/typed.toml", "--style", "looks/mine.toml", *quick, "-o", "typed.glb")
        self.assert_made_again("typed.glb", 1, "sub")
        self.assertIn("--style ../looks/mine.toml ", read(self.path / "typed.glb")[0]["meshes"][0]["extras"]["command"])
        (self.path / "sub/named.toml").write_text(scene.format('style = "own/mine.toml"\n'))
        self.pomona("scene", "sub/named.toml", *quick, "-o", "named.glb")
        self.assert_made_again("named.glb", 1, "sub")

    def test_of_a_batch_in_its_folder(self):
        self.prepare_folder()
        (self.path / "sub/batch.toml").write_text(
            '[batch]\nformat = 1\nname = "b"\ndetail = 0.2\nstyle = "own/mine.toml"\n[[entry]]\nname = "cut"\n'
            'templates = ["own/radish.toml"]\ncount = 1\nknives = ["half"]\n')
        self.pomona("batch", "sub/batch.toml", "-o", "out")
        item = next((self.path / "out").rglob("radish.glb")).relative_to(self.path)
        self.assert_made_again(item, 2, "sub")
        # The same folder, whatever the path to its file.
        self.pomona("batch", self.path / "sub/batch.toml", "-o", "out", "--resume")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
