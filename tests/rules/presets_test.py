#!/usr/bin/env python3
"""Presets that share a build folder may follow each other in any order: each must leave nothing of the one before.

    presets_test.py ROOT

CMake keeps in the folder's cache what a preset does not say. So every preset must say every option that CMakeLists.txt
declares; and the presets of a shared folder are configured one after another, there and back, in a folder made for it."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()


def presets():
    """What each preset says, what it inherits included: name -> preset."""
    said = {}
    for preset in json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]:
        parent = said.get(preset.get("inherits"), {})
        variables = {**parent.get("cacheVariables", {}), **preset.get("cacheVariables", {})}
        said[preset["name"]] = {**parent, **preset, "cacheVariables": variables}
    return said


def folders_shared():
    """Build folder -> the presets that share it."""
    shared = {}
    for name, preset in presets().items():
        shared.setdefault(preset["binaryDir"], []).append(name)
    return {folder: names for folder, names in shared.items() if len(names) > 1}


def there_and_back(names):
    """Each name after the one before it, and after the one behind it."""
    return [*names, *names[-2::-1]]


class Presets(unittest.TestCase):
    def test_every_preset_says_every_option(self):
        options = re.findall(r"^option\((\w+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertGreater(len(options), 3)
        for name, preset in presets().items():
            for option in [*options, "CMAKE_BUILD_TYPE"]:
                self.assertIn(option, preset["cacheVariables"], f"preset {name}")

    def test_make_uses_no_preset_that_is_not_there(self):
        used = re.findall(r"cmake --preset ([\w-]+)", (ROOT / "Makefile").read_text(encoding="utf-8"))
        self.assertGreater(len(used), 3)
        self.assertLessEqual(set(used), set(presets()))

    def test_presets_of_one_folder_follow_each_other(self):
        for names in folders_shared().values():
            walk = there_and_back(names)
            with tempfile.TemporaryDirectory() as build:
                for before, name in zip([None, *walk], walk):
                    done = subprocess.run(["cmake", "--preset", name, "-B", build], cwd=ROOT, capture_output=True, text=True)
                    self.assertEqual(done.returncode, 0, f"{name} after {before}: {done.stderr}")
                    self.assert_as_said(name, pathlib.Path(build, "CMakeCache.txt"))

    def assert_as_said(self, name, cache):
        kept = dict(re.findall(r"^(\w+):\w+=(.*)$", cache.read_text(encoding="utf-8"), re.MULTILINE))
        for option, value in presets()[name]["cacheVariables"].items():
            self.assertEqual(kept[option], value, f"{option} of preset {name}")


if __name__ == "__main__":
    unittest.main()
