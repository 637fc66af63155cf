#!/usr/bin/env python3
"""Runs the fuzzers of tests/fuzz (the preset fuzz), one for each reader.

    fuzz.py build-fuzz --runs 100000 --again    each so often, from the beginning, by the same dice: what CI does
    fuzz.py build-fuzz --runs 10000000          each so often; stop it, and it goes on later where it was
    fuzz.py build-fuzz --runs 1000000 ply glb   these readers alone
    fuzz.py build-fuzz --seconds 10             each so long

--again makes the same inputs whenever the same program runs, so that CI says of a change what it said before it was
pushed. All else is by new dice.

Prints a line for each reader: its runs so far, the inputs that made it do something new, what it found. What is new is
kept in out/fuzz/READER, findings in out/fuzz/findings. Ends with 1 if there are any; what made them belongs into
tests/fuzz/corpus/READER when it is mended, where every later run begins with it. Most
inputs have at most 1 KB, which readers take by thousands a second and in which most of what can be wrong has room; some
have 2 KB. Some have up to 32 KB, and what costs a third of the pace or more is left to these: AddressSanitizer looks for
uses of the stack after a return, and libFuzzer chooses inputs by how rare is what they do, which it counts after every run."""

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
    "template": (["templates/*.toml", "tests/template/good.toml", "tests/template/bad/*.toml"], "toml"),
    "sketch": (["templates/*.svg", "tests/template/sketches/*.svg", "tests/template/sketches/bad/*.svg"], "svg"),
    "stroke": (["scenes/*.svg"], "svg"),
    "path": ([], "path"),
    "knife": ([], "knife"),
    "scene": (["scenes/*.toml", "tests/scene/bad/*.toml"], "toml"),
    "style": (["styles/*.toml"], "toml"),
    "batch": (["scenes/*.toml", "tests/batch/bad/*.toml"], "toml"),
    "data": (["scenes/*.toml"], "toml"),
    "layout": (["tests/scene/bad/*.json"], "json"),
    "ply": (["tests/surface/bad/*.ply"], "ply"),
    "obj": (["scenes/dishes/*.obj"], "obj"),
    "glb": ([], "glb"),
    "png": ([], None),
    "hdr": ([], None),
}

SHORT, MIDDLE, LONGEST = 1 << 10, 1 << 11, 1 << 15  # bytes of an input
ROUND = 800000  # runs; every step of a round first runs all that was kept, so that short ones would do little else
SHARES = ((LONGEST, 0.01), (MIDDLE, 0.19), (SHORT, 0.8))  # of a round, where runs are counted
FEWEST = 20  # runs that every step makes, if it is asked for so many, or the reader takes too long to be fuzzed at all
LIMITS = ["-timeout=10", "-rss_limit_mb=2048", "-malloc_limit_mb=512"]


def sanitizers(longest):
    """What the sanitizers look for beside inputs of that length. To be quick, stacks of allocations are short, and what is
    freed is kept back as long as a run takes, not for hundreds of runs, which would have all memory come from afar."""
    returns = 1 if longest == LONGEST else 0
    return {"ASAN_OPTIONS": f"detect_stack_use_after_return={returns}:allocator_may_return_null=0:malloc_context_size=2:"
                            f"quarantine_size_mb={256 if returns else 16}",
            "UBSAN_OPTIONS": "print_stacktrace=1"}


def seeds_of(reader, folder, longest):
    """What every run begins with: our own files, whole, if they are short enough."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    patterns = READERS.get(reader, ([], None))[0] + [f"tests/fuzz/corpus/{reader}/*"]
    for path in sorted(p for pattern in patterns for p in ROOT.glob(pattern)):
        if path.stat().st_size <= longest:
            shutil.copy(path, folder / f"{path.parent.name}-{path.name}")
    return folder


def files_in(folder):
    return len(list(folder.iterdir()))


def run(reader, build, work, limit, amount, longest, again):
    """One program, with inputs of at most so many bytes: its runs, whether it found something, what it said. Runs of
    what was there before are asked for in addition, and not counted, where runs are."""
    grown = work / reader
    findings = work / "findings"
    for folder in (grown, findings):
        folder.mkdir(parents=True, exist_ok=True)
    seeds = seeds_of(reader, work / "seeds" / reader, longest)
    repeated = files_in(grown) + files_in(seeds) if limit == "-runs" else 0
    command = [build / "tests" / "fuzz" / f"fuzz_{reader}", *LIMITS, f"-max_len={longest}", "-print_final_stats=1",
               "-verbosity=1", f"-entropic={1 if longest == LONGEST else 0}", f"-artifact_prefix={findings}/{reader}-",
               f"{limit}={amount + repeated}"]
    if again:
        command += ["-seed=1", "-reload=0"]  # reading the folder anew once a second would make inputs depend on the time
    dictionary = READERS.get(reader, ([], None))[1]
    if dictionary:
        command.append(f"-dict={FUZZ / 'dictionaries' / dictionary}.dict")
    done = subprocess.run([str(part) for part in [*command, grown, seeds]], capture_output=True, text=True, errors="replace",
                          env={**os.environ, **sanitizers(longest)}, check=False)
    runs = re.search(r"number_of_executed_units: (\d+)", done.stderr)
    crashed = done.returncode != 0
    if crashed:
        (findings / f"{reader}.log").write_text(done.stderr[-20000:], encoding="utf-8")
    return max(0, int(runs.group(1)) - repeated) if runs else 0, crashed, done.stderr


def steps(options, known):
    """What is asked of the program one after the other, and how long its inputs may be."""
    if not options.runs:
        for longest, share in ((SHORT, 0.6), (MIDDLE, 0.3), (LONGEST, 0.1)):
            yield "-max_total_time", max(1, round(share * options.seconds)), longest
        return
    while known["runs"] < options.runs:
        runs = min(ROUND, options.runs - known["runs"])
        for longest, share in SHARES:
            left = options.runs - known["runs"]
            if left > 0:
                yield "-runs", min(left, max(1, round(share * runs))), longest


def fuzz(reader, build, work, options):
    """Runs the reader as long or as often as asked for, in steps that are written down."""
    book = work / f"{reader}.json"
    known = json.loads(book.read_text()) if book.exists() and options.runs else {"runs": 0, "findings": 0}
    begun, made = time.monotonic(), 0
    if options.again:
        known = {"runs": 0, "findings": 0}
        shutil.rmtree(work / reader, ignore_errors=True)
    for limit, amount, longest in steps(options, known):
        if known["findings"]:
            break
        runs, crashed, output = run(reader, build, work, limit, amount, longest, options.again)
        fewest = min(FEWEST, amount) if limit == "-runs" else FEWEST
        if runs < fewest and not crashed:
            crashed, output = True, f"{reader}: {runs} runs in a step ({limit}={amount}), which tries nothing\n{output}"
        made += runs
        known["runs"] += runs
        known["findings"] += crashed
        book.write_text(json.dumps(known))
        if crashed:
            print(output[-3000:], file=sys.stderr)
    passed = max(time.monotonic() - begun, 1e-3)
    new = files_in(work / reader) if (work / reader).exists() else 0
    print(f"{reader:9} {known['runs']:>10} runs {made / passed:>8.0f}/s {new:>6} inputs kept {known['findings']:>3} findings", flush=True)
    return known


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("readers", nargs="*", default=list(READERS))
    parser.add_argument("--seconds", type=int, default=10)
    parser.add_argument("--runs", type=int, default=0)
    parser.add_argument("--again", action="store_true", help="from the beginning, by the same dice")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "out" / "fuzz")
    options = parser.parse_intermixed_args()  # readers may follow options, as the Makefile has them
    unknown = set(options.readers) - set(READERS) - {"planted"}
    if unknown:
        parser.error(f"there is no reader {', '.join(sorted(unknown))}: {', '.join(READERS)}")
    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda r: fuzz(r, options.build.resolve(), options.work, options), options.readers))
    findings = sum(result["findings"] for result in results)
    print(f"{len(results)} readers, {sum(r['runs'] for r in results)} runs, {findings} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
