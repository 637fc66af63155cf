#!/usr/bin/env python3
"""Changes the generator and its exporters by itself, one small fault at a time, and asks the tests whether they see it.

    mutants.py list [--count N] [--only PATH]        the faults, one a line
    mutants.py make [...]                            compiles them all at once; drops those that do not compile
    mutants.py map                                   which test reaches which fault, and what each test costs
    mutants.py show [...] [--seconds S]              shows each fault to the tests that reach it; goes on where it was stopped
    mutants.py report                                what was seen, folder by folder, and what survived: docs/mutants.md
    mutants.py make|map|show --survivors [--asked T] the same for what survived alone, in build/mutants_survivors: a matter of
                                                     minutes, with the tests written for it

Faults are turned comparisons, signs and conditions, other constants, limits that are left out, arguments that change
places, statements that are missing. They are drawn with a fixed seed from all sources (.cpp) of `generator` and
`render/export`, from each file in proportion to its lines. All of them are compiled into one copy of the sources, each
behind `(pomona_fault(K) ? faulty : sound)`; the environment variable POMONA_MUTANT chooses one when a program starts.

Asked are the GoogleTest tests that ctest knows, those that start the program among them. Golden pictures, tests by
other programs, scripts and published hashes are not. Each test first runs once without a fault, by itself, and notes
which faults' places it comes by (POMONA_MUTANT_MAP). A fault is then shown to those tests alone, the cheap ones first,
until one fails; to a test that does not come by its place it changes nothing. A test also sees a fault when it crashes,
or takes more than four times its usual processor time and ten seconds, or more than 6 GB. tests/mutants.toml says of
survivors why nothing can see them. Works in build/mutants; what was shown is kept in tests/mutants_shown.tsv.
"""

import argparse
import hashlib
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tomllib

import mutant_tests

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "tests" / "mutants_shown.tsv"
MUTATED = ("generator", "render/export")
PARTS = ("generator", "render", "cli", "shaders", "styles", "templates", "scenes", "cmake", "tests", "bench/baselines",
         "docs", "scripts", "CMakeLists.txt", "CMakePresets.json")
SEED = 18

SWITCH = '''// Whether this run has the fault of a number, and a note that it came by.
#pragma once

#include <cstdlib>

unsigned char* pomona_reached_places();

inline unsigned char* const pomona_reached = pomona_reached_places();
inline const int pomona_mutant = [] {
  const char* text = std::getenv("POMONA_MUTANT");
  return text == nullptr ? 0 : std::atoi(text);
}();

inline bool pomona_fault(int number) {
  if (pomona_reached != nullptr) pomona_reached[number] = 1;
  return pomona_mutant == number;
}
'''

# The notes are a file that all processes of a test share, so that they outlive a crash.
NOTES = '''#include <fcntl.h>
#include <sys/mman.h>

#include <cstdlib>

unsigned char* pomona_reached_places() {
  const char* path = std::getenv("POMONA_MUTANT_MAP");
  const int file = path == nullptr ? -1 : open(path, O_RDWR | O_CLOEXEC);
  if (file < 0) return nullptr;
  void* const notes = mmap(nullptr, 65536, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  return notes == MAP_FAILED ? nullptr : static_cast<unsigned char*>(notes);
}
'''

# Where faults are, and there alone: what is odd about one need not keep it from compiling, less is optimised, and all
# sources of a folder are compiled together, where no two of them name things alike.
FLAGS = "add_compile_options(-O1 -w -Wno-narrowing)\n"
TOGETHER = """
target_sources(pomona_base PRIVATE ${PROJECT_SOURCE_DIR}/generator/base/pomona_mutant.cpp)
set_target_properties(pomona_template pomona_variation pomona_knife pomona_piece PROPERTIES UNITY_BUILD_BATCH_SIZE 100)
"""
FOLDERS = {"generator": TOGETHER, "render/export": ""}


def work_in(folder):
    """Where the copy is, and what was found out about it."""
    global WORK, TREE, BUILD, DROPPED
    WORK = ROOT / "build" / folder
    TREE, BUILD, DROPPED = WORK / "tree", WORK / "tree" / "build", WORK / "dropped.txt"
    WORK.mkdir(parents=True, exist_ok=True)


# ---- Finding places ----


def blanked(text):
    """The same text, character for character, with comments, literals and preprocessor lines made blank."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#[^\n]*', re.S | re.M)
    return pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group(0)), text)


OPENING, CLOSING = "([{", ")]}"
# Where an expression of this operator ends, to the left and to the right, unless inside brackets.
LOOSER = {"logic": r"[,;?]|(?<!:):(?!:)|(?<![=!<>+\-*/|&^%])=(?!=)|<<|>>|\breturn\b|[-+*/|&]=", "order": r"&&|\|\|", "sum": r"[<>]=?|[=!]="}
ENDS = {
    "logic": re.compile(LOOSER["logic"]),
    "order": re.compile("|".join((LOOSER["logic"], LOOSER["order"]))),
    "sum": re.compile("|".join((LOOSER["logic"], LOOSER["order"], LOOSER["sum"], r"[+\-*/%|&^]="))),
}


def edge(line, places, brackets, other):
    """The first place, of these, that lies outside the brackets the walk began in."""
    depth = 0
    for i in places:
        if line[i] in other:
            depth += 1
        elif line[i] in brackets:
            if depth == 0:
                return i
            depth -= 1
    return None


def extent(line, at, length, kind):
    """Where the expression around an operator begins and ends; none where it does not lie within the line."""
    opening, closing = edge(line, range(at - 1, -1, -1), OPENING, CLOSING), edge(line, range(at + length, len(line)), CLOSING, OPENING)
    begin, end = 0 if opening is None else opening + 1, len(line) if closing is None else closing
    flat, depth = "", 0  # the same with the insides of brackets blank
    for c in line[begin:end]:
        depth -= c in CLOSING
        flat += " " if depth > 0 else c
        depth += c in OPENING
    ends = [(begin + found.start(), begin + found.end()) for found in ENDS[kind].finditer(flat)]
    left = max((after for _, after in ends if after <= at), default=None if opening is None else begin)
    right = min((before for before, _ in ends if before >= at + length), default=None if closing is None else end)
    if left is None or right is None:
        return None
    inside = line[left:right]
    left += len(inside) - len(inside.lstrip())
    return left, left + len(inside.strip())


def arguments(line, opening):
    """Begins and ends of the arguments of a call, and where it closes; none where that is not in this line."""
    depth, begin, found = 0, opening + 1, []
    for i in range(opening, len(line)):
        if line[i] in OPENING:
            depth += 1
        elif line[i] in CLOSING:
            depth -= 1
            if depth == 0:
                return found + [(begin, i)], i
        elif line[i] == "," and depth == 1:
            found.append((begin, i))
            begin = i + 2
    return None


TURNED = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ",
          " && ": " || ", " || ": " && ", " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * "}
KINDS = {" && ": "logic", " || ": "logic", " + ": "sum", " - ": "sum", " * ": "sum", " / ": "sum"}
SYMMETRIC = {"dot", "distance", "min", "max", "static_cast", "if", "for", "while", "switch", "assert", "lerp", "hypot", "minmax"}


def other_constant(text):
    if re.fullmatch(r"\d+u?", text):
        return {"0": "1", "1": "2"}.get(text, str(int(text.rstrip("u")) + 1) + ("u" if text.endswith("u") else ""))
    return f"(2 * {text} + (({text}) == 0 ? 1 : 0))"


def candidates(line):
    """(kind, begin, end, what stands there in the fault) for each thing that can go wrong in a line without comments."""
    for operator, other in TURNED.items():
        for found in re.finditer(re.escape(operator), line):
            span = extent(line, found.start(), len(operator), KINDS.get(operator, "order"))
            if span and span[0] < found.start() < span[1]:
                whole = line[span[0]:span[1]]
                at = found.start() - span[0]
                yield "operator", *span, whole[:at] + other + whole[at + len(operator):]
    for found in re.finditer(r"(?<![\w.])(\d+\.\d*(?:e-?\d+)?f?|\d+e-?\d+|\d+u?)(?![\w.'])", line):
        yield "constant", *found.span(), other_constant(found.group(0))
    for found in re.finditer(r"\b(?:if|while) \(", line):
        whole = arguments(line, found.end() - 1)
        if whole and len(whole[0]) == 1 and ";" not in line[slice(*whole[0][0])] and " = " not in line[slice(*whole[0][0])]:
            yield "condition", *whole[0][0], "!(" + line[slice(*whole[0][0])] + ")"
    for found in re.finditer(r"std::(min|max|clamp)\(", line):
        whole = arguments(line, found.end() - 1)
        if whole and len(whole[0]) in (2, 3):
            yield "limit", found.start(), whole[1] + 1, "(" + line[slice(*whole[0][0])] + ")"
    for found in re.finditer(r"(?:(?<=return )|(?<=[^\w>] )|(?<=[(\[!.]))([a-z]\w*)\((?=[^)])", line):
        whole = arguments(line, found.end() - 1)
        if whole and len(whole[0]) == 2 and found.group(1) not in SYMMETRIC:
            first, second = (line[slice(*span)] for span in whole[0])
            if first.strip() != second.strip() and not re.search(r"\bconst\b|&\s*\w+$", first):
                yield "arguments", found.start(), whole[1] + 1, f"{found.group(1)}({second.strip()}, {first.strip()})"
    for found in re.finditer(r"(?:(?<=[(\[])|(?<=[,=?:] )|(?<=return ))-(?=[\w(])", line):
        operand = re.match(r"-(?:[\w.:]+|\([^()]*\))(?:\([^()]*\))?", line[found.start():])
        if operand and not re.match(r"-\d", operand.group(0)):
            yield "sign", found.start(), found.start() + operand.end(), operand.group(0)[1:]
    found = re.fullmatch(r"(\s+)((?:[\w\]\[.()]|->)+ (?:[-+*/|]?=) .*;|(?:std::(?:sort|reverse)|\w+\.(?:push_back|insert|erase))\(.*\);)\s*", line)
    if found and not found.group(2).startswith(("return", "const", "auto")):
        yield "statement", found.start(2), found.end(2), None


def sources():
    files = [path for part in MUTATED for path in (ROOT / part).rglob("*.cpp")]
    return sorted(file.relative_to(ROOT).as_posix() for file in files)


class Fault:
    def __init__(self, file, line, kind, begin, end, text, sound):
        self.file, self.line, self.kind, self.begin, self.end, self.text, self.sound = file, line, kind, begin, end, text, sound
        words = "\0".join((file, kind, sound, text or "", str(begin)))
        self.name = hashlib.sha256(words.encode()).hexdigest()[:10]

    def told(self):
        return f"{self.file}:{self.line}: `{self.sound.strip()}` -> " + (f"`{self.text.strip()}`" if self.text else "left out")


def all_faults(file):
    """All candidates of a file, those of one line in turn; lines of constants that a compiler must know are left alone."""
    text = (ROOT / file).read_text(encoding="utf-8")
    for number, (line, raw) in enumerate(zip(blanked(text).splitlines(), text.splitlines()), 1):
        if re.search(r"\b(static_assert|template|case|enum|using|constexpr \w+ \w+\()", line) or re.match(r"\S", line) and not line.startswith("constexpr"):
            continue
        if re.match(r"\s*(?:static )?constexpr", line) and not re.match(r"\s*(?:static )?constexpr (?:double|float) \w+ = [^,]*;", line):
            continue
        for kind, begin, end, faulty in candidates(line):
            # Literals come back from the line as it is; where the fault moves them about it is left out.
            if '"' in raw[begin:end] and kind in ("arguments",):
                continue
            sound = raw[begin:end]
            if faulty is not None and sound != line[begin:end]:
                continue
            yield Fault(file, number, kind, begin, end, faulty, sound)


def drawn(count):
    """The same faults as long as the sources are the same: from each file in proportion to its lines, one a line."""
    files = sources()
    lines = {file: len((ROOT / file).read_text(encoding="utf-8").splitlines()) for file in files}
    total, owed, chosen = sum(lines.values()), 0.0, []
    for file in files:
        owed += count * lines[file] / total
        stream = random.Random(f"{SEED} {file}")
        by_kind = {}
        for fault in all_faults(file):
            by_kind.setdefault(fault.kind, []).append(fault)
        taken = set()
        while owed >= 1 and by_kind:
            kind = stream.choice(sorted(by_kind))
            fault = by_kind[kind].pop(stream.randrange(len(by_kind[kind])))
            if not by_kind[kind]:
                del by_kind[kind]
            # Two like lines of a file have like faults, of one name.
            if fault.line not in taken and fault.name not in taken:
                taken |= {fault.line, fault.name}
                chosen.append(fault)
                owed -= 1
    return chosen


# ---- Compiling ----


def with_faults(file, faults):
    """The file's text with all its faults in it, each behind its number; as many lines as before, after the first."""
    lines = (ROOT / file).read_text(encoding="utf-8").split("\n")
    for number, fault in faults:
        line = lines[fault.line - 1]
        if fault.text is None:
            new = f"if (!pomona_fault({number})) {{ {fault.sound} }}"
        else:
            sound = f"!!({fault.sound})" if fault.kind == "condition" else f"({fault.sound})"
            new = f"(pomona_fault({number}) ? ({fault.text}) : {sound})"
        line = line[:fault.begin] + new + line[fault.end:]
        lines[fault.line - 1] = re.sub(r"^(\s*)(?:static )?constexpr (double|float) ", r"\1static const \2 ", line)
    return '#include "generator/base/pomona_mutant.h"\n#line 1\n' + "\n".join(lines)


def put(path, text):
    """Leaves a file that is so already alone, so that it is not compiled again."""
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def copy_tree():
    for part in PARTS:
        files = [ROOT / part] if (ROOT / part).is_file() else [p for p in (ROOT / part).rglob("*") if p.is_file()]
        for path in files:
            name = path.relative_to(ROOT)
            is_changed = (path.suffix == ".cpp" and name.as_posix().startswith(tuple(part + "/" for part in MUTATED))
                          or name.as_posix() in {folder + "/CMakeLists.txt" for folder in FOLDERS})
            target = TREE / name
            if not is_changed and "__pycache__" not in path.parts and (
                    not target.is_file() or target.read_bytes() != path.read_bytes()):
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, target)
    put(TREE / "generator/base/pomona_mutant.h", SWITCH)
    put(TREE / "generator/base/pomona_mutant.cpp", NOTES)
    for folder, words in FOLDERS.items():
        put(TREE / folder / "CMakeLists.txt", FLAGS + (ROOT / folder / "CMakeLists.txt").read_text(encoding="utf-8") + words)


def numbered(faults):
    """Numbers belong to the faults that were drawn, whether they compile or not."""
    dropped = set(DROPPED.read_text().split()) if DROPPED.is_file() else set()
    return [(number, fault) for number, fault in enumerate(faults, 1) if fault.name not in dropped]


def asked_for(faults, options):
    """Those of the files that the options name, in an order that any first part of is spread over all of them."""
    only = tuple(options.only.split(","))
    return sorted(((n, f) for n, f in numbered(faults) if f.file.startswith(only)), key=lambda one: one[1].name)


def survivors():
    """What survived and is not said to be no fault, whether it is drawn yet or not, as long as it is found in its file."""
    results, known = read_results(), reasons()
    found = [f for file in sources() for f in all_faults(file) if results.get(f.name, ("",))[0] == "survived" and not why(f, known)]
    return list({f.name: f for f in found}.values())


def compiled_survivors():
    """Those that the copy was made with, in the order of their numbers, whatever has been seen since."""
    names = (WORK / "survivors.txt").read_text(encoding="utf-8").split()
    there = {f.name: f for file in sources() for f in all_faults(file)}
    return [there[name] for name in names]


def write_sources(faults):
    by_file = {file: [] for file in sources()}
    for number, fault in numbered(faults):
        by_file[fault.file].append((number, fault))
    for file, here in by_file.items():
        put(TREE / file, with_faults(file, here) if here else (ROOT / file).read_text(encoding="utf-8"))


def errors_of(unit):
    """The places (file, line) that a unit of the build names in errors, when its syntax alone is looked at."""
    words = re.sub(r"^.*?ccache ", "", unit["command"])
    words = re.sub(r" -o \S+", "", re.sub(r" -M\S+( \S+\.(o|d))?", "", words)) + " -fsyntax-only -fmax-errors=0"
    done = subprocess.run(words, shell=True, cwd=unit["directory"], capture_output=True, text=True)
    found = {(m.group(1), int(m.group(2))) for m in re.finditer(
        r"((?:generator|render)/[\w/]+\.cpp):(\d+):(?:\d+:)? (?:error|.*required from)", done.stderr)}
    if done.returncode != 0 and not found:
        sys.exit("mutants.py: error: this does not compile:\n" + done.stderr[-3000:])
    return found


def drop(errors, faults):
    """An error drops the faults of its line, or all of its file if its line has none."""
    here = numbered(faults)
    bad = {f.name for _, f in here if (f.file, f.line) in errors}
    plain = {file for file, _ in errors} - {f.file for _, f in here if f.name in bad}
    bad |= {f.name for _, f in here if f.file in plain}
    with open(DROPPED, "a") as file:
        file.write("".join(name + "\n" for name in sorted(bad)))
    print(f"{len(bad)} faults do not compile", flush=True)
    return bool(bad)


def compile_all(faults, options):
    """Looks at the syntax until it is sound, which is quicker than compiling, and compiles what is left."""
    copy_tree()
    write_sources(faults)
    if not (BUILD / "build.ninja").is_file():
        subprocess.run(["cmake", "--preset", "test"], cwd=TREE, check=True, stdout=subprocess.DEVNULL)
    units = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    left = [u for u in units if re.search(r"/pomona_\w+\.dir/", u["command"]) and f"{u['file']}".startswith(
        tuple(str(place / part) for place in (TREE, BUILD) for part in MUTATED))]
    while left and not options.unchecked:
        found = dict(mutant_tests.in_turn(lambda unit: (unit["file"], errors_of(unit)), left, options.jobs))
        left = [unit for unit in left if found[unit["file"]]]
        if left and not drop(set().union(*found.values()), faults):
            sys.exit(f"mutants.py: error: no fault is to blame for {sorted(set().union(*found.values()))}")
        write_sources(faults)
    targets = [f"tests/{folder}/all" for folder in options.tests.split(",") if folder]
    words = ["cmake", "--build", str(BUILD), "-j", str(options.jobs)] + (["--target", *targets] if targets else [])
    done = subprocess.run([*words, "--", "-k", "0"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("mutants.py: error: what is left does not compile:\n" + done.stdout[-3000:])


# ---- Showing ----


def read_results():
    lines = RESULTS.read_text(encoding="utf-8").splitlines() if RESULTS.is_file() else []
    return {line.split("\t")[0]: line.split("\t")[1:] for line in lines}


def tests_to_ask(options):
    return [test for test in mutant_tests.tests_of(BUILD) if re.search(options.asked, test.name)]


def map_all(faults, options):
    """Notes for each test that was not noted yet which faults it reaches, by their names."""
    names = {number: fault.name for number, fault in enumerate(faults, 1)}
    mutant_tests.note_all(tests_to_ask(options), WORK, names, options)


def show_all(faults, options):
    """A line in the results for each fault that has none; those that survived are asked again where they may be seen now."""
    tests, done = mutant_tests.noted(tests_to_ask(options), WORK), read_results()
    wanted = [(n, f) for n, f in asked_for(faults, options) if f.name not in done or options.survivors]

    def shown(one):
        number, fault = one
        seen, asked, reaching = mutant_tests.show(number, fault.name, fault.file, tests, WORK, options.seconds)
        if not seen and fault.name in done and asked <= int(done[fault.name][2].split("/")[0]):
            print(f"{number}\tsurvived these, too\t{asked}/{reaching}\t{fault.told()}", flush=True)
            return  # it has been shown to more
        state = "seen" if seen else "survived"
        told = f"{state}\t{seen}\t{asked}/{reaching}\t{fault.told()}"
        with open(RESULTS, "a", encoding="utf-8") as file:
            file.write(f"{fault.name}\t{told}\n")
        print(f"{number}\t{told}", flush=True)

    mutant_tests.in_turn(shown, wanted, options.jobs)


# ---- Reporting ----


def reasons(kind="equivalent"):
    """What tests/mutants.toml says of survivors: why nothing can see them, or (unseen) why nothing does."""
    path = ROOT / "tests" / "mutants.toml"
    return tomllib.loads(path.read_text(encoding="utf-8")).get(kind, []) if path.is_file() else []


def first_figures():
    """What was seen before tests were added for survivors, as tests/mutants.toml says; the results themselves know only the last."""
    path = ROOT / "tests" / "mutants.toml"
    told = tomllib.loads(path.read_text(encoding="utf-8")).get("first", []) if path.is_file() else []
    return [r.get("text") or f"At first {r['seen']} of {r['shown']} faults of `{r['folder']}` were seen; tests were added for what survived, and the "
            "table is what they see now." for r in told]


def why(fault, known):
    """Constants are alike in many lines: what tests/mutants.toml says of one goes by the fault's name."""
    found = [r["why"] for r in known if (r["file"], r["sound"], r.get("fault", "")) == (fault.file, fault.sound.strip(), (fault.text or "").strip())
             and r.get("name", fault.name) == fault.name]
    return found[0] if found else ""


def folder_of(file):
    return "/".join(file.split("/")[:2])


def report(faults):
    results, known, told = read_results(), reasons(), reasons("unseen")
    # A change of some source moves what is drawn; what was shown counts as long as it can be found in its file.
    there = {f.name: f for file in sources() for f in all_faults(file)} | {f.name: f for f in faults}
    judged = sorted(((there[name], result) for name, result in results.items() if name in there), key=lambda one: (one[0].file, one[0].line))
    survived = [(f, r) for f, r in judged if r[0] != "seen"]
    excused = [f for f, _ in survived if why(f, known)]
    not_shown = sum(f.name not in results for f in faults)
    seen, could = len(judged) - len(survived), len(judged) - len(excused)
    of = {file: sum(f.file == file for f, _ in judged) for file in {f.file for f, _ in judged}}
    lines = ["# Mutants", "",
             "Faults that a tool has put into the sources, and whether tests other than goldens see them. `make mutants` writes this page. "
             + " ".join(__doc__.split("\n\n")[2:]).replace("\n", " ").strip(), "",
             f"{len(faults)} faults are drawn; {not_shown} of them have not been shown, for they do not compile, or are drawn anew since sources "
             f"changed. {len(judged)} have been shown, those that are no longer drawn but still found in their files among them, in "
             f"{len(of)} of {len(sources())} files: {seen} were seen, {len(survived)} survived, of which {len(excused)} change nothing "
             f"that could be seen. That is {100 * seen / max(1, could):.1f} % of the {could} that could be seen, or {100 * seen / max(1, len(judged)):.1f} % of all.",
             "", *[line for first in first_figures() for line in (first, "")],
             "| folder | faults | seen | survived | that could be seen |", "|---|--:|--:|--:|--:|"]
    for folder in sorted({folder_of(file) for file in of}):
        here = [(f, r) for f, r in judged if folder_of(f.file) == folder]
        left = [f for f, r in here if r[0] != "seen"]
        lines.append(f"| {folder} | {len(here)} | {len(here) - len(left)} | {len(left) or ''} | {sum(not why(f, known) for f in left) or ''} |")
    lines += ["", "Survivors. \"Asked\" is how many tests it was shown to, of those that come by its place.", "", "| fault | asked | why |", "|---|--:|---|"]
    lines += [f"| {f.told().replace('|', chr(92) + '|')} | {r[2].replace('/', ' of ')} | {why(f, known) or untold(r[2]) + ' ' + why(f, told)} |" for f, r in survived]
    (ROOT / "docs" / "mutants.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(lines[4])


def untold(asked):
    return "**no test comes by**" if asked.endswith("/0") else "**not seen**"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("verb", choices=("list", "make", "map", "show", "report"))
    parser.add_argument("--count", type=int, default=460, help="how many are drawn; some of them will not compile")
    parser.add_argument("--only", default="", help="show only files whose path begins so; several with commas between")
    parser.add_argument("--survivors", action="store_true",
                        help="those alone that survived, and are not said to be no faults: in a copy of its own, build/mutants_survivors")
    parser.add_argument("--seconds", type=float, default=1e9, help="of processor time after which a fault is shown to no further tests")
    parser.add_argument("--again", default="", help="tests that are noted once more, as a regular expression")
    parser.add_argument("--asked", default="", help="note and ask only tests of these names, a regular expression: new ones, for survivors")
    parser.add_argument("--tests", default="", help="make only the tests of these folders, with commas between; only they are asked then")
    parser.add_argument("--unchecked", action="store_true", help="what is left is known to compile")
    parser.add_argument("--longest", type=float, default=300, help="of processor time that a test may take without a fault, to be asked at all")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    work_in("mutants_survivors" if options.survivors else "mutants")
    if options.survivors and options.verb == "make":
        (WORK / "survivors.txt").write_text("".join(f.name + "\n" for f in survivors()), encoding="utf-8")
    faults = drawn(options.count) if not options.survivors else survivors() if options.verb == "list" else compiled_survivors()
    if options.verb == "list":
        for number, fault in enumerate(faults, 1):
            if fault.file.startswith(tuple(options.only.split(","))):
                print(number, fault.kind, fault.told())
    elif options.verb == "make":
        compile_all(faults, options)
        print(f"{len(numbered(faults))} faults compile")
    elif options.verb == "map":
        map_all(faults, options)
    elif options.verb == "show":
        show_all(faults, options)
    else:
        report(faults)
    return 0


if __name__ == "__main__":
    sys.exit(main())
