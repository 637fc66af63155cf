#!/usr/bin/env python3
"""The pictures of pages, made by the commands that stand on them.

    figures.py make PROGRAM [PAGE [HEADING]]   runs the commands of a page (figures, knives, style, textures, batch, scenes), or those
                                               below one heading ("8" is "Figure 8"), with this program as pomona
    figures.py check                           says what is missing or made by no command; exits with 1 if anything is
"""

import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ("figures", "knives", "style", "textures", "batch", "scenes")
ELSEWHERE = {"scenes": "scenes/README.md", "batch": "docs/guides/batch.md"}  # pages that are not under docs/reference
FIGURES = [f"Figure {number}" for number in range(1, 14)]


def path_of(page):
    return ELSEWHERE.get(page, f"docs/reference/{page}.md")


def text_of(page):
    return (ROOT / path_of(page)).read_text()


def sections(page):
    """Heading -> what stands below it."""
    parts = re.split(r"^## (.+)$", text_of(page), flags=re.M)
    return dict(zip(parts[1::2], parts[2::2]))


def commands(section):
    return [line for block in re.findall(r"```sh\n(.*?)```", section, re.S) for line in block.splitlines() if line]


def made_by(page, section):
    return set(re.findall(rf"docs/(pictures/{page}/\w+\.(?:png|jpg))", "\n".join(commands(section))))


def with_palette(page, section):
    """The pictures (.png) that 256 colours are enough for. Scenes have more, and a dither would show: they keep
    theirs."""
    scenes = [line for line in commands(section) if line.startswith("pomona scene ")]
    made = [path for path in made_by(page, section) if path.endswith(".png")]
    return sorted(path for path in made if not any(f"docs/{path}" in line for line in scenes))


def make(program, page, headings):
    # "pomona" in a command is the given program.
    program = pathlib.Path(program).resolve()
    if program.name != "pomona" or not program.is_file():
        sys.exit(f"figures: error: {program} is no pomona: make build")
    # Debian's Python before any other: setup.sh has given it what the scripts need, and Blender takes the first it
    # finds.
    where = dict(os.environ, PATH=f"{program.parent}:/usr/bin:{os.environ['PATH']}")
    for folder in (f"docs/pictures/{page}", f"out/{page}"):
        (ROOT / folder).mkdir(parents=True, exist_ok=True)
    for heading in headings:
        section = sections(page)[heading]
        pictures = sorted(f"docs/{path}" for path in made_by(page, section))
        if not pictures:
            continue
        for command in commands(section):
            quiet = command + " --quiet" if command.startswith("pomona ") else command
            subprocess.run(quiet, shell=True, check=True, cwd=ROOT, env=where)
        if palette := [f"docs/{path}" for path in with_palette(page, section)]:
            subprocess.run(["pngquant", "--force", "--ext", ".png", "--speed", "1", "256", "--", *palette], check=True,
                           cwd=ROOT)
        print(f"{heading}: {' '.join(pictures)}", flush=True)


def picture_faults(page):
    """Every picture is made by a command below its heading, shown there, and in the tree."""
    for heading, section in sections(page).items():
        shown = set(re.findall(rf"!\[\]\((?:\.\./)+(?:docs/)?(pictures/{page}/\w+\.(?:png|jpg))\)", section))
        for path in sorted(shown ^ made_by(page, section)):
            yield f"{path_of(page)}: {heading}: {path} is {'shown' if path in shown else 'made'} alone"
        for path in sorted(shown):
            if not (ROOT / "docs" / path).is_file():
                yield f"{path_of(page)}: {path} is not there: scripts/figures.py make build/pomona {page} \"{heading}\""


def figure_faults():
    found = sections("figures")
    for heading in FIGURES:
        if heading not in found:
            yield f"docs/reference/figures.md: there is no heading \"{heading}\""
        elif f"`make figures FIGURE={heading.split()[1]}`" not in found[heading]:
            yield f"docs/reference/figures.md: {heading} does not say its command"


def knife_faults():
    """Every knife in the table of commands cuts at least two fruits on the page."""
    fruits = {}
    for section in sections("knives").values():
        for command in commands(section):
            if not (cut := re.search(r"\bcut (\w+)", command)):
                continue
            fruit = cut[1]
            for knife in re.findall(r"--knife ([a-z]+)", command):
                fruits.setdefault(knife, set()).add(fruit)
    table = text_of("commands").split("| KNIFE | cuts along |")[1].split("\n\n")[0]
    for row in re.findall(r"^\| (`.+?) \|", table, re.M):
        for knife in re.findall(r"`([a-z]+)", row):
            if len(fruits.get(knife, ())) < 2:
                yield f"docs/reference/knives.md: knife \"{knife}\" cuts fewer than two fruits"


def main():
    match sys.argv[1:]:
        case ["make", program, *what] if len(what) <= 2:
            page, *heading = what or ["figures"]
            heading = [f"Figure {h}" if h.isdigit() else h for h in heading]
            if page not in PAGES or not set(heading) <= set(sections(page)):
                sys.exit(__doc__)
            make(program, page, heading or sections(page))
        case ["check"]:
            found = [*figure_faults(), *knife_faults(), *(fault for page in PAGES for fault in picture_faults(page))]
            print(*found, sep="\n", end="\n" if found else "", file=sys.stderr)
            sys.exit(1 if found else 0)
        case _:
            sys.exit(__doc__)


main()
