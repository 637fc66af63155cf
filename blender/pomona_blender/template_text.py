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


def template_text(title: str, mesh_file: str, colors: Sequence[str], size: float, grain: float) -> str:
    """The file.

    colors  #rrggbb: of the skin, right under it, and from the inner surface on
    size    metres, of the widest side; grain is as fine as a twelfth of it, and finer
    grain   how far colours stray, OKLab; 0 is none
    """
    outside, rim, inside = colors
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
""" + (noise_text([outside, inside], 12 / size, grain) if grain > 0 else "")


def noise_text(colors: Sequence[str], frequency: float, grain: float) -> str:
    """frequency: of the coarsest of four bands, cycles per metre."""
    weights = ", ".join(f"{grain * share:.4g}" for share in (0.7, 1.0, 1.0, 0.7))
    keys = [f'[[noise.key]]\ncolor = "{color}"\nweights = [{weights}]\n' for color in colors]
    return "\n".join([f"\n[noise]\nbase_frequency = {frequency:.4g}\n", *keys])
