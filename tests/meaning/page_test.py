#!/usr/bin/env python3
"""The page's and the studio's scripts in node, beside a box: page_test.mjs.

    page_test.py PROGRAM SOURCE
"""

import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from boxes import Program  # noqa: E402


class Page(Program):
    def test_the_scripts(self):
        script = pathlib.Path(__file__).with_suffix(".mjs")
        done = subprocess.run(["node", script, self.program, self.path], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    Program.program, Program.source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
