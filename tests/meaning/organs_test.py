#!/usr/bin/env python3
"""Organs in ground truth, computed again: the area, box and mask of every one from Organ.X of a picture and from organ.png of
one twice as large, and by that what CryptoOrgan says to cover each pixel.

    organs_test.py PROGRAM SOURCE
"""

import json
import pathlib
import struct
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from boxes import Program  # noqa: E402
from exr import Layers  # noqa: E402
from png import Picture  # noqa: E402
from truth_test import box_of, unpacked  # noqa: E402

WIDTH, HEIGHT = 96, 72


class Organs(Program):
    def make(self):
        def cut(folder, size, *more):
            # From low, for there berries hide others.
            self.pomona("cut", "currants", "--seed", "1", "--knife", "half", "--detail", "0.1", "--quality", "draft", "--size", size,
                        "--view=25,5", "-o", "x.png", "--aov", folder, *more)
            return json.loads((self.path / folder / "annotations.json").read_text())["annotations"]
        of_exr = cut("exr", f"{WIDTH}x{HEIGHT}", "--aov-format", "exr")
        exr = Layers((self.path / "exr/truth.exr").read_bytes())
        of_png = cut("png", f"{2 * WIDTH}x{2 * HEIGHT}")
        pictures = [Picture((self.path / f"png/{name}.png").read_bytes()) for name in ("instance", "organ")]
        # What each pixel shows: the numbers of piece and organ.
        seen = list(zip(exr.channels["Instance.X"], exr.channels["Organ.X"]))
        fine = [tuple(one.at(x, y) for one in pictures) for y in range(2 * HEIGHT) for x in range(2 * WIDTH)]
        return {"of_exr": of_exr, "of_png": of_png, "exr": exr, "seen": seen, "fine": fine}

    def assert_told(self, annotations, seen, width):
        found, hidden = {}, 0
        for i, which in enumerate(seen):
            if which[0]:
                found.setdefault(which, set()).add((i % width, i // width))
        self.assertGreater(len(found), 12)
        for piece in annotations:
            self.assertTrue(piece["organs"])
            for organ in piece["organs"]:
                shown = found.pop((piece["id"], organ["instance"]), set())
                hidden += not shown
                self.assertEqual((organ["area"], "bbox" in organ), (len(shown), bool(shown)), organ)
                if shown:
                    self.assertEqual((organ["bbox"], unpacked(organ["segmentation"])), (box_of(shown), shown), organ)
            self.assertEqual(sum(organ["area"] for organ in piece["organs"]), piece["area"])
        self.assertEqual(found, {}, "each that shows is listed")
        self.assertGreater(hidden, 0, "some lie behind others")

    def test_numbers_are_those_of_the_picture(self):
        self.assert_told(self.of_png, self.fine, 2 * WIDTH)

    def test_numbers_are_those_of_the_floats(self):
        self.assert_told(self.of_exr, self.seen, WIDTH)

    def test_mattes_say_what_covers_a_pixel(self):
        key, = (key for key, text in self.exr.texts.items() if text == "CryptoOrgan")
        manifest = json.loads(self.exr.texts[key.removesuffix("name") + "manifest"])
        called = {(piece["id"], organ["instance"]): piece["name"] + f".{organ['name']}-{organ['instance']}" * (organ["instance"] > 0)
                  for piece in self.of_exr for organ in piece["organs"]}
        ranks = [[self.exr.channels[f"CryptoOrgan0{rank}.{which}"] for which in pair] for rank in (0, 1) for pair in ("RG", "BA")]
        several = 0
        for i in range(WIDTH * HEIGHT):
            told = {struct.pack("<f", ids[i]): shares[i] for ids, shares in ranks if shares[i]}
            expected = {}
            for k in range(4):
                which = self.fine[2 * WIDTH * (2 * (i // WIDTH) + k // 2) + 2 * (i % WIDTH) + k % 2]
                if which[0]:
                    key = struct.pack("<I", int(manifest[called[which]], 16))
                    expected[key] = expected.get(key, 0) + 0.25
            self.assertEqual(told, expected, (i % WIDTH, i // WIDTH))
            several += len(told) > 1
        self.assertGreater(several, 10, "pixels that show two berries")


if __name__ == "__main__":
    Program.program, Program.source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
