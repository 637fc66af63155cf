#!/usr/bin/env python3
"""Tests scripts/golden.py: what must fail does, and renewing asks for what it should.

    golden_test.py PROGRAM
"""

import contextlib
import io
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "scripts"))
import golden  # noqa: E402

POMONA = sys.argv.pop(1)


def png(width, height, red=200, one_redder=0):
    colors = [[(red, x % 256, y % 256) for x in range(width)] for y in range(height)]
    colors[0][0] = (red + one_redder, 0, 0)
    rows = b"".join(b"\0" + b"".join(bytes(color) for color in row) for row in colors)

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Goldens(unittest.TestCase):
    """A tree of its own, whose program draws what lies in drawn/ and compares as the real one does."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.before = golden.ROOT, golden.GOLDEN
        golden.ROOT, golden.GOLDEN = self.root, self.root / "tests" / "golden"
        golden.GOLDEN.mkdir(parents=True)
        (self.root / "drawn").mkdir()
        self.program = self.root / "pomona"
        self.program.write_text(f'#!/bin/sh\n[ "$1" = compare ] && exec "{POMONA}" "$@"\n[ "$1" = fail ] && exit 65\n'
                                f'cp "{self.root}"/drawn/* .\n')
        self.program.chmod(0o755)
        self.declare('[[run]]\nname = "disc"\ncommand = "draw"\nexact = ["disc.png"]\n')
        self.draw("disc.png", png(20, 10))
        (golden.GOLDEN / "disc.png").write_bytes(png(20, 10))
        self.git("init", "-q")
        self.commit()

    def tearDown(self):
        golden.ROOT, golden.GOLDEN = self.before

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@x", *words], cwd=self.root, check=True,
                       capture_output=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", "x")

    def declare(self, text):
        (golden.GOLDEN / "golden.toml").write_text(text)

    def draw(self, name, data):
        (self.root / "drawn" / name).write_bytes(data)

    def check(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = golden.check(golden.declared_runs(), self.program, self.root / "out")
        return status, said.getvalue()

    def renew(self, reason="it is redder", only_wrong=False):
        with contextlib.redirect_stdout(io.StringIO()):
            return golden.renew(golden.declared_runs(), self.program, self.root / "out", reason, only_wrong)

    def test_what_is_as_it_should_be_passes_and_leaves_no_page(self):
        self.assertEqual(self.check()[0], 0)
        self.assertFalse((self.root / "out" / "disc.png.html").exists())

    def test_one_step_of_one_colour_fails_and_the_page_is_named(self):
        self.draw("disc.png", png(20, 10, red=201))
        status, said = self.check()
        self.assertEqual(status, 1)
        page = self.root / "out" / "disc.png.html"
        self.assertIn(str(page), said)
        self.assertIn("reference: disc.png", page.read_text())

    def test_what_is_close_passes_where_it_may(self):
        self.draw("disc.png", png(20, 10, red=201))
        self.declare('[[run]]\nname = "disc"\ncommand = "draw"\nclose = ["disc.png"]\n')
        self.assertEqual(self.check()[0], 1, "a step all over is seen by FLIP")
        self.draw("disc.png", png(20, 10, one_redder=3))
        self.assertEqual(self.check()[0], 0)
        self.draw("disc.png", png(20, 10, one_redder=4))
        self.assertEqual(self.check()[0], 1)

    def test_what_is_missing_or_spoilt_or_not_drawn_fails(self):
        (golden.GOLDEN / "disc.png").unlink()
        self.assertEqual(self.check()[0], 1)
        (golden.GOLDEN / "disc.png").write_bytes(png(20, 10)[:60])
        self.assertEqual(self.check()[0], 1)
        (golden.GOLDEN / "disc.png").write_bytes(png(20, 10))
        (self.root / "drawn" / "disc.png").rename(self.root / "drawn" / "other.png")
        self.assertEqual(self.check()[0], 1)
        self.declare('[[run]]\nname = "disc"\ncommand = "fail"\nexact = ["disc.png"]\n')
        self.assertEqual(self.check()[0], 1)

    def test_a_result_of_an_earlier_run_is_not_taken_for_this_one(self):
        self.check()
        (self.root / "drawn" / "disc.png").unlink()
        self.draw("other.png", b"")
        self.assertEqual(self.check()[0], 1)

    def test_text_is_held_to_every_character(self):
        self.declare('[[run]]\nname = "lines"\ncommand = "draw"\ntext = ["lines.svg"]\n')
        (golden.GOLDEN / "lines.svg").write_text("<svg>\n<path d='M 0 1'/>\n</svg>\n")
        self.draw("lines.svg", b"<svg>\n<path d='M 0 1'/>\n</svg>\n")
        self.assertEqual(self.check()[0], 0)
        self.draw("lines.svg", b"<svg>\n<path d='M 0 2'/>\n</svg>\n")
        status, said = self.check()
        self.assertEqual(status, 1)
        self.assertIn("2 lines differ", said)

    def test_renewing_keeps_the_picture_and_the_reason(self):
        self.draw("disc.png", png(20, 10, red=90))
        self.commit()
        self.renew()
        self.assertEqual(self.check()[0], 0)
        self.assertRegex((golden.GOLDEN / "REASONS.md").read_text(), r"it is redder: disc\.png")

    def test_renewing_refuses_a_dirty_tree_and_a_missing_reason(self):
        self.draw("disc.png", png(20, 10, red=90))
        for reason, clean in (("it is redder", False), ("", True), (None, True), ("  ", True)):
            if clean:
                self.commit()
            with self.assertRaises(SystemExit):
                self.renew(reason)
        self.assertEqual(self.check()[0], 1, "nothing was renewed")

    def test_renewing_refuses_what_is_too_large(self):
        self.draw("disc.png", png(257, 10))
        self.commit()
        with self.assertRaises(SystemExit):
            self.renew()

    def test_renewing_all_leaves_alone_what_passes(self):
        self.renew(only_wrong=True)
        self.assertFalse((golden.GOLDEN / "REASONS.md").exists())

    def test_a_list_with_a_name_twice_or_an_unknown_key_is_refused(self):
        run = '[[run]]\nname = "disc"\ncommand = "draw"\nexact = ["disc.png"]\n'
        for wrong in (run + run, run + 'exactly = ["x.png"]\n', '[[run]]\nname = "disc"\ncommand = "draw"\n'):
            self.declare(wrong)
            with self.assertRaises(SystemExit):
                golden.declared_runs()


class TheList(unittest.TestCase):
    def test_holds_no_large_picture_and_no_picture_lies_unused(self):
        declared = {file for run in golden.declared_runs() for file in run["goldens"]}
        there = {path.name for path in golden.GOLDEN.iterdir() if path.suffix in (".png", ".svg")}
        self.assertEqual(declared, there)
        for name in there:
            golden.refuse_large(golden.GOLDEN / name)


if __name__ == "__main__":
    unittest.main()
