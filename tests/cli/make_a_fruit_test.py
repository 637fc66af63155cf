"""Types what docs/guides/make_a_fruit.md tells to type, from section 8 on: every template there grows without an
error or a warning, and half a cabbage is one piece.

    make_a_fruit_test.py POMONA SOURCE
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

POMONA = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()


def blocks(text):
    """The indented blocks of a document, one after another."""
    found = re.findall(r"(?:^(?: {4}.*)?\n)+", text, re.M)
    return [re.sub(r"^ {4}", "", block, flags=re.M).strip("\n") + "\n" for block in found if block.strip()]


def templates(text):
    """The text of each template by its name: a block with a format begins one, those after it belong to it."""
    found = {}
    for block in blocks(text):
        if "pomona" in block:
            continue
        if block.startswith("format"):
            name = re.search(r'^name = "(.*)"', block, re.M)[1]
            found[name] = ""
        found[name] += block + "\n"
    return found


def section(guide, number):
    return re.search(rf"^## {number}\. .*?(?=^## )", guide, re.M | re.S)[0]


class Guide(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.addCleanup(self.folder.cleanup)
        self.place = pathlib.Path(self.folder.name)
        self.guide = (SOURCE / "docs/guides/make_a_fruit.md").read_text(encoding="utf-8")
        (self.place / "organs").mkdir()

    def write(self, number):
        """The templates of a section, each in the folder that the section names."""
        text = section(self.guide, number)
        for name, lines in templates(text).items():
            file = f"organs/{name}.toml" if f"`organs/{name}.toml`" in text else f"{name}.toml"
            (self.place / file).write_text(lines, encoding="utf-8")

    def run_pomona(self, *words):
        done = subprocess.run([POMONA, *words], cwd=self.place, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("warning", done.stderr)

    def test_bunch_of_grapes(self):
        shutil.copy(SOURCE / "templates/organs/grape.toml", self.place / "organs")
        self.write(8)
        self.run_pomona("check", "bunch.toml")

    def test_cabbage_whose_halves_hold_together(self):
        self.write(9)
        coarse = ["--quality", "draft", "--detail", "0.4", "-o", "halves.stl", "--pieces", "halves.json"]
        self.run_pomona("cut", "cabbage.toml", "--knife", "half", *coarse)
        pieces = json.loads((self.place / "halves.json").read_text(encoding="utf-8"))["pieces"]
        self.assertEqual(len(pieces), 2)

    def test_ear_of_maize(self):
        self.write(10)
        self.run_pomona("check", "organs/kernel.toml", "ear.toml")

    def test_salami(self):
        self.write(11)
        self.run_pomona("check", "salami.toml")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
