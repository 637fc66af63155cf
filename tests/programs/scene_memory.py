#!/usr/bin/env python3
"""A scene of 300 pieces, its .glb and its picture: what the whole command takes of memory.

    scene_memory.py PROGRAM REPOSITORY FOLDER
"""
import re
import resource
import shutil
import subprocess
import sys
from pathlib import Path

program, repository, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
most = 600  # MB
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
salad = (repository / "scenes" / "salad.toml").read_text()
(folder / "three_hundred.toml").write_text(re.sub(r"(?m)^total = \d+$", "total = 300", salad, count=1))
shutil.copytree(repository / "scenes" / "dishes", folder / "dishes")
subprocess.run([program, "scene", "three_hundred.toml", "--size", "960x720", "--quiet", "-o", "a.glb", "-o", "a.png"],
               cwd=folder, check=True)
taken = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1000
print(f"{taken:.0f} MB")
sys.exit(0 if taken <= most else f"300 pieces take {taken:.0f} MB, more than {most}")
