"""The studio, which the program serves to a browser. Nothing here touches Blender's data."""

from __future__ import annotations

import os
import re
import subprocess
import threading
import webbrowser
from pathlib import Path


class Studio:
    """One that was started. `address` is there once `is_told`; None then if it did not start."""

    def __init__(self, program: str, template: str, folder: Path, shows: bool) -> None:
        self.address: str | None = None
        self.last_words = ""
        self._shows = shows
        self._told = threading.Event()
        self._child = subprocess.Popen([program, "studio", template], cwd=folder, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        threading.Thread(target=self._listen, name="pomona studio", daemon=True).start()

    @property
    def is_told(self) -> bool:
        return self._told.is_set()

    def wait(self) -> None:
        """Until it is told; the program tells its address at once, or ends."""
        self._told.wait(20)

    def end(self) -> None:
        self._child.terminate()
        self._child.wait(5)

    def _listen(self) -> None:
        """Reads to the end, or the program would wait for a reader."""
        assert self._child.stdout is not None
        with self._child.stdout as told:
            for line in told:
                self._hear(line)
        self._told.set()

    def _hear(self, line: str) -> None:
        if self.is_told:
            return
        if found := re.search(r"http://\S+", line):
            self.address = found.group(0)
            self._told.set()
            if self._shows:
                webbrowser.open(self.address)  # on this thread: some browsers let whoever opens them wait
        else:
            self.last_words = f"{self.last_words} {line.strip()}".strip()


# Ended with the add-on.
_studios: list[Studio] = []


def open_studio(program: str, template: str, folder: Path, shows: bool) -> Studio:
    """Starts it, in the folder that gets a copy of a template of the program's own. shows: opens the browser, too."""
    _studios.append(Studio(program, os.fspath(template), folder, shows))
    return _studios[-1]


def end_studios() -> None:
    while _studios:
        _studios.pop().end()
