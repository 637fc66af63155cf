"""`pomona verify` finds differences from its table, and names the stage.

    verify_test.py PROGRAM SOURCE
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
STAGES = ["curves", "surfaces", "places", "triangles", "colours", ".ply", ".glb", ".png"]


class Verify(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        made = cls.pomona("verify", "cherry", "-o", "made.txt", "--threads", "1", status=0)
        assert made.stdout == "made.txt: hashes of 6 cuts\n", made.stdout
        cls.lines = pathlib.Path(cls.folder.name, "made.txt").read_text().splitlines()
        # The quickest of them, for what is asked again and again.
        cls.line = next(line for line in cls.lines if " half " in line)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def pomona(cls, *words, status):
        done = subprocess.run([PROGRAM, *words], cwd=cls.folder.name, capture_output=True, text=True)
        assert done.returncode == status, f"{words}: status {done.returncode}\n{done.stdout}{done.stderr}"
        return done

    def table(self, *lines):
        pathlib.Path(self.folder.name, "table.txt").write_text("# A comment.\n" + "".join(line + "\n" for line in lines))
        return "--table=table.txt"

    @staticmethod
    def published():
        lines = (SOURCE / "templates/hashes.txt").read_text().splitlines()
        return [line for line in lines if not line.startswith("#")]

    def changed(self, *stages):
        words = self.line.split()
        for stage in stages:
            words[3 + STAGES.index(stage)] = "01234567"
        return " ".join(words)

    def test_a_table_that_this_machine_made_is_met_on_several_threads(self):
        said = self.pomona("verify", self.table(*self.lines), "--threads", "3", status=0)
        self.assertEqual(said.stdout, "6 of 6 cuts compared, 0 differ: this machine gives what is published.\n")
        self.assertIn("verify (6)", said.stderr, "progress")

    def test_the_first_stage_that_differs_is_named(self):
        for number, stage in enumerate(STAGES):
            said = self.pomona("verify", "--all", self.table(self.changed(stage, *STAGES[number:])), status=1)
            self.assertIn(f"half: differs from {stage} on\n", said.stdout)
            self.assertIn(f"does not give what is published, from {stage} on.", said.stdout)

    def test_the_result_for_programs(self):
        said = json.loads(self.pomona("verify", "--json", self.table(self.changed(".glb")), status=1).stdout)
        seed = int(self.line.split()[1])
        self.assertEqual(said, {"same": False, "compared": 1, "published": 1,
                                "different": [{"template": "cherry", "seed": seed, "knife": "half", "stage": ".glb"}]})

    def test_quiet_leaves_the_status(self):
        said = self.pomona("verify", "--quiet", self.table(self.changed(".png")), status=1)
        self.assertEqual(said.stdout + said.stderr, "")

    def test_a_tenth_is_compared_unless_all_is_asked_for(self):
        words = self.line.split()
        other = " ".join([words[0], str((int(words[1]) + 1) % 10), *words[2:]])
        said = self.pomona("verify", self.table(self.line, other), status=0)
        self.assertIn("1 of 2 cuts compared", said.stdout)
        said = self.pomona("verify", "--all", self.table(self.line, other), status=1)
        self.assertIn("2 of 2 cuts compared, 1 differ", said.stdout)

    def test_each_template_and_knife_has_one_seed_of_ten(self):
        self.assertEqual(len(self.lines), 2 + 6)
        self.assertEqual(len({line.split()[2] for line in self.lines[2:]}), 6)

    def test_a_knife_that_is_not_for_a_fruit_is_left_out(self):
        self.pomona("verify", "spinach", "-o", "leaf.txt", status=0)
        knives = {line.split()[2] for line in pathlib.Path(self.folder.name, "leaf.txt").read_text().splitlines()[2:]}
        self.assertEqual(knives, {line.split()[2] for line in self.lines[2:]} - {"peel:3mm"})
        line = " ".join(["spinach", "1", "peel:3mm", *self.line.split()[3:]])
        said = self.pomona("verify", "--all", self.table(line), status=1)
        self.assertIn("spinach, seed 1, peel:3mm: differs from", said.stdout)

    def test_what_is_wrong_is_told(self):
        def error(*words, status):
            return self.pomona("verify", *words, status=status).stderr
        self.assertIn("table.txt:3:1: error: is no line of hashes", error(self.table(self.line, "tomato 1 half"), status=65))
        self.assertIn("table.txt:2:1: error:", error(self.table(self.line.replace(" ", " x", 1)), status=65))
        self.assertIn("table.txt:3:1: error: is a cut that an earlier", error(self.table(self.line, self.line), status=65))
        self.assertIn("did you mean cherry?", error("chery", self.table(self.line), status=66))
        self.assertIn('no template "chert"', error("--all", self.table(self.line.replace("cherry", "chert")), status=66))
        self.assertIn("table.txt:2:1: error:", error(self.table(self.line.replace("half", "hlaf")), status=65))
        self.assertIn("table.txt:1:1: error: holds no hashes", error(self.table(), status=65))
        self.assertIn("no such file", error("--table", "missing.txt", status=66))
        self.assertIn("is a folder", error("--table", ".", status=66))
        error("-o", "x.txt", "--table", "made.txt", status=64)
        error("cherry", "-o", "missing/x.txt", status=73)
        self.assertFalse(pathlib.Path(self.folder.name, "x.txt").exists())

    def test_the_published_table_has_every_template_and_knife(self):
        there = {(line.split()[0], line.split()[2]) for line in self.published()}
        names = {file.stem for file in (SOURCE / "templates").glob("*.toml")}
        knives = {line.split()[2] for line in self.lines[2:]}
        # A leaf and a receptacle are thinner; bunches and heads of leaves have no one skin.
        thin, many = ("spinach", "raspberry"), ("blackberry", "broccoli", "cabbage", "currants", "garlic", "grapes", "lettuce")
        unfit = {(name, "peel:3mm") for name in (*thin, *many)}
        missing = sorted({(name, knife) for name in names for knife in knives} - there - unfit)
        self.assertEqual(missing, [], "`make verify-table` makes it anew")

    @unittest.skipIf("SANITIZED" in os.environ, "a quarter of an hour")
    def test_the_published_table_holds_for_a_cut_of_every_template(self):
        """Here, because a step that changes an organ changes all templates that place it; CI compares more cuts."""
        of_each = {}
        for line in self.published():
            if line.split()[2] == "half":
                of_each.setdefault(line.split()[0], []).append(line)
        one_of_each = [cuts[number % len(cuts)] for number, cuts in enumerate(of_each.values())]
        said = self.pomona("verify", "--all", self.table(*one_of_each), status=0)
        self.assertIn(f"{len(one_of_each)} of {len(one_of_each)} cuts compared, 0 differ", said.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
