#!/usr/bin/env python3
"""Golden pictures: what Pomona draws, held to what it drew when somebody looked and was content.

    golden.py list                                       the runs of tests/golden/golden.toml
    golden.py check [NAME...] [--programs]               draws and compares; status 1 if anything differs
    golden.py renew NAME... --reason "WHY"               draws anew and keeps; `all` renews what differs or is missing

--program FILE is the pomona to run (default build/pomona), --out FOLDER where results and pages go (default
build/golden). docs/guides/golden.md has the rest.
"""

import argparse
import base64
import datetime
import difflib
import html
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import textwrap
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests" / "golden"
MOST_BYTES, MOST_PIXELS = 200 * 1024, 256  # of a golden picture; along its longer side
CLASSES = ("exact", "close", "text")

# Software OpenGL, whatever card there is: it is what the goldens were drawn with.
ENVIRONMENT = {**os.environ, "POMONA_GL": "surfaceless", "LIBGL_ALWAYS_SOFTWARE": "1", "NO_COLOR": "1"}


def declared_runs():
    """The runs as the list declares them, each with its goldens: {file name: class}."""
    runs = tomllib.loads((GOLDEN / "golden.toml").read_text(encoding="utf-8"))["run"]
    seen = set()
    for run in runs:
        run["goldens"] = {file: kind for kind in CLASSES for file in run.get(kind, [])}
        unknown = run.keys() - {"name", "command", "shows", "size", "goldens", *CLASSES}
        names = {run["name"], *run["goldens"]}
        if unknown or not run["goldens"] or names & seen:
            sys.exit(f"golden.toml: error: run {run['name']}: unknown keys {unknown}, no goldens, or a name used twice")
        seen |= names
    return runs


def needs_programs(run):
    return any(file.endswith(".pov.png") for file in run["goldens"])


# Drawing


def texture_of(glb):
    """The first picture within a .glb."""
    data = glb.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    view = document["bufferViews"][document["images"][0]["bufferView"]]
    start = 20 + length + 8 + view.get("byteOffset", 0)
    return data[start:start + view["byteLength"]]


def render_with_povray(pov, picture, size):
    """One thread, no jitter: the same file gives the same pixels (docs/guides/golden.md)."""
    width, height = size.split("x")
    words = ["povray", pov.name, f"+W{width}", f"+H{height}", "+WT1", "-J", "+A0.1", "+AM1", "-D", f"+O{picture.name}"]
    done = subprocess.run(words, cwd=pov.parent, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError("povray failed:\n" + done.stderr[-2000:])


def draw(run, program, folder):
    """Runs the command in an empty folder, and makes the pictures that lie within other files. Raises RuntimeError."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    words = shlex.split(run["command"].replace("{golden}", str(GOLDEN)).replace("{root}", str(ROOT)))
    done = subprocess.run([str(program), *words, "--quiet"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"`pomona {run['command']}` ended with {done.returncode}:\n{done.stderr}")
    for file in run["goldens"]:
        if file.endswith(".glb.png"):
            (folder / file).write_bytes(texture_of(folder / file.removesuffix(".png")))
        elif file.endswith(".pov.png"):
            render_with_povray(folder / file.removesuffix(".png"), folder / file, run.get("size", "192x144"))
        if not (folder / file).is_file():
            raise RuntimeError(f"`pomona {run['command']}` left no {file}")


# Comparing


def compare_text(golden, result, page):
    """Line by line; the program's version, which stands in every file, is no part of a picture."""
    texts = (path.read_text(encoding="utf-8") for path in (golden, result))
    old, new = (re.sub(r"\bpomona \d+\.\d+\.\d+", "pomona VERSION", text).splitlines() for text in texts)
    lines = list(difflib.unified_diff(old, new, "reference", "result", lineterm=""))
    if not lines:
        return {"same": True, "reasons": []}
    shown = "\n".join(html.escape(line) for line in lines[:2000])
    pictures = "".join(f'<figure><figcaption>{name}</figcaption><img alt="" width="480" src="data:image/svg+xml;base64,'
                       f'{base64.b64encode(path.read_bytes()).decode()}"></figure>'
                       for name, path in (("reference", golden), ("result", result)) if golden.suffix == ".svg")
    page.write_text(f'<!doctype html><meta charset="utf-8"><title>{golden.name}</title><h1>{golden.name}</h1>'
                    f'<div style="display:flex">{pictures}</div><pre>{shown}</pre>\n', encoding="utf-8")
    changed = sum(line[0] in "+-" for line in lines[2:])
    return {"same": False, "lines": changed, "reasons": [f"{changed} lines differ"]}


def compare(file, kind, program, folder, page):
    """The figures of one golden; its page is written where it differs."""
    golden, result = GOLDEN / file, folder / file
    if not golden.is_file():
        return {"same": False, "missing": True, "reasons": [f"there is no tests/golden/{file} yet"]}
    if kind == "text":
        return compare_text(golden, result, page)
    done = subprocess.run([str(program), "compare", str(golden), str(result), "--tolerance", kind, "--json",
                           "--html", str(page)], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"`pomona compare` ended with {done.returncode}:\n{done.stderr}")
    if done.returncode == 0:
        page.unlink()
    return json.loads(done.stdout)


def check_run(run, program, out, comparer=None):
    """{golden: figures} of one run."""
    try:
        draw(run, program, out / run["name"])
        return {file: compare(file, kind, comparer or program, out / run["name"], out / (file + ".html"))
                for file, kind in run["goldens"].items()}
    except RuntimeError as error:
        return {file: {"same": False, "failed": True, "reasons": [str(error)]} for file in run["goldens"]}


def check(runs, program, out):
    out.mkdir(parents=True, exist_ok=True)
    bad = 0
    for run in runs:
        for file, figures in check_run(run, program, out).items():
            if figures["same"]:
                print(f"{file}: as it should be")
                continue
            bad += 1
            print(f"{file}: DIFFERENT: {'; '.join(figures['reasons'])}")
            page = out / (file + ".html")
            if page.is_file():
                print(f"  reference, result and difference: {page}")
            print(f'  if this is better: make golden-renew NAME={run["name"]} REASON="why"')
    return 1 if bad else 0


# Renewing


def refuse_dirty_tree():
    """What is kept must be what a commit draws. tests/golden itself may hold what is about to be committed."""
    status = subprocess.run(["git", "status", "--porcelain", "--", ".", ":!tests/golden"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout
    if status:
        sys.exit(f"golden.py: error: the tree is not clean; commit first, so that the pictures have an origin:\n{status}")


def refuse_large(path):
    data = path.read_bytes()
    if len(data) > MOST_BYTES:
        sys.exit(f"golden.py: error: {path.name} has {len(data)} bytes; {MOST_BYTES} are the most")
    if path.suffix == ".png" and max(struct.unpack_from(">II", data, 16)) > MOST_PIXELS:
        sys.exit(f"golden.py: error: {path.name} is larger than {MOST_PIXELS} pixels a side")


def renew(runs, program, out, reason, only_wrong):
    refuse_dirty_tree()
    if not re.search(r"\w{3}", reason or ""):
        sys.exit('golden.py: error: a renewal needs a reason: --reason "bruises are softer now"')
    out.mkdir(parents=True, exist_ok=True)
    renewed = []
    for run in runs:
        for file, figures in check_run(run, program, out).items():
            if figures.get("failed"):
                sys.exit(f"golden.py: error: {'; '.join(figures['reasons'])}")
            untouched = figures["same"] and (only_wrong or figures.get("different", 0) == 0)
            if untouched:
                continue
            refuse_large(out / run["name"] / file)
            shutil.copyfile(out / run["name"] / file, GOLDEN / file)
            renewed.append(file)
            print(f"renewed {file}" + ("" if figures.get("missing") else f": {'; '.join(figures['reasons'])}"))
            if (out / (file + ".html")).is_file():
                print(f"  old and new: {out / (file + '.html')}")
    if renewed:
        with open(GOLDEN / "REASONS.md", "a", encoding="utf-8") as reasons:
            line = f"- {datetime.date.today()}, {reason.strip()}: {', '.join(sorted(renewed))}"
            reasons.write(textwrap.fill(line, 120, subsequent_indent="  ", break_long_words=False) + "\n")
    print(f"{len(renewed)} renewed" + ("; look at them, then commit them together with REASONS.md" if renewed else ""))
    return 0


def parsed(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("list", "check", "renew"))
    parser.add_argument("names", nargs="*", metavar="NAME", help="of runs, or of their files")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "pomona")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build" / "golden")
    parser.add_argument("--programs", action="store_true", help="those that need POV-Ray, too")
    parser.add_argument("--reason")
    return parser.parse_intermixed_args(words)


def main():
    asked = parsed(sys.argv[1:])
    runs = declared_runs()
    if asked.action == "list":
        for run in runs:
            print(run["name"], "programs" if needs_programs(run) else "plain", " ".join(run["goldens"]), sep="\t")
        return 0
    program, out = asked.program.resolve(), asked.out.resolve()
    everything = not asked.names or asked.names == ["all"]
    known = {name: run for run in runs for name in (run["name"], *run["goldens"])}
    unknown = [] if everything else [name for name in asked.names if name not in known]
    if unknown:
        sys.exit(f"golden.py: error: there is no golden {', '.join(unknown)}; see `scripts/golden.py list`")
    chosen = runs if everything else [run for run in runs if {run["name"], *run["goldens"]} & set(asked.names)]
    if everything and not asked.programs:
        chosen = [run for run in chosen if not needs_programs(run)]
    if asked.action == "check":
        return check(chosen, program, out)
    if not asked.names:
        sys.exit("golden.py: error: which? name them, or say `all`")
    return renew(chosen, program, out, asked.reason, everything)


if __name__ == "__main__":
    sys.exit(main())
