#!/usr/bin/env python3
"""Does scripts/fuzz.py see a fault where there is one? fuzz_test.py BUILD: asks it of the planted one."""

import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as work:
        command = [ROOT / "scripts" / "fuzz.py", build, "planted", "--seconds", "20", "--work", work]
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
        kept = list(pathlib.Path(work, "findings").glob("planted-crash-*"))
        told = "heap-buffer-overflow" in done.stderr
        if done.returncode != 1 or not kept or not told or kept[0].read_bytes()[:4] != b"SEED":
            print(done.stdout, done.stderr[-3000:], file=sys.stderr)
            sys.exit("fuzz.py did not see the planted fault")
    print("the planted fault was found")


if __name__ == "__main__":
    main()
