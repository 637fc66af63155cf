"""Grows fruit and vegetables that can be cut anywhere, and fills scenes with them.

    import pomona
    wedges = pomona.grow("tomato", seed=3, ripeness=0.4).cut("wedges:6")
    wedges[0].positions, wedges[0].volume
    wedges.write("wedges.glb")
    picture = pomona.scene("salad", seed=2).render(size=(640, 480))

The same seed gives the same bytes, as the program does. Every option of the program is a keyword argument of the
function that needs it first: help(pomona.grow), help(pomona.Fruit.cut), help(pomona.Pieces.write)."""

from typing import NamedTuple

from . import _core
from ._core import version as __version__
from ._options import Option, options
from ._telling import Diagnostic, Error, PomonaWarning
from ._things import Fruit, Piece, Pieces, Scene, Section, Truth, grow, scene

__all__ = ["Diagnostic", "Error", "Fruit", "Option", "Piece", "Pieces", "PomonaWarning", "Scene", "Section",
           "SceneEntry", "StyleEntry", "TemplateEntry", "Truth", "grow", "options", "scene", "scenes", "shown_on",
           "styles", "templates"]


class TemplateEntry(NamedTuple):
    """What `templates()` tells of one."""

    name: str
    title: str
    parts: list
    file: object


class SceneEntry(NamedTuple):
    """What `scenes()` tells of one."""

    name: str
    title: str
    file: object


class StyleEntry(NamedTuple):
    """What `styles()` tells of one."""

    name: str
    title: str


def templates():
    """What can be grown: a list of name, title, parts and file."""
    return [TemplateEntry(*one) for one in _core.templates()]


def scenes():
    """What can be composed: a list of name, title and file."""
    return [SceneEntry(*one) for one in _core.scenes()]


def styles():
    """What pictures can be drawn in: a list of name and title."""
    return [StyleEntry(*one) for one in _core.styles()]


def shown_on(bar):
    """Progress for a bar of tqdm: pomona.scene("salad", progress=pomona.shown_on(tqdm()))."""

    def show(stage, done, total):
        bar.set_description(stage, refresh=False)
        bar.total, bar.n = total, done
        bar.refresh()

    return show
