#!/usr/bin/env python3
"""Makes the picture of a [[detail]] of kind "example": a periodic cube of flesh, its slices one below the other.

    scripts/example_tile.py templates/textures/kiwi_flesh.png --painted kiwi_flesh
    scripts/example_tile.py my_flesh.png --picture slice.png

--picture takes a picture of the flesh as it looks across its fibres: even, lit from nowhere, without edges. It need not
be periodic. The cube is grown out of noise: on each of its three axes every neighbourhood of 7 x 7 texels takes after the
most similar one of the picture [Kopf et al. 2007, Solid Texture Synthesis from 2D Exemplars]. --painted are those that
Pomona ships; they are drawn in the cube itself, by formulas.

Same arguments, same bytes on one machine; libraries of linear algebra round differently on others, so the pictures are
checked in. Needs python3-numpy and python3-pil.
"""

import argparse
import zlib
from pathlib import Path

import numpy as np
from PIL import Image

RADIUS = 3  # of neighbourhoods, texels
DIMENSIONS = 10  # of neighbourhoods, after projection on their principal axes


def linear(srgb):
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def srgb_of(color):
    return np.where(color <= 0.0031308, color * 12.92, 1.055 * np.maximum(color, 1e-9) ** (1 / 2.4) - 0.055)


def ranks(values):
    """Each value's share of the way from the least to the largest, by rank."""
    order = np.argsort(values.ravel(), kind="stable")
    rank = np.empty(values.size)
    rank[order] = (np.arange(values.size) + 0.5) / values.size
    return rank.reshape(values.shape)


# ---- From a picture ----


def neighbourhoods(picture):
    """One row for each place that has a whole neighbourhood."""
    windows = np.lib.stride_tricks.sliding_window_view(picture, (2 * RADIUS + 1, 2 * RADIUS + 1))
    return windows.reshape(-1, (2 * RADIUS + 1) ** 2)


class Likeness:
    """Finds the most similar neighbourhood of a picture."""

    def __init__(self, picture):
        hoods = neighbourhoods(picture)
        self.middle = picture[RADIUS:-RADIUS, RADIUS:-RADIUS].ravel()
        self.mean = hoods.mean(0)
        _, _, axes = np.linalg.svd(hoods - self.mean, full_matrices=False)
        self.axes = axes[:DIMENSIONS].T
        self.known = ((hoods - self.mean) @ self.axes).astype(np.float32)
        self.squares = (self.known**2).sum(1)

    def nearest(self, hoods):
        """The values in the middle of the most similar neighbourhoods, and how far these are."""
        asked = ((hoods - self.mean) @ self.axes).astype(np.float32)
        value, distance = np.empty(len(asked)), np.empty(len(asked))
        for start in range(0, len(asked), 4096):
            part = asked[start : start + 4096]
            away = self.squares - 2 * part @ self.known.T
            found = away.argmin(1)
            value[start : start + 4096] = self.middle[found]
            distance[start : start + 4096] = away[np.arange(len(part)), found] + (part**2).sum(1)
        return value, np.sqrt(np.maximum(distance, 0))


def one_round(cube, likeness, is_last):
    """Every texel becomes the mean of what its three slices say, or in the end what the most similar one says."""
    total, weights, best, winner = np.zeros(cube.size), np.zeros(cube.size), np.full(cube.size, np.inf), cube.ravel()
    for axis in range(3):
        across = [a for a in range(3) if a != axis]
        steps = range(-RADIUS, RADIUS + 1)
        hoods = np.stack([np.roll(cube, (-a, -b), across).ravel() for a in steps for b in steps], 1)
        value, distance = likeness.nearest(hoods)
        weight = 1 / (1e-3 + distance) ** 1.2
        total, weights = total + weight * value, weights + weight
        winner, best = np.where(distance < best, value, winner), np.minimum(distance, best)
    return (winner if is_last else total / weights).reshape(cube.shape)


def grown(picture, side):
    """A cube whose slices look like the picture, values as ranks. First half as large, so that large shapes settle."""
    small = 0.25 * (picture[::2, ::2] + picture[1::2, ::2] + picture[::2, 1::2] + picture[1::2, 1::2])
    cube = np.random.default_rng(7).random((side // 2,) * 3)
    for each, rounds in ((small, 8), (picture, 5)):
        likeness, sorted_values = Likeness(each), np.sort(each.ravel())
        if cube.shape[0] < side and each is picture:
            cube = cube.repeat(2, 0).repeat(2, 1).repeat(2, 2)
        for k in range(rounds):
            # As often as in the picture, so that means do not fade.
            cube = np.interp(ranks(cube), np.linspace(0, 1, sorted_values.size), sorted_values)
            cube = one_round(cube, likeness, each is picture and k >= rounds - 2)
    return cube


def from_picture(path, side, levels):
    """The cube's values as ranks 0..1, and the picture's colours by rank, linear."""
    colors = linear(np.asarray(Image.open(path).convert("RGB"), dtype=float) / 255)
    longest = min(colors.shape[:2]) // 2 * 2
    if longest < 32:
        raise SystemExit(f"{path}: is smaller than 32 x 32 pixels")
    colors = colors[: min(longest, 128), : min(longest, 128)]
    rank = ranks(colors @ (0.2126, 0.7152, 0.0722))
    bins = np.minimum((rank * levels).astype(int), levels - 1)
    palette = np.stack([colors[bins == b].mean(0) for b in range(levels)])
    return ranks(grown(rank, side)), palette


# ---- Painted in the cube ----


class Painter:
    """Periodic noise and cells in a cube."""

    def __init__(self, side, seed):
        self.side = side
        self.random = np.random.default_rng(seed)
        frequency = np.fft.fftfreq(side)
        self.squared = (
            frequency[:, None, None] ** 2 + frequency[None, :, None] ** 2 + frequency[None, None, :] ** 2
        )

    def noise(self, size):
        """Standard normal, smooth over `size` texels."""
        white = np.fft.fftn(self.random.standard_normal((self.side,) * 3))
        soft = np.fft.ifftn(white * np.exp(-2 * (np.pi * size) ** 2 * self.squared)).real
        return (soft - soft.mean()) / soft.std()

    def cells(self, count):
        """Distances to the nearest and second nearest of so many points, texels; and the nearest one's number."""
        nearest = np.full((self.side,) * 3, np.inf)
        second, own = nearest.copy(), np.zeros(nearest.shape, int)
        along = np.arange(self.side)
        for number, point in enumerate(self.random.random((count, 3)) * self.side):
            x, y, z = [((along - p + self.side / 2) % self.side - self.side / 2) ** 2 for p in point]
            away = np.sqrt(z[:, None, None] + y[None, :, None] + x[None, None, :])
            second = np.minimum(second, np.maximum(nearest, away))
            own = np.where(away < nearest, number, own)
            nearest = np.minimum(nearest, away)
        return nearest, second, own


def step(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def kiwi_flesh(side):
    """Pale rays between glassy flecks: blobs, which the template draws out along its rays."""
    paint = Painter(side, 1)
    rays = step(0.35, 1.5, paint.noise(1.4) + 0.7 * paint.noise(2.6))
    flecks = step(1.0, 2.0, paint.noise(1.4))
    value = 0.35 + 0.5 * rays - 0.25 * flecks * (1 - rays) + 0.04 * paint.noise(1)
    return value, [(0, "#4d7c14"), (0.35, "#84ad2e"), (0.75, "#a8c852"), (1, "#e2eda6")]


def watermelon_flesh(side):
    """Crumbs of uneven size with dark gaps, gathered in swathes."""
    paint = Painter(side, 4)
    nearest, second, own = paint.cells(700)
    swathe = 0.5 + 0.5 * np.tanh(paint.noise(5))
    crumb = paint.random.random(700)[own]
    gap = 1 - step(0.1, 1.6, second - nearest)
    value = 0.5 - 0.4 * gap * swathe + 0.3 * step(0.75, 1, crumb) * step(0.6, 2.2, second - nearest) * swathe
    return value + 0.08 * paint.noise(3), [(0, "#a81822"), (0.45, "#d8433f"), (0.8, "#e9756a"), (1, "#f6b3a6")]


def beetroot_flesh(side):
    """Fine grain, a few pale strands and a few dark ones."""
    paint = Painter(side, 5)
    pale = step(1.0, 2.2, paint.noise(1.3) + 0.5 * paint.noise(3))
    dark = step(1.2, 2.4, paint.noise(1.6))
    value = 0.5 + 0.4 * pale - 0.25 * dark * (1 - pale) + 0.07 * paint.noise(1) + 0.08 * paint.noise(4)
    return value, [(0, "#3a0420"), (0.5, "#7d1244"), (0.8, "#a8305f"), (1, "#cf6d92")]


def bread_crumb(side):
    """Bubbles of all sizes with thin, glossy walls; in the large ones one looks into the dark."""
    paint = Painter(side, 6)
    value = 0.62 + 0.05 * paint.noise(1) + 0.06 * paint.noise(4)
    along = np.arange(side)
    for number in range(420):
        radius = 0.9 + 5.2 * paint.random.random() ** 5
        x, y, z = [((along - p + side / 2) % side - side / 2) ** 2 for p in paint.random.random(3) * side]
        away = np.sqrt(z[:, None, None] + y[None, :, None] + x[None, None, :]) / radius
        hollow = 1 - step(0.72, 1.0, away)
        wall = step(0.8, 1.02, away) * (1 - step(1.02, 1.25, away))
        depth = 0.16 + 0.055 * radius
        value = value * (1 - hollow) + (value - depth) * hollow + 0.1 * wall * (number % 3 == 0)
    return value, [(0, "#8c5f34"), (0.35, "#c39a63"), (0.62, "#e0c592"), (0.85, "#efdcb4"), (1, "#fbf0d4")]


PAINTED = {each.__name__: each for each in (kiwi_flesh, watermelon_flesh, beetroot_flesh, bread_crumb)}


def painted(name, side, levels):
    """The cube's values 0..1, and the colours by value, linear."""
    value, stops = PAINTED[name](side)
    low, high = np.quantile(value, (0.001, 0.999))
    at = [stop for stop, _ in stops]
    rgb = np.array([[int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)] for _, color in stops])
    steps = (np.arange(levels) + 0.5) / levels
    palette = np.stack([linear(np.interp(steps, at, rgb[:, k])) for k in range(3)], 1)
    return np.clip((value - low) / (high - low), 0, 1), palette


def write(cube, palette, path):
    """Slices one below the other, each texel a number of the palette."""
    levels, side = len(palette), cube.shape[0]
    number = np.minimum((cube * levels).astype(np.uint8), levels - 1)
    picture = Image.fromarray(number.reshape(side * side, side), "P")
    picture.putpalette(np.round(srgb_of(palette) * 255).astype(np.uint8).ravel().tolist())
    path.parent.mkdir(parents=True, exist_ok=True)
    picture.save(path, optimize=True)
    print(f"{path}: {side} x {side} x {side}, {levels} colours, {path.stat().st_size} bytes,"
          f" {zlib.crc32(number.tobytes()):08x}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tile", type=Path, help="the picture to write, .png")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--picture", type=Path, help="of flesh, across its fibres")
    source.add_argument("--painted", choices=PAINTED)
    parser.add_argument("--texels", type=int, choices=(16, 32, 48), default=48, help="along each edge (48)")
    parser.add_argument("--levels", type=int, choices=range(2, 257), metavar="2..256", default=24, help="colours (24)")
    told = parser.parse_args()
    if told.picture:
        cube, palette = from_picture(told.picture, told.texels, told.levels)
    else:
        cube, palette = painted(told.painted, told.texels, told.levels)
    write(cube, palette, told.tile)


if __name__ == "__main__":
    main()
