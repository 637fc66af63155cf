"""The one table of options, as the module or the program tells it. The add-on has none of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterable, Optional, Union


@dataclass(frozen=True)
class Option:
    """A row of the table.

    kind     bool, int, float, choice or text
    default  as a text; "" where the template or the scene decides
    takers   the commands that have it
    formats  the files that it bears on, as "glb"; none means all
    step     grow, cut or write: which function of the module takes it; "" if the program told the table
    """

    name: str
    keyword: str
    kind: str
    default: str
    low: Optional[float]
    high: Optional[float]
    choices: tuple[str, ...]
    help: str
    takers: tuple[str, ...]
    formats: tuple[str, ...]
    step: str = ""

    def value_of(self, text: str) -> Union[bool, int, float, str]:
        """What a command line says, as this kind of value. ValueError if it is none."""
        return {"int": int, "float": float}.get(self.kind, str)(text)


KINDS = {"flag": "bool", "count": "int", "whole": "int", "number": "float", "choice": "choice"}


def told_by_program(rows: Iterable[dict[str, Any]]) -> list[Option]:
    """What `pomona pages options` prints."""
    return [Option(name=row["name"], keyword=row["key"], kind=KINDS.get(row["type"], "text"), default=row["usual"],
                   low=row.get("low"), high=row.get("high"), choices=tuple(row.get("words", ())), help=row["help"],
                   takers=tuple(row["commands"]), formats=tuple(row["formats"])) for row in rows]


def told_by_module(rows: Iterable[Any]) -> list[Option]:
    """What `pomona.options()` gives."""
    plain = ("bool", "int", "float", "choice")
    return [Option(name=row.name, keyword=row.keyword, kind=row.kind if row.kind in plain else "text",
                   default=row.default, low=row.range[0] if row.range else None,
                   high=row.range[1] if row.range else None, choices=tuple(row.choices), help=row.help,
                   takers=tuple(row.takers), formats=tuple(row.formats), step=row.step) for row in rows]


# What the table has for .glb files of pieces, and a person has no use for here: knives are a list of their own, objects
# have a seed each, the other files are not read, and names and extras for engines are not for Blender.
NOT_ASKED = frozenset(("knife", "seeds", "section", "pieces", "maps-dir", "aov", "aov-format", "engine", "instances",
                       "feature-ids", "compress", "atlas", "ripeness-variants", "threads"))


def asked(table: Iterable[Option]) -> list[Option]:
    """The options that fruit in Blender has."""
    return [option for option in table if "cut" in option.takers and option.name not in NOT_ASKED
            and (not option.formats or "glb" in option.formats)]
