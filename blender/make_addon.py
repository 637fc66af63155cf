#!/usr/bin/env python3
"""Packs the add-on for Blender: the package with its manifest, the program's version and the program's pictures.

    make_addon.py PROGRAM FOLDER      leaves FOLDER/pomona_blender-VERSION.zip

The same sources and the same program give the same bytes."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
PACKAGE = HERE / "pomona_blender"
SIDE = 128  # pixels of a thumbnail


def version_of(program: str) -> str:
    """As "0.6.0"."""
    told = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    found = re.search(r"\d+\.\d+\.\d+", told)
    if not found:
        raise ValueError(f"{program} tells no version: {told}")
    return found.group(0)


def thumbnails(program: str) -> dict[str, bytes]:
    """A .png of each template by name: its halves, on nothing."""
    batch = ('[batch]\nformat = 1\nname = "thumbnails"\nquality = "draft"\n'
             '[[entry]]\nname = "half"\ntemplates = "all"\n'
             f'seeds = [0]\nknives = ["half"]\nthumbnail = {SIDE}\nstyle = "photo"\nfaces = "coarse"\n')
    with tempfile.TemporaryDirectory() as scratch:
        file, folder = Path(scratch, "thumbnails.toml"), Path(scratch, "made")
        file.write_text(batch, encoding="utf-8")
        subprocess.run([program, "batch", file, "-o", folder, "--quiet"], check=True)
        items = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))["items"]
        return {item["template"]: (folder / item["item"] / "thumbnail.png").read_bytes() for item in items}


def with_version(text: str, placeholder: str, version: str) -> str:
    """The text, with the version in the one place that is kept for it."""
    if text.count(placeholder) != 1:
        raise ValueError(f"{placeholder} does not stand once where the version belongs")
    return text.replace(placeholder, version)


def contents(program: str) -> dict[str, bytes]:
    """All files of the .zip, by their names in its one folder."""
    version = version_of(program)
    files = {path.name: path.read_bytes() for path in PACKAGE.glob("*.py")}
    opening = with_version(files["__init__.py"].decode(), "(0, 0, 0)", "(" + version.replace(".", ", ") + ")")
    manifest = with_version((HERE / "blender_manifest.toml").read_text(encoding="utf-8"), '"0.0.0"', f'"{version}"')
    files |= {"__init__.py": opening.encode(), "blender_manifest.toml": manifest.encode(),
              "LICENSE": (HERE.parent / "LICENSE").read_bytes()}
    return files | {f"thumbnails/{name}.png": picture for name, picture in thumbnails(program).items()}


def pack(files: dict[str, bytes], path: Path) -> None:
    """Sorted, and without the time of day."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, data in sorted(files.items()):
            entry = zipfile.ZipInfo(f"{PACKAGE.name}/{name}", (1980, 1, 1, 0, 0, 0))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            packed.writestr(entry, data)


def main() -> None:
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{PACKAGE.name}-{version_of(program)}.zip"
    pack(contents(program), path)
    print(path)


if __name__ == "__main__":
    main()
