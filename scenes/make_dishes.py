#!/usr/bin/env python3
"""Models what the scenes' fruit lies in and on, and writes it as meshes (.obj with colours at the vertices).

    python3 scenes/make_dishes.py scenes

Crates, a board, a knife, a belt, a stall's table and a hill of crushed ice. Centimetres; +Y up; each stands on y = 0 about the
middle of its foot. Every part is a closed mesh of its own, its edges rounded off by one facet so that light catches
on them. Nothing is random but the grain of the wood, which comes from a small generator of its own.
"""

import math
import pathlib
import sys


class Noise:
    """The same numbers everywhere: a linear congruential generator [Numerical Recipes]."""

    def __init__(self, seed):
        self.state = seed

    def __call__(self):
        self.state = (1664525 * self.state + 1013904223) % 2**32
        return self.state / 2**32


def mixed(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def shaded(color, light):
    return tuple(min(1.0, max(0.0, c * light)) for c in color)


class Mesh:
    def __init__(self):
        self.points, self.colors, self.faces = [], [], []

    def point(self, p, color):
        self.points.append(p)
        self.colors.append(color)
        return len(self.points)  # OBJ counts from 1

    def face(self, *corners):
        self.faces.append(corners)

    def write(self, path):
        lines = [f"# {path.name}: made by make_dishes.py"]
        for p, c in zip(self.points, self.colors):
            place = " ".join(f"{x:.3f}".rstrip("0").rstrip(".") for x in p)
            lines.append(f"v {place} " + " ".join(f"{x:.2f}" for x in c))
        lines += ["f " + " ".join(map(str, face)) for face in self.faces]
        path.write_text("\n".join(lines) + "\n")


def rings(mesh, sections):
    """A closed surface through rings of as many points each, in the same order; its outside is found by its volume."""
    numbered = [[mesh.point(p, c) for p, c in ring] for ring in sections]
    count = len(numbered[0])
    faces = [tuple(reversed(numbered[0])), tuple(numbered[-1])]
    for low, high in zip(numbered, numbered[1:]):
        for i in range(count):
            j = (i + 1) % count
            faces.append((low[i], low[j], high[j], high[i]))
    outside = sum(volume([mesh.points[i - 1] for i in face]) for face in faces) > 0
    mesh.faces += faces if outside else [tuple(reversed(face)) for face in faces]


def volume(points):
    """Six times that of the pyramid from the origin."""
    total, a = 0.0, points[0]
    for b, c in zip(points[1:], points[2:]):
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                  + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return total


def turned(p, turn, at):
    """About the vertical, then moved."""
    c, s = math.cos(turn), math.sin(turn)
    return (at[0] + c * p[0] + s * p[2], at[1] + p[1], at[2] - s * p[0] + c * p[2])


WOOD = ((0.80, 0.64, 0.44), (0.66, 0.48, 0.30))


def plank(mesh, size, at, noise, colors=WOOD, turn=0.0, bevel=0.15):
    """A board along x, size = (length, thickness, width), its middle at `at`, with grain along its length."""
    length, thick, wide = size
    b = min(bevel, 0.3 * thick, 0.3 * wide)
    # The outline of its section, counter-clockwise seen from +x, with some points across the broad sides for the grain.
    across = 4
    ring = []
    for k in range(across + 1):
        ring.append((thick / 2, (0.5 - k / across) * (wide - 2 * b)))
    ring.append((thick / 2 - b, -wide / 2))
    ring.append((-thick / 2 + b, -wide / 2))
    for k in range(across + 1):
        ring.append((-thick / 2, (k / across - 0.5) * (wide - 2 * b)))
    ring.append((-thick / 2 + b, wide / 2))
    ring.append((thick / 2 - b, wide / 2))
    tone = noise()
    grain = [noise() for _ in ring]
    steps = max(2, int(length / 6))
    stations = [-length / 2, -length / 2 + b] + [
        (i / steps - 0.5) * (length - 2 * b) for i in range(1, steps)] + [length / 2 - b, length / 2]
    sections = []
    for s, x in enumerate(stations):
        inset = b if s in (0, len(stations) - 1) else 0
        section = []
        for (y, z), g in zip(ring, grain):
            f = 1 - inset / (max(thick, wide) / 2)
            p = (x, y * (1 - inset / (thick / 2)), z * f)
            light = 0.9 + 0.14 * tone + 0.10 * (g - 0.5) + 0.05 * (noise() - 0.5)
            section.append((turned(p, turn, at), shaded(mixed(*colors, 0.6 * g), light)))
        sections.append(section)
    rings(mesh, sections)


def crate(long=48, wide=32, high=15, colors=WOOD, seed=1):
    """Of slats on a floor, with four posts: low enough to look into."""
    mesh, noise = Mesh(), Noise(seed)
    wall, slats = 0.9, 3
    floor = 5
    for k in range(floor):
        w = wide / floor
        plank(mesh, (long, 0.9, w - 0.25), (0, 1.0, (k - (floor - 1) / 2) * w), noise, colors)
    for z in (-1, 1):
        plank(mesh, (wide - 4, 1.1, 3), (z * (long / 2 - 6), 0.55 - 0.0, 0), noise, colors, turn=math.pi / 2)
    pitch = (high - 1.4) / slats
    for k in range(slats):
        y = 1.6 + (k + 0.5) * pitch
        h = pitch - 0.7
        for side in (-1, 1):
            upright_plank(mesh, long, h, wall, (0, y, side * (wide / 2 - wall / 2)), 0, noise, colors)
            upright_plank(mesh, wide - 2 * wall - 0.05, h, wall, (side * (long / 2 - wall / 2), y, 0), math.pi / 2, noise, colors)
    for x in (-1, 1):
        for z in (-1, 1):
            box(mesh, (2.0, high - 1.46, 2.0), (x * (long / 2 - wall - 1.0), 1.46 + (high - 1.46) / 2, z * (wide / 2 - wall - 1.0)),
                shaded(colors[0], 0.86), noise)
    return mesh


def upright_plank(mesh, long, high, thick, at, turn, noise, colors):
    """A slat that stands on its edge, along x before it is turned."""
    own = Mesh()
    plank(own, (long, thick, high), (0, 0, 0), noise, colors)
    first = len(mesh.points)
    for p, c in zip(own.points, own.colors):
        # A quarter turn about x: what was up looks to the front, what was in front looks down.
        mesh.point(turned((p[0], -p[2], p[1]), turn, at), c)
    mesh.faces += [tuple(first + i for i in face) for face in own.faces]


def box(mesh, size, at, color, noise, bevel=0.12):
    sx, sy, sz = (s / 2 for s in size)
    b = min(bevel, 0.3 * min(size))
    sections = []
    for y, inset in ((-sy, b), (-sy + b, 0), (sy - b, 0), (sy, b)):
        x, z = sx - inset, sz - inset
        c = b
        ring = [(x, -z + c), (x, z - c), (x - c, z), (-x + c, z), (-x, z - c), (-x, -z + c), (-x + c, -z), (x - c, -z)]
        sections.append([((at[0] + px, at[1] + y, at[2] + pz), shaded(color, 0.95 + 0.08 * noise())) for px, pz in ring])
    rings(mesh, sections)


def board(long=44, wide=28, thick=2.2):
    """Of staves glued side by side, which the colours tell apart, with rounded corners."""
    mesh, noise = Mesh(), Noise(7)
    staves = 7
    tones = [noise() for _ in range(staves)]
    grain = [[noise() for _ in range(9)] for _ in range(staves)]
    half = wide / 2
    # Each stave is a body of its own; the outermost are shorter at their corners.
    for k in range(staves):
        z0, z1 = -half + k * wide / staves, -half + (k + 1) * wide / staves
        outer = k in (0, staves - 1)
        reach = long / 2
        strips = 4
        sections = []
        nx = 12
        for s in range(strips + 1):
            z = z0 + (z1 - z0) * s / strips
            # Rounded corners: the end recedes near the long sides.
            r = 3.0
            away = half - abs(z)
            cut = r - math.sqrt(max(0.0, r * r - (r - away) ** 2)) if outer and away < r else 0
            xr = reach - cut
            ring = []
            b = 0.25
            path = [(-xr + b, 0.0)]
            path += [(-xr + b + (2 * xr - 2 * b) * i / nx, 0.0) for i in range(1, nx)]
            path += [(xr - b, 0.0), (xr, b), (xr, thick - b), (xr - b, thick)]
            path += [(xr - b - (2 * xr - 2 * b) * i / nx, thick) for i in range(1, nx)]
            path += [(-xr + b, thick), (-xr, thick - b), (-xr, b)]
            edge = 0.25 if outer and (s == 0 and k == 0 or s == strips and k == staves - 1) else 0
            for x, y in path:
                yy = min(max(y, edge), thick - edge)
                g = grain[k][(2 * s) % 9]
                light = 0.92 + 0.16 * tones[k] + 0.08 * (g - 0.5) + 0.03 * (noise() - 0.5)
                color = shaded(mixed((0.76, 0.55, 0.34), (0.60, 0.39, 0.22), 0.7 * g), light)
                ring.append(((x, yy, z), color))
            sections.append(ring)
        rings(mesh, sections)
    return mesh


def knife(long=20.0, deep=4.6, handle=12.0):
    """A cook's knife that lies on its side, the tip to +X and the edge to +Z: a blade, a bolster and a handle."""
    mesh, noise = Mesh(), Noise(3)
    steel, bright = (0.62, 0.65, 0.68), (0.80, 0.82, 0.84)
    # The blade: sections from the heel to the tip, each a flat wedge from the spine (-z) to the edge (+z).
    steps = 20
    sections = []
    for k in range(steps + 1):
        t = k / steps
        x = t * long
        spine = -deep / 2 + 0.35 * deep * max(0.0, t - 0.35) ** 2 / 0.4225
        edge = deep / 2 - 0.92 * deep * max(0.0, t - 0.45) ** 2.2 / 0.55**2.2 * 0.62
        if k == steps:
            edge = spine + 0.25
        half = 0.16 * (1 - 0.75 * t)
        bevel = spine + 0.72 * (edge - spine)
        lift = 0.75
        ring = [(spine, half), (bevel, half * 0.8), (edge, 0.02), (edge, -0.02), (bevel, -half * 0.8), (spine, -half)]
        tones = {spine: steel, bevel: steel, edge: bright}
        sections.append([((x, lift + y, z), shaded(tones.get(z, steel), 0.97 + 0.05 * noise())) for z, y in ring])
    rings(mesh, sections)
    # The bolster and the handle: rounded sections.
    dark = (0.17, 0.12, 0.10)

    def round_ring(x, cz, half_wide, half_thick, color):
        ring = []
        for i in range(12):
            a = -2 * math.pi * i / 12
            ring.append(((x, 0.75 + half_thick * math.sin(a), cz + half_wide * math.cos(a)), shaded(color, 0.95 + 0.1 * noise())))
        return ring

    cz = -deep / 2 + 1.35
    rings(mesh, [round_ring(-1.6, cz, 1.20, 0.62, steel), round_ring(-0.9, cz, 1.34, 0.55, bright),
                 round_ring(0.15, cz, 1.34, 0.30, steel)])
    along = ((-handle - 1.55, 0.95, 0.50), (-handle - 1.2, 1.30, 0.68), (-handle + 1.5, 1.52, 0.74),
             (-handle + 5.0, 1.22, 0.72), (-4.0, 1.28, 0.74), (-1.7, 1.15, 0.66))
    rings(mesh, [round_ring(x, cz + 0.05 * (x + 2) * 0.8, w, h, dark) for x, w, h in along])
    return mesh


def belt(long=150.0, wide=46.0):
    """A food line: a belt of plastic links between two rails, seen from above."""
    mesh, noise = Mesh(), Noise(11)
    blue = (0.33, 0.50, 0.62)
    link = 5.0
    count = int(long / link)
    for k in range(count):
        x = -long / 2 + (k + 0.5) * link
        tone = 0.97 + 0.05 * (k % 2) + 0.02 * noise()
        box(mesh, (link - 0.18, 2.0, wide - 0.2), (x, 3.0, 0), shaded(blue, tone), noise, bevel=0.25)
    rail = (0.70, 0.72, 0.74)
    for side in (-1, 1):
        box(mesh, (long, 9.0, 2.4), (0, 4.5, side * (wide / 2 + 1.3)), rail, noise, bevel=0.5)
    return mesh


def table(long=176.0, wide=84.0, high=12.0):
    """A market stall's table: boards along its length on a plinth."""
    mesh, noise = Mesh(), Noise(23)
    old = ((0.58, 0.47, 0.36), (0.46, 0.36, 0.27))
    boards = 7
    w = wide / boards
    for k in range(boards):
        plank(mesh, (long, 2.4, w - 0.3), (0, high - 1.2, (k - (boards - 1) / 2) * w), noise, old)
    step(mesh, long, wide, high, noise, old)
    box(mesh, (long - 8, high - 2.45, wide - 8), (0, (high - 2.45) / 2, 0), (0.40, 0.31, 0.24), noise, bevel=0.3)
    return mesh


def step(mesh, long, wide, high, noise, colors):
    """The back half of the table stands higher, so that all crates are seen into."""
    rise, deep, boards = 13.0, wide / 2, 4
    w = deep / boards
    for k in range(boards):
        plank(mesh, (long, 2.0, w - 0.3), (0, high + rise - 1.0, -wide / 2 + (k + 0.5) * w), noise, colors)
    box(mesh, (long - 4, rise - 2.05, deep - 4), (0, high + (rise - 2.05) / 2, -wide / 4), (0.36, 0.28, 0.21), noise, bevel=0.3)


def hill(radius=30.0, high=9.0):
    """A round mound, as of crushed ice: what is strewn on a slope."""
    mesh, noise = Mesh(), Noise(5)
    rings_, around = 20, 120
    pale = (0.78, 0.84, 0.89)

    def height(r, a):
        t = r / radius
        bumps = 0.05 * math.sin(3 * a + 5 * t) + 0.04 * math.sin(7 * a - 9 * t + 1)
        return high * max(0.0, (1 - t * t) * (1 + 3 * bumps * t * (1 - t)))

    top = mesh.point((0, height(0, 0) , 0), pale)
    levels = []
    for i in range(1, rings_ + 1):
        r = radius * i / rings_
        grain = 0.1 * min(1.0, 3 * i / rings_)  # less at the top, where the triangles are slivers and would show as rays
        levels.append([mesh.point((r * math.cos(2 * math.pi * k / around), height(r, 2 * math.pi * k / around),
                                   -r * math.sin(2 * math.pi * k / around)), shaded(pale, 0.99 + grain * (noise() - 0.5)))
                       for k in range(around)])
    for k in range(around):
        mesh.face(top, levels[0][k], levels[0][(k + 1) % around])
    for low, high_ in zip(levels, levels[1:]):
        for k in range(around):
            j = (k + 1) % around
            mesh.face(low[k], high_[k], high_[j], low[j])
    mesh.face(*reversed(levels[-1]))
    return mesh


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1]) / "dishes"
    folder.mkdir(exist_ok=True)
    green = ((0.42, 0.55, 0.34), (0.33, 0.45, 0.27))
    for name, mesh in (("crate", crate()), ("crate_green", crate(colors=green, seed=9)), ("board", board()),
                       ("knife", knife()), ("belt", belt()), ("table", table()), ("hill", hill())):
        mesh.write(folder / f"{name}.obj")


main()
