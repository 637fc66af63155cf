"""Files of one scene whose textures and materials are shared by nobody, by a piece, by all pieces: the same triangles in
fewer draw calls; with textures, and with colours of vertices; for engines.   atlas_test.py FOLDER"""

import pathlib
import sys
import unittest

from glb import Glb

FOLDER = pathlib.Path(sys.argv[1])


class Atlas(unittest.TestCase):
    files_begin = "small-atlas"

    def setUp(self):
        self.files = {name: Glb(FOLDER / f"{self.files_begin}-{name}.glb") for name in ("none", "piece", "file")}

    def primitives(self, name):
        return [primitive for mesh in self.files[name].json["meshes"] for primitive in mesh["primitives"]]

    def test_a_piece_is_one_draw_call(self):
        meshes = len(self.files["none"].json["meshes"])
        self.assertGreater(len(self.primitives("none")), 2 * meshes, "there is something to join")
        for name in ("piece", "file"):
            self.assertEqual(len(self.primitives(name)), meshes)

    def test_materials_and_images_are_few(self):
        meshes = len(self.files["none"].json["meshes"])
        self.assertEqual(len(self.files["piece"].json["materials"]), meshes)
        self.assertLessEqual(len(self.files["file"].json["materials"]), 2, "open meshes need one that shows both sides")
        self.assertLessEqual(len(self.files["file"].json["images"]), 6, "one for each map")

    def test_triangles_and_parts_stay(self):
        for name in ("piece", "file"):
            for mesh, joined in zip(self.files["none"].json["meshes"], self.files[name].json["meshes"]):
                self.assertEqual(mesh["name"], joined["name"])
                self.assertEqual(mesh["extras"]["parts"], joined["extras"]["parts"])
                self.assertEqual(sorted(self.files["none"].triangles(mesh)), sorted(self.files[name].triangles(joined)))
                self.assertTrue(all("_PART" in primitive["attributes"] for primitive in joined["primitives"]))


class Looks(Atlas):
    files_begin = "small-looks"

    def test_materials_and_images_are_few(self):
        self.assertLessEqual(len(self.files["piece"].json["materials"]), 3, "one for each kind of fruit")
        for name in ("piece", "file"):
            self.assertLessEqual(len(self.files[name].json["images"]), 4, "one for each map")
        self.assertEqual(len(self.files["file"].json["materials"]), 1)

    def test_triangles_and_parts_stay(self):
        for name in ("piece", "file"):
            for mesh, joined in zip(self.files["none"].json["meshes"], self.files[name].json["meshes"]):
                self.assertEqual(mesh["extras"]["parts"], joined["extras"]["parts"])
                self.assertEqual(len(self.files["none"].triangles(mesh)), len(self.files[name].triangles(joined)))


class Engines(unittest.TestCase):
    def test_draw_a_piece_once_unless_light_goes_straight_through(self):
        for name in ("small-godot", "small-unreal", "small-crate"):
            glb = Glb(FOLDER / f"{name}.glb")
            drawn = [mesh["primitives"] for mesh in glb.json["meshes"] if "material" in mesh["primitives"][0]]
            self.assertGreater(len(drawn), 1)
            self.assertLessEqual(max(map(len, drawn)), 2, name)
            self.assertLess(sum(map(len, drawn)), 1.2 * len(drawn), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
