#!/usr/bin/env python3
"""How fast the program is beside what it should be: a line for each aim, with what is measured on this machine.

    measure_speed.py PROGRAM ROAD [ROW ...]      ROAD is build/bench/road; a ROW is a word of its line, all unless said

Times are of the processor, on one thread; the least of three runs counts, because other programs use the machine, too.
Batches are measured by the clock, on two threads, a part of their thousand pieces.
`measured / aim` is at most 1 where an aim is met.
"""

import argparse
import functools
import json
import pathlib
import re
import subprocess
import tempfile

from measure_batch import measured, measured_batch

RUNS = 3
SOURCES = pathlib.Path(__file__).resolve().parent.parent


class Measuring:
    """Runs the program in a folder of its own."""

    def __init__(self, program, road, folder):
        self.program, self.road, self.folder = program, road, pathlib.Path(folder)

    def seconds(self, *words):
        output = self.folder / f"out{len(list(self.folder.iterdir()))}.glb"
        return min(measured([self.program, *words, "--quiet", "-o", str(output)])[1] for _ in range(RUNS))

    def half(self, fruit, *words):
        return self.seconds("cut", fruit, "--knife", "half", "--quality", "draft", "--threads", "1", *words)

    def levels(self):
        """The worst of four fruits: three levels beside the cut alone."""
        return max(self.half(fruit, "--lod", "3") / self.half(fruit) for fruit in ("apple", "tomato", "kiwi", "cucumber"))

    def textured(self):
        return self.half("tomato", "--texture", "512")

    def wedges(self):
        return self.seconds("cut", "tomato", "--knife", "wedges:6", "--texture", "1024", "--maps", "color", "--threads", "1")

    def thousand_pieces(self, items, further=""):
        """Seconds by the clock of 500 items, halved, of which only so many are made."""
        return 500 / items * measured_batch(self.program, items, 2, further)[0]

    @functools.cache
    def road_times(self, quality):
        told = subprocess.run([self.road, "--seeds", "1", "--runs", "1", "--quality", quality, "--json"],
                              capture_output=True, text=True, check=True)
        return [row["all"] for row in json.loads(told.stdout)[quality]]

    def road_mean(self, quality):
        times = self.road_times(quality)
        return sum(times) / len(times)

    def folds(self):
        """64 folds beside 16: proportion is 4."""
        few, many = (self.seconds("grow", "tomato", "--folds", str(folds), "--threads", "1") for folds in (16, 64))
        return many / few

    def bowl(self):
        salad = (SOURCES / "scenes" / "salad.toml").read_text(encoding="utf-8")
        scene = self.folder / "three_hundred.toml"
        scene.write_text(re.sub(r"(?m)^total = \d+$", "total = 300", salad, count=1), encoding="utf-8")
        dishes = self.folder / "dishes"
        if not dishes.exists():
            dishes.symlink_to(SOURCES / "scenes" / "dishes")
        return measured([self.program, "scene", str(scene), "--quality", "draft", "--threads", "1", "--quiet", "-o",
                         str(self.folder / "bowl.json")])[2]


# What, how it is measured, the unit, and the aim.
ROWS = [
    ("levels: `cut --lod 3` beside `cut`, the worst of four fruits", Measuring.levels, "times", 2),
    ("texture: half of a tomato, 512 texels", Measuring.textured, "s", 0.6),
    ("wedges: six of a tomato, 1024 texels", Measuring.wedges, "s", 2),
    ("road: draft, mean of all templates", lambda m: m.road_mean("draft"), "ms", 150),
    ("slowest: draft, the slowest template", lambda m: max(m.road_times("draft")), "ms", 300),
    ("final: mean of all templates", lambda m: m.road_mean("final"), "ms", 240),
    ("grapes: half of a bunch", lambda m: m.half("grapes"), "s", 1.5),
    ("pieces: a batch of 1 000 at draft, by the clock, on two threads", lambda m: m.thousand_pieces(112), "s", 45),
    ("baked: the same with 512 texels", lambda m: m.thousand_pieces(56, "texture = 512"), "s", 150),
    ("folds: 64 beside 16 of a tomato", Measuring.folds, "times", 4),
    ("bowl: 300 pieces laid out at draft, memory", Measuring.bowl, "MB", 400),
]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("road")
    parser.add_argument("row", nargs="*")
    asked = parser.parse_args()
    print("| what | measured | aim | measured / aim |\n|---|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        measuring = Measuring(str(pathlib.Path(asked.program).resolve()), str(pathlib.Path(asked.road).resolve()), folder)
        for what, measure, unit, aim in ROWS:
            if asked.row and what.split(":")[0] not in asked.row:
                continue
            value = measure(measuring)
            print(f"| {what} | {value:.3g} {unit} | {aim} {unit} | {value / aim:.2f} |", flush=True)


if __name__ == "__main__":
    main()
