#!/usr/bin/env python3
"""Models a kidney and writes it as surfaces for Pomona: the kind of file any modelling tool can make.

    python3 templates/make_kidney.py templates/kidney.ply

Shapes are signed distances in millimetres (negative inside), in the fruit's frame: +Y up, +X to the hilum, +Z to
the front. What faces air becomes one closed mesh; what only gives colour are grids laid around rays and tubes.
Nothing is random, and nothing but the standard library is used; it takes about half a minute.
"""

import heapq
import math
import struct
import sys
from itertools import product

# ---- Vectors ----


def add(a, b, k=1.0):
    return (a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a)) or 1.0
    return (a[0] / length, a[1] / length, a[2] / length)


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def ramp(stops, t):
    """Piecewise linear through (place, value); values may be numbers or colours."""
    for (a, x), (b, y) in zip(stops, stops[1:]):
        if t < b:
            s = max(0.0, (t - a) / (b - a))
            return mix(x, y, s) if isinstance(x, tuple) else x + (y - x) * s
    return stops[-1][1]


# ---- Distances ----


def smooth_min(a, b, k):
    h = max(0.0, min(1.0, 0.5 + 0.5 * (b - a) / k))
    return b + (a - b) * h - k * h * (1 - h)


def smooth_max(a, b, k):
    return -smooth_min(-a, -b, k)


def ellipsoid(p, r):
    k0 = math.sqrt(sum((x / s) ** 2 for x, s in zip(p, r)))
    k1 = math.sqrt(sum((x / (s * s)) ** 2 for x, s in zip(p, r)))
    return k0 * (k0 - 1) / k1 if k1 > 1e-9 else -min(r)


def tube(p, path):
    """Along (point, radius), ..., round at its ends."""
    best = 1e9
    for (a, ra), (b, rb) in zip(path, path[1:]):
        ab, ap = sub(b, a), sub(p, a)
        t = max(0.0, min(1.0, dot(ap, ab) / dot(ab, ab)))
        d = sub(ap, (ab[0] * t, ab[1] * t, ab[2] * t))
        best = min(best, math.sqrt(dot(d, d)) - (ra + (rb - ra) * t))
    return best


MIDDLE = 55.0  # height of the hilum; the kidney is 110 mm high


BEND = (50.0, 52.0, math.radians(34))  # the kidney's bent middle line: x of its centre, radius, half its angle


def bean(p):
    """The kidney without its hilum's contents: thick around a bent line, flat to front and back, a notch at the hilum."""
    x, y = p[0] - BEND[0], p[1] - MIDDLE
    turn = max(-BEND[2], min(BEND[2], math.atan2(y, -x)))
    share = abs(turn) / BEND[2]
    from_line = math.hypot(x + BEND[1] * math.cos(turn), y - BEND[1] * math.sin(turn))
    radius = 24.0 + 1.0 * share * share
    deep = p[2] * radius / 16.0
    length = math.hypot(from_line, deep)
    slope = math.hypot(from_line, deep * radius / 16.0) / length if length > 1e-6 else 1.0
    body = (length - radius) / max(1.0, slope)
    notch = ellipsoid((p[0] - 33.0, y, p[2]), (15.0, 11.0, 12.0))
    return smooth_max(body, -notch, 6.0)


def sinus(p):
    """The space behind the hilum that fat, calyces and vessels fill."""
    half_height = ramp([(4.0, 27.0), (19.0, 12.0)], p[0])
    return ellipsoid((p[0] - 14.0, p[1] - MIDDLE, p[2]), (20.5, half_height, 9.0))


def along_ray(start, direction, field, level):
    """The first place on a ray where the field rises to the level."""
    low, step = 0.0, 0.5
    while field(add(start, direction, low + step)) < level and low < 100:
        low += step
    high = low + step
    for _ in range(16):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if field(add(start, direction, middle)) < level else (low, middle)
    return add(start, direction, low)


# ---- Pyramids: nine cones in one fan, two before and behind its middle, from the cortex to their papillae ----

CENTER = (10.0, MIDDLE, 0.0)  # from here the pyramids fan out
FIRST, SPREAD = math.radians(64), math.radians(29)
PROFILE = [(0, 0), (0.03, 0.15), (0.08, 0.24), (0.2, 0.35), (0.45, 0.6), (0.7, 0.87), (0.84, 1.0), (0.92, 0.95),
           (0.97, 0.74), (1.0, 0.0)]


def fan(angle, lean=0.0):
    return unit((math.cos(angle), math.sin(angle), lean))


class Pyramid:
    def __init__(self, axis, calyx, most_thick):
        self.axis, self.calyx = axis, calyx
        self.tip = along_ray(CENTER, self.axis, sinus, -4.0)
        self.base = along_ray(add(self.tip, self.axis, 10.0), self.axis, bean, -7.0)
        to_base = sub(self.base, self.tip)
        self.length = math.sqrt(dot(to_base, to_base))
        self.across = unit(cross((0.0, 0.0, 1.0), self.axis))
        self.deep = cross(self.axis, self.across)
        widest = add(self.tip, self.axis, 0.8 * self.length)
        out = sub(widest, CENTER)
        self.wide = math.sqrt(dot(out, out)) * SPREAD / 2 - 1.2
        self.thick = min(most_thick, max(3.5, along_ray(widest, (0.0, 0.0, 1.0), bean, -4.5)[2] - abs(widest[2])))

    def at(self, t, turn, share=1.0):
        r = ramp(PROFILE, t) * share
        p = add(self.tip, self.axis, t * self.length)
        return add(add(p, self.across, r * self.wide * math.cos(turn)), self.deep, r * self.thick * math.sin(turn))

    def distance(self, p):
        q = sub(p, self.tip)
        if dot(q, q) > 2.6 * self.length**2:
            return 9.0
        t = dot(q, self.axis) / self.length
        if not -0.6 < t < 1.5:
            return 9.0
        rho = math.hypot(dot(q, self.across) / self.wide, dot(q, self.deep) / self.thick)
        side = (rho - ramp(PROFILE, min(1.0, max(0.0, t)))) * 0.8 * min(self.wide, self.thick)
        return max(side, -t * self.length, (t - 1) * self.length)


MIDDLE_ONE, ASIDE = 4, math.tan(math.radians(37))


def all_pyramids():
    """The fan, whose middle one leaves room for one before it and one behind: a cut across shows three."""
    for number in range(9):
        thick = 4.6 if number == MIDDLE_ONE else 99.0
        yield Pyramid(fan(FIRST + SPREAD * number, 0.03 if number % 2 else -0.03), number // 3, thick)
    for lean in (ASIDE, -ASIDE):
        yield Pyramid(fan(FIRST + SPREAD * MIDDLE_ONE, lean), MIDDLE_ONE // 3, 4.6)


PYRAMIDS = list(all_pyramids())


def pyramids(p):
    return min(pyramid.distance(p) for pyramid in PYRAMIDS)


# ---- Hollows and vessels ----

CALYX = [(10.0, 68.0, -0.5), (5.0, 55.0, -0.5), (10.0, 42.0, -0.5)]  # the three major calyces
PELVIS = (14.0, 53.0, -1.0)
URETER = [(20.0, 50.0, -2.0), (29.0, 45.0, -3.0), (37.0, 36.0, -4.0), (39.0, 14.0, -4.0)]
ARTERY = [(16.0, 61.0, 3.0), (24.0, 61.5, 3.0), (46.0, 63.5, 3.0)]
VEIN = [(16.0, 54.0, 6.5), (24.0, 54.5, 6.5), (46.0, 56.0, 6.5)]
CUT_X, CUT_Y, FAT_X = 34.0, 20.0, 21.5  # where the vessels, the ureter and the fat end
BLOOD_X = 30.5  # to here the vessels are full: open all along, a cut made a tuning fork of them


def path(points, *radii):
    return list(zip(points, radii if len(radii) > 1 else radii * len(points)))


def drainage(p):
    """The hollow: cups around the papillae, calyces, pelvis, ureter."""
    d = min(tube(p, path([PELVIS] + URETER, 3.4, 2.3, 1.8, 1.7, 1.7)),
            min(tube(p, [(m, 1.9), (PELVIS, 2.6)]) for m in CALYX))
    for pyramid in PYRAMIDS:
        neck = add(pyramid.tip, pyramid.axis, -2.2)
        if dot(sub(p, pyramid.tip), sub(p, pyramid.tip)) > 576:
            continue
        d = smooth_min(d, tube(p, [(neck, 1.2), (CALYX[pyramid.calyx], 1.5)]), 1.0)
        cup = tube(p, [(add(pyramid.tip, pyramid.axis, 1.2), 3.5), (neck, 1.6)])
        d = smooth_min(d, smooth_max(cup, 0.5 - pyramid.distance(p), 1.2), 1.5)
    return smooth_max(d, 0.3 - pyramids(p), 0.8)


def place_at(points, x):
    """Of a vessel's last stretch, the place there."""
    a, b = points[-2:]
    return mix(a, b, (x - a[0]) / (b[0] - a[0]))


def open_end(points):
    """Of a vessel, the stretch without blood."""
    return [place_at(points, BLOOD_X), points[-1]]


def vessel(p, points, radius):
    return max(tube(p, path(points, radius)), p[0] - CUT_X)


def outside(p):
    """What faces air outside, each with its name, nearest first."""
    return [("capsule", bean(p)),
            ("hilum", smooth_max(sinus(p), p[0] - FAT_X, 5.0)),
            ("ureter", max(tube(p, path(URETER, 4.4, 3.8, 3.3, 3.3)), CUT_Y - p[1])),
            ("artery", vessel(p, ARTERY, 2.7)), ("vein", vessel(p, VEIN, 3.6))]


def hollows(p):
    found = [("pelvis", drainage(p))] if sinus(p) < 8 or p[0] > 12 else []
    return found + [("artery_hollow", tube(p, path(open_end(ARTERY), 1.2))),
                    ("vein_hollow", tube(p, path(open_end(VEIN), 2.1)))]


def solid(p):
    d = 1e9
    for _, other in outside(p):
        d = smooth_min(d, other, 1.2) if d < 1e8 else other
    return d if d > 3 or d < -40 else max([d] + [-h for _, h in hollows(p)])


# ---- Meshes of distances ----


def gradient(field, p, h=0.02):
    return tuple((field(add(p, e, h)) - field(add(p, e, -h))) / (2 * h) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))


def onto(field, p, most):
    """Moves a point towards the field's zero, by no more than `most`, so that the mesh keeps its order."""
    g, d = gradient(field, p), field(p)
    return add(p, g, -max(-most, min(most, d / max(0.5, dot(g, g)))))


def surface_net(field, low, high, step):
    """Quads between the cells that the zero passes [Gibson 1998], as triangles that face outwards."""
    n = [int((b - a) / step) + 1 for a, b in zip(low, high)]
    grid, block = {}, 4
    for first in product(*(range(0, k, block) for k in n)):
        # Far from the zero a block's middle says enough.
        middle = field(tuple(a + step * (i + 0.5 * block) for a, i in zip(low, first)))
        far = abs(middle) > 1.8 * block * step
        for c in product(*(range(i, min(i + block, k)) for i, k in zip(first, n))):
            grid[c] = middle if far else field(tuple(a + step * i for a, i in zip(low, c)))
    cells, points, triangles = {}, [], []

    def vertex(cell):
        if cell not in cells:
            crossings = []
            for corner in product((0, 1), repeat=3):
                for axis in range(3):
                    if corner[axis] == 0:
                        a = tuple(c + k for c, k in zip(cell, corner))
                        b = tuple(c + (i == axis) for i, c in enumerate(a))
                        if (grid[a] < 0) != (grid[b] < 0):
                            crossings.append(mix(a, b, grid[a] / (grid[a] - grid[b])))
            mean = tuple(sum(c) / len(crossings) for c in zip(*crossings))
            cells[cell] = len(points)
            points.append(tuple(l + step * m for l, m in zip(low, mean)))
        return cells[cell]

    for a in product(*map(range, [k - 1 for k in n])):
        for axis in range(3):
            b = tuple(c + (i == axis) for i, c in enumerate(a))
            if (grid[a] < 0) == (grid[b] < 0):
                continue
            u, v = [(i == (axis + 1) % 3) * 1 for i in range(3)], [(i == (axis + 2) % 3) * 1 for i in range(3)]
            around = [tuple(c - i * x - j * y for c, x, y in zip(a, u, v)) for i, j in ((1, 1), (0, 1), (0, 0), (1, 0))]
            q = [vertex(cell) for cell in around]
            if grid[a] >= 0:
                q.reverse()
            triangles += [(q[0], q[1], q[2]), (q[0], q[2], q[3])]
    return [onto(field, p, 0.25 * step) for p in points], triangles


class Simplifier:
    """Collapses edges, those first that matter least [Garland & Heckbert 1997]; keeps the mesh closed."""

    def __init__(self, points, triangles):
        self.points, self.triangles = list(points), {i: t for i, t in enumerate(triangles)}
        self.of = [set() for _ in points]
        self.quadric = [[0.0] * 10 for _ in points]
        self.age = [0] * len(points)
        for i, t in self.triangles.items():
            a, b, c = (points[k] for k in t)
            normal = cross(sub(b, a), sub(c, a))
            area = math.sqrt(dot(normal, normal))
            x, y, z = unit(normal)
            w = -dot((x, y, z), a)
            plane = (x * x, x * y, x * z, x * w, y * y, y * z, y * w, z * z, z * w, w * w)
            for k in t:
                self.of[k].add(i)
                for j in range(10):
                    self.quadric[k][j] += plane[j] * area
        self.heap = []
        for i in range(len(points)):
            for j in sorted(self.neighbours(i)):
                if i < j:
                    self.offer(i, j)

    def neighbours(self, i):
        return {k for t in self.of[i] for k in self.triangles[t]} - {i}

    def error(self, quadric, p):
        x, y, z = p
        q = quadric
        return (q[0] * x * x + 2 * q[1] * x * y + 2 * q[2] * x * z + 2 * q[3] * x + q[4] * y * y + 2 * q[5] * y * z
                + 2 * q[6] * y + q[7] * z * z + 2 * q[8] * z + q[9])

    def offer(self, i, j):
        quadric = [a + b for a, b in zip(self.quadric[i], self.quadric[j])]
        a, b = self.points[i], self.points[j]
        choices = [mix(a, b, 0.5), a, b]
        costs = [self.error(quadric, p) for p in choices]
        best = min(range(3), key=lambda k: costs[k])
        length = dot(sub(a, b), sub(a, b))  # a little against slivers where all is flat
        heapq.heappush(self.heap, (costs[best] + 2e-3 * length * length, i, j, self.age[i], self.age[j], choices[best]))

    def may(self, i, j, p):
        if len(self.neighbours(i) & self.neighbours(j)) != 2 or len(self.of[i] & self.of[j]) != 2:
            return False
        for k in (i, j):
            for t in self.of[k] - (self.of[i] & self.of[j]):
                before = [self.points[v] for v in self.triangles[t]]
                after = [p if v == k else self.points[v] for v in self.triangles[t]]
                n = [unit(cross(sub(c[1], c[0]), sub(c[2], c[0]))) for c in (before, after)]
                if dot(*n) < 0.5:
                    return False
        return True

    def run(self, count):
        while len(self.triangles) > count and self.heap:
            _, i, j, age_i, age_j, p = heapq.heappop(self.heap)
            if age_i != self.age[i] or age_j != self.age[j] or not self.of[i] or not self.of[j] or not self.may(i, j, p):
                continue
            for t in sorted(self.of[i] & self.of[j]):
                for k in self.triangles.pop(t):
                    self.of[k].discard(t)
            for t in sorted(self.of[j]):
                self.triangles[t] = tuple(i if k == j else k for k in self.triangles[t])
                self.of[i].add(t)
            self.of[j] = set()
            self.points[i] = p
            self.quadric[i] = [a + b for a, b in zip(self.quadric[i], self.quadric[j])]
            self.age[i] += 1
            for k in sorted(self.neighbours(i)):
                self.offer(min(i, k), max(i, k))
        used = sorted({k for t in self.triangles.values() for k in t})
        new = {k: i for i, k in enumerate(used)}
        return [self.points[k] for k in used], [tuple(new[k] for k in self.triangles[t]) for t in sorted(self.triangles)]


# ---- Colours ----


def srgb(text):
    return tuple(int(text[i:i + 2], 16) / 255 for i in (1, 3, 5))


CAPSULE_SKIN, CAPSULE = srgb("#8e4436"), srgb("#dcb09a")
CORTEX, INNER_CORTEX, COLUMN = srgb("#ab5a43"), srgb("#b86a50"), srgb("#b4674d")
MEDULLA = [(0.0, srgb("#d9a58f")), (0.25, srgb("#b96656")), (0.6, srgb("#8f3833")), (1.0, srgb("#702523"))]
STREAK = [(0.0, srgb("#e0b09a")), (0.25, srgb("#cd8270")), (0.6, srgb("#ae5549")), (1.0, srgb("#94403a"))]
FAT, WALL, LINING = srgb("#f2d98c"), srgb("#f1e2cf"), srgb("#f6ddcf")
URETER_SKIN = srgb("#e6c7a6")
ARTERY_SKIN, ARTERY_WALL, ARTERY_BLOOD = srgb("#c0392f"), srgb("#e2a295"), srgb("#a3161a")
VEIN_SKIN, VEIN_WALL, VEIN_BLOOD = srgb("#50649f"), srgb("#b3b4cc"), srgb("#38437f")

PARTS = ["capsule", "cortex", "medulla", "fat", "pelvis", "ureter", "artery", "vein"]


class Model:
    """Surfaces as the file holds them: vertices with two colours, blur (mm) and hidden sides."""

    def __init__(self):
        self.names, self.vertices, self.faces = [], [], []

    def surface(self, name):
        if name not in self.names:
            self.names.append(name)
        return self.names.index(name)

    def vertex(self, p, front, back, blur=0.0, hidden=(0, 0)):
        self.vertices.append((p, front, back, blur, hidden))
        return len(self.vertices) - 1

    def face(self, corners, surface, front_part, back_part):
        self.faces.append((corners, self.surface(surface), PARTS.index(front_part), PARTS.index(back_part)))

    def grid(self, rows, closed, name, parts, keep=lambda p: True):
        """Rows of vertices around; a row of one is a pole. Front is to the right of the way around and along."""
        for low, high in zip(rows, rows[1:]):
            n = max(len(low), len(high))
            for i in range(n if closed else n - 1):
                a, b = low[i % len(low)], low[(i + 1) % len(low)]
                c, d = high[(i + 1) % len(high)], high[i % len(high)]
                for t in ((a, b, c), (a, c, d)):
                    if len(set(t)) == 3 and any(keep(self.vertices[k][0]) for k in t):
                        self.face(t, name, *parts)

    def write(self, file):
        used = sorted({k for f in self.faces for k in f[0]})
        new = {k: i for i, k in enumerate(used)}
        header = ["ply", "format binary_little_endian 1.0", "comment a kidney, by templates/make_kidney.py"]
        header += [f"comment surface {i} {name}" for i, name in enumerate(self.names)]
        header += [f"comment part {i} {name}" for i, name in enumerate(PARTS)]
        header += [f"element vertex {len(used)}"] + [f"property float {k}" for k in ("x", "y", "z")]
        header += [f"property uchar {k}" for k in ("red", "green", "blue")]
        header += [f"property float {k}" for k in ("back_r", "back_g", "back_b", "blur")]
        header += [f"property uchar {k}" for k in ("front_hidden", "back_hidden")]
        header += [f"element face {len(self.faces)}", "property list uchar ushort vertex_indices"]
        header += [f"property uchar {k}" for k in ("surface", "front_part", "back_part")] + ["end_header", ""]
        data = ["\n".join(header).encode()]
        for k in used:
            p, front, back, blur, hidden = self.vertices[k]
            values = [round(x, 3) / 1000 for x in p] + [round(255 * c) for c in front]
            values += [linear(c) for c in back] + [blur / 1000, *hidden]
            data.append(struct.pack("<3f3B3ff2B", *values))
        for corners, surface, front, back in self.faces:
            data.append(struct.pack("<B3H3B", 3, *(new[k] for k in corners), surface, front, back))
        with open(file, "wb") as out:
            out.write(b"".join(data))


def linear(c):
    return round(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4, 4)


# ---- The kidney ----


def nearest_name(p):
    names = [(abs(d), name) for name, d in hollows(p) + outside(p)]
    name = min(names)[1]
    return "papilla" if name == "pelvis" and pyramids(p) < 1.0 else name


# Colour towards air, colour inside, blur, part.
FACING_AIR = {
    "capsule": (CAPSULE_SKIN, CAPSULE, 0.0, "capsule"), "hilum": (FAT, FAT, 0.0, "fat"),
    "ureter": (URETER_SKIN, WALL, 0.3, "ureter"), "artery": (ARTERY_SKIN, ARTERY_WALL, 0.3, "artery"),
    "vein": (VEIN_SKIN, VEIN_WALL, 0.3, "vein"), "pelvis": (LINING, WALL, 0.7, "pelvis"),
    "papilla": (LINING, MEDULLA[0][1], 0.0, "medulla"), "artery_hollow": (ARTERY_BLOOD, ARTERY_WALL, 0.2, "artery"),
    "vein_hollow": (VEIN_BLOOD, VEIN_WALL, 0.2, "vein")}


def add_boundary(model, faces):
    net = surface_net(solid, (-31.0, -3.3, -19.8), (46.0, 114.0, 19.8), 1.15)
    points, triangles = Simplifier(*net).run(faces)
    at, names = [], []
    for p in points:
        names.append(nearest_name(p))
        front, back, blur, _ = FACING_AIR[names[-1]]
        at.append(model.vertex(p, front, back, blur, (1, 0)))
    for t in triangles:
        found = [names[k] for k in t]
        name = max(found, key=found.count)
        model.face(tuple(at[k] for k in t), name, FACING_AIR[name][3], FACING_AIR[name][3])


def sphere_rows(model, center, field, around, rings, paint):
    """Rays from a centre to the zero of a field, from below upwards."""
    rows = []
    for j in range(rings):
        tilt = math.pi * (j / (rings - 1) - 0.5)
        row = []
        for i in range(around if 0 < j < rings - 1 else 1):
            turn = 2 * math.pi * i / around
            ray = (math.cos(tilt) * math.cos(turn), math.sin(tilt), -math.cos(tilt) * math.sin(turn))
            p = along_ray(center, ray, field, 0.0)
            row.append(model.vertex(p, *paint(p)))
        rows.append(row)
    return rows


def add_cortex(model):
    """Under the capsule: the cortex begins."""
    rows = sphere_rows(model, (-1.0, MIDDLE, 0.0), lambda p: bean(p) + 0.9, 44, 40, lambda p: (CAPSULE, CORTEX, 0.15))
    model.grid(rows, True, "cortex", ("capsule", "cortex"), lambda p: sinus(p) > 0.5)


def add_sinus(model):
    rows = sphere_rows(model, CENTER, lambda p: max(sinus(p), bean(p) + 1.2), 32, 36, lambda p: (COLUMN, FAT, 0.3))
    model.grid(rows, True, "sinus", ("cortex", "fat"),
               lambda p: bean(p) < -2.0 and pyramids(p) > -0.2 and drainage(p) > 0.3)


def add_pyramid(model, pyramid):
    steps = [0, 0.03, 0.08, 0.16, 0.28, 0.42, 0.56, 0.7, 0.8, 0.88, 0.93, 0.97, 0.99, 1.0]
    rows = []
    for t in steps:
        row = []
        for i in range(20 if 0 < t < 1 else 1):
            p = pyramid.at(t, 2 * math.pi * i / 20)
            outer = FAT if sinus(p) < -0.5 else INNER_CORTEX if t > 0.85 else COLUMN
            row.append(model.vertex(p, outer, ramp(MEDULLA, t), 0.2))
        rows.append(row)
    model.grid(rows, True, "pyramids", ("cortex", "medulla"))

    # Straight tubules and vessels run from base to tip in bundles: nested cones, so that every cut shows streaks.
    for number, share in enumerate((0.8, 0.58, 0.38, 0.18)):
        rows = []
        for t in (0.12, 0.3, 0.5, 0.7, 0.84, 0.94 - 0.05 * (share > 0.7)):
            dark, light = ramp(MEDULLA, t), ramp(STREAK, t)
            row = []
            for i in range(12):
                p = add(pyramid.at(min(t, 0.84), 2 * math.pi * i / 12, share), pyramid.axis,
                        max(0.0, t - 0.84) * pyramid.length)
                sides = (dark, light) if i % 2 == 0 else (mix(dark, light, 0.4), mix(dark, light, 0.6))
                row.append(model.vertex(p, *(sides if number % 2 == 0 else sides[::-1]), 0.25))
            rows.append(row)
        model.grid(rows, True, "streaks", ("medulla", "medulla"))


def add_tube(model, points, radii, name, front, back, part, around=8):
    rows = []
    for i, p in enumerate(points):
        way = unit(sub(points[min(i + 1, len(points) - 1)], points[max(i - 1, 0)]))
        side = unit(cross(way, (0.0, 0.0, 1.0)))
        up = cross(way, side)
        rows.append([model.vertex(add(add(p, side, radii[i] * math.cos(a)), up, radii[i] * math.sin(a)),
                                  front(p), back, 0.1) for a in (2 * math.pi * k / around for k in range(around))])
    rows = [[model.vertex(points[0], front(points[0]), back)]] + rows + [[model.vertex(points[-1], front(points[-1]), back)]]
    model.grid(rows, True, name, (part, part))


def smooth_path(points, count):
    """A Catmull-Rom curve through the points."""
    p = [points[0]] + points + [points[-1]]
    result = []
    for k in range(count):
        s = k * (len(points) - 1) / (count - 1)
        i = min(int(s), len(points) - 2)
        t = s - i
        w = [(-t + 2 * t * t - t**3) / 2, (2 - 5 * t * t + 3 * t**3) / 2, (t + 4 * t * t - 3 * t**3) / 2, (t**3 - t * t) / 2]
        result.append(tuple(sum(w[j] * p[i + j][c] for j in range(4)) for c in range(3)))
    return result


def add_arcade(model, angle, way, name, back, size):
    """Where a vessel has come up between two pyramids it bends and runs over the base of one of them."""
    def over_base(share, depth):
        ray = fan(angle + way * share * SPREAD / 2)
        return add(along_ray(along_ray(CENTER, ray, sinus, 3.0), ray, bean, -depth), (0.0, 0.0, 1.0), 0.07)
    inner = 0.0 if name == "artery" else 1.3
    curve = [over_base(share, ramp([(0.0, 9.4), (0.35, 7.2), (0.9, 6.2)], share) + inner * min(1.0, 2 * share))
             for share in (0.03, 0.15, 0.3, 0.45, 0.6, 0.75, 0.88)]
    radii = [size * ramp([(0, 0.42), (6, 0.2)], float(k)) * 1.2 for k in range(len(curve))]
    add_tube(model, curve, radii, name, lambda p: INNER_CORTEX, back, name, 6)


def in_front_of_hollows(p, room):
    """The place, or the nearest one towards the viewer that is so far from the calyces and the pelvis."""
    while drainage(p) < room:
        p = add(p, (0.0, 0.0, 1.0), 0.2)
    return p


def add_blood(model):
    """In the trunks, up to their open ends."""
    for points, radius, name, wall, blood in ((ARTERY, 1.7, "artery", ARTERY_WALL, ARTERY_BLOOD),
                                              (VEIN, 2.6, "vein", VEIN_WALL, VEIN_BLOOD)):
        curve = [place_at(points, x) for x in (18.0, 24.0, 30.0, BLOOD_X - 0.6)]
        add_tube(model, curve, [0.8 * radius, radius, radius, radius], name, lambda p, wall=wall: wall, blood, name, 12)


def add_vessels(model):
    """From the hilum through the fat, in front of the calyces where these are in the way, into the columns between the
    pyramids, and over their bases."""
    def around(p, start, blood):
        # Where branches leave the trunk they lie in each other, and nothing parts them.
        way = sub(p, start)
        return blood if dot(way, way) < 64 else FAT if sinus(p) < 0 else COLUMN
    for number in range(8):
        angle = FIRST + SPREAD * (number + 0.5)
        ray = fan(angle)
        rim, end = along_ray(CENTER, ray, sinus, 0.5), along_ray(along_ray(CENTER, ray, sinus, 3.0), ray, bean, -8.5)
        side = unit(cross((0.0, 0.0, 1.0), ray))
        for start, offset, name, back, size in (((21.0, 61.0, 3.0), 0.6, "artery", ARTERY_BLOOD, 0.7),
                                                ((21.0, 54.5, 6.5), -0.7, "vein", VEIN_BLOOD, 1.0)):
            room = 1.9 * size
            before = in_front_of_hollows(add(mix(CENTER, rim, 0.8), side, offset), room)
            points = [start, in_front_of_hollows(mix(start, before, 0.55), room), before,
                      add(add(rim, ray, 2.0), side, offset), add(end, side, offset)]
            curve = smooth_path(points, 13)
            radii = [ramp([(0, 1.6), (6, 1.2), (9, 0.6), (12, 0.4)], float(k)) * size for k in range(13)]
            add_tube(model, curve, radii, name, lambda p: around(p, start, back), back, name)
            for way in (1, -1):
                add_arcade(model, angle, way, name, back, size)


def main():
    model = Model()
    add_boundary(model, 8500)
    add_cortex(model)
    add_sinus(model)
    for pyramid in PYRAMIDS:
        add_pyramid(model, pyramid)
    add_blood(model)
    add_vessels(model)
    model.write(sys.argv[1])
    print(f"{len(model.vertices)} vertices, {len(model.faces)} faces")


if __name__ == "__main__":
    main()
