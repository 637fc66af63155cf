"""Broken .obj files."""

from .box import COLORS, CORNERS, FACES
from .case import Case

VERTICES = [" ".join(["v", *(f"{x:g}" for x in corner), *(f"{c:g}" for c in color)]) for corner, color in zip(CORNERS, COLORS)]
LINES = ["o box", *VERTICES, *("f " + " ".join(str(corner + 1) for corner in face) for face in FACES)]
FIRST_FACE = 1 + len(VERTICES)
WHOLE = ("\n".join(LINES) + "\n").encode()


def with_line(number, line):
    lines = [text.encode() for text in LINES]
    lines[number] = line if isinstance(line, bytes) else line.encode()
    return b"\n".join(lines) + b"\n"


def cases():
    def case(kind, done, data, wanted="told"):
        return Case(f"OBJ: {kind}", done, data, "obj", wanted, WHOLE)

    for text in ("nan", "inf", "-inf", "1e300", "1e999", "x", "1,5", "0x1p3", "1.#IND", "1.#QNAN", "--1", "1e", ".", "1.2.3", "½", "''", "1_0"):
        for column in (1, 2, 3, 4):
            words = VERTICES[0].split()
            words[column] = text
            yield case("numbers", f"{text} as number {column}", with_line(1, " ".join(words)))
    for count in (0, 1, 2, 5, 8, 9, 20):
        yield case("numbers", f"a vertex of {count} numbers", with_line(1, "v" + " 0" * count))
    for word in ("0", "9", "-9", "99999999999", "-99999999999", "9223372036854775808", "1.5", "x", "1e0", "", "/1", "//1", "NaN", "0x1", "+", "-", "1\\"):
        yield case("corners", f"a corner {word!r}", with_line(FIRST_FACE, f"f 4 3 2 {word or '/'}"))
    for word in ("1/", "1//", "1/1/1", "1/99/99", "1//99"):
        yield case("corners", f"a corner {word!r}", with_line(FIRST_FACE, f"f 4 3 2 {word}"), "either")
    for done, line in {"two corners": "f 4 3", "one corner": "f 4", "no corner": "f",                        "three times one": "f 4 4 4", "there and back": "f 4 3 4 3", "a crossing": "f 4 2 3 1"}.items():
        yield case("faces", f"a face of {done}", with_line(FIRST_FACE, line))
    yield case("faces", "a corner twice in a row", with_line(FIRST_FACE, "f 4 4 3 2 1 4"), "whole")
    for done, line in {"a curve": "curv 0 1 1 2", "a surface": "surf 0 1 0 1 1 2 3 4", "another file": "call more.obj", "a capital V": "V 0 0 0",
                       "a capital F": "F 1 2 3", "a number alone": "1 2 3", "bytes": b"\xff\xfe\x00\x01", "NUL": b"\0\0\0\0",
                       "a control character": b"\x1b[2J"}.items():
        yield case("lines", done, with_line(0, line))
    for done, line in {"an unknown keyword": "weight 3", "a comment": "# x", "a material that is not there": "usemtl none", "Latin-1": b"# caf\xe9",
                       "a library that is not there": "mtllib none.mtl", "texture places": "vt 0 0", "a bad texture place": "vt x",
                       "a name in Latin-1": b"o b\xf6x", "a name of control characters": b"g \x1b[2J", "a long name": "g " + "x" * 100000}.items():
        yield case("lines", done, with_line(0, line), "whole")
    for number, name in ((1, "the first vertex"), (8, "the last vertex")):
        yield case("lines", f"without {name}", b"\n".join(line.encode() for k, line in enumerate(LINES) if k != number) + b"\n")
    yield case("lines", "without a face", b"\n".join(line.encode() for line in LINES[:-1]) + b"\n")
    yield case("lines", "without faces", b"\n".join(line.encode() for line in LINES[:FIRST_FACE]) + b"\n")
    yield case("lines", "a face twice", WHOLE + LINES[-1].encode() + b"\n")
    for length in (0, 1, 2, 10, 30, 60, 100, 150, len(WHOLE) - 11, len(WHOLE) - 6):
        yield case("cut short", f"the first {length} bytes", WHOLE[:length])
    yield case("cut short", "without its last line end", WHOLE[:-1], "whole")
    for code, wanted in (("utf-8-sig", "whole"), ("utf-16", "told"), ("utf-16-le", "told"), ("utf-16-be", "told"), ("utf-32", "told")):
        yield case("texts", f"as {code}", WHOLE.decode().encode(code), wanted)
    yield case("texts", "with CR LF", WHOLE.replace(b"\n", b"\r\n"), "whole")
    yield case("texts", "with CR", WHOLE.replace(b"\n", b"\r"), "whole")
    yield case("texts", "with tabs", WHOLE.replace(b" ", b"\t"), "whole")
    yield case("texts", "NUL behind its end", WHOLE + b"\0" * 16)
    for done, data in {"glTF": b"glTF\2\0\0\0" + bytes(100), "PLY": b"ply\nformat ascii 1.0\n", "HTML": b"<!DOCTYPE html><html></html>",
                       "a picture": b"\x89PNG\r\n\x1a\n" + bytes(50), "zip": b"PK\3\4" + bytes(50), "gzip": b"\x1f\x8b\x08" + bytes(50),
                       "STL": b"solid box\nfacet normal 0 0 1\n"}.items():
        yield case("texts", f"{done} by this name", data)
