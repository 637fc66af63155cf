#!/usr/bin/env python3
"""Our own files, spoilt in ways that have a name, each given to the program: it must say what is wrong and where, end with
the documented status, write nothing, and take no more than 2 seconds of the processor and 512 MB.

    malformed.py PROGRAM                 all of them, some 3000: `make malformed`
    malformed.py PROGRAM --every 12      each twelfth: part of the ordinary tests
    malformed.py PROGRAM --keep FOLDER   leaves the files there

The files are made anew each time, the same each time: a change of ours that stops being a mistake is told, too."""

import argparse
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SECONDS, KILOBYTES = 2.0, 512 * 1024
PLACE = re.compile(r"^\S.*?:(\d+:\d+|[^:\n]*\b(byte|vertex|face|scene|node|mesh|header|end of file)\b[^\n]*?): error: .{8,}|^\S+: error: is larger than \d+ [KM]iB", re.M)


# What is done to a text: from the text, a spoilt one, or None where the change does not apply.

def once(pattern, new, flags=re.M):
    """Puts `new` in the place of what the pattern finds first."""
    def change(text):
        spoilt, count = re.subn(pattern, lambda m: m.expand(new), text, count=1, flags=flags)
        return spoilt if count else None
    return change


def in_front(words):
    return lambda text: words + text


def behind(words):
    return lambda text: text + words


TOML = {
    "a word that is no TOML": in_front("fruit\n"),
    "a text without its end": behind('\nmore = "text\n'),
    "a bracket without its end": behind("\n[more\n"),
    "an array without its end": behind("\nmore = [1, 2\n"),
    "a byte that is no UTF-8": behind("\n# \udcff\n"),
    "an unknown key": in_front("colour_of_sky = 1\n"),
    "control characters in a key": in_front('"\\u001b[2Jsky" = 1\n'),
    "a key twice": in_front("format = 1\n"),
    "a format of the future": once(r"^format = 1", "format = 99"),
    "a format that is a text": once(r"^format = 1", 'format = "1"'),
    "no format": once(r"^format = 1\n", ""),
    "a name with blanks": once(r'^name = "[^"]*"', 'name = "a b"'),
    "a name that is a number": once(r'^name = "[^"]*"', "name = 7"),
    "a name of a thousand letters": once(r'^name = "[^"]*"', f'name = "{"x" * 1000}"'),
    "brackets 100 deep": behind("\nmore = " + "[" * 100 + "]" * 100 + "\n"),
    "an array of 100 001": behind("\nmore = [" + "1," * 100001 + "]\n"),
    "a text of 65 537 bytes": behind('\nmore = "' + "x" * 65537 + '"\n'),
    "a key of 100 dots": behind("\n" + ".".join("a" * 100) + " = 1\n"),
    "nothing at all": lambda text: "",
}
TEMPLATE = TOML | {
    "a unit without a unit": once(r'^unit = "([0-9.]+)mm"', 'unit = "\\1 parsecs"'),
    "no symmetry": once(r"^\[symmetry\]\n(?:[^\[].*\n|\n)*", ""),
    "another symmetry": once(r'^kind = "(cylindrical|folds|none|[a-z]+)"', 'kind = "helical"'),
    "no parts": once(r"^parts = \[[^\]]*\]", "parts = []"),
    "a part that is not there": once(r'part = "[a-z]+"', 'part = "feather"'),
    "a colour of five digits": once(r'"#[0-9a-f]{6}"', '"#12345"'),
    "a colour that is none": once(r'"#[0-9a-f]{6}"', '"red"'),
    "a length that is not a number": once(r'"[0-9.]+mm"', '"nanmm"'),
    "an endless length": once(r'"[0-9.]+mm"', '"1e999mm"'),
    "a negative blur": once(r'blur = "[0-9.]+mm"', 'blur = "-1mm"'),
    "around without end": once(r"around = \d+", "around = 2000000000"),
    "along of nothing": once(r"along = \d+", "along = 0"),
    "a curve that is no path": once(r'"\s*M [^"]*"', '"M 0 0 L x y"'),
    "a curve too far away": once(r'"\s*M [^"]*"', '"M 0 0 L 1e300 5"'),
    "a curve of one point": once(r'"\s*M [^"]*"', '"M 1 1"'),
    "a mean density of nothing": in_front("density = -5\n"),
    "grains too near": once(r'^spacing = "[0-9.]+mm"', 'spacing = "0mm"'),
    "a sketch from elsewhere": once(r'^sketch = "[^"]*"', 'sketch = "../../../etc/passwd"'),
    "a sketch that is not there": once(r'^sketch = "[^"]*"', 'sketch = "none.svg"'),
    "a curve that is not in the sketch": once(r'= "#[a-z][a-z0-9 _-]*"', '= "#no-such-curve"'),
}
SCENE = TOML | {
    "no template of that name": once(r'^template = "[^"]*"', 'template = "durian"'),
    "a knife that is none": once(r'^knives = \[[^\]]*\]', 'knives = ["halve"]'),
    "a knife without a unit": once(r'^knives = \[[^\]]*\]', 'knives = ["slices:4.5"]'),
    "too many cells": once(r'^knives = \[[^\]]*\]', 'knives = ["dice:0.05mm"]'),
    "a count of millions": once(r"^count = \d+", "count = 4000000"),
    "a count that is not a number": once(r"^count = \d+", "count = nan"),
    "no layout of that name": in_front('layout = "none.json"\n'),
    "a picture of no size": once(r"^size = \[[^\]]*\]", "size = [0, 900]"),
    "a bowl that is no line": once(r'^profile = """[^"]*"""', 'profile = "M 0 0"'),
    "two pieces of one name": lambda text: text + text[text.index("[[pieces]]"):] if "[[pieces]]" in text else None,
    "a style that is not there": in_front('style = "cubism.toml"\n'),
}
STYLE = TOML | {
    "another kind": once(r'^kind = "style"', 'kind = "template"'),
    "a width below nothing": behind("\n[ink2]\nwidth = -1\n"),
}
BATCH = TOML | {
    "a batch without entries": once(r"\[\[entry\]\][\s\S]*", ""),
    "no template of that name": once(r'templates = \[[^\]]*\]', 'templates = ["durian"]'),
    "a knife that is none": once(r'knives = \[[^\]]*\]', 'knives = [["halve"]]'),
}
SVG = {
    "no XML": in_front("fruit"),
    "an element without its end": once(r"</svg>\s*$", ""),
    "an attribute without its end": once(r' d="', " d=\"M 0 0 ' "),
    "another root": lambda text: text.replace("<svg", "<html").replace("</svg>", "</html>"),
    "compressed": in_front("\x1f\x8b"),
    "100 groups deep": once(r"</svg>\s*$", "<g>" * 100 + "</g>" * 100 + "</svg>"),
    "a path that is none": once(r' d="[^"]*"', ' d="M 0 0 L x"'),
    "a path too far away": once(r' d="[^"]*"', ' d="M 0 0 L 1e300 1"'),
    "cut short": lambda text: text[: len(text) // 2],
    "nothing at all": lambda text: "",
}
JSON = {
    "cut short": lambda text: text[: len(text) // 2],
    "no JSON": in_front("layout "),
    "a format of the future": once(r'"format": ?1', '"format": 2'),
    "no instances": once(r'"instances"', '"things"'),
    "a turn that is none": once(r'"rotation": ?\[[^\]]*\]', '"rotation": [2,0,0,0]'),
    "a place too far away": once(r'"translation": ?\[[^\]]*\]', '"translation": [1e300,0,0]'),
    "two numbers for three": once(r'"translation": ?\[[^\]]*\]', '"translation": [0,0]'),
    "a name that is a number": once(r'"name": ?"[^"]*"', '"name": 7'),
    "brackets 100 deep": lambda text: "[" * 100 + "]" * 100,
    "1 600 000 values": lambda text: '{"format": 1, "instances": [' + "0," * 1600000 + "0]}",
    "a key twice": once(r'"format"', '"format": 1, "format"'),
    "1001 keys": lambda text: "{" + ",".join(f'"{i}": 0' for i in range(1001)) + "}",
    "nothing at all": lambda text: "",
}
PLY = {
    "another first line": once(r"^ply", "plx"),
    "an unknown format": once(r"^format \S+", "format octal"),
    "a count of billions": once(r"^element vertex \d+", "element vertex 4000000000"),
    "a negative count": once(r"^element face \d+", "element face -1"),
    "an unknown type": once(r"^property float x", "property float128 x"),
    "no x": once(r"^property float x", "property float u"),
    "no faces": once(r"^element face", "element edge"),
    "a header without its end": once(r"^end_header", "end"),
    "cut short": lambda text: text[: len(text) - 20],
    "cut in the header": lambda text: text[:60],
    "nothing at all": lambda text: "",
}
OBJ = {
    "a number that is none": once(r"^v \S+", "v x"),
    "a number too large": once(r"^v \S+", "v 1e300"),
    "a number that is not finite": once(r"^v \S+", "v nan"),
    "two numbers for three": once(r"^v (\S+) (\S+).*", "v \\1 \\2"),
    "a vertex that is not there": once(r"^f \S+", "f 99999999"),
    "vertex 0": once(r"^f \S+", "f 0"),
    "a face of words": once(r"^f \S+", "f x"),
    "no faces": lambda text: re.sub(r"^f .*\n?", "", text, flags=re.M),
    "nothing at all": lambda text: "",
}
GLB = {
    "another first word": once(r"^glTF", "glTG"),
    "cut short": lambda text: text[: len(text) // 2],
    "a length too large": lambda text: text[:8] + "\xff\xff\xff\x7f" + text[12:],
    "JSON longer than the file": lambda text: text[:12] + "\xff\xff\xff\x7f" + text[16:],
    "another first chunk": once("JSON", "XSON"),
    "no JSON": once(r'\{"asset"', '["asset"'),
    "an accessor that is not there": once(r'"POSITION":0', '"POSITION":9'),
    "a node that is not there": once(r'"nodes":\[0\]', '"nodes":[9]'),
    "a mesh that is not there": once(r'"mesh":0', '"mesh":9'),
    "a count too large": once(r'"count":\d', '"count":9'),
    "lines": once(r'\{"attributes"', '{"mode":1,"attributes"'),
    "another type": once(r'"VEC3"', '"VEC2"'),
    "nothing at all": lambda text: "",
}
for name in ("a count too large", "lines", "another type", "no JSON", "an accessor that is not there"):
    GLB[name] = (lambda change: lambda text: measured(change(text)))(GLB[name])


def measured(glb):
    """The lengths of a .glb's file and first chunk made right again."""
    if glb is None:
        return None
    data = glb.encode("latin-1")
    end = data.index(b"BIN\0") - 4
    head = struct.pack("<4sII", b"glTF", 2, 0) + struct.pack("<I4s", 0, b"JSON")
    text = data[len(head):end].rstrip(b" ")
    text += b" " * (-len(text) % 4)
    whole = 20 + len(text) + len(data) - end
    return (struct.pack("<4sIII4s", b"glTF", 2, whole, len(text), b"JSON") + text + data[end:]).decode("latin-1")


def with_size(width, height):
    def change(text):
        head = b"IHDR" + struct.pack(">II", width, height) + text.encode("latin-1")[24:29]
        return text[:12] + (head + struct.pack(">I", zlib.crc32(head))).decode("latin-1") + text[33:]
    return change


PNG = {
    "another first byte": lambda text: "\x88" + text[1:],
    "cut short": lambda text: text[: len(text) // 2],
    "cut in its head": lambda text: text[:20],
    "no pixels": with_size(0, 0),
    "more pixels than it holds": with_size(9000, 9000),
    "more pixels than are read": with_size(16000, 16000),
    "more pixels than there are": with_size(2**31 - 1, 2**31 - 1),
    "a wrong checksum": lambda text: text[:29] + "\0\0\0\0" + text[33:],
    "a picture of another kind": lambda text: "GIF89a" + text,
    "nothing at all": lambda text: "",
}

# Which files of ours, how they are read and written, what is done to them, and what the program is asked.
KINDS = [
    ("template", ["templates/*.toml"], "utf-8", TEMPLATE),
    ("scene", ["scenes/*.toml"], "utf-8", SCENE),
    ("style", ["styles/*.toml"], "utf-8", STYLE),
    ("batch", ["scenes/*.toml"], "utf-8", BATCH),
    ("drawing", ["templates/*.svg", "scenes/*.svg"], "latin-1", SVG),
    ("layout", ["tests/fuzz/corpus/layout/*"], "utf-8", JSON),
    ("surfaces", ["templates/*.ply", "tests/fuzz/corpus/ply/*"], "latin-1", PLY),
    ("mesh", ["scenes/dishes/*.obj", "tests/fuzz/corpus/obj/*"], "latin-1", OBJ),
    ("glTF", ["tests/fuzz/corpus/glb/*"], "latin-1", GLB),
    ("picture", ["tests/fuzz/corpus/png/*", "tests/golden/pepper_six.png"], "latin-1", PNG),
]


def is_kind(kind, path):
    if kind == "batch":
        return "[batch]" in path.read_text(encoding="utf-8")
    if kind == "scene":
        return "[batch]" not in path.read_text(encoding="utf-8")
    return True


def spoilt_files():
    """(kind, source, what was done, bytes) of all that can be made."""
    for kind, patterns, encoding, changes in KINDS:
        for path in sorted(p for pattern in patterns for p in ROOT.glob(pattern)):
            if not is_kind(kind, path):
                continue
            text = path.read_bytes().decode(encoding)
            for name, change in changes.items():
                spoilt = change(text)
                if spoilt is not None and spoilt != text:
                    data = spoilt.encode(encoding, errors="surrogateescape")
                    yield kind, path, name, data


def fault_of(program, file):
    """What the program did wrong with the file, or nothing; and what it took."""
    before = sorted(os.listdir(file.parent))
    with tempfile.TemporaryFile() as out:
        run = subprocess.Popen([program, "check", file.name], cwd=file.parent, stdout=out, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        said = out.read()
    took = used.ru_utime + used.ru_stime
    if run.returncode not in (65, 66):
        return f"status {run.returncode}", took, used.ru_maxrss, said
    if not PLACE.search(said.decode("utf-8", errors="replace")):
        return "no place or no message", took, used.ru_maxrss, said
    if re.search(rb"[\x00-\x08\x0b-\x1f\x7f]", said):
        return "control characters", took, used.ru_maxrss, said
    if took > SECONDS:
        return f"{took:.1f} s", took, used.ru_maxrss, said
    if used.ru_maxrss > KILOBYTES:
        return f"{used.ru_maxrss // 1024} MB", took, used.ru_maxrss, said
    if sorted(os.listdir(file.parent)) != before:
        return "it left a file behind", took, used.ru_maxrss, said
    return None, took, used.ru_maxrss, said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    program = options.program.resolve()

    folder = options.keep or pathlib.Path(tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    for source in [*ROOT.glob("templates/*.svg"), *ROOT.glob("templates/*.ply"), *ROOT.glob("scenes/*.svg")]:
        shutil.copy(source, folder)
    shutil.copytree(ROOT / "scenes" / "dishes", folder / "dishes", dirs_exist_ok=True)
    files, faults, slowest, largest, kinds = 0, 0, 0.0, 0, {}
    for number, (kind, source, name, data) in enumerate(spoilt_files()):
        if number % options.every:
            continue
        file = folder / f"spoilt-{number}{source.suffix}"
        file.write_bytes(data)
        fault, seconds, kilobytes, said = fault_of(program, file)
        files, slowest, largest = files + 1, max(slowest, seconds), max(largest, kilobytes)
        kinds[kind] = kinds.get(kind, 0) + 1
        if fault:
            faults += 1
            print(f"{source.relative_to(ROOT)}, {name}: {fault}")
            print("    " + said.decode("utf-8", errors="replace")[:400].replace("\n", "\n    "))
        if not options.keep:
            file.unlink()
    if not options.keep:
        shutil.rmtree(folder)
    print(", ".join(f"{count} {kind}" for kind, count in kinds.items()))
    print(f"{files} malformed files, {faults} not told as they should be; "
          f"at most {slowest:.2f} s and {largest / 1024:.0f} MB")
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main())
