#!/usr/bin/env python3
"""Stops a batch at many moments and resumes it: the result must equal an undisturbed run, byte for byte. Calls that
fail (a full disk, a read-only one, ...) must end with a documented status and damage nothing.

    stops_test.py PROGRAM SHIM KILLS    KILLS: so many kills in all, half at random moments, half at every k-th call
"""

import errno
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from batches import TINY, pomona, tree  # noqa: E402

PROGRAM, SHIM, KILLS = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), int(sys.argv[3])
STATUSES = {73, 74}  # cannot create, cannot write: docs/reference/commands.md


class Stops:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.out = self.folder / "out"
        (self.folder / "small.toml").write_text(TINY)
        began = time.monotonic()
        self.check(self.batch(), 0, "undisturbed")
        self.seconds = time.monotonic() - began
        self.expected = tree(self.out)
        self.random = random.Random(1)

    def batch(self, *words, **environment):
        shim = SHIM if environment else None
        return pomona(PROGRAM, "batch", "small.toml", "-o", "out", "--quiet", *words, folder=self.folder, shim=shim, **environment)

    def check(self, result, status, what):
        if result.returncode != status:
            sys.exit(f"{what}: status {result.returncode}, not {status}\n{result.stderr}")

    def failing(self, call, at, how, *words, count=""):
        return self.batch(*words, POMONA_FAIL_FOLDER=self.out, POMONA_FAIL_CALL=call, POMONA_FAIL_AT=at, POMONA_FAIL_WITH=how,
                          POMONA_FAIL_COUNT=count)

    def calls(self, call, *words):
        """The number of calls in an undisturbed run."""
        shutil.rmtree(self.out, ignore_errors=True)
        count = self.folder / "count"
        self.check(self.failing(call, 0, "0", "--threads", "1", *words, count=count), 0, "counting")
        return int(count.read_text())

    def goes_on(self, what):
        self.check(self.batch("--resume", "--threads", "2"), 0, what)
        found = tree(self.out)
        if found != self.expected:
            wrong = sorted(set(found.items()) ^ set(self.expected.items()))
            sys.exit(f"{what}: differs in {wrong[:6]}")

    def nothing_is_half_there(self, what):
        """Every item in its place is complete."""
        for path in self.out.rglob("*"):
            name = path.relative_to(self.out).as_posix()
            if not name.startswith(".pomona") and (name not in self.expected or path.is_file() and tree_hash(path) != self.expected[name]):
                sys.exit(f"{what}: {name} is not as it should be")

    def killed_at_calls(self, kills):
        """Kills at every k-th call that changes something; later runs are resumed ones."""
        total = self.calls("any")
        step = max(1, -(-total // kills))
        moments = list(range(1, total + 1, step))
        for at in moments:
            shutil.rmtree(self.out, ignore_errors=True)
            self.check(self.failing("any", at, "kill", "--threads", "1"), -9, f"kill at call {at}")
            self.nothing_is_half_there(f"kill at call {at}")
            if at % 3 == 0:  # and once more, while it goes on
                self.failing("any", self.random.randint(1, total), "kill", "--resume")
                self.nothing_is_half_there(f"second kill after call {at}")
            self.goes_on(f"after a kill at call {at} of {total}")
        return len(moments)

    def killed_at_random(self, kills):
        killed = 0
        shutil.rmtree(self.out, ignore_errors=True)
        while killed < kills:
            if self.random.random() < 0.4:
                shutil.rmtree(self.out, ignore_errors=True)
            run = subprocess.Popen([PROGRAM, "batch", "small.toml", "-o", "out", "--resume", "--quiet"], cwd=self.folder)
            try:
                run.wait(timeout=self.random.uniform(0, self.seconds))
            except subprocess.TimeoutExpired:
                run.kill()
            killed += run.wait() == -9
            self.nothing_is_half_there(f"random kill {killed}")
            if self.random.random() < 0.3:
                self.goes_on(f"after random kill {killed}")
        self.goes_on("after all random kills")
        return killed

    def killed_shards(self):
        """A shard and a merge, each killed at some calls, then repeated."""
        for at in (3, 9, 17, 26, 34):
            shutil.rmtree(self.out, ignore_errors=True)
            self.failing("any", at, "kill", "--shard", "1/2")
            self.check(self.batch("--shard", "2/2"), 0, "the other shard")
            self.check(self.batch("--shard", "1/2", "--resume"), 0, "the killed shard")
            pomona(PROGRAM, "merge", "out", folder=self.folder, shim=SHIM, POMONA_FAIL_FOLDER=self.out, POMONA_FAIL_CALL="any",
                   POMONA_FAIL_AT=at - 2, POMONA_FAIL_WITH="kill")
            self.check(pomona(PROGRAM, "merge", "out", folder=self.folder), 0, "merge")
            if tree(self.out) != self.expected:
                sys.exit(f"shard and merge killed at call {at}: differs")
        return 10

    def killed_updates(self, kills):
        """An update that keeps an item, moves one, removes one and makes one, killed at calls; then once more, or resumed."""
        file = self.folder / "small.toml"
        grown = TINY.replace('knives = "half"', 'knives = ["across", "half"]').replace("count = 2", "count = 1")
        file.write_text(grown)
        shutil.rmtree(self.out, ignore_errors=True)
        self.check(self.batch(), 0, "undisturbed")
        before, self.expected = self.expected, tree(self.out)
        shutil.rmtree(self.out)
        file.write_text(TINY)
        self.check(self.batch(), 0, "undisturbed")
        old = self.folder / "old"
        shutil.copytree(self.out, old)
        file.write_text(grown)
        count = self.folder / "count"
        self.check(self.failing("any", 0, "0", "--threads", "1", "--update", count=count), 0, "counting")
        total = int(count.read_text())
        moments = list(range(1, total + 1, max(1, total // kills)))
        for at in moments:
            shutil.rmtree(self.out)
            shutil.copytree(old, self.out)
            self.check(self.failing("any", at, "kill", "--threads", "1", "--update"), -9, f"update killed at call {at}")
            is_new = (self.out / "batch.json").read_bytes() != (old / "batch.json").read_bytes()
            how = "--resume" if is_new and at % 2 else "--update"
            self.check(self.batch(how), 0, f"{how} after an update killed at call {at} of {total}")
            if tree(self.out) != self.expected:
                sys.exit(f"{how} after an update killed at call {at} of {total}: differs")
        file.write_text(TINY)
        self.expected = before
        return len(moments)

    def failing_calls(self):
        """A full disk, a broken one, one that is read-only or beyond its quota: from some call on, each call fails."""
        tried = 0
        for call, errors in (("write", (errno.ENOSPC, errno.EIO, errno.EDQUOT)), ("fsync", (errno.EIO, errno.ENOSPC)),
                             ("close", (errno.EIO, errno.EDQUOT)), ("rename", (errno.EROFS, errno.ENOSPC, errno.EIO)),
                             ("mkdir", (errno.ENOSPC, errno.EROFS)), ("open", (errno.EROFS, errno.EDQUOT))):
            total = self.calls(call)
            for error in errors:
                for at in sorted({1, total // 2, total - 1}):
                    what = f"{call} {at} of {total} fails with {errno.errorcode[error]}"
                    shutil.rmtree(self.out, ignore_errors=True)
                    result = self.failing(call, at, error)
                    forgiven = call in ("fsync", "close") and result.returncode == 0  # of folders and locks
                    if result.returncode not in STATUSES and not forgiven:
                        sys.exit(f"{what}: status {result.returncode}\n{result.stderr}")
                    if not forgiven and "error" not in result.stderr:
                        sys.exit(f"{what}: nothing is said")
                    self.nothing_is_half_there(what)
                    self.goes_on(f"after {what}")
                    tried += 1
        return tried


def tree_hash(path):
    return tree(path.parent)[path.name]


def main():
    with tempfile.TemporaryDirectory(prefix="pomona-test-") as folder:
        stops = Stops(folder)
        print(f"an undisturbed run takes {stops.seconds:.2f} s", flush=True)
        at_calls = stops.killed_at_calls(KILLS // 2)
        print(f"{at_calls} kills at calls: all went on, same bytes", flush=True)
        print(f"{stops.killed_at_random(KILLS - at_calls)} kills at random moments: all went on, same bytes", flush=True)
        print(f"{stops.killed_shards()} kills of shards and merges: same bytes")
        print(f"{stops.killed_updates(KILLS // 4)} kills of updates: same bytes")
        print(f"{stops.failing_calls()} failing calls: documented statuses, nothing damaged, all went on")


if __name__ == "__main__":
    main()
