#!/usr/bin/env python3
"""Draws the surfaces of a file, a level plane that cuts them, and where it does, as the paper's Figure 3a does.

    pomona grow tomato -o surfaces.ply
    draw_cutting_surface.py surfaces.ply plane.png [HEIGHT]     at this share of the height; half of it unless said

What lies above the plane is drawn faintly, over it. Needs rsvg-convert (Debian: librsvg2-bin).
"""

import math
import subprocess
import sys

from surface_file import read, srgb

PIXELS = 480
TURN, TILT = math.radians(25), math.radians(28)  # of the fruit about its axis; of the eye above the table


def seen(p):
    """Where a point is on the page, and how near it is to the eye."""
    x = p[0] * math.cos(TURN) + p[2] * math.sin(TURN)
    z = p[2] * math.cos(TURN) - p[0] * math.sin(TURN)
    return x, -(p[1] * math.cos(TILT) - z * math.sin(TILT)), p[1] * math.sin(TILT) + z * math.cos(TILT)


def place(vertex):
    return vertex["x"], vertex["y"], vertex["z"]


def color_of(corners):
    """The painted side's; the middle of both where both are."""
    sides = [side for side in ("front", "back") if not corners[0][f"{side}_hidden"]] or ["back"]
    return [sum(c[f"{side}_{k}"] for c in corners for side in sides) / (len(corners) * len(sides)) for k in "rgb"]


def polygon(points, fill, opacity, line="none", width=0.0):
    at = " ".join(f"{x:.6f},{y:.6f}" for x, y, *_ in points)
    return (f'<polygon points="{at}" fill="{fill}" fill-opacity="{opacity}" stroke="{line}" '
            f'stroke-width="{width:.6f}" stroke-linejoin="round"/>')


def surfaces(vertices, faces, height, above, opacity):
    """The triangles of one side of the plane, the farthest first."""
    drawn = []
    for face in faces:
        corners = [vertices[i] for i in face]
        if (sum(c["y"] for c in corners) / 3 > height) == above:
            points = [seen(place(c)) for c in corners]
            drawn.append((sum(p[2] for p in points), points, srgb(color_of(corners))))
    return [polygon(points, fill, opacity) for _, points, fill in sorted(drawn, key=lambda d: d[0])]


def segments(vertices, faces, height, width):
    """The cut segments: dark, with the colour of the surface along their middle."""
    under, over = [], []
    for face in faces:
        corners = [vertices[i] for i in face]
        ends = []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if (a["y"] < height) != (b["y"] < height):
                t = (height - a["y"]) / (b["y"] - a["y"])
                ends.append(seen([a[k] + t * (b[k] - a[k]) for k in "xyz"]))
        if len(ends) == 2:
            line = f'x1="{ends[0][0]:.6f}" y1="{ends[0][1]:.6f}" x2="{ends[1][0]:.6f}" y2="{ends[1][1]:.6f}"'
            under.append(f'<line {line} stroke="#1c1714" stroke-width="{2.2 * width:.6f}" stroke-linecap="round"/>')
            over.append(f'<line {line} stroke="{srgb(color_of(corners))}" stroke-width="{width:.6f}" '
                        'stroke-linecap="round"/>')
    return under + over


def main(surface_file, png, share):
    vertices, faces = read(surface_file)
    low, high = [[f(v[k] for v in vertices) for k in "xyz"] for f in (min, max)]
    height = low[1] + share * (high[1] - low[1])
    half = 0.62 * max(high[0] - low[0], high[2] - low[2])
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    plane = [seen((middle[0] + x * half, height, middle[2] + z * half)) for x, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    points = plane + [seen(place(v)) for v in vertices]
    left, top = [min(p[i] for p in points) for i in (0, 1)]
    size = [max(p[i] for p in points) - start for i, start in enumerate((left, top))]
    margin = 0.02 * size[0]
    parts = [*surfaces(vertices, faces, height, False, 0.35), polygon(plane, "#cfdff0", 0.78, "#6f8fb0", 0.004 * size[0]),
             *segments(vertices, faces, height, 0.006 * size[0]), *surfaces(vertices, faces, height, True, 0.07)]
    box = f"{left - margin} {top - margin} {size[0] + 2 * margin} {size[1] + 2 * margin}"
    picture_height = round(PIXELS * (size[1] + 2 * margin) / (size[0] + 2 * margin))
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{PIXELS}" height="{picture_height}" viewBox="{box}">'
           + "".join(parts) + "</svg>")
    subprocess.run(["rsvg-convert", "--unlimited", "--background-color", "white", "-o", png], input=svg.encode(), check=True)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]) if len(sys.argv) > 3 else 0.5)
