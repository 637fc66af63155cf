"""Convex shapes of a .glb where they stand, and how deep they lie within each other."""

import itertools


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def placed(node, point):
    """A point of the node's, in the scene."""
    *axis, w = node.get("rotation", (0, 0, 0, 1))
    twice = [2 * one for one in cross(axis, point)]
    moved = zip(point, twice, cross(axis, twice), node.get("translation", (0, 0, 0)))
    return tuple(p + w * t + c + place for p, t, c, place in moved)


def shape(glb, node, hull):
    """The points of a hull where it stands, and the normals of its faces."""
    mesh = glb.json["meshes"][hull["mesh"]]
    points = [placed(node, p) for p in glb.values(mesh["primitives"][0]["attributes"]["POSITION"])]
    normals = [cross(minus(points[b], points[a]), minus(points[c], points[a])) for a, b, c in glb.triangles(mesh)]
    return points, [tuple(one / dot(n, n) ** 0.5 for one in n) for n in normals if dot(n, n) > 0]


def depth(a, b):
    """How deep two shapes lie within each other, along the normals of their faces."""
    least = float("inf")
    for sign, normals in ((1, a[1]), (-1, b[1])):
        for normal in normals:
            along = [sign * one for one in normal]
            least = min(least, max(dot(along, p) for p in a[0]) - min(dot(along, p) for p in b[0]))
            if least <= 0:
                return 0
    return least


def may_meet(a, b):
    """Whether boxes around two shapes meet."""
    ends = [[(min(p[k] for p in points), max(p[k] for p in points)) for k in range(3)] for points, _ in (a, b)]
    return all(one[0] < other[1] and other[0] < one[1] for one, other in zip(*ends))


def deepest(shapes):
    """The two bodies whose shapes lie deepest within each other, and how deep. `shapes` are lists, by names of bodies."""
    found = [(0, "nothing", "nothing")]
    for one, other in itertools.combinations(shapes, 2):
        pairs = [(a, b) for a in shapes[one] for b in shapes[other] if may_meet(a, b)]
        found.append((max((depth(a, b) for a, b in pairs), default=0), one, other))
    return max(found)
