#!/usr/bin/env python3
"""Blender imports a scene: every piece at its place, in its group, with its triangles, materials and properties, and a
picture of it shows fruit.

    blender_test.py FILE.glb FOLDER [ATLAS.glb...]

Further files of the same scene have their colours in images: the same as those of the vertices.
"""

import json
import os
import pathlib
import subprocess
import sys
import unittest

from glb import Glb

FILE, FOLDER, *ATLASES = (pathlib.Path(word).resolve() for word in sys.argv[1:])


class InBlender(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FOLDER.mkdir(parents=True, exist_ok=True)
        script = pathlib.Path(__file__).with_name("blender_scene.py")
        # Blender's Python looks along PATH for its own home: no other Python may stand there first.
        environment = dict(os.environ, PATH="/usr/bin:/bin")
        result = subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "-t", "2", "-P", script,
                                 "--", FILE, FOLDER / "blender.png", *ATLASES], capture_output=True, text=True, timeout=240,
                                env=environment)
        assert result.returncode == 0, result.stdout[-3000:] + result.stderr[-3000:]
        lines = dict(line.split(" ", 1) for line in result.stdout.splitlines() if line.startswith(("SAID ", "SEEN ", "COLORS ")))
        cls.said, cls.seen, cls.colors = (json.loads(lines[word]) for word in ("SAID", "SEEN", "COLORS"))
        cls.glb = Glb(FILE)

    def test_every_piece_is_an_object_at_its_place(self):
        nodes = self.glb.nodes_with_meshes()
        self.assertEqual(set(self.said["objects"]), set(nodes))
        for name, node in nodes.items():
            x, y, z = node["translation"]
            for theirs, ours in zip(self.said["objects"][name]["place"], (x, -z, y)):
                self.assertAlmostEqual(theirs, ours, places=5, msg=name)
            self.assertEqual(self.said["objects"][name]["mesh"], self.glb.json["meshes"][node["mesh"]]["name"])

    def test_pieces_of_a_fruit_hang_together(self):
        self.assertEqual(self.said["objects"]["tomato-wedges-1.piece-2"]["in"], "tomato-wedges-1")
        self.assertEqual(self.said["objects"]["radish-1"]["in"], "radish")

    def test_meshes_come_whole_with_colours_materials_and_properties(self):
        self.assertEqual(len(self.said["meshes"]), len(self.glb.json["meshes"]))
        for mesh in self.glb.json["meshes"]:
            theirs = self.said["meshes"][mesh["name"]]
            # Blender takes a triangle of the same vertices but once.
            different = {tuple(sorted(corners)) for corners in self.glb.triangles(mesh)}
            self.assertEqual(theirs["triangles"], len(different), mesh["name"])
            self.assertEqual(theirs["colors"], 1)
            names = [self.glb.json["materials"][primitive["material"]]["name"] for primitive in mesh["primitives"]]
            self.assertEqual(theirs["materials"], names)
            for key in ("template", "seed", "knife", "command", "mass"):
                self.assertEqual(theirs["extras"][key], mesh["extras"][key])

    def test_images_have_the_colours_of_vertices(self):
        for file in ATLASES:
            told = self.colors[str(file)]
            self.assertEqual(set(told), set(self.said["objects"]), file.name)
            for name, difference in told.items():
                # Texels blur an onion's skins, which are thinner.
                texels = 0.2 if name.startswith("onion") else 0.05
                self.assertLess(difference, 0.005 if "looks" in file.name else texels, f"{name} of {file.name}")

    def test_the_camera_sees_fruit(self):
        self.assertEqual(self.said["cameras"], ["view"])
        self.assertGreater(self.seen["share"], 0.03)
        red, green, blue = self.seen["color"]
        self.assertGreater(red, 1.3 * blue, "tomatoes, onions and a radish are red")
        self.assertLess(max(red, green, blue), 0.95, "white is nothing")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
