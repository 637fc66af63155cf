"""Dictionaries as TOML, for templates and scenes that a program makes: the standard library reads it, and writes none."""

import json
import math
import numbers
import re
from collections.abc import Mapping


def text_of(table):
    """The TOML of a dictionary. Values are texts, numbers, switches, lists and dictionaries of these."""
    return "\n".join(lines_of(table, ())) + "\n"


def lines_of(table, path):
    """Plain values first: what follows a heading belongs to it."""
    nested = {key: value for key, value in table.items() if isinstance(value, Mapping) or is_tables(value)}
    for key, value in table.items():
        if key not in nested:
            yield f"{word(key)} = {value_of(value)}"
    for key, value in nested.items():
        heading = ".".join(word(part) for part in (*path, key))
        for one in value if is_tables(value) else [value]:
            yield f"[[{heading}]]" if is_tables(value) else f"[{heading}]"
            yield from lines_of(one, (*path, key))


def is_tables(value):
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(one, Mapping) for one in value)


def word(key):
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else json.dumps(key)


def value_of(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        number = float(value)
        return repr(number) if math.isfinite(number) else str(number)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{word(key)} = {value_of(one)}" for key, one in value.items()) + "}"
    if hasattr(value, "__fspath__"):
        return value_of(value.__fspath__())
    return "[" + ", ".join(value_of(one) for one in value) + "]"
