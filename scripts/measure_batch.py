#!/usr/bin/env python3
"""How fast batches are made: items in a second on 1 and 2 threads, processor time for each, and memory. New variants of all
templates in turn, halved, at draft, as .glb with vertex colours and a thumbnail of 256 pixels.

    measure_batch.py PROGRAM [--texture N [--maps]] [ITEMS ...]      50, 500 and 5000 of them unless said

An item is one variant in two pieces, so that 500 items are a thousand pieces. With --texture colours are baked into N x N texels for each piece,
with --maps normals, roughness and what else textures can hold, too.
"""

import argparse
import os
import pathlib
import sys
import tempfile
import time

BATCH = """
[batch]
format = 1
name = "bench"
seed = 1

[[entry]]
name = "halves"
templates = "all"
total = {items}
knives = "half"
formats = "glb"
thumbnail = 256
{further}
"""


def measured(words):
    """Seconds by the clock, seconds of the processor, and the most memory (MB) of a program."""
    began = time.monotonic()
    child = os.spawnv(os.P_NOWAIT, words[0], words)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"measure_batch: error: {' '.join(words)} ended with {status}")
    return time.monotonic() - began, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measured_batch(program, items, threads, further=""):
    """What `measured` tells of a batch of so many items. `further` has more keys of its entry."""
    with tempfile.TemporaryDirectory(prefix="pomona-batch-") as folder:
        file = pathlib.Path(folder, "bench.toml")
        file.write_text(BATCH.format(items=items, further=further))
        return measured([program, "batch", str(file), "-o", f"{folder}/out", "--threads", str(threads), "--quiet"])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("items", type=int, nargs="*", default=[50, 500, 5000])
    parser.add_argument("--texture", type=int, default=0)
    parser.add_argument("--maps", action="store_true")
    parser.add_argument("--threads", type=int, action="append")
    asked = parser.parse_args()
    program = str(pathlib.Path(asked.program).resolve())
    texture = f"texture = {asked.texture}" if asked.texture else ""
    if asked.maps:
        texture += '\nmaps = "all"'
    print("| items | threads | time | items a second | processor time of an item | memory |")
    print("|--:|--:|--:|--:|--:|--:|")
    for items in asked.items:
        for threads in asked.threads or (1, 2):
            seconds, processor, memory = measured_batch(program, items, threads, texture)
            print(f"| {items} | {threads} | {seconds:.1f} s | {items / seconds:.2f} | {1000 * processor / items:.0f} ms | "
                  f"{memory:.0f} MB |", flush=True)


if __name__ == "__main__":
    main()
