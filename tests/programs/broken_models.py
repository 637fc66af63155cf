#!/usr/bin/env python3
"""Files that other programs could write wrongly, made from a small right one in systematic ways: each must be refused with its
place and a documented status, or be told by a warning, or read exactly; never crash, hang, or give nothing with status 0.

    broken_models.py PROGRAM [--report FILE] [--check] [--every N] [--only TEXT] [--verbose]

Writes the table into the report, docs/reports/models.md; with --check it changes nothing and fails where the table is not that
of today.
"""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import sys

from broken import glb, judge, obj, ply, svg

BEGIN, END = "<!-- broken_models.py -->", "<!-- end of broken models -->"


def every_case():
    for format in (glb, obj, ply, svg):
        yield from format.cases()


def table_of(verdicts):
    kinds = collections.defaultdict(collections.Counter)
    for case, verdict in verdicts:
        kinds[case.kind][verdict.split()[0]] += 1
    rows = ["| what is broken | files | refused | told by a warning | read exactly |", "|---|--:|--:|--:|--:|"]
    for kind, counts in kinds.items():
        rows.append(f"| {kind} | {counts.total()} | {counts['refused']} | {counts['warned']} | {counts['as']} |")
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--report", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2] / "docs/reports/models.md")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    program = options.program.resolve()
    cases = [case for case in every_case() if options.only in case.kind][::options.every]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        verdicts = list(zip(cases, pool.map(lambda case: judge.judged(program, case), cases)))
    for case, verdict in verdicts:
        if options.verbose or verdict.startswith("fault"):
            print(f"{case.kind}: {case.done}: {verdict}")
    faults = sum(verdict.startswith("fault") for _, verdict in verdicts)
    print(f"{len(cases)} broken files, {faults} not told as they should be")
    if faults or not cases:
        sys.exit(1)
    if options.every == 1 and not options.only:
        keep_table(options.report, table_of(verdicts), options.check)


def keep_table(report, rows, is_check):
    text = report.read_text(encoding="utf-8")
    head, tail = text.split(BEGIN)[0], text.split(END)[1]
    wanted = head + BEGIN + "\n\n" + "\n".join(rows) + "\n\n" + END + tail
    if not is_check:
        report.write_text(wanted, encoding="utf-8")
    elif wanted != text:
        sys.exit(f"{report} is not what is read today: run {sys.argv[0]} PROGRAM")


main()
