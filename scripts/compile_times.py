#!/usr/bin/env python3
"""Where the compiler's time goes.

    compile_times.py log [BUILD]              seconds and objects by folder, and the ten slowest objects
    compile_times.py headers [BUILD] NAME...  seconds to read each header alone, and how many sources include it

`log` reads the .ninja_log of a build made from nothing with an empty ccache or none (CCACHE_DISABLE=1). A second is
one of the wall clock: on a machine that does nothing else it is one of a core. `headers` compiles an empty source
that includes the header, with the flags of the first source of the build, and asks ninja who depends on it.
"""

import argparse
import collections
import json
import pathlib
import resource
import shlex
import subprocess
import tempfile


def folder_of(output):
    """generator/cut/CMakeFiles/pomona_cut.dir/pieces.cpp.o lies in generator/cut; what is no object is linked."""
    return output.split("/CMakeFiles/")[0] if output.endswith((".o", ".gch", ".pch")) else "links, archives"


def times_in(log):
    """Output -> seconds, of the last time it was made."""
    lines = [line.split("\t") for line in log.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return {output: (int(end) - int(start)) / 1000 for start, end, _, output, _ in lines if "cmake" not in output.split("/")[-1]}


def print_log(build):
    """The table by folder, then the slowest objects."""
    times = times_in(build / ".ninja_log")
    seconds, objects = collections.Counter(), collections.Counter()
    for output, time in times.items():
        seconds[folder_of(output)] += time
        objects[folder_of(output)] += 1
    print(f"| folder | seconds | objects |\n|---|--:|--:|\n| all | {sum(seconds.values()):.0f} | {len(times)} |")
    for folder, time in seconds.most_common():
        print(f"| {folder} | {time:.0f} | {objects[folder]} |")
    print("\n| slowest | seconds |\n|---|--:|")
    for output, time in sorted(times.items(), key=lambda entry: -entry[1])[:10]:
        print(f"| {output.split('/CMakeFiles/')[0]}/{output.split('.dir/')[-1]} | {time:.1f} |")


def user_seconds(command, folder):
    """Of one command, its children included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, cwd=folder, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def print_headers(build, names):
    """Of each header: how long it alone takes, and how many objects read it."""
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    words = [shlex.split(entry["command"].replace("-isystem ", "-isystem")) for entry in commands]
    folders = sorted({word for line in words for word in line if word.startswith(("-I", "-isystem"))})
    compiler = next(word for word in words[0] if word.endswith("++"))
    deps = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout.split("\n\n")
    print("| header | seconds to read | objects that read it |\n|---|--:|--:|")
    for name in names:
        with tempfile.NamedTemporaryFile("w", suffix=".cpp") as source:
            source.write(f"#include <{name}>\n")
            source.flush()
            time = user_seconds([compiler, "-std=c++20", "-fsyntax-only", *folders, source.name], build)
        print(f"| {name} | {time:.2f} | {sum(f'/{name}' in block for block in deps)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("log", "headers"))
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("names", nargs="*", help="headers as #include names them")
    given = parser.parse_args()
    if given.what == "log":
        print_log(given.build)
    else:
        print_headers(given.build, given.names)


if __name__ == "__main__":
    main()
