"""The ways to Pomona: its Python module in this process, or its program in another. Both leave a .glb file.

A door does long work on the thread that asks: see jobs.py."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Optional, Protocol

from .option_table import Option, told_by_module, told_by_program
from .orders import Order, Value

# Called with a stage, how much is done and of how much; what it raises ends the work.
Progress = Callable[[str, int, int], None]

INSTALL = ("Install the Debian package pomona (`make package`), or say in the add-on's preferences where the "
           "program lies")


class DoorError(Exception):
    """What Pomona says is wrong, in its words: message, place and hint."""


class Stopped(Exception):
    """The work was stopped as asked."""


@dataclass(frozen=True)
class Named:
    """A template or a scene that Pomona has."""

    name: str
    title: str


class Door(Protocol):
    """A way to Pomona."""

    name: str

    def options(self) -> list[Option]:
        """The table of options."""

    def templates(self) -> list[Named]:
        """What can be grown."""

    def scenes(self) -> list[Named]:
        """What can be composed."""

    def make(self, order: Order, path: Path, progress: Progress, stop: threading.Event) -> list[str]:
        """Writes what was ordered to a .glb; the warnings. DoorError, or Stopped soon after `stop` is set."""


class ModuleDoor:
    """Pomona's Python module. It keeps the last fruit as they grew, so that another cut is quick."""

    KEPT = 3

    def __init__(self, pomona: Any) -> None:
        self.name = f"Python module {pomona.__version__}"
        self._pomona = pomona
        self._grown: dict[tuple[Any, ...], Any] = {}
        self._steps = {option.name: option.step for option in self.options()}

    def options(self) -> list[Option]:
        return told_by_module(self._pomona.options())

    def templates(self) -> list[Named]:
        return [Named(one.name, one.title) for one in self._pomona.templates()]

    def scenes(self) -> list[Named]:
        return [Named(one.name, one.title) for one in self._pomona.scenes()]

    def make(self, order: Order, path: Path, progress: Progress, stop: threading.Event) -> list[str]:
        def heard(stage: str, done: int, total: int) -> None:
            if stop.is_set():
                raise Stopped
            progress(stage, done, total)

        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                self._make(order, path, heard)
            except self._pomona.Error as error:
                raise DoorError(str(error)) from error
        return [str(one.message) for one in caught]

    def _make(self, order: Order, path: Path, heard: Progress) -> None:
        given: dict[str, dict[str, Value]] = {"grow": {}, "cut": {}, "write": {}}
        for name, value in order.options:
            given[self._steps[name]][name.replace("-", "_")] = value
        if order.verb == "scene":
            made = self._pomona.scene(order.what, progress=heard, **given["grow"], **given["cut"], **given["write"])
            made.write(path, progress=heard)
        elif order.verb == "grow":
            self._fruit(order, given["grow"], heard).write(path, progress=heard, **given["cut"], **given["write"])
        else:
            fruit = self._fruit(order, given["grow"], heard)
            pieces = fruit.cut(*order.knives, progress=heard, **given["cut"], **given["write"])
            pieces.write(path, progress=heard)

    def _fruit(self, order: Order, options: dict[str, Value], heard: Progress) -> Any:
        key = (order.what, order.stamp, *options.items())
        fruit = self._grown.pop(key, None) or self._pomona.grow(order.what, progress=heard, **options)
        self._grown[key] = fruit
        while len(self._grown) > self.KEPT:
            del self._grown[next(iter(self._grown))]
        return fruit


class ProgramDoor:
    """Pomona's program, started anew for each order."""

    def __init__(self, program: str) -> None:
        self._program = program
        self.name = self._told("--version").strip() or "pomona"

    @property
    def program(self) -> str:
        return self._program

    def _told(self, *words: str) -> str:
        done = subprocess.run([self._program, *words], capture_output=True, text=True, timeout=20, check=False)
        if done.returncode:
            raise DoorError(done.stderr.strip())
        return done.stdout

    def options(self) -> list[Option]:
        return told_by_program(json.loads(self._told("pages", "options")))

    def templates(self) -> list[Named]:
        return [Named(one["name"], one["title"]) for one in json.loads(self._told("list", "--json"))]

    def scenes(self) -> list[Named]:
        return [Named(one["name"], one["title"]) for one in json.loads(self._told("list", "--scenes", "--json"))]

    def make(self, order: Order, path: Path, progress: Progress, stop: threading.Event) -> list[str]:
        words = [self._program, *order.words(), "-o", os.fspath(path)]
        with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as child:
            over = threading.Event()
            guard = threading.Thread(target=interrupt_if_asked, args=(child, stop, over), daemon=True)
            guard.start()
            assert child.stderr is not None
            told = []
            for line in child.stderr:
                told.append(line.rstrip("\n"))
                if stage := re.fullmatch(r"(\w[\w ]*) \((\d+)\)", told[-1]):
                    progress(stage.group(1), 0, int(stage.group(2)))
            status = child.wait()
            over.set()
        if stop.is_set():
            raise Stopped
        if status not in (0, 1):
            raise DoorError("\n".join(line for line in told if "error:" in line or "hint:" in line) or "\n".join(told))
        return [line.split("warning: ", 1)[1] for line in told if "warning: " in line]


def interrupt_if_asked(child: subprocess.Popen[str], stop: threading.Event, over: threading.Event) -> None:
    """Ends the program as Ctrl-C does, so that it leaves no half files."""
    while not over.wait(0.05):
        if stop.is_set():
            child.send_signal(signal.SIGINT)
            return


def find_program(said: str = "") -> Optional[str]:
    """The program: where a person says, else on PATH, else where `make install` puts it."""
    places = [said] if said else [shutil.which("pomona") or "", os.path.expanduser("~/.local/bin/pomona"),
                                  "/usr/local/bin/pomona", "/usr/bin/pomona"]
    return next((place for place in places if place and os.access(place, os.X_OK) and os.path.isfile(place)), None)


def find_module(folder: str = "") -> Optional[Any]:
    """The module: where Blender's Python finds it, or in this folder. None where it is not, or for another Python."""
    added = bool(folder) and folder not in sys.path
    if added:
        sys.path.insert(0, folder)
    try:
        import pomona
    except ImportError:
        return None
    finally:
        if added:
            sys.path.remove(folder)
    return pomona


def find_door(program: str = "", module_folder: str = "") -> Optional[Door]:
    """The module where it is, else the program; None if neither is there, or neither works. A program that a person
    names goes before a module that is only found."""
    if not (program and not module_folder):
        module = find_module(module_folder)
        if module is not None and hasattr(module, "options"):
            return ModuleDoor(module)
    found = find_program(program)
    if found:
        try:
            return ProgramDoor(found)
        except (DoorError, OSError, subprocess.SubprocessError):
            return None
    return None
