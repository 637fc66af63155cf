#!/usr/bin/python3
"""Draws a sketch with the names of its curves beside them, as docs/guides/make_a_fruit.md shows them.

    draw_sketch.py templates/lemon.svg docs/pictures/sketch_lemon.png

Needs rsvg-convert and svgelements (Debian: librsvg2-bin, python3-svgelements).
"""

import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from svgelements import Matrix
from svgelements import Path as SketchedPath

SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
DRAWN = {SVG + "path", SVG + "circle"}
LINE = 6.0  # height of a line of names, millimetres
ROOM = 24


def points_of(element, place):
    """The nodes of a path, or the middle of a circle, on the page; `place` is the transform of what holds it."""
    place = Matrix(element.get("transform", "")) * place
    if element.tag == SVG + "circle":
        return [tuple(place.point_in_matrix_space((float(element.get("cx", 0)), float(element.get("cy", 0)))))]
    path = abs(SketchedPath(element.get("d", "")) * place)
    return [tuple(segment.end) for segment in path if segment.end is not None]


def named_curves(view):
    """(name, colour, points) of what has a name in a layer; groups count as one."""
    layer = Matrix(view.get("transform", ""))
    for element in view:
        name = element.get(LABEL)
        if element.tag == SVG + "image" or not name:
            continue
        group = element.tag == SVG + "g"
        inside = [e for e in element if e.tag in DRAWN] if group else [element]
        place = Matrix(element.get("transform", "")) * layer if group else layer
        color = re.search(r"(?:stroke|fill):(#\w+)", " ".join(e.get("style", "") for e in inside))
        yield name, color.group(1) if color else "#000000", [points_of(e, place) for e in inside]


def text(parent, place, words, color, anchor="start"):
    style = f"font-size:4.2px;font-family:sans-serif;fill:{color};text-anchor:{anchor}"
    node = ElementTree.SubElement(parent, SVG + "text", x=f"{place[0]:.2f}", y=f"{place[1]:.2f}", style=style)
    node.text = words


def leader(parent, from_, to, color):
    path = f"M {from_[0]:.2f},{from_[1]:.2f} L {to[0]:.2f},{to[1]:.2f}"
    ElementTree.SubElement(parent, SVG + "path", d=path, style=f"fill:none;stroke:{color};stroke-width:0.25")


def name_guides(parent, curves):
    """The axis, fold lines and the scale carry their names at their ends."""
    folds = {name: lines[0][:2] for name, _, lines in curves if name.startswith("fold ") and len(lines[0]) > 1}
    for name, (inner, outer) in folds.items():
        out = [outer[i] + 0.08 * (outer[i] - inner[i]) for i in (0, 1)]
        text(parent, (out[0], out[1] + 1.5), name, "#0050ff", "middle")
    for name, _, lines in curves:
        if name == "axis" and len(lines[0]) > 1:
            text(parent, (lines[0][1][0], lines[0][1][1] - 2), name, "#0050ff", "middle")
        if name.startswith("scale"):
            middle = [sum(p[i] for p in lines[0]) / len(lines[0]) for i in (0, 1)]
            text(parent, (middle[0], middle[1] + 5), name, "#0050ff", "middle")


def name_curves(parent, curves, right):
    """All others have a line to their name, in a column at the right, of which the end is returned."""
    named = [(name, color, [p for line in lines for p in line]) for name, color, lines in curves
             if not name.startswith(("fold ", "scale")) and not (name == "axis" and len(lines[0]) > 1)]

    # Lines leave the widest curve at its upper right, the narrowest at its lower right, and do not cross between.
    named.sort(key=lambda curve: -max(p[0] for p in curve[2]))
    marks = []
    for place, (name, color, points) in enumerate(named):
        angle = math.radians(60 - 110 * place / max(len(named) - 1, 1))
        at = max(points, key=lambda p: p[0] * math.cos(angle) - p[1] * math.sin(angle))
        marks.append((at, name, color))
    y = -1e9
    for at, name, color in sorted(marks, key=lambda mark: mark[0][1]):
        y = max(y + LINE, at[1] - 6)
        leader(parent, at, (right, y), color)
        text(parent, (right + 1, y + 1.4), name, "#303030")
    return [(right, y)]


def show_only(page, points):
    """Cuts the page down to the curves, with room for names."""
    low = [min(p[i] for p in points) - (20, 8)[i] for i in (0, 1)]
    size = [max(p[i] for p in points) - low[i] + (46, 9)[i] for i in (0, 1)]
    page.set("viewBox", " ".join(f"{v:.1f}" for v in low + size))
    page.set("width", f"{size[0]:.1f}mm")
    page.set("height", f"{size[1]:.1f}mm")


def main(svg, png):
    for prefix, uri in (("", SVG[1:-1]), ("xlink", "http://www.w3.org/1999/xlink"), ("inkscape", LABEL[1:-6])):
        ElementTree.register_namespace(prefix, uri)
    tree = ElementTree.parse(svg)
    page = tree.getroot()
    names = ElementTree.Element(SVG + "g")
    points = []
    for view in page.findall(SVG + "g"):
        if view.get(LABEL) == "top view":  # room for the names of the side view's curves
            view.set("transform", f"translate({ROOM}, 0) " + view.get("transform", ""))
        curves = list(named_curves(view))
        if view.get(LABEL) not in ("side view", "top view") or not curves:
            continue
        points += [p for _, _, lines in curves for line in lines for p in line]
        right = max(p[0] for _, _, lines in curves for line in lines for p in line) + 14
        name_guides(names, curves)
        points += name_curves(names, curves, right)
    page.append(names)
    show_only(page, points)
    command = ["rsvg-convert", "--zoom", "0.85", "--background-color", "white", "-o", png]
    subprocess.run(command, input=ElementTree.tostring(page), check=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), sys.argv[2])
