#!/usr/bin/env python3
"""The pictures of docs/figures.md, made by the commands that stand in it.

    figures.py make PROGRAM [NUMBER]   runs the commands of all figures, or of one, with this program as pomona
    figures.py check                   says what is missing or made by no command; exits with 1 if anything is
"""

import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/figures.md"
FIGURES = range(1, 14)


def sections():
    """Figure number -> what stands below its heading."""
    parts = re.split(r"^## Figure (\d+)$", PAGE.read_text(), flags=re.M)
    return {int(number): text for number, text in zip(parts[1::2], parts[2::2])}


def commands(section):
    return [line for block in re.findall(r"```sh\n(.*?)```", section, re.S) for line in block.splitlines() if line]


def made_by(section):
    return set(re.findall(r"docs/(pictures/figures/\w+\.png)", "\n".join(commands(section))))


def make(program, numbers):
    # "pomona" in a command is the given program.
    program = pathlib.Path(program).resolve()
    if program.name != "pomona" or not program.is_file():
        sys.exit(f"figures: error: {program} is no pomona: make build")
    where = dict(os.environ, PATH=f"{program.parent}:{os.environ['PATH']}")
    for folder in ("docs/pictures/figures", "out/figures"):
        (ROOT / folder).mkdir(parents=True, exist_ok=True)
    for number in numbers:
        section = sections()[number]
        for command in commands(section):
            quiet = command + " --quiet" if command.startswith("pomona ") else command
            subprocess.run(quiet, shell=True, check=True, cwd=ROOT, env=where)
        pictures = sorted(f"docs/{path}" for path in made_by(section))
        subprocess.run(["pngquant", "--force", "--ext", ".png", "--speed", "1", "256", "--", *pictures], check=True,
                       cwd=ROOT)
        print(f"Figure {number}: {' '.join(pictures)}", flush=True)


def faults():
    found = sections()
    for number in FIGURES:
        if number not in found:
            yield f"docs/figures.md: there is no heading \"Figure {number}\""
            continue
        section = found[number]
        if f"`make figures FIGURE={number}`" not in section:
            yield f"docs/figures.md: Figure {number} does not say its command"
        shown = set(re.findall(r"!\[\]\((pictures/figures/\w+\.png)\)", section))
        for path in sorted(shown ^ made_by(section)):
            yield f"docs/figures.md: Figure {number}: {path} is {'shown' if path in shown else 'made'} alone"
        for path in sorted(shown):
            if not (ROOT / "docs" / path).is_file():
                yield f"docs/figures.md: {path} is not there: make figures FIGURE={number}"


def main():
    match sys.argv[1:]:
        case ["make", program]:
            make(program, FIGURES)
        case ["make", program, number] if number.isdigit() and int(number) in FIGURES:
            make(program, [int(number)])
        case ["check"]:
            found = list(faults())
            print(*found, sep="\n", end="\n" if found else "", file=sys.stderr)
            sys.exit(1 if found else 0)
        case _:
            sys.exit(__doc__)


main()
