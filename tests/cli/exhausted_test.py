#!/usr/bin/env python3
"""Whatever little memory there is, a command ends well or says that there is too little: never is it "a bug". A studio
that cannot have all its threads answers with fewer.

    exhausted_test.py POMONA

The space for addresses grows in small steps, from what the program needs to tell its version to what the command needs;
on the way first the threads cannot be had, then this allocation, then that one. Outputs appear whole or not at all.
"""

import os
import resource
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
STUDIO_LIMIT = 160 << 20  # bytes: the stacks of 32 threads take 256 MB


def ran(program, folder, words, limit):
    """Status and message of a run that may have so many bytes of addresses."""
    def confine():
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, preexec_fn=confine, check=False)
    return done.returncode, done.stderr.strip()


def tried(program, words, least):
    """What a command said on its way from `least` bytes to as many as it needs."""
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
    with tempfile.TemporaryDirectory() as folder:
        if asked_studio(program, folder) != 200:
            sys.exit("the studio does not answer")


if __name__ == "__main__":
    main()
