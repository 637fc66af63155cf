"""What lives as long as Blender runs, and not in its files: the door to Pomona, its tables, work under way."""

from __future__ import annotations

from collections import OrderedDict
from typing import Optional, Sequence

from .doors import Door, Named
from .glb_file import Model
from .jobs import Job
from .option_table import Option, asked
from .orders import Order

# Models that are kept: undo and redo, and a knife that goes back, find them.
KEPT_BYTES = 256 * 1024 * 1024


class Workshop:
    """door is None where Pomona is not installed; then nothing can be made."""

    def __init__(self, door: Optional[Door]) -> None:
        self.door = door
        self.table: Sequence[Option] = door.options() if door else ()
        self.asked: Sequence[Option] = asked(self.table)
        self.templates: Sequence[Named] = sorted(door.templates(), key=lambda one: one.title) if door else ()
        self.scenes: Sequence[Named] = sorted(door.scenes(), key=lambda one: one.title) if door else ()
        self.jobs: dict[str, Job] = {}
        self._at_work: list[Job] = []
        self._models: OrderedDict[str, Model] = OrderedDict()

    def known(self, order: Order) -> Optional[Model]:
        """What this order has made before."""
        model = self._models.get(order.key)
        if model is not None:
            self._models.move_to_end(order.key)
        return model

    def keep(self, order: Order, model: Model) -> None:
        self._models[order.key] = model
        while len(self._models) > 1 and sum(one.size for one in self._models.values()) > KEPT_BYTES:
            self._models.popitem(last=False)

    def start(self, root_name: str, order: Order) -> Job:
        """Work for this root; what it worked at before is stopped."""
        assert self.door is not None
        if root_name in self.jobs:
            self.jobs[root_name].stop()
        self.jobs[root_name] = Job(self.door, order)
        self._at_work = [*(job for job in self._at_work if job.is_at_work), self.jobs[root_name]]
        return self.jobs[root_name]

    def stop_all(self) -> None:
        for job in self.jobs.values():
            job.stop()

    def close(self) -> None:
        """Waits for threads: Blender may not end while one works within the module."""
        self.stop_all()
        for job in self._at_work:
            job.stop()
            job.join(30)


# Blender's callbacks, timers and operators share one; it is another after the preferences have changed.
_open: list[Workshop] = []


def open_workshop(door: Optional[Door]) -> Workshop:
    close_workshop()
    _open.append(Workshop(door))
    return _open[0]


def close_workshop() -> None:
    while _open:
        _open.pop().close()


def workshop() -> Workshop:
    return _open[0]
