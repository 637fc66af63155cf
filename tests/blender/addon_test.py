#!/usr/bin/env python3
"""The add-on for Blender: packed, installed into a Blender that has nothing of a person's, and tried there.

    addon_test.py PROGRAM ADDON_FOLDER SCRATCH [--module FOLDER] [--window]

ADDON_FOLDER gets the .zip. --module tries it by the Python package in FOLDER, too; --window in a window under Xvfb."""

import argparse
import ast
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "blender"))
import make_addon  # noqa: E402

parser = argparse.ArgumentParser()
for name in ("program", "addon_folder", "scratch", "--module"):
    parser.add_argument(name, type=lambda word: pathlib.Path(word).resolve())
parser.add_argument("--window", action="store_true")
said = parser.parse_args()
PROGRAM, MODULES = said.program, [said.module] if said.module else []


def packed():
    """The .zip, made anew: it takes ten seconds."""
    said.addon_folder.mkdir(parents=True, exist_ok=True)
    path = said.addon_folder / f"pomona_blender-{make_addon.version_of(str(PROGRAM))}.zip"
    make_addon.pack(make_addon.contents(str(PROGRAM)), path)
    return path


ADDON = packed()


def blender(script, *words, before=("blender", "-b"), name="", seconds=1800):
    """Runs a script in a Blender with a home and an empty folder of its own. Blender's Python looks along PATH for its
    own home: no other Python may stand there first."""
    home, folder = said.scratch / f"home_{name}", said.scratch / name
    for clean in (home, folder):
        shutil.rmtree(clean, ignore_errors=True)
        clean.mkdir(parents=True)
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("BLENDER", "XDG", "PYTHON"))}
    environment |= {"HOME": str(home), "PATH": "/usr/bin:/bin", "LIBGL_ALWAYS_SOFTWARE": "1",
                    "LP_NUM_THREADS": "0"}
    flags = ["--factory-startup", "--python-exit-code", "1", "-t", "2", "-P", HERE / script, "--"]
    return subprocess.run([*before, *flags, ADDON, PROGRAM, folder, *words], capture_output=True, text=True,
                          timeout=seconds, env=environment, cwd=folder)


class Addon(unittest.TestCase):
    def assert_passed(self, done):
        self.assertEqual(done.returncode, 0, done.stdout[-6000:] + done.stderr[-6000:])

    def test_the_zip_serves_old_and_new_blenders(self):
        with zipfile.ZipFile(ADDON) as files:
            names = files.namelist()
            self.assertEqual({name.split("/")[0] for name in names}, {"pomona_blender"}, "one folder")
            opening = files.read("pomona_blender/__init__.py").decode()
            manifest = files.read("pomona_blender/blender_manifest.toml").decode()
        version = make_addon.version_of(str(PROGRAM))
        tree = next(node for node in ast.parse(opening).body if isinstance(node, ast.Assign))
        info = ast.literal_eval(tree.value)  # as Blender reads it, without running it
        self.assertEqual(".".join(map(str, info["version"])), version)
        import tomllib

        told = tomllib.loads(manifest)
        self.assertEqual((told["version"], told["id"], told["type"]), (version, "pomona_blender", "add-on"))
        for words in (told["tagline"], *told["permissions"].values()):  # as the extensions' checker wants it
            self.assertLessEqual(len(words), 64)
            self.assertFalse(re.search(r"[.!?]$", words))
        self.assertLessEqual({"schema_version", "name", "maintainer", "blender_version_min", "license"}, set(told))
        listed = subprocess.run([PROGRAM, "list"], capture_output=True, text=True, check=True).stdout
        pictures = {name.rsplit("/", 1)[1][:-4] for name in names if name.endswith(".png")}
        self.assertEqual(pictures, {line.split("\t")[0] for line in listed.splitlines()})

    def test_the_same_sources_give_the_same_bytes(self):
        again = io.BytesIO()
        with zipfile.ZipFile(ADDON) as files:
            make_addon.pack({name.split("/", 1)[1]: files.read(name) for name in files.namelist()}, again)
        self.assertEqual(again.getvalue(), ADDON.read_bytes())

    def test_by_the_program(self):
        self.assert_passed(blender("in_blender.py", name="program"))

    @unittest.skipUnless(said.module, "--module")
    def test_by_the_module(self):
        self.assert_passed(blender("in_blender.py", *MODULES, name="module"))

    @unittest.skipUnless(said.window, "--window")
    def test_in_a_window(self):
        for words in ([], *([one] for one in MODULES)):
            name = "window_module" if words else "window_program"
            # A small window: no card draws it.
            before = ("xvfb-run", "-a", "-s", "-screen 0 640x480x24", "blender", "-p", "0", "0", "640", "480")
            done = blender("in_window.py", *words, name=name, before=before)
            self.assert_passed(done)
            print(name, *[line for line in done.stdout.splitlines() if line.startswith("held up")])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
