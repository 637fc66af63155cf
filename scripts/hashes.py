#!/usr/bin/env python3
"""A table of hashes of what the program writes: all templates, six knives, three seeds, every format, the scenes.

    hashes.py make PROGRAM TABLE.tsv [--jobs N] [--only WORD]   goes on where it was stopped
    hashes.py compare BEFORE.tsv AFTER.tsv                      status 1, and the names, where they differ

A line is "what, file, SHA-256". For steps that are to change no byte: make the table with the program before the
step and with the one after it, and compare. The version's number is left out of what is hashed. Pictures of solids
come from OpenGL, so two tables must be made on one machine.
"""

import argparse
import concurrent.futures
import hashlib
import pathlib
import re
import subprocess
import sys
import tempfile

KNIVES = {
    "half": ["half"],
    "wedges": ["wedges:6"],
    "dice": ["dice:3"],
    "stroke and crinkle": ["crinkle:13mm", "plane:1,2,3,1cm"],
    "ball and half": ["half", "ball:17mm"],
    "core and slices": ["core:9mm", "slices:4"],
}
SEEDS = (0, 1, 7)
SCENES = ("salad", "carved", "ripeness")
TEXTURED = ("kiwi", "tomato", "pepper")
HARMONIC = ("apple", "onion", "tomato", "strawberry")


def jobs(names):
    """What is run: a name, and the words after the program's name; each run writes into a folder of its own."""
    for fruit in names:
        for seed in SEEDS:
            grown = ["grow", fruit, "--seed", str(seed)]
            yield f"grow {fruit} {seed}", [*grown, "-o", "x.ply", "-o", "x.glb", "-o", "x.pov", "-o", "x.svg"]
            yield f"sheets {fruit} {seed}", [*grown, "--sheets", "-o", "x.ply"]
            for name, knives in KNIVES.items():
                cut = ["cut", fruit, "--seed", str(seed)]
                for knife in knives:
                    cut += ["--knife", knife]
                section = [*cut, "--section", "-o", "x.ply", "-o", "x.png", "-o", "x.svg"]
                yield f"section {fruit} {seed} {name}", section
                pieces = [*cut, "--quality", "draft", "-o", "x.glb", "-o", "x.pov", "--pieces", "x.json"]
                yield f"pieces {fruit} {seed} {name}", pieces
        for name in ("half", "core and slices"):
            cut = [word for knife in KNIVES[name] for word in ("--knife", knife)]
            drawn = ["cut", fruit, *cut, "--quality", "draft", "-o", "x.png", "-o", "x.svg", "--size", "320x240"]
            yield f"picture {fruit} {name}", drawn
        yield f"picture {fruit}", ["grow", fruit, "-o", "x.png", "--size", "320x240"]
        yield f"glass {fruit}", ["grow", fruit, "--surfaces", "-o", "x.png", "-o", "x.glb", "--size", "320x240"]
    for fruit in set(TEXTURED) & set(names):
        yield f"texture {fruit}", ["cut", fruit, "--knife", "half", "--texture", "192", "--quality", "draft", "-o", "x.glb"]
    for fruit in set(HARMONIC) & set(names):
        yield f"harmonic {fruit}", ["cut", fruit, "--knife", "half", "--diffuser", "harmonic", "--section", "-o", "x.ply"]
    for scene in SCENES:
        for seed in (0, 1):
            words = ["scene", scene, "--seed", str(seed), "-o", "x.glb", "-o", "x.pov", "-o", "x.png", "-o", "x.json"]
            yield f"scene {scene} {seed}", [*words, "--size", "640x480"]


def hashes_of(program, words, version):
    """The hash of every file that one run writes, by name; of a run that fails, of its status and words."""
    root = program.resolve().parent.parent
    words = [str(root / "scenes" / (word + ".toml")) if word in SCENES else word for word in words]
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([str(program), *words, "--threads", "1", "--quiet"], cwd=folder, capture_output=True)
        files = sorted(path for path in pathlib.Path(folder).rglob("*") if path.is_file())
        if run.returncode != 0:
            return {f"status {run.returncode}": hashlib.sha256(run.stderr).hexdigest()}
        hashed = {}
        for path in files:
            content = path.read_bytes().replace(b"pomona " + version, b"pomona VERSION")
            hashed[path.name] = hashlib.sha256(content).hexdigest()
        return hashed


def read(table):
    lines = pathlib.Path(table).read_text().splitlines() if pathlib.Path(table).exists() else []
    return {tuple(line.split("\t")[:2]): line.split("\t")[2] for line in lines if line.count("\t") == 2}


def make(options):
    program = options.program.resolve()
    version = re.search(rb"\d+\.\d+\.\d+", subprocess.run([program, "--version"], capture_output=True).stdout).group(0)
    listed = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout
    names = [line.split("\t")[0] for line in listed.splitlines()]
    done = {what for what, _ in read(options.table)}
    todo = [job for job in jobs(names) if job[0] not in done and (options.only or "") in job[0]]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool, open(options.table, "a") as table:
        runs = {pool.submit(hashes_of, program, words, version): what for what, words in todo}
        for run in concurrent.futures.as_completed(runs):
            table.write("".join(f"{runs[run]}\t{name}\t{digest}\n" for name, digest in run.result().items()))
            table.flush()
    print(f"{len(read(options.table))} hashes in {options.table}")
    return 0


def compare(options):
    before, after = read(options.before), read(options.after)
    both = before.keys() & after.keys()
    wrong = sorted(key for key in both if before[key] != after[key])
    alone = sorted(before.keys() ^ after.keys())
    for key in wrong:
        print("differs:", *key)
    for key in alone:
        print("only in", options.before if key in before else options.after, *key)
    print(f"{len(both) - len(wrong)} of {len(both)} equal; {len(alone)} in one table only")
    return 1 if wrong or alone else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(required=True)
    maker = verbs.add_parser("make")
    maker.add_argument("program", type=pathlib.Path)
    maker.add_argument("table")
    maker.add_argument("--jobs", type=int, default=2)
    maker.add_argument("--only", help="only what has this word in its name")
    maker.set_defaults(run=make)
    comparer = verbs.add_parser("compare")
    comparer.add_argument("before")
    comparer.add_argument("after")
    comparer.set_defaults(run=compare)
    options = parser.parse_args()
    return options.run(options)


if __name__ == "__main__":
    sys.exit(main())
