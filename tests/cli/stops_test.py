#!/usr/bin/env python3
"""Stops `pomona grow` while it replaces one file, and five in two folders: by SIGKILL at every k-th call that changes a folder, by
SIGKILL, SIGTERM and SIGINT at random moments, and by calls that fail.

    stops_test.py PROGRAM SHIM STOPS    STOPS: so many kills and signals in all

Each file is whole, old or new, at any time. After a signal or a failing call all are old or all new, and nothing else is left.
After SIGKILL the next run that writes into one of the folders makes all old or all new.
"""

import errno
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent / "batch"))
from batches import pomona, tree  # noqa: E402

PROGRAM, SHIM, STOPS = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), int(sys.argv[3])
SETS = {"one": ["here/a.glb"], "five": ["here/a.glb", "here/b.ply", "there/c.ply", "here/d.svg", "there/e.glb"]}


class Stops:
    def __init__(self, folder, outputs):
        self.folder, self.outputs = pathlib.Path(folder), outputs
        self.out = self.folder / "out"
        for name in ("here", "there"):
            (self.out / name).mkdir(parents=True)
        self.random = random.Random(1)
        self.expect(self.grow(1), 0, "the old set")
        self.old = {name: (self.out / name).read_bytes() for name in outputs}
        began = time.monotonic()
        self.expect(self.grow(2), 0, "the new set")
        self.seconds = time.monotonic() - began
        self.new = {name: (self.out / name).read_bytes() for name in outputs}
        assert all(self.old[name] != self.new[name] for name in outputs)

    def words(self, seed):
        words = ["grow", "radish", "--detail", "0.1", "--seed", seed, "--quiet", "--threads", "2"]
        for name in self.outputs:
            words += ["-o", f"out/{name}"]
        return [str(word) for word in words]

    def grow(self, seed, **environment):
        return pomona(PROGRAM, *self.words(seed), folder=self.folder, shim=SHIM if environment else None, **environment)

    def failing(self, call, at, how, count="", once=False):
        return self.grow(2, POMONA_FAIL_FOLDER=self.out, POMONA_FAIL_CALL=call, POMONA_FAIL_AT=at, POMONA_FAIL_WITH=how,
                         POMONA_FAIL_COUNT=count, POMONA_FAIL_ONCE=int(once))

    def calls(self, call):
        """The number of calls in an undisturbed run."""
        self.put_old()
        count = self.folder / "count"
        self.expect(self.failing(call, 0, "0", count), 0, "counting")
        return int(count.read_text())

    def expect(self, result, status, what):
        if result.returncode != status:
            sys.exit(f"{what}: status {result.returncode}, not {status}\n{result.stderr}")

    def put_old(self):
        for path in self.out.rglob("*"):
            if path.is_file():
                path.unlink()
        for name, content in self.old.items():
            (self.out / name).write_bytes(content)

    def which(self, what):
        """Whether the outputs are old, new or mixed; every file is whole."""
        found = set()
        for name in self.outputs:
            content = (self.out / name).read_bytes() if (self.out / name).exists() else None
            if content not in (self.old[name], self.new[name]):
                sys.exit(f"{what}: {name} is neither old nor new: {content and len(content)} bytes")
            found.add("old" if content == self.old[name] else "new")
        return found.pop() if len(found) == 1 else "mixed"

    def all_or_none(self, what):
        if self.which(what) == "mixed":
            sys.exit(f"{what}: some files are old and some new")

    def nothing_left(self, what):
        others = set(name for name, digest in tree(self.out).items() if digest) - set(self.outputs) - {"here/next.ply", "there/next.ply"}
        if others:
            sys.exit(f"{what}: left behind {sorted(others)}")

    def next_runs(self, what):
        """Other files are written into both folders, in either order: the first run already finishes the transaction."""
        for folder in self.random.sample(["here", "there"], 2):
            result = pomona(PROGRAM, "grow", "radish", "--detail", "0.1", "--quiet", "-o", f"out/{folder}/next.ply", folder=self.folder)
            self.expect(result, 0, f"the run after {what}")
            self.all_or_none(f"the run after {what}")
        self.nothing_left(f"the runs after {what}")

    def killed_at_calls(self, stops):
        total = self.calls("any")
        moments = range(1, total + 1, max(1, -(-total // stops)))
        mixed = 0
        for at in moments:
            self.put_old()
            what = f"kill at call {at} of {total}"
            self.expect(self.failing("any", at, "kill"), -signal.SIGKILL, what)
            mixed += self.which(what) == "mixed"
            self.next_runs(what)
        return len(moments), mixed

    def stopped_at_random(self, stops):
        hit = 0
        for n in range(stops):
            self.put_old()
            which = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)[n % 3]
            run = subprocess.Popen([PROGRAM, *self.words(2)], cwd=self.folder)
            # Half of them as soon as writing starts.
            if n % 2:
                while run.poll() is None and not any(self.out.glob("*/.pomona-*")):
                    time.sleep(0.0002)
                time.sleep(self.random.uniform(0, 0.01))
            else:
                time.sleep(self.random.uniform(0, self.seconds))
            run.send_signal(which)
            status = run.wait()
            what = f"{which.name} at a random moment ({n})"
            if status not in (0, -which):
                sys.exit(f"{what}: status {status}")
            hit += status != 0
            if which == signal.SIGKILL:
                self.which(what)
                self.next_runs(what)
            else:
                self.all_or_none(what)
                self.nothing_left(what)
        return hit

    def failing_calls(self):
        tried = 0
        for call, status in (("open", 73), ("write", 74), ("fsync", 74), ("close", 74), ("rename", 73)):
            for at in range(1, self.calls(call) + 1):
                for error in (errno.ENOSPC, errno.EPERM):
                    self.put_old()
                    what = f"{call} {at} fails with {errno.errorcode[error]}"
                    result = self.failing(call, at, error, once=True)
                    forgiven = call in ("fsync", "close") and result.returncode == 0  # of folders and records
                    if not forgiven:
                        self.expect(result, status, what)
                        if "error" not in result.stderr or self.which(what) != "old":
                            sys.exit(f"{what}: {result.stderr}")
                    self.all_or_none(what)
                    self.nothing_left(what)
                    tried += 1
        return tried


def main():
    for name, outputs in SETS.items():
        with tempfile.TemporaryDirectory(prefix="pomona-test-") as folder:
            stops = Stops(folder, outputs)
            share = STOPS // (2 * len(SETS))
            at_calls, mixed = stops.killed_at_calls(share)
            print(f"{name}: {at_calls} kills at calls, of which {mixed} left a mixed set until the next run", flush=True)
            at_random = 2 * share - at_calls
            print(f"{name}: {stops.stopped_at_random(at_random)} of {at_random} stops at random moments in time: all whole", flush=True)
            print(f"{name}: {stops.failing_calls()} failing calls: all old, nothing left", flush=True)


if __name__ == "__main__":
    main()
