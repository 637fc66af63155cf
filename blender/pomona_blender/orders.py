"""What is asked of Pomona: a value that says all of it, and its words on a command line."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Iterable, Sequence, Union

from .option_table import Option

Value = Union[bool, int, float, str]


@dataclass(frozen=True)
class Order:
    """A fruit, its pieces or a scene.

    verb     grow, cut or scene: a command of the program
    what     a template or a scene: a name or a path
    knives   words as "half" and "wedges:6", in the order of cutting
    options  (name as in the table, value), in the order of the table; what is left out is as the table says
    stamp    when the file `what` was changed, so that an edited template is another order; 0 for a name
    """

    verb: str
    what: str
    knives: tuple[str, ...] = ()
    options: tuple[tuple[str, Value], ...] = ()
    stamp: int = 0

    def words(self) -> list[str]:
        """The command line without the program and without outputs."""
        said = [self.verb, self.what]
        for knife in self.knives:
            said += ["--knife", knife]
        for name, value in self.options:
            said += [f"--{name}"] if value is True else [f"--{name}", spelled(value)]
        return said

    @property
    def key(self) -> str:
        """Equal for equal orders; kept in files of Blender."""
        return shlex.join(self.words()) + (f" @{self.stamp}" if self.stamp else "")


def spelled(value: Value) -> str:
    """A number as short as a person writes it: Blender keeps 32 bits, in which 0.4 is 0.4000000059604645."""
    return f"{value:.7g}" if isinstance(value, float) else str(value)


def stamp_of(what: str) -> int:
    """When the file, or the sketch beside it, was changed last, nanoseconds; 0 if `what` is the name of something that
    Pomona has."""
    path = Path(what)
    files = [path, path.with_suffix(".svg")] if path.suffix else []
    return max((file.stat().st_mtime_ns for file in files if file.is_file()), default=0)


def order_from_command(command: str, table: Sequence[Option]) -> Order:
    """What a piece's `command` makes again, without its outputs. ValueError if it is no command of Pomona's."""
    words = shlex.split(command)
    if len(words) < 3 or words[1] not in ("grow", "cut", "scene"):
        raise ValueError(f"not a command that makes a piece: {command}")
    known = {option.name: option for option in table}
    knives: list[str] = []
    options: dict[str, Value] = {}
    rest = iter(words[3:])
    for word in rest:
        if word == "-o":
            next(rest, None)
        elif word == "--knife":
            knives.append(next(rest))
        elif word.startswith("--") and word[2:] in known:
            option = known[word[2:]]
            options[option.name] = True if option.kind == "bool" else option.value_of(next(rest))
        else:
            raise ValueError(f"Pomona has no {word} here: {command}")
    return Order(words[1], words[2], tuple(knives), in_table_order(options.items(), table))


def in_table_order(options: Iterable[tuple[str, Value]], table: Sequence[Option]) -> tuple[tuple[str, Value], ...]:
    """So that orders that say the same are equal."""
    places = {option.name: place for place, option in enumerate(table)}
    return tuple(sorted(options, key=lambda one: places[one[0]]))
