#!/usr/bin/env python3
"""What a batch of very many items costs beside the making: the first items are made, the others are links to their files with
records of their own; then it is looked at and merged, by the program, as a real one would be.

    many_items.py PROGRAM FOLDER N      prints the table of docs/reports/scale.md; FOLDER must not be there, and is removed
"""

import os
import pathlib
import shutil
import subprocess
import sys
import time

PROGRAM, FOLDER, ITEMS = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), int(sys.argv[3])

BATCH = f"""
[batch]
format = 1
name = "many"
title = "Very many"
thumbnail = 256

[[entry]]
name = "halves"
templates = "all"
total = {ITEMS}
knives = "half"
"""


def templates():
    listed = subprocess.run([PROGRAM, "list"], check=True, capture_output=True, text=True).stdout
    return len(listed.splitlines())


def place(number):
    """As item_folder() has it."""
    digits = f"{number:0{3 if ITEMS <= 1000 else 6 if ITEMS <= 1_000_000 else 9}}"
    return "/".join(digits[at:at + 3] for at in range(0, len(digits), 3))


def make_first(count):
    """One item of every template, by shards of one item each."""
    for shard in range(1, count + 1):
        subprocess.run([PROGRAM, "batch", FOLDER / "many.toml", "-o", FOLDER / "out", "--shard", f"{shard}/{ITEMS}",
                        "--resume", "--quiet"], check=True)


def link_others(count):
    entry = FOLDER / "out" / "halves"
    records = [(entry / place(n) / "item.json").read_text() for n in range(count)]
    names = [[name for name in os.listdir(entry / place(n)) if name != "item.json"] for n in range(count)]
    for number in range(count, ITEMS):
        like = number % count
        there = entry / place(number)
        os.makedirs(there)
        for name in names[like]:
            os.link(entry / place(like) / name, there / name)
        record = records[like].replace(f'"item":"halves/{place(like)}"', f'"item":"halves/{place(number)}"', 1)
        (there / "item.json").write_text(record.replace(f'"number":{like},', f'"number":{number},', 1))


def timed(*words):
    """Seconds, seconds of processor time and peak memory in MB of the program with these words."""
    begin = time.monotonic()
    process = subprocess.Popen([PROGRAM, *words], stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 1):
        sys.exit(f"{words} failed")
    return time.monotonic() - begin, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def made_by(count):
    """Bytes of an item's files and of its record, and how many files it has, on average over the templates."""
    entry = FOLDER / "out" / "halves"
    files = [path for n in range(count) for path in (entry / place(n)).iterdir()]
    records = sum(path.stat().st_size for path in files if path.name == "item.json")
    return sum(path.stat().st_size for path in files) / count, records / count, len(files) / count


def main():
    FOLDER.mkdir(parents=True)
    (FOLDER / "many.toml").write_text(BATCH)
    count = templates()
    make_first(count)
    link_others(count)
    bytes_of_item, bytes_of_record, files = made_by(count)
    looked = timed("farm", "status", FOLDER / "out", "--threads", "1")
    merged = timed("merge", FOLDER / "out", "--quiet")

    size = {name: (FOLDER / "out" / name).stat().st_size / 1e6 for name in ("manifest.json", "index.html")}
    print(f"| {ITEMS} items, halves of all templates in turn | |\n|---|---|")
    print(f"| bytes of an item | {bytes_of_item / 1e3:.0f} kB in {files:.1f} files and a folder |")
    print(f"| its record | {bytes_of_record / 1e3:.2f} kB |")
    for name, megabytes in size.items():
        print(f"| {name} | {megabytes:.1f} MB, {1e6 * megabytes / ITEMS:.0f} bytes an item |")
    for name, (seconds, processor, memory) in (("farm status", looked), ("merge", merged)):
        print(f"| {name} | {seconds:.1f} s, {processor:.1f} s of processor time, {1e6 * processor / ITEMS:.0f} µs an item, "
              f"{memory:.0f} MB |")
    shutil.rmtree(FOLDER)


main()
