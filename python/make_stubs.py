"""Writes what type checkers read of the package, __init__.pyi: its functions with all options of the table as keyword
arguments.

    make_stubs.py PACKAGE OUTPUT        PACKAGE: build/module
"""

import functools
import inspect
import sys

HEAD = '''"""Made from the table of options and the package's signatures; do not edit."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, NamedTuple, Optional, Union, overload

import numpy
from numpy.typing import NDArray

__version__: str
_Progress = Optional[Callable[[str, int, int], object]]
_Source = Union[str, os.PathLike[str], Mapping[str, Any]]
_Path = Union[str, os.PathLike[str]]

class PomonaWarning(UserWarning): ...
'''

# What signatures do not say.
PARAMETERS = {"progress": "_Progress", "template": "_Source", "description": "_Source", "path": "_Path",
              "more": "_Path", "knives": "str"}
FLOATS, NUMBERS, BYTES = "NDArray[numpy.float32]", "NDArray[numpy.float64]", "NDArray[numpy.uint8]"
RESULTS = {
    "grow": "Fruit", "scene": "Scene", "section": "Section", "write": "list[Path]", "render": BYTES,
    "ground_truth": "Truth", "templates": "list[TemplateEntry]", "scenes": "list[SceneEntry]",
    "styles": "list[StyleEntry]", "options": "list[Option]", "shown_on": "Callable[[str, int, int], None]",
    "cut": "Union[Pieces, Section]", "to_trimesh": "Any", "__len__": "int",
    "name": "str", "title": "str", "part_names": "list[str]", "template": "str", "seed": "int", "index": "int",
    "knives": "list[str]", "closed": "bool", "crumb": "bool", "command": "str",
    "positions": FLOATS, "normals": FLOATS, "colors": FLOATS, "uv": FLOATS, "texture": f"Optional[{BYTES}]",
    "parts": "NDArray[numpy.int32]", "cut_faces": "NDArray[numpy.int32]", "triangles": "NDArray[numpy.uint32]",
    "volume": "float", "mass": "float", "density": "float", "center": NUMBERS, "inertia": NUMBERS, "bounds": NUMBERS,
    "pieces": "list[Piece]", "instances": "list[str]", "solids": "NDArray[numpy.int32]", "poses": NUMBERS,
    "file": "str", "line": "int", "column": "int", "message": "str", "hint": "str",
}
TRUTH = {"instance": "NDArray[numpy.uint16]", "fruit": "NDArray[numpy.uint16]", "part": "NDArray[numpy.uint16]",
         "organ": "NDArray[numpy.uint16]", "depth": FLOATS, "normal": FLOATS, "section": BYTES, "instances": "list[str]", "fruits": "list[str]",
         "parts": "list[str]"}
FIELDS = {"parts": "list[str]", "file": "Path", "line": "int", "column": "int", "choices": "tuple[str, ...]",
          "takers": "tuple[str, ...]", "range": "Optional[tuple[float, float]]"}


def parameter(name, said):
    if said.kind is inspect.Parameter.VAR_POSITIONAL:
        return f"*{name}: {PARAMETERS[name]}"
    if said.annotation is not inspect.Parameter.empty and isinstance(said.annotation, str):
        return f"{name}: {said.annotation} = ..."
    if name in PARAMETERS:
        return f"{name}: {PARAMETERS[name]}" + ("" if said.default is inspect.Parameter.empty else " = ...")
    return name if name == "self" else f"{name}: Any"


def signature(name, function, result=None):
    """One line; a star stands before the first that is a keyword alone."""
    words, starred = [], False
    for one, said in inspect.signature(function).parameters.items():
        if said.kind is inspect.Parameter.KEYWORD_ONLY and not starred:
            words.append("*")
        starred = starred or said.kind in (inspect.Parameter.KEYWORD_ONLY, inspect.Parameter.VAR_POSITIONAL)
        words.append(parameter(one, said))
    return f"def {name}({', '.join(words)}) -> {result or RESULTS[name]}: ..."


def cut_signatures(function):
    """It gives a section only where that is asked for."""
    pieces = signature("cut", function, "Pieces").replace("section: Optional[bool]", "section: Literal[False, None]")
    section = signature("cut", function, "Section").replace("section: Optional[bool] = ...", "section: Literal[True]")
    return ["@overload", pieces, "@overload", section]


def members(kind):
    for name, member in vars(kind).items():
        if isinstance(member, (property, functools.cached_property)) and not name.startswith("_"):
            yield from ("@property", f"def {name}(self) -> {RESULTS[name]}: ...")
        elif inspect.isfunction(member) and not name.startswith("_"):
            yield from cut_signatures(member) if name == "cut" else [signature(name, member)]


def stub_of(pomona):
    lines = [HEAD]
    for kind in (pomona.Diagnostic, pomona.Option, pomona.TemplateEntry, pomona.SceneEntry, pomona.StyleEntry):
        lines += [f"class {kind.__name__}(NamedTuple):", *(f"    {field}: {FIELDS.get(field, 'str')}" for field in kind._fields)]
    lines += ["class Error(Exception):", "    status: int", "    diagnostics: list[Diagnostic]",
              *("    " + line for line in members(pomona.Error))]
    lines += ["class Truth:", *(f"    {name}: {kind}" for name, kind in TRUTH.items())]
    for kind in (pomona.Piece, pomona.Pieces, pomona.Section, pomona.Fruit, pomona.Scene):
        parent = "(Sequence[Piece])" if kind is pomona.Pieces else ""
        lines += [f"class {kind.__name__}{parent}:", *("    " + line for line in members(kind))]
        if kind is pomona.Pieces:
            lines += ["    @overload", "    def __getitem__(self, which: int) -> Piece: ...", "    @overload",
                      "    def __getitem__(self, which: slice) -> list[Piece]: ...", "    def __len__(self) -> int: ..."]
    for name in ("grow", "scene", "templates", "scenes", "styles", "options", "shown_on"):
        lines.append(signature(name, getattr(pomona, name)))
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.path.insert(0, sys.argv[1])
    sys.dont_write_bytecode = True
    import pomona

    with open(sys.argv[2], "w", encoding="utf-8") as output:
        output.write(stub_of(pomona))
