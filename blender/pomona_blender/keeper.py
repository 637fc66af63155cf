"""Keeps fruit as their settings ask: what changes is made anew, by jobs that do not hold up the window.

A fruit is derived from its settings as a modifier's result is from its mesh. So there is one rule for a slider, for a
plane that moves, for a template that is edited, and for undo: where the order of the settings is not the one the pieces
were made by (`made`), they are made again. While things change they are made in haste, as drafts; when all is quiet, as
ordered. Blender's undo must know of every data-block: where some are new, or gone, a step of undo is pushed."""

from __future__ import annotations

import os
import time
from typing import Any, Iterator, Optional, Sequence

import bpy
from bpy.app.handlers import persistent

from .build_objects import build, pieces_of
from .glb_file import Model
from .new_data import NewData
from .orders import Order
from .settings import hasty, order_of, roots
from .workshop import workshop

# Seconds: how long a window may wait for an operator, how long a step of building takes at most, how long nothing has
# changed until all is made as ordered, and how often we look. A step may be late by one mesh, some 0.1 s.
PATIENCE, AT_ONCE, QUIET, OFTEN, SELDOM = 0.2, 0.04, 0.7, 0.03, 0.2
SMALL = 4_000_000  # bytes of a model that becomes objects within an operator, some 0.1 s


class Building:
    """A model that becomes objects, step by step."""

    def __init__(self, root: Any, order: Order, model: Model, warnings: Sequence[str]) -> None:
        self.root_name, self.order, self.warnings = root.name, order, warnings
        self.new = NewData()
        in_haste = order.key != order_of(root, workshop().asked).key
        self._steps: Iterator[None] = build(root, model, self.new, keep_objects=in_haste)

    def go_on(self, seconds: Optional[float]) -> bool:
        """Whether it is done after so long; None goes on to the end."""
        began = time.monotonic()
        for _ in self._steps:
            if seconds is not None and time.monotonic() - began > seconds:
                return False
        root = bpy.data.objects.get(self.root_name)
        if root is not None:
            root.pomona.made = self.order.key
            root.pomona.message = "\n".join(self.warnings)
            root.empty_display_size = 0.01
        return True


class Keeper:
    """look: something may have changed. It is set by whatever changes settings; files are looked at each second."""

    def __init__(self) -> None:
        self.look = True
        self._looked = 0.0
        self._building: Optional[Building] = None
        self._changed: dict[str, float] = {}
        self._seen: dict[str, str] = {}
        self._waits: set[str] = set()

    def forget(self) -> None:
        """Another file is open."""
        workshop().stop_all()
        self.__init__()  # type: ignore[misc]

    def came_back(self) -> None:
        """After undo: a fruit without pieces is one that is not made yet, and the step before is without it. It waits
        for a person, or nobody could go back beyond it."""
        self._building = None
        self._waits = {root.name for root in roots() if not pieces_of(root)}
        self.look = True

    def look_at(self, root_name: str) -> None:
        """It counts as not seen yet."""
        self._seen.pop(root_name, None)
        self.look = True

    @property
    def is_busy(self) -> bool:
        return self.look or self._building is not None or bool(workshop().jobs) or bool(self._changed)

    def make_now(self, root: Any, seconds: Optional[float]) -> bool:
        """Makes it as ordered, within this time if it goes; else work goes on, and the window too. None waits for the
        end. What is wrong is the root's message then."""
        shop = workshop()
        if shop.door is None:
            return False
        root.pomona.message = ""
        order = order_of(root, shop.asked)
        self._seen[root.name] = order.key
        self._changed.pop(root.name, None)
        self._waits.discard(root.name)
        model, warnings = shop.known(order), []
        if model is None:
            job = shop.start(root.name, order)
            if not job.wait(seconds):
                return False
            del shop.jobs[root.name]
            if job.model is None:
                root.pomona.message = job.error or "Stopped"
                return True
            model, warnings = job.model, job.warnings
            shop.keep(order, model)
        building = Building(root, order, model, warnings)
        if seconds is not None and model.size > SMALL:
            # The operator's step of undo keeps what is there now: the old pieces, never some of both.
            self._building = building
            return False
        return building.go_on(None)

    def tick(self) -> float:
        """What is to do now, in less than the time in which a window stutters. Returns when to look again, seconds."""
        shop = workshop()
        if shop.door is None:
            return 1.0
        if self._building is not None:
            if self._building.go_on(AT_ONCE):
                self._finish(self._building)
            return 0.0
        for name in [name for name, job in shop.jobs.items() if job.is_over]:
            self._take(name)
            if self._building is not None:
                return 0.0
        if self.look or time.monotonic() - self._looked > 1 and any(is_of_file(root) for root in roots()):
            self.look, self._looked = False, time.monotonic()
            self._notice()
        self._start_what_is_due()
        return OFTEN if self.is_busy else SELDOM

    def _finish(self, building: Building) -> None:
        self._building = None
        self.look = True
        if building.new.count:
            push_undo(f"Pomona: {building.root_name}")
        redraw()

    def _take(self, name: str) -> None:
        """What a job has made, or what was wrong."""
        job = workshop().jobs.pop(name)
        root = bpy.data.objects.get(name)
        if job.model is not None:
            workshop().keep(job.order, job.model)
        if root is None or not root.pomona.verb:
            return
        if job.model is not None:
            self._building = Building(root, job.order, job.model, job.warnings)
        elif job.error is not None:
            root.pomona.message = job.error
            self._changed.pop(name, None)
        elif job.is_stopped and job.order.key == self._seen.get(name):
            root.pomona.message = "Stopped"
            self._changed.pop(name, None)
        redraw()

    def _notice(self) -> None:
        """Whose settings ask for something else than before."""
        for root in roots():
            if not root.pomona.follow or root.name in self._waits or root.pomona.verb == "scene":
                continue
            adopt_copy(root.pomona)
            key = order_of(root, workshop().asked).key
            if key != self._seen.get(root.name, root.pomona.made):
                self._changed[root.name] = time.monotonic()
            self._seen[root.name] = key
            if key == root.pomona.made:
                self._changed.pop(root.name, None)

    def _start_what_is_due(self) -> None:
        shop = workshop()
        for name, when in list(self._changed.items()):
            root = bpy.data.objects.get(name)
            if root is None:
                del self._changed[name]
                continue
            order = order_of(root, shop.asked)
            quick = hasty(order, shop.asked)
            is_quiet = time.monotonic() - when > QUIET
            wanted = order if is_quiet or shop.known(order) is not None else quick
            if root.pomona.made == wanted.key:
                if wanted is order:
                    del self._changed[name]
                continue
            running = shop.jobs.get(name)
            if running is not None and running.order.key == wanted.key:
                continue
            if running is not None and wanted is quick:
                continue  # a draft of a place just left is still better than none: the next follows at once
            model = shop.known(wanted)
            if model is not None:
                self._building = Building(root, wanted, model, [])
                return
            shop.start(name, wanted)


def is_of_file(root: Any) -> bool:
    """Whether a file says what it is, which others may change."""
    return bool(root.pomona.copy) or root.pomona.what.endswith(".toml")


def adopt_copy(fruit: Any) -> None:
    """From when the studio has saved its copy, that is what grows."""
    if fruit.copy and os.path.isfile(fruit.copy):
        fruit.what, fruit.copy = fruit.copy, ""


def push_undo(message: str) -> None:
    """A step of undo, from outside of an operator."""
    windows = bpy.context.window_manager.windows
    if bpy.app.background or not windows:
        return
    with bpy.context.temp_override(window=windows[0]):
        bpy.ops.ed.undo_push(message=message)


def redraw() -> None:
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in ("VIEW_3D", "STATUSBAR"):
                area.tag_redraw()


# Shared by Blender's timers, handlers and operators, as the workshop is.
_keeper = Keeper()


def keeper() -> Keeper:
    return _keeper


def tick() -> float:
    """Blender's timer."""
    delay = _keeper.tick()
    show_progress()
    return delay


def show_progress() -> None:
    """Opens the progress bar once work takes longer than a window may wait."""
    windows = bpy.context.window_manager.windows
    late = [job for job in workshop().jobs.values() if job.seconds > PATIENCE]
    if late and windows and not bpy.context.window_manager.pomona_is_watched:
        with bpy.context.temp_override(window=windows[0]):
            bpy.ops.pomona.watch("INVOKE_DEFAULT")


def settings_changed(_group: Any, _context: Any) -> None:
    """Update of every property of settings."""
    _keeper.look = True


@persistent
def something_moved(_scene: Any, graph: Any) -> None:
    """A plane may be a knife."""
    if any(isinstance(update.id, bpy.types.Object) and update.is_updated_transform for update in graph.updates):
        _keeper.look = True


@persistent
def undone(*_told: Any) -> None:
    _keeper.came_back()


@persistent
def file_opened(*_told: Any) -> None:
    _keeper.forget()


HANDLERS = (("depsgraph_update_post", something_moved), ("undo_post", undone), ("redo_post", undone),
            ("load_post", file_opened))


def start_keeping() -> None:
    for name, handler in HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)
    if not bpy.app.background:
        bpy.app.timers.register(tick, first_interval=SELDOM, persistent=True)


def end_keeping() -> None:
    for name, handler in HANDLERS:
        kept = getattr(bpy.app.handlers, name)
        if handler in kept:
            kept.remove(handler)
    if bpy.app.timers.is_registered(tick):
        bpy.app.timers.unregister(tick)
