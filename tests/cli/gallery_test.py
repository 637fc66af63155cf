#!/usr/bin/env python3
"""Runs the gallery's commands of one template, in small, and asks for every picture.

    gallery_test.py PROGRAM NAME
"""

import pathlib
import re
import shlex
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def size_of(picture):
    head = picture.read_bytes()[:24]
    assert head.startswith(b"\x89PNG"), f"{picture} is no PNG"
    return struct.unpack(">II", head[16:24])


def main():
    program, name = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        listed = subprocess.run([ROOT / "scripts" / "gallery.py", "commands", program, folder, name],
                                check=True, capture_output=True, text=True)
        commands = [re.sub(r"--size \d+x\d+", "--size 32x32", line) for line in listed.stdout.splitlines()]
        assert len(commands) >= 10, listed.stdout
        (pathlib.Path(folder) / name).mkdir()
        for command in commands:
            words = shlex.split(command)
            subprocess.run(words, check=True, cwd=ROOT)
            assert size_of(pathlib.Path(words[-1])) == (32, 32), command


main()
