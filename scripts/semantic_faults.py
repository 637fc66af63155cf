#!/usr/bin/env python3
"""Seeds faults of meaning and asks the tests whether they see them: a wrong frame, unit, mask, key or order, a value of the item
before. `make mutants` changes operators and constants; these are mistakes that a person makes, each at a place of its own.

    semantic_faults.py list                          the faults, one a line
    semantic_faults.py seed TREE                     puts all of them into a copy of the sources, each behind a switch
    semantic_faults.py show TREE [--only N ...]      starts the tests once without a fault, and once with each
    semantic_faults.py report                        docs/reports/semantic_faults.md, of what was shown

tests/semantic_faults.toml is the table: file, the text before and the text of the fault, its kind, and what a user would get of
it. `seed` writes `(fault_is(N) ? after : before)` in their place, or, of statements, `if (fault_is(N)) {after} else {before}`; the
environment variable POMONA_FAULT chooses one when a program starts, so that one build has them all. In scripts of pages it is the
same, for node. `show` asks the tests of tests/meaning and those that the table names besides; none compares with a golden. A
fault is seen where a test fails that passes without it. What was shown is kept in tests/semantic_faults_shown.tsv.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE, SHOWN, REPORT = (ROOT / name for name in ("tests/semantic_faults.toml", "tests/semantic_faults_shown.tsv",
                                                 "docs/reports/semantic_faults.md"))
HEADER = """#pragma once
#include <cstdlib>
namespace pomona {
inline bool fault_is(int number) {
  static const int chosen = [] { const char* text = std::getenv("POMONA_FAULT"); return text ? std::atoi(text) : 0; }();
  return chosen == number;
}
}  // namespace pomona
"""
SCRIPT_SWITCH = "globalThis.process?.env?.POMONA_FAULT === '{number}'"
LONGEST = 300  # seconds of a test


def faults():
    """The table's rows, numbered from 1 in its order."""
    rows = tomllib.loads(TABLE.read_text(encoding="utf-8"))["fault"]
    return {number: row for number, row in enumerate(rows, 1)}


def switched(number, fault):
    """The text that has both."""
    switch = SCRIPT_SWITCH.format(number=number) if fault["file"].endswith(".js") else f"fault_is({number})"
    before, after = fault["before"], fault["after"]
    if fault.get("statement"):
        return f"if ({switch}) {{ {after} }} else {{ {before} }}"
    return f"({switch} ? ({after}) : ({before}))"


def seed(tree):
    """Rewrites the copy. A text that is not there once is an error: the table follows the sources."""
    (tree / "generator/base/fault_is.h").write_text(HEADER)
    texts = {}
    for number, fault in faults().items():
        name = fault["file"]
        text = texts.get(name) or (tree / name).read_text(encoding="utf-8")
        within = fault.get("within", fault["before"])
        if text.count(within) != 1 or within.count(fault["before"]) != 1:
            sys.exit(f"fault {number}: {name} has {text.count(within)} times\n{within}")
        texts[name] = text.replace(within, within.replace(fault["before"], switched(number, fault)))
    for name, text in texts.items():
        if not name.endswith(".js"):
            text = re.sub(r'^(#include "[^"]+"\n)', r'\1#include "generator/base/fault_is.h"\n', text, count=1, flags=re.M)
        (tree / name).write_text(text, encoding="utf-8")
    print(f"{len(faults())} faults in {len(texts)} files")


def tests_of(tree):
    """Each with its words; what is named in the table beside them."""
    program, meaning, cli = tree / "build/pomona", tree / "tests/meaning", tree / "tests/cli"
    python = [sys.executable, "-B"]
    tests = {name: [*python, meaning / f"{name}_test.py", program, tree] for name in ("exporters", "truth", "units", "batches", "remake")}
    tests["page"] = [*python, meaning / "page_test.py", program, tree]
    tests["studio"] = [*python, cli / "studio_test.py", program, tree / "templates"]
    tests["names"] = [*python, cli / "names_test.py", program, tree]
    tests["batch"] = [*python, cli / "batch/batch_test.py", program, tree]
    return tests


def passes(words, number):
    """Whether the test passes, and how long it took; of one that fails, its first words of why."""
    environment = dict(os.environ)
    environment.pop("POMONA_FAULT", None)
    if number:
        environment["POMONA_FAULT"] = str(number)
    began = time.monotonic()
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, env=environment, timeout=LONGEST, check=False)
    except subprocess.TimeoutExpired:
        return False, LONGEST, "takes too long"
    told = done.stdout + done.stderr
    named = re.findall(r"^(?:FAIL|ERROR): (\w+)", told, re.M)
    return done.returncode == 0, time.monotonic() - began, named[0] if named else ""


def kept():
    """What was shown before: the row of each fault by its place and text."""
    if not SHOWN.exists():
        return {}
    rows = [line.split("\t") for line in SHOWN.read_text(encoding="utf-8").splitlines()[1:]]
    return {row[0]: row[1:] for row in rows}


def key_of(fault):
    return f"{fault['file']}: {fault['kind']}"


def show(tree, only):
    tests = tests_of(tree)
    asked = {number: fault for number, fault in faults().items() if not only or number in only}
    wanted = {name for fault in asked.values() for name in fault["tests"]}
    sound = {name: passes(tests[name], 0) for name in sorted(wanted)}
    for name, (well, seconds, first) in sound.items():
        print(f"{name}: {'passes' if well else 'FAILS ' + first} without a fault, {seconds:.1f} s", flush=True)
    rows = kept()
    for number, fault in asked.items():
        seen, sound_ones = "", [name for name in fault["tests"] if sound[name][0]]
        if not sound_ones:
            print(f"{number}\tnot asked: its tests fail without a fault\t{fault['file']}: {fault['kind']}", flush=True)
            continue
        for name in sound_ones:
            well, _, first = passes(tests[name], number)
            if not well:
                seen = f"{name} {first}".strip()
                break
        rows[key_of(fault)] = [seen or "not seen"]
        print(f"{number}\t{seen or 'NOT SEEN'}\t{fault['file']}: {fault['kind']}", flush=True)
        write_shown(rows)


def write_shown(rows):
    known = [key_of(fault) for fault in faults().values()]
    lines = ["fault\tseen by"] + ["\t".join([key, *rows[key]]) for key in known if key in rows]
    SHOWN.write_text("\n".join(lines) + "\n", encoding="utf-8")


def report():
    rows, groups = kept(), {"ours": "Seeded here", "review": "Seeded by a reviewer, before these tests were written"}
    text = ["# Faults of meaning, and which tests see them", "",
            "`make semantic-faults` writes this page. Each fault is one that a person makes: a wrong frame, unit, mask, key or",
            "order, a value of the item before (`tests/semantic_faults.toml`). They are shown to tests of `tests/meaning` and a few",
            "of `tests/cli`; none of these compares with a golden.", ""]
    for group, title in groups.items():
        chosen = [fault for fault in faults().values() if fault.get("group", "ours") == group]
        if not chosen:
            continue
        seen = [fault for fault in chosen if rows.get(key_of(fault), ["not seen"])[0] != "not seen"]
        text += [f"## {title}: {len(seen)} of {len(chosen)} seen", "", "| file | fault | seen by |", "|---|---|---|"]
        for fault in chosen:
            by = rows.get(key_of(fault), ["not shown"])[0]
            named = by if by.startswith("not ") else "`" + by.replace(" test_", ".test_") + "`"
            text.append(f"| `{fault['file']}` | {fault['kind']} | {named} |")
        text.append("")
    REPORT.write_text("\n".join(text), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("verb", choices=("list", "seed", "show", "report"))
    parser.add_argument("tree", nargs="?", type=pathlib.Path, help="a copy of the sources; built in its folder build")
    parser.add_argument("--only", type=int, nargs="*", default=[])
    options = parser.parse_args()
    if options.verb == "list":
        for number, fault in faults().items():
            print(number, fault["file"], fault["kind"], sep="\t")
    elif options.verb == "report":
        report()
    elif options.tree is None:
        parser.error("which copy of the sources?")
    elif options.verb == "seed":
        seed(options.tree.resolve())
    else:
        show(options.tree.resolve(), set(options.only))


if __name__ == "__main__":
    main()
