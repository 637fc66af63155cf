"""What the program makes of a broken file: whether it tells, or reads what the whole file holds."""

import functools
import pathlib
import re
import subprocess
import tempfile

SECONDS = 10
MESH = """format = 1
name = "brick"
parts = ["skin", "flesh"]
symmetry.kind = "none"

[[mesh]]
name = "skin"
file = "{file}"
front = {{ part = "skin", hidden = true, color = "#804020" }}
back = {{ part = "flesh"{color} }}
"""
DRAWN = """format = 1
name = "brick"
parts = ["skin", "flesh"]
sketch = "{file}"
symmetry.kind = "cylindrical"

[[surface]]
name = "skin"
type = "around-axis"
vertical = "#skin"
horizontal = "#skin"
around = 16
along = 8
front = {{ part = "skin", hidden = true, color = "#804020" }}
back = {{ part = "flesh", color = "#d9a03c" }}
"""
PLACE = re.compile(rb"^\S*broken\.\w+(:[^\n]*?)?: error: .{8,}|^\S*broken\.toml:\d+:\d+: error: .*broken\.", re.M)
WARNING = re.compile(rb"^warning: .{8,}", re.M)


def grown(program, data, ending):
    """Status, bytes of the mesh that the program writes, and what it says. The colours at vertices are the back's."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / f"broken.{ending}").write_bytes(data)
        text = DRAWN if ending == "svg" else MESH
        color = "" if has_colors(data, ending) else ', color = "#d9a03c"'
        (folder / "broken.toml").write_text(text.format(file=f"broken.{ending}", color=color))
        try:
            done = subprocess.run([program, "cut", "broken.toml", "--knife", "plane:1,1,1,2cm", "-o", "out.ply"], cwd=folder,
                                  capture_output=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return None, b"", b"", []
        out = folder / "out.ply"
        made = out.read_bytes() if out.exists() else b""
        return done.returncode, made, done.stderr, sorted(p.name for p in folder.iterdir())


def has_colors(data, ending):
    return b"COLOR_0" in data if ending == "glb" else b"red" in data if ending == "ply" else ending == "obj"


@functools.lru_cache(maxsize=None)
def whole_mesh(program, data, ending):
    status, made, said, _ = grown(program, data, ending)
    if status != 0 or not made or WARNING.search(said):
        raise SystemExit(f"a whole .{ending} file is not read: {said.decode(errors='replace')}")
    return made


def judged(program, case):
    """"refused 65", "warned", "as whole", or "fault: ..."."""
    status, made, said, left = grown(program, case.data, case.ending)
    if status is None:
        return f"fault: it takes more than {SECONDS} s"
    if re.search(rb"[\x00-\x08\x0b-\x1f\x7f]", said):
        return "fault: control characters reach the terminal"
    if status == 0:
        if not made:
            return "fault: nothing is written, and status 0"
        if WARNING.search(said):
            return "warned" if case.wanted != "whole" else "fault: it warns of what is right"
        if case.wanted == "told":
            return "fault: nothing is told"
        return "as whole" if made == whole_mesh(program, case.whole, case.ending) else "fault: it is read otherwise"
    if not 64 <= status <= 75:
        return f"fault: status {status}: {said[-300:]!r}"
    if not PLACE.search(said):
        return f"fault: no place: {said[:300]!r}"
    if made or left != sorted([f"broken.{case.ending}", "broken.toml"]):
        return "fault: it leaves files behind"
    return f"refused {status}" if case.wanted != "whole" else f"fault: it refuses what is right: {said[:200]!r}"
