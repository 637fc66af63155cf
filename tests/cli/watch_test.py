#!/usr/bin/env python3
"""--watch: outputs are made again when any input file changes; errors are printed, and watching goes on.

    watch_test.py PROGRAM TEMPLATES
"""

import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, TEMPLATES = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


def until(what, condition, seconds=30):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            sys.exit(f"{what}: not within {seconds} s")
        time.sleep(0.05)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file in ("cherry.toml", "cherry.svg"):
            shutil.copy(TEMPLATES / file, folder)
        toml, svg, out, told = folder / "cherry.toml", folder / "cherry.svg", folder / "out.stl", folder / "told"
        words = [PROGRAM, "grow", "cherry.toml", "--detail", "0.3", "-o", "out.stl", "--watch"]
        with open(told, "w", encoding="utf-8") as stream:
            watching = subprocess.Popen(words, cwd=folder, stderr=stream)
        try:
            rounds = lambda: told.read_text(encoding="utf-8").count("watching")  # noqa: E731
            until("the first round", lambda: rounds() == 1)
            first = out.read_bytes()

            # The sketch, which the command line does not name: two writes that are one change.
            drawn = svg.read_text(encoding="utf-8")
            scale = drawn.index('label="scale ') + len('label="scale ')
            svg.write_text(drawn[:len(drawn) // 2], encoding="utf-8")
            svg.write_text(drawn[:scale] + "1" + drawn[scale:], encoding="utf-8")
            until("the sketch has changed", lambda: rounds() == 2)
            assert out.read_bytes() != first, "the sketch is not read anew"

            # An error is printed; the outputs stay.
            made = out.read_bytes()
            template = toml.read_text(encoding="utf-8")
            toml.write_text(template + "colour = 1\n", encoding="utf-8")
            until("the mistake", lambda: rounds() == 3)
            assert "error:" in told.read_text(encoding="utf-8") and out.read_bytes() == made

            toml.write_text(template, encoding="utf-8")
            svg.write_text(drawn, encoding="utf-8")
            until("all as before", lambda: rounds() >= 4 and out.read_bytes() == first)
            time.sleep(0.7)
            assert rounds() <= 5, "outputs are made although nothing has changed"
            watching.send_signal(signal.SIGINT)
            assert watching.wait(timeout=10) == -signal.SIGINT
        finally:
            watching.kill()
            watching.wait()
        piped = subprocess.run([PROGRAM, "grow", "cherry.toml", "-o", "-", "--format", "stl", "--watch"], cwd=folder, capture_output=True)
        assert piped.returncode == 64, piped


main()
