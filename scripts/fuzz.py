#!/usr/bin/env python3
"""Runs the fuzzers of tests/fuzz (the preset fuzz), one for each reader.

    fuzz.py build-fuzz --seconds 10             each so long: what CI does
    fuzz.py build-fuzz --runs 10000000          each so often; stop it, and it goes on later where it was
    fuzz.py build-fuzz --runs 1000000 ply glb   these readers alone

Prints a line for each reader: its runs so far, the inputs that made it do something new, what it found. What is new is
kept in out/fuzz/READER, findings in out/fuzz/findings. Ends with 1 if there are any; what made them belongs into
tests/fuzz/corpus/READER when it is mended, where every later run begins with it."""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent
FUZZ = ROOT / "tests" / "fuzz"

# Beside tests/fuzz/corpus/READER every reader begins with files of ours: patterns, and the dictionary.
READERS = {
    "template": (["templates/*.toml", "tests/template/bad/*.toml"], "toml"),
    "sketch": (["templates/*.svg", "tests/template/sketches/*.svg", "tests/template/sketches/bad/*.svg"], "svg"),
    "stroke": (["scenes/*.svg"], "svg"),
    "path": ([], "path"),
    "knife": ([], "knife"),
    "scene": (["scenes/*.toml", "tests/scene/bad/*.toml"], "toml"),
    "style": (["styles/*.toml"], "toml"),
    "batch": (["scenes/*.toml", "tests/batch/bad/*.toml"], "toml"),
    "layout": (["tests/scene/bad/*.json"], "json"),
    "ply": (["tests/surface/bad/*.ply"], "ply"),
    "obj": (["scenes/dishes/*.obj"], "obj"),
    "glb": ([], "glb"),
    "png": ([], None),
}

LONGEST = 1 << 15  # bytes of an input
LIMITS = ["-timeout=10", "-rss_limit_mb=2048", "-malloc_limit_mb=512"]
ENVIRONMENT = {"ASAN_OPTIONS": "detect_stack_use_after_return=1:allocator_may_return_null=0",
               "UBSAN_OPTIONS": "print_stacktrace=1"}


def seeds_of(reader, folder):
    """What every run begins with: our own files, whole, if they are short enough."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    patterns = READERS[reader][0] + [f"tests/fuzz/corpus/{reader}/*"]
    for path in sorted(p for pattern in patterns for p in ROOT.glob(pattern)):
        if path.stat().st_size <= LONGEST:
            shutil.copy(path, folder / f"{path.parent.name}-{path.name}")
    return folder


def run(reader, build, work, wanted):
    """One program: its runs and findings."""
    grown = work / reader
    findings = work / "findings"
    for folder in (grown, findings):
        folder.mkdir(parents=True, exist_ok=True)
    command = [build / "tests" / "fuzz" / f"fuzz_{reader}", *LIMITS, f"-max_len={LONGEST}", "-print_final_stats=1",
               "-verbosity=1", f"-artifact_prefix={findings}/{reader}-", *wanted]
    dictionary = READERS[reader][1]
    if dictionary:
        command.append(f"-dict={FUZZ / 'dictionaries' / dictionary}.dict")
    command += [grown, seeds_of(reader, work / "seeds" / reader)]
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, errors="replace",
                          env={**os.environ, **ENVIRONMENT}, check=False)
    runs = re.search(r"number_of_executed_units: (\d+)", done.stderr)
    crashed = done.returncode != 0
    if crashed:
        (findings / f"{reader}.log").write_text(done.stderr[-20000:], encoding="utf-8")
    return (int(runs.group(1)) if runs else 0), crashed, done.stderr


def fuzz(reader, build, work, options):
    """Runs the reader as long or as often as asked for, in steps that are written down."""
    book = work / f"{reader}.json"
    known = json.loads(book.read_text()) if book.exists() and options.runs else {"runs": 0, "findings": 0}
    begun, made = time.monotonic(), 0
    while True:
        if options.runs:
            left = options.runs - known["runs"]
            wanted = [f"-runs={min(left, 100000)}"]
        else:
            left = options.seconds - (time.monotonic() - begun)
            wanted = [f"-max_total_time={max(1, int(left))}"]
        if left <= 0 or known["findings"]:
            break
        runs, crashed, output = run(reader, build, work, wanted)
        made += runs
        known = {"runs": known["runs"] + runs, "findings": known["findings"] + crashed}
        book.write_text(json.dumps(known))
        if crashed:
            print(output[-3000:], file=sys.stderr)
        if runs == 0 or not options.runs:
            break
    passed = max(time.monotonic() - begun, 1e-3)
    new = len(list((work / reader).iterdir()))
    print(f"{reader:9} {known['runs']:>10} runs {made / passed:>8.0f}/s {new:>6} inputs kept {known['findings']:>3} findings", flush=True)
    return known


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("readers", nargs="*", default=list(READERS))
    parser.add_argument("--seconds", type=int, default=10)
    parser.add_argument("--runs", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "out" / "fuzz")
    options = parser.parse_intermixed_args()  # readers may follow options, as the Makefile has them
    unknown = set(options.readers) - set(READERS)
    if unknown:
        parser.error(f"there is no reader {', '.join(sorted(unknown))}: {', '.join(READERS)}")
    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda r: fuzz(r, options.build.resolve(), options.work, options), options.readers))
    findings = sum(result["findings"] for result in results)
    print(f"{len(results)} readers, {sum(r['runs'] for r in results)} runs, {findings} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
