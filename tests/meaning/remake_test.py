#!/usr/bin/env python3
"""A piece made in a cut, alone, in a scene and in a batch: its `command` makes every vertex again, with normals, colours,
parts and textures, and all numbers of the piece.

    remake_test.py PROGRAM SOURCE
"""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from boxes import Program  # noqa: E402
from read_meshes import Glb  # noqa: E402

SCENE = """format = 1
name = "s"
seed = 7
style = "plain"
[[pieces]]
name = "w"
template = "tomato.toml"
count = 2
knives = ["wedges:5"]
take = 2
ripeness = [0.5, 1.5]
size = [0.8, 1.2]
[[pieces]]
name = "v"
template = "tomato.toml"
knives = ["half", "across"]
take = 2
variation = 0.6
"""


class Remake(Program):
    def setUp(self):
        super().setUp()
        for kind in ("toml", "svg"):
            shutil.copy(self.source / f"templates/tomato.{kind}", self.path)

    def arrays(self, glb, mesh):
        """The bytes of all attributes and of all pictures."""
        def view(accessor):
            described = glb.json["accessors"][accessor]
            return glb.values(accessor), described["type"]
        found = {}
        for number, primitive in enumerate(mesh["primitives"]):
            for name, accessor in [*primitive["attributes"].items(), ("indices", primitive["indices"])]:
                found[number, name] = view(accessor)
        return found

    def assert_made_again(self, file, least, words=("inertia", "center", "mass", "volume", "density", "low", "high", "triangles",
                                                    "closed", "crumb", "parts", "seed", "index", "knife", "piece", "template")):
        glb = Glb(self.path / file)
        self.assertGreaterEqual(len(glb.json["meshes"]), least)
        for mesh in glb.json["meshes"]:
            command = mesh["extras"]["command"]
            environment = dict(os.environ, PATH=f"{self.program.parent}:{os.environ['PATH']}")
            done = subprocess.run(["sh", "-c", command + " --quiet"], cwd=self.path, env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, command + done.stderr)
            again = Glb(self.path / command.split(" -o ")[1].strip("'"))
            self.assertEqual(len(again.json["meshes"]), 1)
            other, = again.json["meshes"]
            mine, others = self.arrays(glb, mesh), self.arrays(again, other)
            # By name: of long arrays unittest would take minutes to print how they differ.
            self.assertEqual([name for name in sorted({*mine, *others}) if mine.get(name) != others.get(name)], [], command)
            for word in words:
                self.assert_same_number(mesh["extras"][word], other["extras"][word], (command, word))
            pictures = [[g.view(image["bufferView"])[0] for image in g.json.get("images", []) if image["name"].startswith(mesh["name"])]
                        for g in (glb, again)]
            self.assertEqual(*pictures, command)

    def assert_same_number(self, a, b, about):
        self.assertEqual(a, b, about)

    def test_pieces_of_a_cut(self):
        self.pomona("cut", "tomato.toml", "--seed", "3", "--knife", "half", "--knife", "across", "--detail", "0.3", "--quality", "draft", "-o", "c.glb")
        self.assert_made_again("c.glb", 4)

    def test_with_textures(self):
        self.pomona("cut", "tomato.toml", "--seed", "4", "--knife", "wedges:3", "--detail", "0.3", "--quality", "draft", "--texture", "64",
                    "--feature-ids", "-o", "c.glb")
        self.assert_made_again("c.glb", 3)

    def test_pieces_of_a_scene(self):
        (self.path / "s.toml").write_text(SCENE)
        self.pomona("scene", "s.toml", "--detail", "0.3", "--quality", "draft", "-o", "s.glb")
        self.assert_made_again("s.glb", 6)

    def test_sizes_are_drawn_apart_from_ripeness(self):
        """A scene with other sizes has the same fruit, only larger: sizes and fruit have independent random numbers."""
        def ripeness_and_size(scene):
            (self.path / "s.toml").write_text(scene)
            self.pomona("scene", "s.toml", "--detail", "0.2", "--quality", "draft", "-o", "s.glb")
            words = [mesh["extras"]["command"].split() for mesh in Glb(self.path / "s.glb").json["meshes"]]
            return [tuple(w[w.index(key) + 1] for key in ("--ripeness", "--scale") if key in w) for w in words]
        both = 'format = 1\nname = "s"\nseed = 7\n[[pieces]]\nname = "w"\ntemplate = "tomato.toml"\ncount = 6\n'
        drawn = ripeness_and_size(both + "ripeness = [0.0, 2.0]\nsize = [1.0, 3.0]\n")
        ripe, size = [float(r) / 2 for r, _ in drawn], [(float(s) - 1) / 2 for _, s in drawn]
        self.assertGreater(max(abs(a - b) for a, b in zip(ripe, size)), 0.1, "one stream draws both")
        self.assertEqual([r for r, _ in drawn], [r[0] for r in ripeness_and_size(both + "ripeness = [0.0, 2.0]\n")])
        self.assertEqual(len(set(drawn)), 6)

    def test_entries_of_one_template_are_not_the_same_fruit(self):
        entry = '[[pieces]]\nname = "{}"\ntemplate = "tomato.toml"\ncount = 2\n'
        (self.path / "s.toml").write_text('format = 1\nname = "s"\nseed = 7\n' + entry.format("a") + entry.format("b"))
        self.pomona("scene", "s.toml", "--detail", "0.2", "--quality", "draft", "-o", "s.glb")
        glb = Glb(self.path / "s.glb")
        self.assertEqual(len({mesh["extras"]["index"] for mesh in glb.json["meshes"]}), 4)
        self.assertEqual(len({mesh["extras"]["volume"] for mesh in glb.json["meshes"]}), 4)


if __name__ == "__main__":
    Program.program, Program.source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
