"""docs/guides/library.md, word for word, against the installed tree:
it compiles, and what it writes is what the program writes.

    library_test.py BUILD SOURCE COMPILER
"""

import json
import pathlib
import re
import struct
import sys
import tempfile
import unittest

from installed import install, run

BUILD, SOURCE, COMPILER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
PAGE = SOURCE / "docs" / "guides" / "library.md"


def code_block(language):
    """The first block of that language in docs/guides/library.md."""
    return re.search(rf"^```{language}\n(.*?)^```", PAGE.read_text(), re.M | re.S).group(1)


def parts(glb):
    """The JSON of a .glb, and its buffer."""
    length, = struct.unpack_from("<I", glb, 12)
    return json.loads(glb[20:20 + length]), glb[28 + length:]


class InstalledLibrary(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="pomona-test-")
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.tree = install(BUILD, cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_headers_include_only_what_is_installed(self):
        include = self.tree / "include/pomona"
        headers = list(include.rglob("*.h"))
        self.assertGreater(len(headers), 30)
        for header in headers:
            for included in re.findall(r'^#include "([^"]+)"', header.read_text(), re.M):
                self.assertTrue((include / included).is_file(), f"{header} includes {included}")

    def test_every_header_the_document_names_is_installed(self):
        table = PAGE.read_text().split("| step | headers |")[1].split("\n\n")[0]
        names = re.findall(r"`([a-z_/]+\.h)`", table)
        self.assertGreater(len(names), 15)
        installed = [str(header) for header in (self.tree / "include/pomona").rglob("*.h")]
        for name in names:
            self.assertTrue(any(header.endswith("/" + name) for header in installed), name)

    def test_the_document_grows_cuts_and_writes_a_fruit(self):
        source = code_block("cpp")
        self.assertLessEqual(len([line for line in source.split("int main")[1].splitlines() if line.strip()]), 20)
        (self.folder / "wedges.cpp").write_text(source)
        (self.folder / "CMakeLists.txt").write_text(code_block("cmake"))
        run("cmake", "-S", self.folder, "-B", self.folder / "build", f"-DCMAKE_PREFIX_PATH={self.tree}",
            f"-DCMAKE_CXX_COMPILER={COMPILER}", "-DCMAKE_BUILD_TYPE=Debug")
        run("cmake", "--build", self.folder / "build")
        templates = self.tree / "share/pomona/templates"
        run(self.folder / "build/wedges", templates / "tomato.toml", folder=self.folder)
        ours = (self.folder / "wedges.glb").read_bytes()
        for ending in ("usda", "obj", "stl", "ply", "pov", "svg", "png"):
            self.assertGreater((self.folder / f"wedges.{ending}").stat().st_size, 1000, ending)

        run(self.tree / "bin/pomona", "cut", "tomato", "--seed", "3", "--knife", "wedges:6", "-o", "program.glb",
            folder=self.folder)
        program = (self.folder / "program.glb").read_bytes()
        self.assertEqual(len(parts(ours)[0]["meshes"]), 6)
        self.assertEqual(parts(ours)[1], parts(program)[1], "the same positions, normals and colours")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
