"""Data-blocks that were made. Blender's undo wants a step wherever there are new ones: see keeper.py."""

from __future__ import annotations

from typing import Any


class NewData:
    """Counts what was made, or taken away."""

    def __init__(self) -> None:
        self.count = 0

    def kept(self, block: Any) -> Any:
        """The block, counted."""
        self.count += 1
        return block

    def took_away(self) -> None:
        self.count += 1
