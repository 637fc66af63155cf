"""Installs the wheel by pip, without an index, into an environment of its own: the other tests run what is there.

    install_wheel.py WHEELS FOLDER        WHEELS: build/python
"""

import pathlib
import shutil
import subprocess
import sys

WHEELS, FOLDER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])

shutil.rmtree(FOLDER, ignore_errors=True)
subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", FOLDER], check=True)
(wheel,) = WHEELS.glob("pomona-*.whl")
pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--python", FOLDER / "bin/python"]
subprocess.run([*pip, "install", "--quiet", "--no-index", wheel], check=True)
