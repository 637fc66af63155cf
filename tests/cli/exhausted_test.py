#!/usr/bin/env python3
"""With any amount of memory, a command ends well or reports a lack of memory, never "a bug". A studio that cannot have all
its threads answers with fewer.

    exhausted_test.py POMONA

The address space grows in small steps, from what `--version` needs to what the command needs. On the way threads fail, then one
allocation after another. Outputs appear whole or not at all.
"""

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import urllib.request

STEP, MOST = 2 << 20, 1 << 30  # bytes
COMMANDS = (
    "grow kiwi --quiet --threads 4 -o kiwi.ply",
    "cut cherry --knife half --quality draft --detail 0.5 --quiet --threads 4 -o cherry.glb",
    "cut cherry --knife half --section --quality draft --size 200x200 --quiet --threads 4 -o cherry.png",
)
EXHAUSTED = 71
BATCH = """
[batch]
format = 1
name = "b"
quality = "draft"
detail = 0.1
thumbnail = 32
[[entry]]
name = "halves"
templates = ["cherry"]
count = 2
knives = ["half", ["half", "across"]]
[[entry]]
name = "textures"
templates = ["cherry"]
count = 1
texture = [0, 64]
knives = ["wedges:3"]
"""
BATCH_STEP = 16 << 20
STUDIO_LIMIT = 160 << 20  # bytes: the stacks of 32 threads take 256 MB


def ran(program, folder, words, limit):
    """Status and message of a run with this many bytes of address space."""
    def confine():
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, preexec_fn=confine, check=False)
    return done.returncode, done.stderr.strip()


def tried(program, words, least):
    """The messages of a command from `least` bytes up to as many as it needs."""
    told = set()
    with tempfile.TemporaryDirectory() as folder:
        for limit in range(least, MOST, STEP):
            status, message = ran(program, folder, words, limit)
            if status == 0:
                return told
            if status != EXHAUSTED or not message.startswith("error: "):
                sys.exit(f"{' '.join(words)} with {limit >> 20} MB: status {status}, {message!r}")
            if os.listdir(folder):
                sys.exit(f"{' '.join(words)} with {limit >> 20} MB left {os.listdir(folder)}")
            told.add(message.splitlines()[0])
    sys.exit(f"{' '.join(words)}: no limit was enough")


def tried_batch(program, least):
    """A batch in too little memory leaves items missing, says so, and a run with enough makes them: nothing is noted as
    failed for good. How often that was."""
    stopped = 0
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "b.toml"), "w", encoding="utf-8") as file:
            file.write(BATCH)
        words = ["batch", "b.toml", "--threads", "2", "--quiet", "-o"]
        subprocess.run([program, *words, "whole"], cwd=folder, check=True)
        for limit in range(least, MOST, BATCH_STEP):
            shutil.rmtree(os.path.join(folder, "b"), ignore_errors=True)
            status, message = ran(program, folder, [*words, "b"], limit)
            if status not in (0, EXHAUSTED):
                sys.exit(f"a batch with {limit >> 20} MB: status {status}, {message!r}")
            if status == 0:
                break
            items = [os.path.join(at, name) for at, _, names in os.walk(os.path.join(folder, "b")) for name in names]
            for item in items:
                if item.endswith("item.json") and '"error"' in open(item, encoding="utf-8").read():
                    sys.exit(f"a batch with {limit >> 20} MB notes {item} as failed")
            stopped += any(item.endswith("item.json") for item in items)
            done = subprocess.run([program, *words, "b", "--resume"], cwd=folder, capture_output=True, text=True, check=False)
            same = subprocess.run(["diff", "-r", "whole", "b"], cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode != 0 or same.returncode != 0:
                sys.exit(f"a batch after {limit >> 20} MB: {done.stderr} {same.stdout[:500]}")
    return stopped


def asked_studio(program, folder):
    """The status of the page of a studio that has no room for all its threads."""
    def confine():
        resource.setrlimit(resource.RLIMIT_AS, (STUDIO_LIMIT, STUDIO_LIMIT))
    with subprocess.Popen([program, "studio", "cherry"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True, preexec_fn=confine) as studio:
        try:
            return urllib.request.urlopen(studio.stdout.readline().strip(), timeout=20).status
        finally:
            studio.kill()


def main():
    program = os.path.abspath(sys.argv[1])
    least = next(limit for limit in range(STEP, MOST, STEP) if ran(program, ".", ["--version"], limit)[0] == 0)
    for command in COMMANDS:
        told = tried(program, command.split(), least)
        if not told:
            sys.exit(f"{command}: no limit was too small, so nothing was tried")
        print(f"{command}: {'; '.join(sorted(told))}")
    if tried_batch(program, least) == 0:
        sys.exit("no batch was left in the middle, so nothing was tried")
    with tempfile.TemporaryDirectory() as folder:
        if asked_studio(program, folder) != 200:
            sys.exit("the studio does not answer")


if __name__ == "__main__":
    main()
