"""Thumbnails of templates, as Pomona drew them when the add-on was packed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy.utils.previews

FOLDER = Path(__file__).with_name("thumbnails")

_collections: list[Any] = []


def load_pictures() -> None:
    pictures = bpy.utils.previews.new()
    for path in sorted(FOLDER.glob("*.png")):
        pictures.load(path.stem, str(path), "IMAGE")
    _collections.append(pictures)


def forget_pictures() -> None:
    while _collections:
        bpy.utils.previews.remove(_collections.pop())


def icon_of(template: str) -> int:
    """The number of its icon; 0, no icon, for a template of one's own."""
    known = _collections[-1] if _collections else {}
    return int(known[template].icon_id) if template in known else 0
