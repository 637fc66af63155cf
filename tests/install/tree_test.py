"""The installed program finds its data from where it lies, and what belongs to it is there.

    tree_test.py BUILD SOURCE
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from installed import install, run

BUILD, SOURCE = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


class InstalledTree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        cls.tree = install(BUILD, cls.folder.name)
        cls.program = cls.tree / "bin/pomona"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def pomona(self, *words, status=0):
        return run(self.program, *words, folder=self.folder.name, status=status)

    def test_knows_all_templates_scenes_batches_and_styles(self):
        for kind, *options in (("templates", ""), ("scenes", "--scenes", "--batches", "--data-sets"), ("styles", "--styles")):
            there = sorted(file.stem for file in (SOURCE / kind).glob("*.toml"))
            listed = [line.split("\t")[0] for option in options for line in self.pomona("list", *option.split()).splitlines()]
            self.assertEqual(sorted(listed), there, kind)
            for schema in (SOURCE / kind).glob("*.schema.json"):
                self.assertTrue((self.tree / "share/pomona" / kind / schema.name).is_file(), schema)

    def test_templates_with_sketches_and_meshes_are_whole(self):
        self.pomona("check", "lemon", "kidney", "apple")

    def test_composes_a_scene_by_its_name_with_templates_by_theirs(self):
        # Its layout lies beside it: nothing is settled.
        self.pomona("scene", "ripeness", "--quality", "draft", "--detail", "0.3", "-o", "ripeness.json")
        self.assertIn('"overripe-half-1"', pathlib.Path(self.folder.name, "ripeness.json").read_text())

    def test_gives_what_is_published(self):
        # `make verify-table` renews the table where it is meant to be another one.
        self.assertIn("6 of", self.pomona("verify", "cherry"))

    def test_mistyped_scenes_are_told_the_nearest(self):
        self.assertIn("did you mean salad?", self.pomona("scene", "salat", "-o", "x.json", status=66))

    def test_without_its_data_it_says_where_it_looked(self):
        bare = pathlib.Path(self.folder.name, "bare/bin/pomona")
        bare.parent.mkdir(parents=True)
        shutil.copy(self.program, bare)
        for words in (["list"], ["grow", "tomato", "-o", "x.ply"], ["scene", "salad", "-o", "x.json"]):
            error = run(bare, *words, folder=self.folder.name, status=66)
            self.assertIn(str(bare.parent.parent / "share/pomona/"), error)
        self.assertIn("ink\t", run(bare, "list", "--styles", folder=self.folder.name), "styles are part of the program")

    def test_says_its_version_everywhere(self):
        version = re.search(r"VERSION (\d+\.\d+\.\d+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
        self.assertEqual(self.pomona("--version"), f"pomona {version}\n")
        self.assertIn(f'"pomona {version}"', (self.tree / "share/man/man1/pomona.1").read_text())
        self.assertIn(f"\nversion: {version}\n", (self.tree / "share/doc/pomona/CITATION.cff").read_text())
        self.assertIn(f"\n## {version} (", (self.tree / "share/doc/pomona/CHANGELOG.md").read_text())

    def test_manual_page_and_completions_have_every_option(self):
        commands = re.findall(r"^  (\w+) ", self.pomona("-h").split("Subcommands:")[1], re.M)
        self.assertIn("cut", commands)
        pages = [self.tree / place for place in (
            "share/man/man1/pomona.1", "share/bash-completion/completions/pomona",
            "share/zsh/vendor-completions/_pomona", "share/fish/vendor_completions.d/pomona.fish")]
        for command in commands:
            for option in re.findall(r"--([a-z-]+)", self.pomona(command, "-h").split("Options:")[1]):
                for page in pages:
                    self.assertIn(option, page.read_text().replace("\\-", "-"), page)

    def complete(self, *words):
        """What bash offers for the last of the words."""
        script = """source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _pomona 2>/dev/null
printf '%s\\n' "${COMPREPLY[@]}" """
        page = self.tree / "share/bash-completion/completions/pomona"
        subprocess.run(["bash", "-n", page], check=True)
        path = f"PATH={self.program.parent}:/usr/bin:/bin"
        return run("env", path, "bash", "-c", script, "bash", page, *words).split()

    def test_bash_completes_commands_options_and_values(self):
        self.assertEqual(self.complete("pomona", "s"), ["sketch", "scene", "studio"])
        self.assertEqual(self.complete("pomona", "cut", "tomato", "--kn"), ["--knife"])
        self.assertEqual(self.complete("pomona", "grow", "tom"), ["tomato"])
        self.assertEqual(self.complete("pomona", "scene", "sal"), ["salad"])
        self.assertEqual(self.complete("pomona", "cut", "tomato", "--quality", "="), ["draft", "final", "reference"])
        self.assertEqual(self.complete("pomona", "cut", "tomato", "--view", "=", "t"), ["top", "three-quarter"])
        self.assertEqual(self.complete("pomona", "cut", "tomato", "--knife", "b"), ["ball:", "bite:"])
        self.assertEqual(self.complete("pomona", "cut", "tomato", "--style", "pl"), ["plain", "plate"])

    def test_every_knife_of_the_documents_is_in_the_help(self):
        help_of_cut = self.pomona("cut", "-h")
        table = (SOURCE / "docs/reference/commands.md").read_text().split("| KNIFE | cuts along |")[1].split("\n\n")[0]
        knives = re.findall(r"`([a-z]+)[:`]", table)
        self.assertGreater(len(knives), 10)
        for knife in knives:
            self.assertRegex(help_of_cut, rf"\b{knife}\b")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
