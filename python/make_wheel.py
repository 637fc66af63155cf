"""Makes the wheel of the Python module, by the standard library alone: the same bytes for the same files.

    make_wheel.py PACKAGE SOURCE VERSION TAG FOLDER
        PACKAGE   build/module: what `import` finds
        SOURCE    the source tree, whose templates, scenes and styles go with it
        TAG       "cp311-cp311-linux_x86_64"
"""

import base64
import hashlib
import pathlib
import sys
import zipfile

METADATA = """Metadata-Version: 2.1
Name: pomona
Version: {version}
Summary: Grows fruit and vegetables that can be cut anywhere
License: GPL-3.0-or-later
Requires-Python: >=3.11,<3.12
Requires-Dist: numpy
"""
WHEEL = "Wheel-Version: 1.0\nGenerator: pomona\nRoot-Is-Purelib: false\nTag: {tag}\n"


def contents(package, source):
    """Every file by its name in the wheel."""
    files = {}
    for path in package.rglob("*"):
        if path.is_file() and "__pycache__" not in path.parts:
            files[path.relative_to(package).as_posix()] = path.read_bytes()
    for kind in ("templates", "scenes", "styles"):
        for path in (source / kind).rglob("*"):
            if path.is_file() and path.suffix not in (".py", ".pyc"):
                files[f"pomona/{path.relative_to(source).as_posix()}"] = path.read_bytes()
    return files


def record(files, name):
    rows = []
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.append(f"{path},sha256={digest},{len(content)}\n")
    return "".join([*rows, f"{name},,\n"])


def main(package, source, version, tag, folder):
    files = dict(sorted(contents(pathlib.Path(package), pathlib.Path(source)).items()))
    info = f"pomona-{version}.dist-info"
    files[f"{info}/METADATA"] = METADATA.format(version=version).encode()
    files[f"{info}/WHEEL"] = WHEEL.format(tag=tag).encode()
    files[f"{info}/COPYING"] = (pathlib.Path(source) / "LICENSE").read_bytes()
    files[f"{info}/RECORD"] = record(files, f"{info}/RECORD").encode()
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    for old in pathlib.Path(folder).glob("pomona-*.whl"):
        old.unlink()
    with zipfile.ZipFile(pathlib.Path(folder) / f"pomona-{version}-{tag}.whl", "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, content)


if __name__ == "__main__":
    main(*sys.argv[1:])
