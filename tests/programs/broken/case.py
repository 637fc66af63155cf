from dataclasses import dataclass


@dataclass
class Case:
    """A broken file: of what kind, what was done to it, its bytes and ending, and what is wanted. `whole`: the bytes of the file
    that it was made from, which must be read; "told" wants an error or a warning, "whole" the same mesh as the whole file, to
    the byte, and "either" one of both."""
    kind: str
    done: str
    data: bytes
    ending: str
    wanted: str = "told"
    whole: bytes = b""
    object: str = ""
