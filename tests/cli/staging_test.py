#!/usr/bin/env python3
"""Draws pieces and fruit, and measures the pictures: with the shadow they fill three quarters of the width or the height, the
shadow exists, and no edge of the picture cuts it, nor the faint shade around things.

    staging_test.py PROGRAM
"""

import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

COMMANDS = (
    "cut tomato --knife wedges:6", "cut cucumber --knife half", "cut apple --knife bite:45mm",
    "cut kiwi --knife dice:15mm", "grow carrot", "grow kiwi",
)
# As usual, on paper without grain.
STYLE = """format = 1
kind = "style"
name = "without-grain"
paper = { grain = 0 }
"""
WIDTH, HEIGHT = 160, 120
FAINT = 2  # of 255: how much darker than the paper the picture's edges may be
DARK = 60


def pixels_of(picture):
    """Rows of grey values of an 8-bit PNG in full colour."""
    data, at, packed = picture.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colors = struct.unpack(">IIBB", body[:10])
            assert depth == 8 and colors in (2, 6), "the picture has not all its colours"
            step = 3 if colors == 2 else 4
        packed += body if kind == b"IDAT" else b""
        at += length + 12
    raw, rows, above = zlib.decompress(packed), [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        row = bytearray(raw[start + 1:start + 1 + width * step])
        for x in range(width * step):
            a, b, c = (row[x - step] if x >= step else 0), above[x], (above[x - step] if x >= step else 0)
            row[x] = row[x] + (0, a, b, (a + b) // 2, paeth(a, b, c))[raw[start]] & 255
        rows.append([sum(row[x * step:x * step + 3]) / 3 for x in range(width)])
        above = row
    return rows


def paeth(a, b, c):
    return min((a, b, c), key=lambda v: (abs(a + b - c - v)))


def faults(rows):
    paper = sorted(value for row in (rows[0], rows[-1]) for value in row)[len(rows[0])]
    on = [(x, y) for y, row in enumerate(rows) for x, value in enumerate(row) if abs(value - paper) > FAINT]
    wide, high = [(max(p[i] for p in on) - min(p[i] for p in on) + 1) for i in (0, 1)]
    if max(wide / WIDTH, high / HEIGHT) < 0.75:
        yield f"fills only {wide / WIDTH:.0%} of the width and {high / HEIGHT:.0%} of the height"
    at_edge = [rows[y][x] for x, y in on if x in (0, WIDTH - 1) or y in (0, HEIGHT - 1)]
    if at_edge:
        yield f"is cut off by an edge of the picture: there it is {max(abs(v - paper) for v in at_edge):.0f} darker"
    # Around ink and colour, the table is darker than paper, but not dark.
    shadow = sum(1 for x, y in on if FAINT < paper - rows[y][x] < DARK)
    if shadow < 0.02 * WIDTH * HEIGHT:
        yield "has no shadow"


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        style = pathlib.Path(folder, "without-grain.toml")
        style.write_text(STYLE)
        for command in COMMANDS:
            picture = pathlib.Path(folder, "picture.png")
            words = [program, *command.split(), "--quality", "draft", "--detail", "0.6", "--style", style, "--size", f"{WIDTH}x{HEIGHT}",
                     "--quiet", "-o", picture]
            subprocess.run(words, check=True)
            for fault in faults(pixels_of(picture)):
                print(f"{command}: {fault}")
                wrong += 1
    sys.exit(1 if wrong else 0)


main()
