#!/usr/bin/env python3
"""Seeds faults into a copy of the program, one at a time, and asks the golden pictures whether they see them.

    golden_mutants.py [NAME...]         all of tests/golden/mutants.toml, or some; results that are still true are not made again
    golden_mutants.py --check           only whether every fault still applies, exactly once
    golden_mutants.py --all-goldens     every golden for every fault, instead of those that the list says catch it

Works in build/golden_mutants. Writes docs/reports/golden_mutants.md when all faults have a result.
Status 1 if a fault goes unseen, or a golden sees none.
"""

import argparse
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tomllib

import golden

ROOT = golden.ROOT
WORK = ROOT / "build" / "golden_mutants"
TREE, BUILD, RESULTS = WORK / "tree", WORK / "tree" / "build", WORK / "results"
PARTS = ("generator", "render", "cli", "shaders", "styles", "templates", "cmake", "tests/golden", "CMakeLists.txt",
         "CMakePresets.json")


def declared_mutants():
    mutants = tomllib.loads((golden.GOLDEN / "mutants.toml").read_text(encoding="utf-8"))["mutant"]
    names = [mutant["name"] for mutant in mutants]
    files = {file for run in golden.declared_runs() for file in run["goldens"]}
    for mutant in mutants:
        if mutant.keys() != {"name", "fault", "file", "find", "replace", "caught_by"} or not mutant["caught_by"]:
            sys.exit(f"mutants.toml: error: {mutant['name']}: name, fault, file, find, replace and caught_by are wanted")
        if names.count(mutant["name"]) > 1 or set(mutant["caught_by"]) - files:
            sys.exit(f"mutants.toml: error: {mutant['name']}: named twice, or caught by what is no golden")
    return mutants


def mutated(mutant, text):
    """The file's text with the fault in it. Raises ValueError unless it applies exactly once."""
    count = text.count(mutant["find"])
    if count != 1:
        raise ValueError(f"{mutant['name']}: {mutant['file']} holds the text to change {count} times, not once")
    return text.replace(mutant["find"], mutant["replace"])


def check_all(mutants):
    wrong = []
    for mutant in mutants:
        try:
            mutated(mutant, (ROOT / mutant["file"]).read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            wrong.append(str(error))
    print("\n".join(wrong) if wrong else f"{len(mutants)} faults apply, each once")
    return 1 if wrong else 0


def key_of(mutant, files, source):
    """Of all that a result depends on."""
    runs = [{**run, "shows": ""} for run in golden.declared_runs() if set(files) & set(run["goldens"])]
    pictures = [hashlib.sha256((golden.GOLDEN / file).read_bytes()).hexdigest() for file in files]
    return hashlib.sha256(json.dumps([mutant, runs, pictures, source]).encode()).hexdigest()


def source_hash():
    """Of the program, and of the fruit and scenes that are drawn."""
    total = hashlib.sha256()
    for part in PARTS:
        for path in sorted(p for p in [ROOT / part, *(ROOT / part).rglob("*")] if p.is_file()):
            if path.parent != ROOT / "tests" / "golden" or path.name.startswith("pile."):
                total.update(path.relative_to(ROOT).as_posix().encode() + b"\0" + path.read_bytes())
    return total.hexdigest()


# Building


def copy_tree():
    """Brings the copy up to date, file by file, so that what did not change is not built again."""
    wanted = set()
    for part in PARTS:
        for path in [ROOT / part] if (ROOT / part).is_file() else (p for p in (ROOT / part).rglob("*") if p.is_file()):
            name = path.relative_to(ROOT)
            wanted.add(name)
            target = TREE / name
            if not target.is_file() or target.read_bytes() != path.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(path, target)
    for path in [p for p in TREE.rglob("*") if p.is_file() and BUILD not in p.parents]:
        if path.relative_to(TREE) not in wanted:
            path.unlink()


def build():
    if not (BUILD / "build.ninja").is_file():
        subprocess.run(["cmake", "--preset", "program"], cwd=TREE, check=True, stdout=subprocess.DEVNULL)
    done = subprocess.run(["cmake", "--build", str(BUILD), "--target", "pomona", "-j", str(os.cpu_count())],
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError("it does not compile:\n" + done.stdout[-3000:])


# Judging


def judge(mutant, files, comparer):
    """{golden: figures} of the faulty program."""
    found = {}
    for run in golden.declared_runs():
        if set(files) & set(run["goldens"]):
            figures = golden.check_run(run, BUILD / "pomona", WORK / "drawn" / mutant["name"], comparer)
            found.update({file: figures[file] for file in run["goldens"]})
    return found


def try_out(mutant, files, comparer):
    target = TREE / mutant["file"]
    sound = target.read_text(encoding="utf-8")
    try:
        target.write_text(mutated(mutant, sound), encoding="utf-8")
        build()
        return judge(mutant, files, comparer)
    except RuntimeError as error:
        sys.exit(f"golden_mutants.py: error: {mutant['name']}: {error}")
    finally:
        target.write_text(sound, encoding="utf-8")


def by_how_much(figures):
    if "lines" in figures:
        return f"{figures['lines']} lines"
    if "flip" not in figures or not figures["pixels"]:
        return figures["reasons"][0].splitlines()[0].replace("|", "/")
    return f"{figures['flip']:.4f}, {figures['largest']}, {100 * figures['different'] / figures['pixels']:.1f} %"


def failures(result):
    return {file: figures for file, figures in result.items() if not figures["same"]}


# Reporting


def write_report(mutants, results):
    lines = ["# Faults that goldens see", "",
             "`make golden-mutants` writes this page. `tests/golden/mutants.toml` describes the faults,",
             "[golden.md](../guides/golden.md) the goldens.", "",
             f"{len(mutants)} faults, {sum(bool(failures(results[m['name']])) for m in mutants)} seen.", "",
             "| fault | in | seen by | mean FLIP |", "|---|---|---|---|"]
    for mutant in mutants:
        seen = failures(results[mutant["name"]])
        by = "<br>".join(seen) or "**nothing**"
        much = "<br>".join(by_how_much(figures).split(",")[0] for figures in seen.values())
        lines.append(f"| {mutant['name']} | {mutant['file']} | {by} | {much} |")
    (ROOT / "docs" / "reports" / "golden_mutants.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


def verdict(mutants, results):
    """1 if a fault goes unseen by what should see it, or a golden sees no fault."""
    bad = 0
    for mutant in mutants:
        blind = set(mutant["caught_by"]) - set(failures(results[mutant["name"]]))
        if blind:
            print(f"{mutant['name']}: NOT SEEN by {', '.join(sorted(blind))}")
            bad = 1
    seen = {file for result in results.values() for file in failures(result)}
    for run in golden.declared_runs():
        for file in run["goldens"]:
            if file not in seen:
                print(f"{file}: sees no fault")
                bad = 1
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--all-goldens", action="store_true")
    asked = parser.parse_args()
    mutants = declared_mutants()
    if asked.check:
        return check_all(mutants)
    if check_all(mutants):
        return 1

    RESULTS.mkdir(parents=True, exist_ok=True)
    copy_tree()
    golden.GOLDEN = TREE / "tests" / "golden"  # whatever happens to the tree meanwhile
    build()
    sound = WORK / "pomona-sound"  # compares, so that no fault can hide itself
    shutil.copy2(BUILD / "pomona", sound)
    source = source_hash()
    every = sorted(file for run in golden.declared_runs() for file in run["goldens"])
    results = {}
    for mutant in mutants:
        files = every if asked.all_goldens else mutant["caught_by"]
        key, kept = key_of(mutant, files, source), RESULTS / (mutant["name"] + ".json")
        old = json.loads(kept.read_text()) if kept.is_file() else {}
        if old.get("key") != key:
            if asked.names and mutant["name"] not in asked.names:
                continue
            old = {"key": key, "result": try_out(mutant, files, sound)}
            kept.write_text(json.dumps(old))
        results[mutant["name"]] = old["result"]
        seen = failures(old["result"])
        print(f"{mutant['name']}: " + ("; ".join(f"{f} ({by_how_much(x)})" for f, x in seen.items()) or "NOT SEEN"),
              flush=True)
    if len(results) < len(mutants):
        print(f"{len(results)} of {len(mutants)} faults have a result")
        return 0
    write_report(mutants, results)
    return verdict(mutants, results)


if __name__ == "__main__":
    sys.exit(main())
