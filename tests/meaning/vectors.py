"""Vectors as tuples, quaternions as (w, x, y, z), colours linear."""

import math


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return times(a, 1 / length(a))


def turned(q, p):
    """The point turned by a unit quaternion."""
    w, u = q[0], q[1:]
    t = times(cross(u, p), 2)
    return add(add(p, times(t, w)), cross(u, t))


def linear(srgb):
    """The sRGB curve of a value from 0 to 1 (IEC 61966-2-1)."""
    return srgb / 12.92 if srgb <= 0.04045 else ((srgb + 0.055) / 1.055) ** 2.4


def furthest(a, b):
    """The largest difference of two lists of numbers."""
    return max((abs(x - y) for x, y in zip(a, b, strict=True)), default=0.0)
