"""What a fruit in Blender is made by: properties of an empty object, its root, whose children are the pieces."""

from __future__ import annotations

from typing import Any, Callable, Iterable, Iterator, Sequence

import bpy

from .option_table import Option
from .orders import Order, Value, in_table_order, spelled, stamp_of
from .plane_knife import plane_words

# Knives to begin with; the manual page tells of all.
KNIFE_EXAMPLES = ("half", "across", "wedges:6", "slices:8", "slices:5mm", "dice:12mm", "sticks:6mm", "crinkle:8mm",
                  "ball:24mm", "core:18mm", "bite:40mm", "peel:2mm", "plane:0,1,0,3cm")


def suggested_knives(_group: Any, _context: Any, typed: str) -> list[str]:
    return [knife for knife in KNIFE_EXAMPLES if typed in knife] or list(KNIFE_EXAMPLES)


def property_of(option: Option, update: Callable[[Any, Any], None] | None) -> Any:
    """A property of Blender with the option's range, choices, default and help. Where the table has no default, the
    template's own counts until somebody sets it."""
    said: dict[str, Any] = {"name": option.name.replace("-", " ").capitalize(), "description": option.help,
                            "options": {"SKIP_SAVE"}}
    if update is not None:
        said["update"] = update
        said["options"] = set()
    if option.kind == "bool":
        return bpy.props.BoolProperty(**said)
    if option.kind == "choice":
        items = [(word, word, "") for word in option.choices]
        return bpy.props.EnumProperty(items=items, default=option.default or option.choices[0], **said)
    if option.kind == "float":
        low, high = option.low or 0.0, option.high or 1e6
        default = float(option.default) if option.default else min(max(1.0, low), high)
        return bpy.props.FloatProperty(min=low, max=high, default=default, **said)
    if is_number(option):
        low, high = int(option.low or 0), int(option.high or 2**31 - 1)
        return bpy.props.IntProperty(min=low, max=high, default=int(option.default or low), **said)
    return bpy.props.StringProperty(**said)


def is_number(option: Option) -> bool:
    """Whether it fits a number of Blender, of 32 bits: an index may be larger, and is kept as a text."""
    return option.kind == "int" and bool(option.default or option.high)


def option_properties(table: Iterable[Option], update: Callable[[Any, Any], None] | None) -> dict[str, Any]:
    """By keyword, in the order of the table."""
    return {option.keyword: property_of(option, update) for option in table}


def said_options(group: Any, table: Sequence[Option]) -> list[tuple[str, Value]]:
    """What somebody has set: (name, value)."""
    said: list[tuple[str, Value]] = []
    for option in table:
        value = getattr(group, option.keyword)
        if group.is_property_set(option.keyword) and value is not False and value != "":
            said.append((option.name, float(spelled(value)) if isinstance(value, float) else value))
    return said


def set_options(group: Any, options: Iterable[tuple[str, Value]], table: Sequence[Option]) -> None:
    """Sets these, and unsets all others. ValueError where a value does not fit."""
    given = dict(options)
    for option in table:
        if option.name not in given:
            group.property_unset(option.keyword)
            continue
        value = given[option.name]
        if option.kind == "int" and not is_number(option):
            value = str(value)
        try:
            setattr(group, option.keyword, value)
        except (OverflowError, TypeError) as error:
            raise ValueError(f"{option.name}: {value} does not fit Blender's numbers") from error


def roots() -> Iterator[Any]:
    """All fruit and scenes of the file."""
    return (thing for thing in bpy.data.objects if thing.type == "EMPTY" and thing.pomona.verb)


def root_of(thing: Any) -> Any:
    """The root that it belongs to, or is; None if none."""
    while thing is not None and not (thing.type == "EMPTY" and thing.pomona.verb):
        thing = thing.parent
    return thing


def knife_words(root: Any) -> tuple[str, ...]:
    """Planes say where they are now; a plane that is gone cuts nothing."""
    said = []
    for knife in root.pomona.knives:
        if knife.is_plane:
            if knife.plane is not None:
                said.append(plane_words(root, knife.plane))
        elif knife.words:
            said.append(knife.words)
    return tuple(said)


def order_of(root: Any, table: Sequence[Option]) -> Order:
    """What its settings ask for."""
    fruit = root.pomona
    knives = knife_words(root)
    verb = "grow" if fruit.verb == "cut" and not knives else fruit.verb
    options = [(option.name, option) for option in table if verb in option.takers]
    taken = [option for _, option in options]
    return Order(verb, fruit.what, knives, in_table_order(said_options(fruit.options, taken), table),
                 stamp_of(fruit.what))


# Left out while something moves: they take long.
LASTING = frozenset(("texture", "texel", "maps", "lod", "quality", "faces"))


def hasty(order: Order, table: Sequence[Option]) -> Order:
    """The same as quick as it goes: a draft without textures and levels. Scenes are not made in haste."""
    if order.verb == "scene":
        return order
    options = [one for one in order.options if one[0] not in LASTING] + [("quality", "draft")]
    if order.verb == "cut":
        options.append(("faces", "coarse"))
    return Order(order.verb, order.what, order.knives, in_table_order(options, table), order.stamp)
