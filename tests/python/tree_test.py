"""What `cmake --install` puts of the module, moved elsewhere and used from there.

    tree_test.py BUILD SOURCE INSTALLED        INSTALLED: tests/install, which knows how to install
"""

import os
import pathlib
import subprocess
import sys
import tempfile

BUILD, SOURCE, INSTALLED = sys.argv[1:4]
sys.path.insert(0, INSTALLED)

from installed import install

PROGRAM = """
import pathlib, pomona
pomona.grow("tomato", seed=3, detail=0.4).cut("half", quality="draft").write("python.glb")
assert pathlib.Path("python.glb").read_bytes() == pathlib.Path("program.glb").read_bytes()
assert pomona.__version__ and len(pomona.templates()) >= 24
assert str(pomona.templates()[0].file).startswith(TREE), pomona.templates()[0].file
"""

with tempfile.TemporaryDirectory(prefix="pomona-test-") as folder:
    tree = install(BUILD, folder)
    words = ["cut", "tomato", "--seed", "3", "--detail", "0.4", "--quality", "draft", "--knife", "half", "-o", "program.glb"]
    subprocess.run([tree / "bin/pomona", *words, "--quiet"], cwd=folder, check=True)
    (package,) = tree.glob("lib/python3*/dist-packages")
    program = f"TREE = {str(tree)!r}{PROGRAM}"
    subprocess.run([sys.executable, "-B", "-c", program], cwd=folder, check=True, env={**os.environ, "PYTHONPATH": str(package)})
