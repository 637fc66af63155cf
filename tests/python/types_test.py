"""mypy takes programs that use the module as the guide does, and tells those that do not.

    types_test.py MYPY
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

MYPY = sys.argv[1]
GOOD = """
import numpy
from numpy.typing import NDArray
import pomona

def volumes(seed: int) -> list[float]:
    fruit = pomona.grow("tomato", seed=seed, ripeness=0.4, detail=0.5)
    pieces = fruit.cut("wedges:6", quality="draft", texture=512)
    points: NDArray[numpy.float32] = pieces[0].positions
    triangles: NDArray[numpy.uint32] = pieces[-1].triangles
    print(points.shape, triangles.max(), len(pieces), [piece.name for piece in pieces[1:]])
    pieces.write("x.glb", "x.usda", lod=2, progress=lambda stage, done, total: print(stage, done / total))
    return [piece.volume for piece in pieces]

def picture() -> NDArray[numpy.uint8]:
    scene = pomona.scene({"scene": {"title": "nothing"}}, seed=2)
    truth = scene.ground_truth(size=(640, 480))
    print(truth.depth.max(), scene.poses.shape, pomona.grow("tomato").section("half").triangles)
    return scene.render(size=(640, 480), view="top")

try:
    volumes(3)
except pomona.Error as error:
    print(error.file, error.line + error.column, error.hint, error.diagnostics[0].message)
print([option.keyword for option in pomona.options()], [t.title for t in pomona.templates()])
"""
BAD = {
    'pomona.grow("tomato", ripenes=1)': "ripenes",
    'pomona.grow("tomato").cut("half", quality="fnal")': "fnal",
    'pomona.grow("tomato", folds="many")': "folds",
    'pomona.grow("tomato").cut("half").volume': "volume",
    'pomona.grow("tomato").section("half").write("x.svg", seed=3)': "seed",
    'len(pomona.grow("tomato"))': "len",
}


class Types(unittest.TestCase):
    def checked(self, text):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "program.py").write_text(text)
            words = [MYPY, "--strict", "--python-executable", sys.executable, "program.py"]
            done = subprocess.run(words, cwd=folder, capture_output=True, text=True, env={**os.environ, "MYPYPATH": ""})
            return done.returncode, done.stdout + done.stderr

    def test_what_is_right_is_taken(self):
        self.assertEqual(self.checked(GOOD)[0], 0, self.checked(GOOD)[1])

    def test_what_is_wrong_is_told(self):
        status, told = self.checked("import pomona\n" + "\n".join(BAD) + "\n")
        self.assertEqual(status, 1, told)
        for line in range(2, 2 + len(BAD)):
            self.assertRegex(told, rf"program\.py:{line}: error", told)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
