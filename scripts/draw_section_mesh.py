#!/usr/bin/env python3
"""Draws the triangles of a section, as the paper's Figure 3 does.

    pomona cut tomato --knife across --section -o section.ply
    draw_section_mesh.py section.ply mesh.png             the triangulation: cut segments with their colours, interior
                                                         vertices, whose colours are still to be diffused, as dots
    draw_section_mesh.py section.ply split.png --apart    coloured, and drawn apart where duplicate vertices split it

Needs rsvg-convert (Debian: librsvg2-bin).
"""

import subprocess
import sys

from surface_file import read, srgb

PIXELS = 480


def islands(count, faces):
    """The connected part of each vertex, as the index of one of its vertices."""
    parent = list(range(count))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for a, b, c in faces:
        parent[root(b)] = root(a)
        parent[root(c)] = root(a)
    return [root(i) for i in range(count)]


def flat(vertices):
    """Their places on the page: the two axes along which they lie furthest apart."""
    spans = {axis: max(v[axis] for v in vertices) - min(v[axis] for v in vertices) for axis in "xyz"}
    thin = min(spans, key=spans.get)
    across, up = {"x": ("z", "y"), "y": ("x", "z"), "z": ("x", "y")}[thin]
    sign = 1 if thin == "y" else -1
    return [(v[across], sign * v[up]) for v in vertices]


def moved_apart(places, faces, share):
    """Each island but the widest drawn together about its middle, so that gaps show where the mesh is split."""
    parts = islands(len(places), faces)
    members = {}
    for part, place in zip(parts, places):
        members.setdefault(part, []).append(place)
    middles = {part: [sum(p[i] for p in ps) / len(ps) for i in (0, 1)] for part, ps in members.items()}
    widest = max(members, key=lambda part: max(p[0] for p in members[part]) - min(p[0] for p in members[part]))
    return [place if part == widest else tuple(m + share * (x - m) for m, x in zip(middles[part], place))
            for part, place in zip(parts, places)]


def triangles(vertices, places, faces, colored, line):
    for face in faces:
        corners = " ".join(f"{places[i][0]:.6f},{places[i][1]:.6f}" for i in face)
        fill = srgb([sum(vertices[i][c] for i in face) / 3 for c in "rgb"]) if colored else "#ffffff"
        ink = "#333" if colored else "#999"
        yield f'<polygon points="{corners}" fill="{fill}" stroke="{ink}" stroke-width="{line:.6f}" stroke-linejoin="round"/>'


def cut_segments(vertices, places, faces, width):
    """The edges at which the mesh is split, in the colours of their two sides."""
    count = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            count[(min(a, b), max(a, b))] = count.get((min(a, b), max(a, b)), 0) + 1
    for (a, b), times in count.items():
        if times == 1:
            color = srgb([(vertices[a][c] + vertices[b][c]) / 2 for c in "rgb"])
            yield (f'<line x1="{places[a][0]:.6f}" y1="{places[a][1]:.6f}" x2="{places[b][0]:.6f}" y2="{places[b][1]:.6f}" '
                   f'stroke="{color}" stroke-width="{width:.6f}" stroke-linecap="round"/>')


def interior_dots(vertices, places, radius):
    for vertex, (x, y) in zip(vertices, places):
        if vertex["interior"]:
            yield f'<circle cx="{x:.6f}" cy="{y:.6f}" r="{radius:.6f}" fill="#222"/>'


def main(section, png, apart):
    vertices, faces = read(section)
    places = flat(vertices)
    if apart:
        places = moved_apart(places, faces, 0.8)
    low = [min(p[i] for p in places) for i in (0, 1)]
    size = [max(p[i] for p in places) - low[i] for i in (0, 1)]
    margin = 0.02 * max(size)
    box = " ".join(f"{v:.6f}" for v in (low[0] - margin, low[1] - margin, size[0] + 2 * margin, size[1] + 2 * margin))
    height = round(PIXELS * (size[1] + 2 * margin) / (size[0] + 2 * margin))
    unit = 0.0009 * max(size)
    shapes = "".join(triangles(vertices, places, faces, apart, unit))
    if not apart:
        shapes += "".join((*cut_segments(vertices, places, faces, 5 * unit), *interior_dots(vertices, places, 1.6 * unit)))
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" width="{PIXELS}" height="{height}" viewBox="{box}">{shapes}</svg>'
    subprocess.run(["rsvg-convert", "--unlimited", "--background-color", "white", "-o", png], input=svg.encode(), check=True)


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    if len(words) != 2:
        sys.exit(__doc__)
    main(*words, "--apart" in sys.argv)
