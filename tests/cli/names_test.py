#!/usr/bin/env python3
"""Names of files and their contents must not act on the terminal or break a format: control characters, line breaks, bytes that
are no UTF-8, USD's "@@@", a dash at the beginning.

    names_test.py PROGRAM SOURCE
"""

import json
import os
import pathlib
import re
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
QUICK = ("--knife", "half", "--detail", "0.3", "--quality", "draft", "--quiet")


class Names(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        shutil.copy(SOURCE / "templates/cherry.svg", self.path)

    def cherry(self, name):
        """A template with this name, which may be any bytes."""
        shutil.copy(SOURCE / "templates/cherry.toml", os.path.join(os.fsencode(self.path), os.fsencode(name)))

    def pomona(self, *words, status=0, **how):
        done = subprocess.run([PROGRAM, *words], cwd=self.path, capture_output=True, check=False, **how)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def assert_plain(self, told):
        """Lines without characters that move a cursor."""
        self.assertEqual([byte for byte in told if byte < 0x20 and byte not in b"\t\n"], [], told)

    def test_a_list_shows_control_characters_spelt_out(self):
        self.cherry("x\x1b[31m\n.toml")
        (self.path / "styles").mkdir()
        ink = (SOURCE / "styles/ink.toml").read_text()
        titled = re.sub("^title = .*$", lambda _: r'title = "q\u001b[31mred\nline"', ink, flags=re.M)
        (self.path / "styles/zs.toml").write_text(titled.replace('name = "ink"', 'name = "zs"'))
        fruit, styles = self.pomona("list").stdout, self.pomona("list", "--styles").stdout
        for told in (fruit, styles):
            self.assert_plain(told)
        self.assertIn(b"x\\x1b[31m\\n\t", fruit)
        self.assertTrue(any(b"q\\x1b[31mred\\nline" in line for line in styles.splitlines()), styles)

    def test_endings_may_be_capitals(self):
        self.cherry("CHERRY.TOML")
        shutil.copy(SOURCE / "styles/ink.toml", self.path / "INK.TOML")
        self.pomona("grow", "CHERRY.TOML", "--detail", "0.3", "-o", "SCAN.PLY")
        self.pomona("check", "SCAN.PLY")
        self.pomona("cut", "SCAN.PLY", *QUICK, "--style", "INK.TOML", "-o", "OUT.GLB")
        self.assertEqual((self.path / "OUT.GLB").read_bytes()[:4], b"glTF")

    def test_a_name_cannot_make_a_line_of_its_own(self):
        self.cherry("good\nx.toml: ok")
        for words, status in ((["check", "no\nx.toml: error: all well"], 66), (["cut", "no\nerror: y", *QUICK, "-o", "x.glb"], 66),
                              (["check", "good\nx.toml: ok"], 65), (["cut", "cherry", *QUICK, "-o", "no\nfolder/x.glb"], 73),
                              (["cut", "cherry", "--knife", "half\nerror: z", "-o", "x.glb"], 64)):
            told = self.pomona(*words, status=status).stderr.decode()
            for line in told.splitlines():
                self.assertRegex(line, r"^(.*error: |  hint: )", told)
            self.assertLessEqual(len(told.splitlines()), 2, told)

    def test_names_that_are_no_utf8(self):
        self.cherry(b"bad\xff.toml")
        outputs = ["o.svg", "o.usda", "o.glb", "o.obj", "o.ply", "o.html", "o.pov"]
        self.pomona("cut", b"./bad\xff.toml", *QUICK, *[word for name in outputs for word in ("-o", name)])
        xml.dom.minidom.parse(str(self.path / "o.svg"))
        self.assertIn("bad\ufffd", (self.path / "o.usda").read_text(encoding="utf-8"))
        self.assertIn("bad\ufffd", (self.path / "o.svg").read_text(encoding="utf-8"))
        self.assertIn("o bad\ufffd", (self.path / "o.obj").read_text(encoding="utf-8"))
        self.assertIn("bad\ufffd", (self.path / "o.ply").read_bytes().partition(b"end_header")[0].decode())
        for name in ("o.html", "o.pov"):
            (self.path / name).read_text(encoding="utf-8")
        # Names of textures follow that of the output.
        self.pomona("cut", SOURCE / "templates/cherry.toml", *QUICK, "--texture", "64", "-o", b"t\xfe.usda")
        text = (self.path / b"t\xfe.usda".decode(errors="surrogateescape")).read_text(encoding="utf-8")
        textures = set(re.findall(r"inputs:file = @([^@]*)@", text))
        self.assertTrue(textures and all((self.path / name).is_file() for name in textures), textures)

    def test_asset_paths_of_usd(self):
        for name in ("a@@@b", "a@@@@b", "@@@", "a@b", "plain"):
            self.pomona("cut", SOURCE / "templates/cherry.toml", *QUICK, "--texture", "64", "-o", name + ".usda")
            text = (self.path / f"{name}.usda").read_text()
            # A path ends at the first sign equal to its opening one, unless a backslash is before it.
            found = re.findall(r'inputs:file = (@@@((?:\\@@@|(?!@@@).)*)@@@|@([^@]*)@)(?: \(colorSpace = "\w+"\))?$', text, re.M)
            self.assertEqual(len(found), text.count("inputs:file"), name)
            for _, long, short in found:
                self.assertTrue((self.path / (long or short).replace("\\@@@", "@@@")).is_file(), (name, long, short))

    def test_commands_of_names_that_begin_with_a_dash(self):
        self.cherry("-x.toml")
        (self.path / "s.toml").write_text('format = 1\nname = "s"\n[[pieces]]\nname = "-e"\ntemplate = "-x.toml"\n'
                                          'knives = ["half"]\ntake = 1\n')
        self.pomona("scene", "s.toml", "--detail", "0.3", "--quality", "draft", "--quiet", "-o", "s.glb")
        self.pomona("cut", "./-x.toml", *QUICK, "-o", "c.glb")
        for file in ("s.glb", "c.glb"):
            data = (self.path / file).read_bytes()
            document = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
            for mesh in document["meshes"]:
                command = mesh["extras"]["command"]
                environment = dict(os.environ, PATH=f"{PROGRAM.parent}:{os.environ['PATH']}")
                done = subprocess.run(["sh", "-c", command + " --quiet"], cwd=self.path, env=environment,
                                      capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, command + done.stderr)

    def test_a_limit_of_file_sizes_is_told(self):
        def confine():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20480, 20480))
        template = SOURCE / "templates/cherry.toml"
        for words in (["cut", template, *QUICK, "-o", "o.glb", "-o", "o.ply"], ["grow", template, "-o", "o.pomona", "--quiet"]):
            told = self.pomona(*words, status=74, preexec_fn=confine).stderr
            self.assertIn(b"File too large", told)
            self.assertEqual([name for name in os.listdir(self.path) if name != "cherry.svg"], [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
