#!/usr/bin/env python3
"""All targets of the Makefile, one after another in one copy of the sources: each configures what it asks for, whatever
the one before it has left, and finds what it wants built.

    targets_test.py ROOT

Nothing is compiled: `make -n` tells a target's commands, those that configure are run, and of those that build it is
asked whether the build folder knows how."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()
NOT_COPIED = shutil.ignore_patterns(".git", "build*", "out", "node_modules", "__pycache__")


def targets():
    """Those that `make help` lists."""
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    return [name for name in re.findall(r"^([a-z0-9-]+):.*## ", makefile, re.MULTILINE) if name != "clean"]


def commands_of(target, folder):
    told = subprocess.run(["make", "-n", target], cwd=folder, capture_output=True, text=True, check=True)
    return [command for line in told.stdout.splitlines() for command in re.split(r"&&|\|\||;", line)]


class Targets(unittest.TestCase):
    def test_each_works_after_the_one_before_it(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch, "copy")
            shutil.copytree(ROOT, folder, ignore=NOT_COPIED)
            configured = None
            for target in targets():
                for command in commands_of(target, folder):
                    if preset := re.search(r"cmake --preset ([\w-]+)", command):
                        needed = {"clang-bytes": "clang++", "clang": "clang++", "python": "pybind11-config"}.get(preset.group(1))
                        if needed and not shutil.which(needed):
                            continue
                        if preset.group(1) != configured:
                            self.run_in(folder, target, "cmake", "--preset", preset.group(1))
                        configured = preset.group(1)
                    elif build := re.search(r"cmake --build (\S+)(?: --target ([\w -]+?))?(?: -j| >|$)", command):
                        if (folder / build.group(1) / "build.ninja").exists():
                            wanted = (build.group(2) or "all").split()
                            self.run_in(folder, target, "ninja", "-C", build.group(1), "-t", "query", *wanted)

    def run_in(self, folder, target, *words):
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"make {target}: {' '.join(words)}: {done.stdout[-1000:]}{done.stderr}")


if __name__ == "__main__":
    unittest.main()
