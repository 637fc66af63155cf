"""What the binding tells: errors and warnings as Python has them."""

import os
import re
import sys
import warnings
from typing import NamedTuple


class PomonaWarning(UserWarning):
    """Something had no effect, or came out other than one may think."""


class Diagnostic(NamedTuple):
    """One thing that is wrong. Line and column count from 1; 0 means the file as a whole, or none."""

    file: str
    line: int
    column: int
    element: str
    message: str
    hint: str

    def __str__(self):
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part)
        words = " ".join(part for part in (place and place + ":", self.element and self.element + ":", self.message) if part)
        return words + (f"\n  hint: {self.hint}" if self.hint else "")


class Error(Exception):
    """What is wrong with what was asked for, or with a file that was read: `diagnostics` has all of it.

    `file`, `line`, `column`, `message` and `hint` are those of the first; `status` is the exit status of the program
    in the same case (docs/reference/commands.md)."""

    def __init__(self, status, diagnostics):
        super().__init__("\n".join(str(one) for one in diagnostics))
        self.status = status
        self.diagnostics = diagnostics

    def __reduce__(self):
        return (type(self), (self.status, self.diagnostics))

    file = property(lambda self: self.diagnostics[0].file)
    line = property(lambda self: self.diagnostics[0].line)
    column = property(lambda self: self.diagnostics[0].column)
    message = property(lambda self: self.diagnostics[0].message)
    hint = property(lambda self: self.diagnostics[0].hint)


def in_python(words):
    """Options are keywords here: "--ripeness-variants" is ripeness_variants."""
    return re.sub(r"(?<![\w-])--([a-z][a-z-]*)", lambda option: option.group(1).replace("-", "_"), words)


def error(status, diagnostics):
    """Called by the binding."""
    told = [Diagnostic(*one) for one in diagnostics]
    return Error(status, [one._replace(message=in_python(one.message), hint=in_python(one.hint)) for one in told])


def warn(messages):
    """Called by the binding. The warning is about the line that called the package."""
    here, level, frame = os.path.dirname(__file__), 1, sys._getframe()
    while frame is not None and os.path.dirname(frame.f_code.co_filename) == here:
        frame, level = frame.f_back, level + 1
    for message in messages:
        warnings.warn(in_python(message), PomonaWarning, stacklevel=level)
