"""Work that takes long, on a thread of its own. Nothing here touches Blender's data."""

from __future__ import annotations

import os
import tempfile
import threading
import time
from pathlib import Path
from typing import Optional

from .doors import Door, DoorError, Stopped
from .glb_file import Model, read_glb
from .orders import Order


class Job:
    """One order under way. `model` or `error` is there once `is_over`; both are None of a job that was stopped."""

    def __init__(self, door: Door, order: Order) -> None:
        self.order = order
        self.stage, self.done, self.total = "starting", 0, 0
        self.model: Optional[Model] = None
        self.error: Optional[str] = None
        self.warnings: list[str] = []
        self.began = time.monotonic()
        self._door = door
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name="pomona", daemon=True)
        self._thread.start()

    @property
    def is_over(self) -> bool:
        """A job that was stopped is over for whoever waits, though its thread may have an item to end."""
        return self._stop.is_set() or not self._thread.is_alive()

    @property
    def is_at_work(self) -> bool:
        return self._thread.is_alive()

    @property
    def seconds(self) -> float:
        return time.monotonic() - self.began

    @property
    def share(self) -> float:
        """How much of the stage is done, 0 to 1."""
        return self.done / self.total if self.total else 0.0

    def wait(self, seconds: Optional[float] = None) -> bool:
        """Whether it is over by then."""
        self._thread.join(seconds)
        return self.is_over

    def join(self, seconds: float) -> None:
        """Waits for its thread."""
        self._thread.join(seconds)

    def stop(self) -> None:
        """Asks it to end; it does so at its next item."""
        self._stop.set()

    @property
    def is_stopped(self) -> bool:
        return self._stop.is_set()

    def _told(self, stage: str, done: int, total: int) -> None:
        self.stage, self.done, self.total = stage, done, total

    def _work(self) -> None:
        try:
            with tempfile.TemporaryDirectory(prefix="pomona-", dir=quick_folder()) as folder:
                path = Path(folder, "made.glb")
                self.warnings = self._door.make(self.order, path, self._told, self._stop)
                if not self._stop.is_set():
                    model = read_glb(path.read_bytes())
                    self.model = None if self._stop.is_set() else model
        except Stopped:
            pass
        except DoorError as error:
            self.error = str(error)
        except Exception as error:  # a thread has nobody else to tell
            self.error = f"{type(error).__name__}: {error}"


def quick_folder() -> Optional[str]:
    """Where a file need not reach a disk; None for the usual place."""
    shared = "/dev/shm"
    return shared if os.path.isdir(shared) and os.access(shared, os.W_OK) else None
