#!/usr/bin/env python3
"""Reads assimp's test models, Khronos' samples among them, as our readers and assimp do, and says who differs.

    model_suite.py MESH_FACTS [--models FOLDER] [--report FILE] [--check]

MESH_FACTS is build/tests/programs/mesh_facts, FOLDER that of Debian's package assimp-testmodels. Writes the table into
the report; with --check it changes nothing and fails where the table is not that of today. Each model must be read as
assimp reads it (area and box of its triangles), or told.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import textwrap

BEGIN, END = "<!-- model_suite.py -->", "<!-- end -->"


def stl_facts(path):
    """Area and box of the triangles of a text .stl; None if it has none."""
    area, low, high, corners = 0.0, [math.inf] * 3, [-math.inf] * 3, []
    for line in path.read_text(encoding="ascii").splitlines():
        words = line.split()
        if words[:1] == ["vertex"]:
            corners.append([float(word) for word in words[1:4]])
        elif words[:1] == ["endfacet"]:
            if len(corners) == 3:
                (a, b, c), area = corners, area + area_of(*corners)
                low = [min(x) for x in zip(low, a, b, c)]
                high = [max(x) for x in zip(high, a, b, c)]
            corners = []
    return {"area": area, "low": low, "high": high} if area > 0 else None


def area_of(a, b, c):
    p, q = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
    return 0.5 * math.hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def assimp_facts(model):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.stl"
        done = subprocess.run(["assimp", "export", str(model), str(out), "-f", "stl", "-tri"], capture_output=True,
                              timeout=120)
        return stl_facts(out) if done.returncode == 0 and out.exists() else None


def own_facts(program, model):
    done = subprocess.run([program, str(model)], capture_output=True, text=True, timeout=60)
    if done.returncode != 0:
        sys.exit(f"{model}: {program} ends with {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout)


def alike(ours, theirs):
    size = math.dist(theirs["low"], theirs["high"])
    corners = zip(ours["low"] + ours["high"], theirs["low"] + theirs["high"])
    return (abs(ours["area"] - theirs["area"]) <= 1e-4 * theirs["area"] and
            all(abs(a - b) <= 1e-4 * size for a, b in corners))


def verdict(ours, theirs):
    """What the table says of a model, and whether that will do."""
    if "error" in ours:
        return "told: " + ours["error"], True
    told = "".join("; told: " + note.split(": ")[-1] for note in ours["notes"])
    if theirs is None:
        return "read, where assimp gives no triangles" + told, True
    if alike(ours, theirs):
        return "as assimp" + told, True
    return f"area {ours['area']:.6g}, assimp's {theirs['area']:.6g}" + told, bool(ours["notes"])


def results(program, folder):
    """What the report says of all models, and what is read otherwise without a word."""
    faults, alike_models, table = [], [], ["| model | read |", "|---|---|"]
    models = sorted(p for p in folder.rglob("*") if p.suffix.lower() in (".obj", ".ply", ".glb"))
    if not models:
        sys.exit(f"{folder} holds no models: install assimp-testmodels")
    for model in models:
        name = str(model.relative_to(folder))
        ours = own_facts(program, model)
        says, good = verdict(ours, None if "error" in ours else assimp_facts(model))
        if not good:
            faults.append(f"{name}: {says}")
        if says == "as assimp":
            alike_models.append(f"{name} {ours['triangles']}")
        else:
            count = f"{ours['triangles']} triangles, " if "triangles" in ours else ""
            table.append(f"| {name} | {count}{says.replace('|', '/')} |")
    listed = textwrap.fill(f"As assimp, with so many triangles: {', '.join(alike_models)}.", 120,
                           break_on_hyphens=False)
    return len(models), [listed, ""] + table, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--models", type=pathlib.Path, default=pathlib.Path("/usr/share/assimp/models"))
    parser.add_argument("--report", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent / "docs/reports/models.md")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    count, report, faults = results(options.program, options.models)
    if faults:
        sys.exit("read otherwise, without a word:\n" + "\n".join(faults))
    text = options.report.read_text(encoding="utf-8")
    head, tail = text.split(BEGIN)[0], text.split(END)[1]
    wanted = head + BEGIN + "\n\n" + "\n".join(report) + "\n\n" + END + tail
    if not options.check:
        options.report.write_text(wanted, encoding="utf-8")
    elif wanted != text:
        sys.exit(f"{options.report} is not what is read today: run {sys.argv[0]} {options.program}")
    print(f"{count} models, each read as assimp does, or told")


main()
