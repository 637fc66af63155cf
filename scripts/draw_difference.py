#!/usr/bin/python3
"""Draws how far two pictures are from each other, colour by colour, eight times as much, dark on white.

    draw_difference.py ONE.png OTHER.png DIFFERENCE.png

Needs Pillow (Debian: python3-pil).
"""

import sys

from PIL import Image, ImageChops

TIMES = 8


def main(one, other, difference):
    pictures = [Image.open(path).convert("RGB") for path in (one, other)]
    apart = ImageChops.difference(*pictures).point(lambda value: max(0, 255 - TIMES * value))
    apart.save(difference)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
