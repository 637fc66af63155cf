"""Shared by tests of batches: a small batch, runs of the program, and folders as values."""

import hashlib
import os
import pathlib
import subprocess

# Coarse, so that an item takes a few hundredths of a second. Two entries, many kinds of files, nine items.
SMALL = """
[batch]
format = 1
name = "test"
title = "Five & <more>"
seed = 5
detail = 0.1
thumbnail = 32

[[entry]]
name = "cut"
templates = ["radish", "cherry"]
count = 2
knives = ["half", ["half", "across"]]

[[entry]]
name = "files"
templates = "radish"
seeds = 3
formats = ["ply", "pov", "svg"]
"""

# The smallest batch with two entries and all kinds of files: three items.
TINY = SMALL.replace('["radish", "cherry"]', '"radish"').replace('knives = ["half", ["half", "across"]]', 'knives = "half"')


def pomona(program, *words, folder=".", shim=None, **environment):
    """Runs `pomona` with these arguments: a CompletedProcess with its output as text."""
    variables = dict(os.environ, **{key: str(value) for key, value in environment.items()})
    if shim:
        variables["LD_PRELOAD"] = str(shim)
    return subprocess.run([program, *map(str, words)], cwd=folder, env=variables, text=True, capture_output=True)


def tree(folder):
    """The contents of a folder: SHA-256 by path, None for folders. Two runs agree if these do."""
    folder = pathlib.Path(folder)
    found = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        found[name] = hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None
    return found
