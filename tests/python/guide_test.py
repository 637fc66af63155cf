"""Runs the programs of docs/guides/python.md, of README.md and of the notebook, word for word, from a clean folder.

    guide_test.py SOURCE
"""

import contextlib
import importlib.util
import io
import json
import os
import pathlib
import re
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()


def programs(document):
    return re.findall(r"^```python\n(.*?)^```", (SOURCE / document).read_text(encoding="utf-8"), re.M | re.S)


def cells(notebook):
    parsed = json.loads((SOURCE / notebook).read_text(encoding="utf-8"))
    return ["".join(cell["source"]) for cell in parsed["cells"] if cell["cell_type"] == "code"]


class Guide(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder.name)

    def run_all(self, texts, name):
        """In turn, as a person pastes them; what needs a package that is not here is left out."""
        known = {"__name__": "__main__"}
        for number, text in enumerate(texts, 1):
            absent = [m for m in re.findall(r"^\s*(?:import|from) (\w+)", text, re.M) if importlib.util.find_spec(m) is None]
            if absent or "to_trimesh" in text and importlib.util.find_spec("trimesh") is None:
                continue
            with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                exec(compile(text, f"{name}, program {number}", "exec"), known)
        return known

    def files(self):
        return {path.relative_to(self.folder.name).as_posix() for path in pathlib.Path(self.folder.name).rglob("*") if path.is_file()}

    def test_of_the_guide(self):
        texts = programs("docs/guides/python.md")
        self.run_all(texts, "python.md")
        self.assertIn("wedges.png", self.files())
        self.assertGreater(len([name for name in self.files() if name.startswith("data/")]), 10)

    def test_ten_lines_make_a_picture_and_thirty_a_data_set(self):
        lines = [[line for line in text.splitlines() if line.strip()] for text in programs("docs/guides/python.md")]
        self.assertLessEqual(len(lines[0]), 10)
        self.assertLessEqual(len(lines[1]), 30)

    def test_of_the_readme(self):
        (text,) = programs("README.md")
        self.assertLessEqual(len(text.splitlines()), 6)
        self.run_all([text], "README.md")
        self.assertIn("wedges.glb", self.files())

    def test_of_the_notebook(self):
        known = self.run_all(cells("docs/guides/python.ipynb"), "python.ipynb")
        self.assertIn("wedges", known)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
