#!/usr/bin/env python3
"""README.md begins with a picture that leads to the page of a tomato; that page is what the program writes today.

    readme_page_test.py PROGRAM
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = "docs/tomato.html"
COMMAND = ["cut", "tomato", "--knife", "half", "-o"]


def main():
    (program,) = sys.argv[1:]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    first = re.search(r'\[(?:!\[[^\]]*\]\([^)]*\)|<img [^>]*>)\]\(([^)]*)\)|<img |!\[', readme)
    assert first and first.group(1) == PAGE, f"README.md begins with {first and first.group(0)}"
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "tomato.html"
        subprocess.run([program, *COMMAND, made, "--quiet"], check=True)
        assert made.read_bytes() == (ROOT / PAGE).read_bytes(), \
            f"{PAGE} is not what the program writes any more: build/pomona {' '.join(COMMAND)} {PAGE}"


main()
