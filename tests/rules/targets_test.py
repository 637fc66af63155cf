#!/usr/bin/env python3
"""All targets of the Makefile, one after another in one copy of the sources: each configures what it asks for, whatever
the one before it has left, and finds what it wants built. CMake keeps in a folder's cache what a preset does not say, so
every preset must say every option that CMakeLists.txt declares.

    targets_test.py ROOT

Nothing is compiled: `make -n` tells a target's commands, those that configure are run, and of those that build it is
asked whether the build folder knows how. What several targets have in common is tried once: a preset after another in
one folder, and all that is built with it."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()
NOT_COPIED = shutil.ignore_patterns(".git", "build*", "out", "node_modules", "__pycache__")
NEEDED = {"clang-bytes": ["clang++", "--version"], "clang": ["clang++", "--version"],
          "python": ["pkg-config", "--exists", "pybind11"]}


def can_be_tried(preset):
    command = NEEDED.get(preset)
    return not command or bool(shutil.which(command[0])) and subprocess.run(command, capture_output=True).returncode == 0


def targets():
    """Those that `make help` lists."""
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    return [name for name in re.findall(r"^([a-z0-9-]+):.*## ", makefile, re.MULTILINE) if name != "clean"]


def commands_of(target, folder):
    told = subprocess.run(["make", "-n", target], cwd=folder, capture_output=True, text=True, check=True)
    return [command for line in told.stdout.splitlines() for command in re.split(r"&&|\|\||;", line)]


def presets():
    """What each preset says, what it inherits included: name -> preset."""
    said = {}
    for preset in json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]:
        parent = said.get(preset.get("inherits"), {})
        variables = {**parent.get("cacheVariables", {}), **preset.get("cacheVariables", {})}
        said[preset["name"]] = {**parent, **preset, "cacheVariables": variables}
    return said


def folder_of(preset):
    """Its build folder."""
    return presets()[preset]["binaryDir"].removeprefix("${sourceDir}/")


def wanted(folder):
    """Steps from one preset of a build folder to another (None: no folder yet), each with the first target that makes it;
    and what is built with each preset."""
    now, steps, built = {}, {}, {}
    for target in targets():
        for command in commands_of(target, folder):
            if configured := re.search(r"cmake --preset ([\w-]+)", command):
                preset = configured.group(1)
                if not can_be_tried(preset):
                    break  # what follows is built with it
                before, now[folder_of(preset)] = now.get(folder_of(preset)), preset
                if before != preset:
                    steps.setdefault((before, preset), target)
            elif build := re.search(r"cmake --build (\S+)(?: --target ([\w -]+?))?(?: -j| >|$)", command):
                if build.group(1) in now:
                    built.setdefault(now[build.group(1)], {}).update(dict.fromkeys((build.group(2) or "all").split()))
    return steps, built


class Presets(unittest.TestCase):
    def test_every_preset_says_every_option(self):
        options = re.findall(r"^option\((\w+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertGreater(len(options), 3)
        for name, preset in presets().items():
            for option in [*options, "CMAKE_BUILD_TYPE"]:
                self.assertIn(option, preset["cacheVariables"], f"preset {name}")


class Targets(unittest.TestCase):
    def test_each_works_after_the_one_before_it(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch, "copy")
            shutil.copytree(ROOT, folder, ignore=NOT_COPIED)
            now = {}
            steps, built = wanted(folder)
            self.assertGreater(len(steps), 10)
            for (before, preset), target in steps.items():
                build = folder_of(preset)
                if now.get(build) != before:
                    self.run_in(folder, target, "cmake", "--preset", before)
                self.run_in(folder, target, "cmake", "--preset", preset)
                self.assert_as_said(preset, folder / build / "CMakeCache.txt")
                now[build] = preset
                self.run_in(folder, target, "ninja", "-C", build, "-t", "query", *built.get(preset, ["all"]))

    def assert_as_said(self, preset, cache):
        kept = dict(re.findall(r"^(\w+):\w+=(.*)$", cache.read_text(encoding="utf-8"), re.MULTILINE))
        for option, value in presets()[preset]["cacheVariables"].items():
            # CMake keeps a compiler with its path.
            self.assertEqual(pathlib.PurePath(kept[option]).name, value, f"{option} of preset {preset}")

    def run_in(self, folder, target, *words):
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"make {target}: {' '.join(words)}: {done.stdout[-1000:]}{done.stderr}")


if __name__ == "__main__":
    unittest.main()
