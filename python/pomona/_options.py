"""The keyword arguments that functions take: those of the one table of options."""

import inspect
from typing import NamedTuple, Optional, Tuple

from . import _core

STEPS = ("grow", "cut", "write")


class Option(NamedTuple):
    """A row of the table of options."""

    name: str
    """As on the command line: ripeness-variants"""
    keyword: str
    """As an argument here: ripeness_variants"""
    kind: str
    """bool, int, float, choice, path, text or knives"""
    default: str
    range: Optional[Tuple[float, float]]
    choices: Tuple[str, ...]
    unit: str
    help: str
    takers: Tuple[str, ...]
    """Commands that have it"""
    step: str
    """The step of the road that needs it first: grow, cut or write"""
    type: str
    """What help calls a text"""
    formats: Tuple[str, ...]
    """The formats on which it has an effect, as "glb"; none means all"""


def options():
    """All options of the one table, in the order in which commands say them: a list of `Option`."""
    return list(TABLE)


def read_table():
    rows = ({**row, "choices": tuple(row["choices"]), "takers": tuple(row["takers"]),
             "formats": tuple(row["formats"])} for row in _core.options())
    return tuple(Option(**row) for row in rows)


TABLE = read_table()

TYPES = {
    "bool": "bool",
    "int": "int",
    "float": "float",
    "choice": "str",
    "path": "Union[str, os.PathLike[str]]",
    "text": "Union[str, float, Sequence[float]]",
    "knives": "Union[str, Sequence[str]]",
}


def annotation(option):
    """What mypy is told of the argument."""
    if option.kind == "choice":
        return "Optional[Literal[" + ", ".join(repr(word) for word in option.choices) + "]]"
    return f"Optional[{TYPES[option.kind]}]"


def described(option):
    """A line of help()."""
    values = ""
    if option.choices:
        values = " (" + ", ".join(option.choices) + ")"
    elif option.range:
        values = " ({:g} to {:g}{})".format(*option.range, " " + option.unit if option.unit else "")
    usual = f" [{option.default}]" if option.default else ""
    return f"    {option.keyword}{values}: {option.help}{usual}"


def taken(taker, step):
    """The options that this taker has from this step on."""
    return [option for option in TABLE if taker in option.takers and STEPS.index(option.step) >= STEPS.index(step)]


def takes(taker, step):
    """Gives a function with **options the signature and the help of those that the table has for it."""

    def with_options(function):
        rows = taken(taker, step)
        said = inspect.signature(function)
        kept = [p for p in said.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
        known = {p.name for p in kept}
        added = [
            inspect.Parameter(row.keyword, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=annotation(row))
            for row in rows
            if row.keyword not in known
        ]
        function.__signature__ = said.replace(parameters=kept + added)
        function.__doc__ = (inspect.cleandoc(function.__doc__) + "\n\nOptions, from the one table (pomona.options()):\n"
                            + "\n".join(described(row) for row in rows))
        return function

    return with_options
