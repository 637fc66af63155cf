#!/usr/bin/env python3
"""Draws where the surfaces of a file meet the plane z = 0, as the paper's Figures 1 and 2 do: a line with the colour of
either side, and circles of the blur's radius.

    pomona grow docs/figures/blur.toml -o surfaces.ply
    draw_surfaces.py surfaces.ply surfaces.png [--circles]

Needs rsvg-convert (Debian: librsvg2-bin).
"""

import math
import subprocess
import sys

from surface_file import read, srgb

PIXELS = 360
LINE = 0.011  # of the picture, each side's


def lerp(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def meetings(vertices, faces):
    """Each triangle that crosses the plane: its two points there, each with its values; front to the left."""
    for face in faces:
        corners = [vertices[i] for i in face]
        for k in range(3):
            lone, right, left = corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]
            if (lone["z"] >= 0) == (right["z"] >= 0) or (lone["z"] >= 0) == (left["z"] >= 0):
                continue
            ends = [between(lone, other) for other in (right, left)]
            yield ends if lone["z"] >= 0 else ends[::-1]


def between(a, b):
    t = a["z"] / (a["z"] - b["z"])
    return {key: a[key] + (b[key] - a[key]) * t for key in a}


def side(ends, name, sign):
    """One side of a line, moved away from it by half its width."""
    (ax, ay), (bx, by) = [(end["x"], -end["y"]) for end in ends]
    length = math.hypot(bx - ax, by - ay) or 1
    nx, ny = sign * (by - ay) / length * LINE / 2, -sign * (bx - ax) / length * LINE / 2
    color = srgb([sum(end[f"{name}_{c}"] for end in ends) / 2 for c in "rgb"])
    return (f'<line x1="{ax + nx * SIZE:.6f}" y1="{ay + ny * SIZE:.6f}" x2="{bx + nx * SIZE:.6f}" y2="{by + ny * SIZE:.6f}" '
            f'stroke="{color}" stroke-width="{LINE * SIZE:.6f}" stroke-linecap="round"/>')


def circles(lines):
    """One every so often, where the blur is not 0."""
    for ends in lines[::9]:
        end = ends[0]
        if end["blur"] > 1e-4:
            yield (f'<circle cx="{end["x"]:.6f}" cy="{-end["y"]:.6f}" r="{end["blur"]:.6f}" fill="none" '
                   f'stroke="#444" stroke-width="{0.002 * SIZE:.6f}"/>')


def picture(lines, with_circles):
    xs = [end["x"] for ends in lines for end in ends]
    ys = [-end["y"] for ends in lines for end in ends]
    middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    parts = [side(ends, name, sign) for ends in lines for name, sign in (("back", 1), ("front", -1))]
    if with_circles:
        parts += circles(lines)
    box = f"{middle[0] - SIZE / 2} {middle[1] - SIZE / 2} {SIZE} {SIZE}"
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{PIXELS}" height="{PIXELS}" viewBox="{box}">'
            + "".join(parts) + "</svg>")


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    if len(words) != 2:
        sys.exit(__doc__)
    vertices, faces = read(words[0])
    lines = list(meetings(vertices, faces))
    SIZE = 1.12 * max(max(v[axis] for v in vertices) - min(v[axis] for v in vertices) for axis in "xy")
    subprocess.run(["rsvg-convert", "--background-color", "white", "-o", words[1]],
                   input=picture(lines, "--circles" in sys.argv).encode(), check=True)
