"""A template from a mesh of Blender: a skin, and one colour within. docs/guides/import.md goes on from there."""

from __future__ import annotations

import json
import re
from typing import Sequence


def template_name(words: str) -> str:
    """As templates are named: a-z, 0-9, - and _."""
    return re.sub(r"[^a-z0-9]+", "_", words.lower()).strip("_") or "mesh"


def hex_color(linear: Sequence[float]) -> str:
    """#rrggbb of a linear colour."""
    parts = [min(max(part, 0.0), 1.0) for part in linear[:3]]
    srgb = [12.92 * part if part <= 0.0031308 else 1.055 * part ** (1 / 2.4) - 0.055 for part in parts]
    return "#" + "".join(f"{round(255 * part):02x}" for part in srgb)


def template_text(title: str, mesh_file: str, outside: str, rim: str, inside: str) -> str:
    """The file. The colours, #rrggbb: of the skin, right under it, and from the inner surface on."""
    name = template_name(title)
    return f"""\
# {title}, from Blender.
format = 1
name = "{name}"
title = {json.dumps(title)}
parts = ["skin", "flesh"]

[symmetry]
kind = "none"

[[mesh]]
name = "skin"
file = {json.dumps(mesh_file)}
object = "skin"
front = {{ part = "skin", hidden = true, color = "{outside}" }}
back = {{ part = "flesh", color = "{rim}" }}

[[mesh]]
name = "inside"
file = {json.dumps(mesh_file)}
object = "inside"
front = {{ part = "flesh", color = "{inside}" }}
back = {{ part = "flesh", color = "{inside}" }}
"""
