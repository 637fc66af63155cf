#!/usr/bin/env python3
"""Writes render/lettering/*.letters from the EB Garamond of Debian's fonts-ebgaramond and fonts-ebgaramond-extra
(needs python3-fonttools). What it writes is kept in the tree, so that letters are the same everywhere and nobody needs
the fonts to build Pomona.

    make_letters.py FOLDER      FOLDER = render/lettering
"""

import pathlib
import sys

from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont

FONTS = pathlib.Path("/usr/share/fonts/opentype/ebgaramond")
FACES = {
    "italic": "EBGaramond12-Italic.otf",
    "capitals": "EBGaramondSC12-Regular.otf",
}
CHARACTERS = [*range(0x20, 0x7F), *range(0xA0, 0x180), 0x2013, 0x2014, 0x2018, 0x2019, 0x201C, 0x201D, 0x2026]
KERNED = [*range(ord("A"), ord("Z") + 1), *range(ord("a"), ord("z") + 1), ord("."), ord(",")]


def path_of(font, glyph):
    """SVG-like path data in font units: M, L, C, Z with absolute numbers."""
    pen = DecomposingRecordingPen(font.getGlyphSet())
    font.getGlyphSet()[glyph].draw(pen)
    words = []
    for operator, points in pen.value:
        letter = {"moveTo": "M", "lineTo": "L", "curveTo": "C", "closePath": "Z", "endPath": "Z"}[operator]
        words.append(letter + " ".join(f"{round(x)} {round(y)}" for x, y in points))
    return "".join(words)


def kerning(font):
    """Horizontal pair adjustments of the kern feature: {(left, right): units}."""
    pairs = {}
    if "GPOS" not in font:
        return pairs
    table = font["GPOS"].table
    lookups = {i for f in table.FeatureList.FeatureRecord if f.FeatureTag == "kern" for i in f.Feature.LookupListIndex}
    for index in sorted(lookups):
        for subtable in table.LookupList.Lookup[index].SubTable:
            subtable = getattr(subtable, "ExtSubTable", subtable)
            if subtable.LookupType != 2:
                continue
            for key, value in pairs_of(subtable):
                pairs.setdefault(key, value)
    return pairs


def pairs_of(subtable):
    first = subtable.Coverage.glyphs
    if subtable.Format == 1:
        for left, pair_set in zip(first, subtable.PairSet):
            for record in pair_set.PairValueRecord:
                yield (left, record.SecondGlyph), (record.Value1.XAdvance or 0) if record.Value1 else 0
        return
    seconds = subtable.ClassDef2.classDefs
    wanted = {g: c for g, c in seconds.items()}
    for left in first:
        row = subtable.Class1Record[subtable.ClassDef1.classDefs.get(left, 0)].Class2Record
        for right, c in wanted.items():
            value = row[c].Value1
            amount = getattr(value, "XAdvance", 0) if value else 0
            if amount:
                yield (left, right), amount


def write(face, folder):
    font = TTFont(FONTS / FACES[face])
    names = font.getBestCmap()
    lines = [
        f"# {FACES[face]} of EB Garamond 0.016, Copyright 2010-2013 Georg Duffner, SIL Open Font License 1.1 (OFL.txt):",
        "# a part of it, rewritten by scripts/make_letters.py. letter: character, advance, outline; kern: two characters, units.",
        f"units {font['head'].unitsPerEm}",
    ]
    for code in CHARACTERS:
        if code in names:
            glyph = names[code]
            lines.append(f"letter {code:04x} {font['hmtx'][glyph][0]} {path_of(font, glyph)}".rstrip())
    pairs = kerning(font)
    for left in KERNED:
        for right in KERNED:
            amount = pairs.get((names.get(left), names.get(right)), 0)
            if amount:
                lines.append(f"kern {left:04x} {right:04x} {amount}")
    (folder / f"{face}.letters").write_text("\n".join(lines) + "\n", encoding="ascii")


def main():
    for face in FACES:
        write(face, pathlib.Path(sys.argv[1]))


if __name__ == "__main__":
    main()
