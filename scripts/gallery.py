#!/usr/bin/env python3
"""The gallery: which command makes which picture, and the pages that show them.

    gallery.py commands PROGRAM FOLDER [NAME...]   the commands, one a line, as a user could type them
    gallery.py write                               writes the gallery into templates/README.md and README.md
    gallery.py check                               says what is stale or missing; exits with 1 if anything is

Names are those of templates, "salad", "ripeness" or "variation"; without any, all. What a template shows is told by the first sentence of its
opening comment.
"""

import pathlib
import re
import shlex
import sys
import textwrap
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = "docs/pictures"
SEEDS = (118, 121, 132)  # drawn once by lot, from 101 to 140, so that nobody has chosen what is shown
ROW_SEEDS = (111, 113, 119, 130, 136)  # the same
SCENES = {"salad": "880x660", "ripeness": "800x352"}  # picture sizes
VARIATION = {  # of docs/reference/variation.md: what is grown, at seed 2
    **{f"pepper_folds_{folds}.png": ["pepper", "--folds", str(folds)] for folds in (3, 4, 6)},
    **{f"tomato_variation_{amount}.png": ["tomato", "--variation", amount] for amount in ("0.5", "1", "2")},
}
STAGED = {  # how halves are shown, where not as all are
    "star_fruit": ["--view=-22,34"],  # from below, where its ribs are in sight
}
STANDING = {"star_fruit": ["--view=18,35"]}  # a whole fruit, likewise: past a rib, and onto the star
ACROSS = {
    "cherry": "plane:0,1,0,13mm",  # through the stone: with the long stem, half the height lies above it
    "bread": "plane:1,0,0,0mm",  # these lie: a slice
    "swiss_roll": "plane:1,0,0,0mm",
    "salami": "plane:1,0,0,0mm",
    "currants": "plane:0,1,0,45mm",  # through two berries and past their stalks
    "garlic": "plane:0,1,0,18mm",  # through the green shoots of the cloves; half the height lies above them
}
# Sizes in pixels. templates/README.md shows pictures as large as they are, README.md at GRID_SHOWN.
ROW = 800, 240  # seeds side by side, at one scale
WIDE = 360, 240
LARGE, SMALL = 240, 150
GRID_SHOWN = 180


def templates():
    return sorted(file.stem for file in (ROOT / "templates").glob("*.toml"))


def opening(name):
    """The first sentence of the comment at the top of a template."""
    lines = []
    for line in (ROOT / "templates" / f"{name}.toml").read_text().splitlines():
        if line.startswith("#:"):
            continue
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return re.match(r"(.*?\.)(?:\s|$)|(.*)", " ".join(lines)).group(0).strip()


def read(name):
    with open(ROOT / "templates" / f"{name}.toml", "rb") as file:
        return tomllib.load(file)


def symmetry(template):
    declared = template.get("symmetry", {})
    if declared.get("kind") == "folds":
        return f"{declared['folds']} folds"
    return "not symmetric" if declared.get("kind", "none") == "none" else declared["kind"]


def varies(name):
    """What is imported, and has no symmetry, looks the same at every seed."""
    return symmetry(read(name)) != "not symmetric"


def pictures_of(name):
    """File name in the template's folder -> words after the program's name."""
    large, small = ["--size", f"{LARGE}x{LARGE}"], ["--size", f"{SMALL}x{SMALL}"]
    section = ["--section", "--knife"]
    across = ACROSS.get(name, "across")
    made = {
        "surfaces.png": ["grow", name, "--surfaces", *large],
        "whole.png": ["grow", name, *STANDING.get(name, []), *large],
        "half.png": ["cut", name, *section, "half", *large],
        "across.png": ["cut", name, *section, across, *large],
        "halves.png": ["cut", name, "--knife", "half", *STAGED.get(name, []), "--size", f"{WIDE[0]}x{WIDE[1]}"],
    }
    for seed in SEEDS if varies(name) else ():
        made[f"seed_{seed}_across.png"] = ["cut", name, *section, across, "--seed", str(seed), *small]
    if varies(name):
        row = ["--seeds", ",".join(map(str, ROW_SEEDS)), "--size", f"{ROW[0]}x{ROW[1]}"]
        made["seeds.png"] = ["grow", name, *row]
        made["seeds_half.png"] = ["cut", name, "--knife", "half", "--piece", "1", *row]
    return made


def all_pictures(names=()):
    """Path under PICTURES -> words after the program's name."""
    made = {}
    for name in templates():
        if not names or name in names:
            made |= {f"{name}/{file}": words for file, words in pictures_of(name).items()}
    for scene, size in SCENES.items():
        if not names or scene in names:
            made[f"{scene}.png"] = ["scene", f"scenes/{scene}.toml", "--size", size]
    if not names or "variation" in names:
        for file, words in VARIATION.items():
            made[file] = ["cut", *words, "--seed", "2", "--knife", "across", "--section", "--size", "180x180"]
    return made


def print_commands(program, folder, names):
    unknown = set(names) - set(templates()) - set(SCENES) - {"variation"}
    if unknown:
        sys.exit(f"gallery: error: there is no template {', '.join(sorted(unknown))}")
    for path, words in all_pictures(names).items():
        print(shlex.join([program, *words, "--quiet", "-o", f"{folder}/{path}"]))


def image(path, alt):
    return f"![{alt}]({path})"


def block(name):
    """What templates/README.md shows of one template."""
    template = read(name)
    folder = f"../{PICTURES}/{name}"
    large = [image(f"{folder}/{view}.png", view) for view in ("surfaces", "whole", "half", "across")]
    small = [image(f"{folder}/seed_{seed}_across.png", f"seed {seed}") for seed in SEEDS if varies(name)]
    rows = [image(f"{folder}/{row}.png", f"seeds {what}")
            for row, what in (("seeds", "whole"), ("seeds_half", "halved")) if varies(name)]
    return "\n".join([
        f"### {template.get('title', name)}",
        "",
        textwrap.fill(f"[`{name}`]({name}.toml), {symmetry(template)}. {opening(name)}", 120, break_on_hyphens=False),
        "",
        *large,
        image(f"{folder}/halves.png", "halves"),
        "",
        *([*small, "", *rows, ""] if small else []),
    ])


def grid_cell(name):
    picture = f'<img src="{PICTURES}/{name}/halves.png" alt="{name}" width="{GRID_SHOWN}">'
    return f"[{picture}](templates/README.md#{anchor(name)})"


def anchor(name):
    title = read(name).get("title", name)
    return re.sub(r"[^a-z0-9 _-]", "", title.lower()).replace(" ", "-")


def pages():
    """Page -> what stands between its markers."""
    return {
        "templates/README.md": "\n".join(block(name) for name in templates()),
        "README.md": "\n".join(grid_cell(name) for name in templates()) + "\n",
    }


BETWEEN = re.compile(r"(<!-- gallery: make gallery writes this -->\n)(.*?)(<!-- end of the gallery -->)", re.S)


def written(page, gallery):
    text = (ROOT / page).read_text()
    if not BETWEEN.search(text):
        sys.exit(f"gallery: error: {page} has lost its markers")
    return BETWEEN.sub(lambda found: f"{found[1]}\n{gallery}\n{found[3]}", text)


def write():
    for page, gallery in pages().items():
        (ROOT / page).write_text(written(page, gallery))


def faults():
    """Everything about the gallery that is not as it should be."""
    for page, gallery in pages().items():
        if written(page, gallery) != (ROOT / page).read_text():
            yield f"{page}: the gallery is stale: scripts/gallery.py write"
    made = set(all_pictures())
    made |= {file.name for file in (ROOT / PICTURES).glob("sketch_*.png")}  # by scripts/draw_sketch.py
    made |= {f"scenes/{file.name}" for file in (ROOT / PICTURES / "scenes").glob("*.png")}  # by scripts/figures.py
    made |= {f"style/{file.name}" for file in (ROOT / PICTURES / "style").glob("*.png")}  # by scripts/figures.py
    made |= {"page/tomato.png", "page/board.png", "page/tomatoes.png"}  # scripts/page_picture.mjs: docs/reference/page.md
    for page in pages():
        folder = (ROOT / page).parent
        for link in re.findall(r'(?:src="|\]\()([^")]*\.png)', (ROOT / page).read_text()):
            path = (folder / link).resolve()
            if not path.is_file():
                yield f"{page}: {link} is not there: make gallery"
            if path.relative_to(ROOT / PICTURES).as_posix() not in made:
                yield f"{page}: no command of scripts/gallery.py makes {link}"

    # The gallery's folders are those of templates; nothing stands in them that no command makes.
    for file in sorted((ROOT / PICTURES).glob("*.png")) + [
            file for name in templates() for file in sorted((ROOT / PICTURES / name).glob("*"))]:
        path = file.relative_to(ROOT / PICTURES).as_posix()
        if path not in made:
            yield f"{PICTURES}/{path}: no command of scripts/gallery.py makes it"


def check():
    found = sorted(set(faults()))
    for fault in found:
        print(fault, file=sys.stderr)
    sys.exit(1 if found else 0)


def main():
    match sys.argv[1:]:
        case ["commands", program, folder, *names]:
            print_commands(program, folder, names)
        case ["write"]:
            write()
        case ["check"]:
            check()
        case _:
            sys.exit(__doc__)


main()
