"""A copy of the sources that has all faults at once, each behind its number, and is compiled once."""

import json
import re
import shutil
import subprocess
import sys

from .asked_tests import in_turn
from .faults import all_faults, sources
from .places import MUTATED, ROOT
from .results import survivors

PARTS = ("generator", "render", "cli", "shaders", "styles", "templates", "scenes", "cmake", "tests", "bench/baselines",
         "docs", "scripts", "CMakeLists.txt", "CMakePresets.json")

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
set_target_properties(pomona_text pomona_template pomona_variation pomona_knife pomona_piece PROPERTIES UNITY_BUILD_BATCH_SIZE 100)
"""
FOLDERS = {"generator": TOGETHER, "render/export": ""}


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


class FaultyCopy:
    """Lies in a folder of its own; which faults do not compile is kept there."""

    def __init__(self, folder):
        self.work = ROOT / "build" / folder
        self.tree = self.work / "tree"
        self.build = self.tree / "build"
        self.dropped = self.work / "dropped.txt"
        self.work.mkdir(parents=True, exist_ok=True)

    def keep_survivors(self):
        """Notes what has survived so far, which the copy is then made with."""
        put(self.work / "survivors.txt", "".join(f.name + "\n" for f in survivors()))

    def kept_survivors(self):
        """Those that the copy was made with, in the order of their numbers, whatever has been seen since."""
        names = (self.work / "survivors.txt").read_text(encoding="utf-8").split()
        there = {f.name: f for file in sources() for f in all_faults(file)}
        return [there[name] for name in names]

    def numbered(self, faults):
        """Numbers belong to the faults that were drawn, whether they compile or not."""
        dropped = set(self.dropped.read_text().split()) if self.dropped.is_file() else set()
        return [(number, fault) for number, fault in enumerate(faults, 1) if fault.name not in dropped]

    def make(self, faults, options):
        """Looks at the syntax until it is sound, which is quicker than compiling, and compiles what is left."""
        self._copy_tree()
        self._write_sources(faults)
        if not (self.build / "build.ninja").is_file():
            subprocess.run(["cmake", "--preset", "test"], cwd=self.tree, check=True, stdout=subprocess.DEVNULL)
        if not options.unchecked:
            self._drop_what_does_not_compile(faults, options.jobs)
        targets = [f"tests/{folder}/all" for folder in options.tests.split(",") if folder]
        words = ["cmake", "--build", str(self.build), "-j", str(options.jobs)] + (["--target", *targets] if targets else [])
        done = subprocess.run([*words, "--", "-k", "0"], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit("mutants.py: error: what is left does not compile:\n" + done.stdout[-3000:])

    def _copy_tree(self):
        for part in PARTS:
            files = [ROOT / part] if (ROOT / part).is_file() else [p for p in (ROOT / part).rglob("*") if p.is_file()]
            for path in files:
                name = path.relative_to(ROOT)
                is_changed = (path.suffix == ".cpp" and name.as_posix().startswith(tuple(part + "/" for part in MUTATED))
                              or name.as_posix() in {folder + "/CMakeLists.txt" for folder in FOLDERS})
                target = self.tree / name
                if not is_changed and "__pycache__" not in path.parts and (
                        not target.is_file() or target.read_bytes() != path.read_bytes()):
                    target.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy2(path, target)
        put(self.tree / "generator/base/pomona_mutant.h", SWITCH)
        put(self.tree / "generator/base/pomona_mutant.cpp", NOTES)
        for folder, words in FOLDERS.items():
            put(self.tree / folder / "CMakeLists.txt", FLAGS + (ROOT / folder / "CMakeLists.txt").read_text(encoding="utf-8") + words)

    def _write_sources(self, faults):
        by_file = {file: [] for file in sources()}
        for number, fault in self.numbered(faults):
            by_file[fault.file].append((number, fault))
        for file, here in by_file.items():
            put(self.tree / file, with_faults(file, here) if here else (ROOT / file).read_text(encoding="utf-8"))

    def _drop_what_does_not_compile(self, faults, jobs):
        units = json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8"))
        left = [u for u in units if re.search(r"/pomona_\w+\.dir/", u["command"]) and f"{u['file']}".startswith(
            tuple(str(place / part) for place in (self.tree, self.build) for part in MUTATED))]
        while left:
            found = dict(in_turn(lambda unit: (unit["file"], errors_of(unit)), left, jobs))
            left = [unit for unit in left if found[unit["file"]]]
            if left and not self._drop(set().union(*found.values()), faults):
                sys.exit(f"mutants.py: error: no fault is to blame for {sorted(set().union(*found.values()))}")
            self._write_sources(faults)

    def _drop(self, errors, faults):
        """An error drops the faults of its line, or all of its file if its line has none."""
        here = self.numbered(faults)
        bad = {f.name for _, f in here if (f.file, f.line) in errors}
        plain = {file for file, _ in errors} - {f.file for _, f in here if f.name in bad}
        bad |= {f.name for _, f in here if f.file in plain}
        with open(self.dropped, "a") as file:
            file.write("".join(name + "\n" for name in sorted(bad)))
        print(f"{len(bad)} faults do not compile", flush=True)
        return bool(bad)
