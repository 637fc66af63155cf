#!/usr/bin/env python3
"""A cut that takes long says that it is still at work: on a terminal in one line that is drawn again, in a log a line every ten seconds.

    waiting_test.py POMONA
"""

import os
import pathlib
import pty
import re
import select
import subprocess
import sys
import tempfile
import time

SLOW = ["cut", "melon", "--knife", "peel:3mm,spiral=9mm", "--quality", "draft", "-o", "peel.ply"]  # a minute or so
MOST = 50  # seconds


def heard(descriptor, wanted, process):
    """Everything read from the descriptor until a text matches."""
    text, end = "", time.monotonic() + MOST
    while not re.search(wanted, text):
        if time.monotonic() > end or (process.poll() is not None and not select.select([descriptor], [], [], 0)[0]):
            sys.exit(f"waited for {wanted!r}, heard {text!r}")
        if select.select([descriptor], [], [], 0.2)[0]:
            text += os.read(descriptor, 4096).decode()
    return text


def listen(program, folder, wanted, *, terminal):
    reading, writing = pty.openpty() if terminal else os.pipe()
    with subprocess.Popen([program, *SLOW], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=writing) as process:
        os.close(writing)
        try:
            return heard(reading, wanted, process)
        finally:
            process.kill()
            os.close(reading)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        shown = listen(program, folder, r"cutting, \d+ s so far\r\x1b\[Kcutting, \d+ s so far", terminal=True)
        assert "\n" not in shown, shown
        logged = listen(program, folder, r"cutting, \d+ s so far\n", terminal=False)
        assert int(re.search(r"(\d+) s so far", logged)[1]) >= 3, logged
        assert os.listdir(folder) == [], os.listdir(folder)


if __name__ == "__main__":
    main()
