#!/usr/bin/env python3
"""`pomona batch` and `merge` as a user starts them: the same bytes with any threads and shards, the manifest against the files,
errors of bad input, locks.

    batch_test.py PROGRAM SOURCE [unittest's words]
"""

import fcntl
import hashlib
import html.parser
import json
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from batches import SMALL, pomona, tree  # noqa: E402

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


class Sandbox(unittest.TestCase):
    """A folder with small.toml; the batch is made once for all tests."""

    @classmethod
    def setUpClass(cls):
        cls.once = tempfile.TemporaryDirectory(prefix="pomona-test-")
        (pathlib.Path(cls.once.name) / "small.toml").write_text(SMALL)
        result = pomona(PROGRAM, "batch", "small.toml", "-o", "whole", "--threads", 2, folder=cls.once.name)
        assert result.returncode == 0, result.stderr
        cls.whole = pathlib.Path(cls.once.name) / "whole"
        cls.expected = tree(cls.whole)

    @classmethod
    def tearDownClass(cls):
        cls.once.cleanup()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.path = pathlib.Path(self.folder.name)
        (self.path / "small.toml").write_text(SMALL)

    def tearDown(self):
        self.folder.cleanup()

    def run_batch(self, *words, status=0, batch="small.toml"):
        return self.run_pomona("batch", batch, "-o", "out", *words, status=status)

    def run_pomona(self, *words, status=0):
        result = pomona(PROGRAM, *words, folder=self.path)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def assert_as_expected(self, folder="out"):
        self.assertEqual(tree(self.path / folder), self.expected)


class SameBytes(Sandbox):
    def test_of_any_number_of_threads(self):
        self.run_batch("--threads", "1")
        self.assert_as_expected()

    def test_with_little_memory(self):
        self.run_batch("--threads", "4", "--memory", "1MB")
        self.assert_as_expected()

    def test_of_shards_in_any_order(self):
        for number in (3, 1, 2):
            self.run_batch("--shard", f"{number}/3")
        self.run_pomona("merge", "out")
        self.assert_as_expected()

    def test_of_shards_side_by_side(self):
        runs = [subprocess.Popen([PROGRAM, "batch", "small.toml", "-o", "out", "--shard", f"{n}/4", "--quiet"], cwd=self.path)
                for n in (1, 2, 3, 4)]
        self.assertEqual([run.wait() for run in runs], [0, 0, 0, 0])
        self.run_pomona("merge", "out")
        self.assert_as_expected()

    def test_of_shards_in_folders_that_are_copied_together(self):
        for number in (1, 2):
            self.run_pomona("batch", "small.toml", "-o", f"part{number}", "--shard", f"{number}/2")
            shutil.copytree(self.path / f"part{number}", self.path / "out", dirs_exist_ok=True)
        self.run_pomona("merge", "out")
        self.assert_as_expected()

    def test_of_more_shards_than_items(self):
        for number in range(1, 13):
            self.run_batch("--shard", f"{number}/12", "--quiet")
        self.run_pomona("merge", "out")
        self.assert_as_expected()

    def test_as_cut_writes(self):
        item = json.loads((self.whole / "cut/001/item.json").read_text())
        self.run_pomona("cut", item["template"], "--seed", item["seed"], "--quality", "draft", "--detail", "0.1",
                        *(word for knife in item["knives"] for word in ("--knife", knife)), "-o", "by_hand.glb")
        self.assertEqual((self.path / "by_hand.glb").read_bytes(), (self.whole / "cut/001/radish.glb").read_bytes())

    def test_with_all_maps_as_cut_writes(self):
        text = ('[batch]\nformat = 1\nname = "b"\ntexture = 64\nmaps = "all"\ndetail = 0.1\n'
                '[[entry]]\nname = "all"\ntemplates = "radish"\nseeds = 3\nknives = "half"\n'
                '[[entry]]\nname = "color"\ntemplates = "radish"\nseeds = 3\nknives = "half"\nmaps = "color"\n')
        (self.path / "maps.toml").write_text(text)
        self.run_batch(batch="maps.toml")
        for name, words in ("all", ()), ("color", ("--maps", "color")):
            item = json.loads((self.path / f"out/{name}/000/item.json").read_text())
            self.assertEqual(item.get("maps"), "all" if name == "all" else None)
            self.run_pomona("cut", "radish", "--seed", "3", "--knife", "half", "--quality", "draft", "--detail", "0.1",
                            "--texture", "64", *words, "-o", f"{name}.glb")
            made = (self.path / f"out/{name}/000/radish.glb").read_bytes()
            self.assertEqual(made, (self.path / f"{name}.glb").read_bytes())
            self.assertEqual(b"normalTexture" in made, name == "all")

    def test_of_an_entry_whatever_stands_beside_it(self):
        other = SMALL.replace('name = "files"', 'name = "other"').replace("count = 2", "count = 2\nlod = 0")
        (self.path / "other.toml").write_text(other)
        self.run_batch(batch="other.toml")
        ours = {name: hash for name, hash in tree(self.path / "out").items() if name.startswith("cut/")}
        self.assertEqual(ours, {name: hash for name, hash in self.expected.items() if name.startswith("cut/")})


class Resume(Sandbox):
    def test_begins_a_folder_that_is_not_there(self):
        self.run_batch("--resume")
        self.assert_as_expected()

    def test_makes_only_what_is_missing(self):
        shutil.copytree(self.whole, self.path / "out")
        shutil.rmtree(self.path / "out/cut/003")
        (self.path / "out/files/000/radish.ply").write_bytes(b"cut short")
        (self.path / "out/cut/004/item.json").write_text("{")
        result = json.loads(self.run_batch("--resume", "--json").stdout)
        self.assertEqual((result["made"], result["found"]), (3, 6))
        self.assert_as_expected()

    def test_with_verify_makes_anew_what_is_not_as_it_was_written(self):
        shutil.copytree(self.whole, self.path / "out")
        file = self.path / "out/files/000/radish.ply"
        bytes_then = bytearray(file.read_bytes())
        bytes_then[-1] ^= 1
        file.write_bytes(bytes_then)
        self.assertEqual(json.loads(self.run_batch("--resume", "--json").stdout)["made"], 0, "lengths alone are looked at")
        self.assertEqual(json.loads(self.run_batch("--resume", "--verify", "--json").stdout)["made"], 1)
        self.assert_as_expected()
        self.run_batch("--verify", status=64)

    def test_is_asked_for_where_items_are_there(self):
        shutil.copytree(self.whole, self.path / "out")
        self.assertIn("--resume", self.run_batch(status=73).stderr)
        self.assert_as_expected()

    def test_goes_on_after_a_signal_that_asks_to_end(self):
        run = subprocess.Popen([PROGRAM, "batch", "small.toml", "-o", "out", "--threads", "1"], cwd=self.path,
                               stderr=subprocess.PIPE, text=True)
        while not (self.path / "out/cut").exists():
            time.sleep(0.002)
        run.send_signal(signal.SIGTERM)
        self.assertIn("--resume", run.communicate()[1])
        self.assertEqual(run.returncode, 75)
        self.assertFalse((self.path / "out/.pomona").exists())
        self.run_batch("--resume")
        self.assert_as_expected()


class Update(Sandbox):
    """A folder that grows with its batch file ends with the bytes of a new one."""

    def updated(self, text, *words):
        """What --update says, after the folder of the small batch has been updated to this text."""
        if not (self.path / "out").exists():
            shutil.copytree(self.whole, self.path / "out")
        (self.path / "small.toml").write_text(text)
        report = json.loads(self.run_batch("--update", "--json", *words).stdout)
        self.run_pomona("batch", "small.toml", "-o", "anew", "--quiet")
        self.assertEqual(tree(self.path / "out"), tree(self.path / "anew"))
        shutil.rmtree(self.path / "anew")
        return report

    def test_begins_a_folder_and_keeps_one_that_is_as_it_should_be(self):
        self.run_batch("--update")
        self.assert_as_expected()
        report = self.updated(SMALL)
        self.assertEqual((report["made"], report["found"]), (0, 9))

    def test_makes_only_what_is_new(self):
        # A further variant of the last template, and a further way to cut, which gives all items other numbers.
        report = self.updated(SMALL.replace("seeds = 3", "seeds = [3, 4]"))
        self.assertEqual((report["made"], report["found"]), (1, 9))
        report = self.updated(SMALL.replace('knives = ["half"', 'knives = ["across", "half"'))
        self.assertEqual((report["made"], report["found"]), (4, 9))

    def test_moves_items_that_lie_deeper_among_more_than_a_thousand(self):
        text = SMALL[:SMALL.index("[[entry]]")] + '[[entry]]\nname = "many"\ntemplates = "radish"\nseeds = [1, 2]\n'
        (self.path / "small.toml").write_text(text)
        self.run_batch("--quiet")
        # The thousand and first item is what counts: the others fail at once.
        more = text.replace("seeds = [1, 2]", "seeds = [2, 1]\nknives = [" + ", ".join(
            f'"slices:{0.001 + n * 1e-6:.6f}mm"' for n in range(500)) + ", []]")
        (self.path / "small.toml").write_text(more)
        report = json.loads(self.run_batch("--update", "--json", "--quiet", status=1).stdout)
        self.assertEqual((report["items"], report["found"], len(report["failed"])), (1002, 2, 1000))
        record = json.loads((self.path / "out/many/001/001/item.json").read_text())
        self.assertEqual((record["item"], record["seed"], record["knives"]), ("many/001/001", 1, []))
        self.assertFalse((self.path / "out/many/002").exists())

    def test_removes_what_is_no_longer_asked_for_and_says_so(self):
        text = SMALL[:SMALL.rindex("[[entry]]")]
        shutil.copytree(self.whole, self.path / "out")
        (self.path / "out/mine.txt").write_text("not of the batch")
        (self.path / "small.toml").write_text(text)
        result = self.run_batch("--update")
        self.assertIn("kept 8 items, removed 1 that the batch no longer asks for: files/000", result.stderr)
        self.assertFalse((self.path / "out/files").exists())
        self.assertTrue((self.path / "out/mine.txt").exists())

    def test_makes_anew_what_another_template_quality_or_program_gives(self):
        shutil.copy(SOURCE / "templates/radish.toml", self.path / "mine.toml")
        text = SMALL.replace('"radish", "cherry"', '"mine.toml", "cherry"')
        self.assertEqual(self.updated(text)["made"], 4)
        with open(self.path / "mine.toml", "a") as file:
            file.write("# another template\n")
        self.assertEqual(self.updated(text)["made"], 4)
        self.assertEqual(self.updated(text.replace("seeds = 3", "seeds = 3\nthumbnail = 33"))["made"], 1)

        # Items of another version have other recipes.
        record = self.path / "out/cut/000/item.json"
        record.write_text(re.sub('"recipe":"[0-9a-f]*"', '"recipe":"' + "0" * 64 + '"', record.read_text()))
        batch = self.path / "out/batch.json"
        batch.write_text(batch.read_text().replace('"program": "pomona', '"program": "pear'))
        self.assertEqual(self.updated(text.replace("seeds = 3", "seeds = 3\nthumbnail = 33"))["made"], 1)

    def test_refuses_another_batch_and_shards(self):
        shutil.copytree(self.whole, self.path / "out")
        (self.path / "small.toml").write_text(SMALL.replace('name = "test"', 'name = "other"'))
        self.assertIn("another batch", self.run_batch("--update", status=73).stderr)
        self.assertIn("--shard", self.run_batch("--update", "--shard", "1/2", status=64).stderr)
        self.run_batch("--update", "--resume", status=64)
        self.assert_as_expected()

    def test_is_what_resume_hints_at(self):
        shutil.copytree(self.whole, self.path / "out")
        (self.path / "small.toml").write_text(SMALL.replace("count = 2", "count = 3"))
        self.assertIn("--update", self.run_batch("--resume", status=73).stderr)


class LaidOut(Sandbox):
    HEAD = '[batch]\nformat = 1\nname = "b"\ndetail = 0.1\nformats = ["obj", "glb"]\nlayout = "table"\n'
    ENTRY = '[[entry]]\nname = "a"\ntemplates = "lemon"\nseeds = 3\nknives = "half"\n'

    def boxes(self, file):
        """Of each piece: the lowest and the highest x, y and z."""
        found = []
        for line in (self.path / "out/a/000" / file).read_text().splitlines():
            words = line.split()
            if words[:1] == ["o"]:
                found.append([])
            elif words[:1] == ["v"]:
                found[-1].append([float(word) for word in words[1:4]])
        return [([min(p[k] for p in points) for k in range(3)], [max(p[k] for p in points) for k in range(3)]) for points in found]

    def test_pieces_lie_side_by_side_on_the_ground(self):
        (self.path / "laid.toml").write_text(self.HEAD + self.ENTRY)
        self.run_batch(batch="laid.toml")
        first, second = self.boxes("lemon.obj")
        for low, high in (first, second):
            self.assertAlmostEqual(low[1], 0, delta=1e-4)
        apart = any(first[1][k] < second[0][k] or second[1][k] < first[0][k] for k in (0, 2))
        self.assertTrue(apart, (first, second))

    def test_pieces_have_files_of_their_own(self):
        (self.path / "apart.toml").write_text(self.HEAD + 'pieces = "apart"\n' + self.ENTRY)
        self.run_batch(batch="apart.toml")
        files = {path.name for path in (self.path / "out/a/000").iterdir()}
        self.assertEqual(files, {"item.json", "lemon-1.obj", "lemon-2.obj", "lemon-1.glb", "lemon-2.glb"})
        for number in (1, 2):
            (low, high), = self.boxes(f"lemon-{number}.obj")
            self.assertAlmostEqual(low[1], 0, delta=1e-4)
            self.assertTrue(low[0] < 0 < high[0] and low[2] < 0 < high[2])


class Merge(Sandbox):
    def test_says_what_is_missing(self):
        self.run_batch("--shard", "1/2")
        result = self.run_pomona("merge", "out", status=1)
        made = json.loads(self.run_pomona("merge", "out", "--json", status=1).stdout)
        self.assertIn(f"{made['missing']} of 9 items are missing", result.stderr)
        self.assertIn(f"{made['first_missing'][0]}: error: missing", result.stderr)
        self.assertFalse((self.path / "out/manifest.json").exists())

    def test_needs_a_batch(self):
        (self.path / "empty").mkdir()
        self.run_pomona("merge", "empty", status=66)
        self.run_pomona("merge", "nowhere", status=66)
        self.assertEqual(list((self.path / "empty").iterdir()), [])

    def test_refuses_a_record_that_is_none(self):
        (self.path / "out").mkdir()
        (self.path / "out/batch.json").write_text('{"format": 1, "entries": [{"name": "..", "items": 1}]}')
        self.assertIn("batch.json:1:1: error", self.run_pomona("merge", "out", status=65).stderr)


class Failures(Sandbox):
    def test_are_listed_and_do_not_stop_the_others(self):
        # Radishes have no room for so many slices, which is known only when they are grown.
        text = SMALL.replace('name = "test"', 'name = "failing"').replace("seeds = 3", 'seeds = 3\nknives = ["half", "slices:0.01mm"]')
        (self.path / "failing.toml").write_text(text)
        result = self.run_batch("--quiet", batch="failing.toml", status=1)
        manifest = json.loads((self.path / "out/manifest.json").read_text())
        failed = [item for item in manifest["items"] if "error" in item]
        self.assertEqual([item["knives"] for item in failed], [["slices:0.01mm"]])
        self.assertEqual(manifest["failed"], 1)
        self.assertIn(f"{failed[0]['item']}: error: {failed[0]['error']}", result.stderr)
        self.assertEqual(failed[0]["files"], [])
        self.assertEqual(len(manifest["items"]), 10)

        # They are tried again, and shards give the same result.
        before = tree(self.path / "out")
        self.assertEqual(json.loads(self.run_batch("--resume", "--json", batch="failing.toml", status=1).stdout)["made"], 1)
        self.assertEqual(tree(self.path / "out"), before)
        for number in (2, 1):
            result = pomona(PROGRAM, "batch", "failing.toml", "-o", "shards", "--shard", f"{number}/2", folder=self.path)
            self.assertIn(result.returncode, (0, 1))
        self.run_pomona("merge", "shards", status=1)
        self.assertEqual(tree(self.path / "shards"), before)


class Manifest(Sandbox):
    def setUp(self):
        super().setUp()
        self.manifest = json.loads((self.whole / "manifest.json").read_text())

    def test_knows_every_file(self):
        listed = {"batch.json", "manifest.json", "index.html"}
        for item in self.manifest["items"]:
            listed.add(item["item"] + "/item.json")
            for file in item["files"]:
                path = self.whole / item["item"] / file["name"]
                self.assertEqual(path.stat().st_size, file["bytes"])
                summed = subprocess.run(["sha256sum", path], capture_output=True, text=True, check=True).stdout
                self.assertEqual(summed.split()[0], file["sha256"])
                listed.add(item["item"] + "/" + file["name"])
        self.assertEqual({name for name, hash in self.expected.items() if hash}, listed)

    def test_says_what_was_made(self):
        self.assertEqual(len(self.manifest["items"]), 9)
        first, second = self.manifest["items"][:2]
        self.assertEqual((first["knives"], second["knives"]), (["half"], ["half", "across"]))
        self.assertEqual(first["seed"], second["seed"])
        self.assertGreater(len(second["pieces"]), len(first["pieces"]))
        for item in self.manifest["items"]:
            self.assertGreater(sum(piece["volume"] for piece in item["pieces"]), 1e-7)
        self.assertEqual({item["seed"] for item in self.manifest["items"] if item["entry"] == "files"}, {3})

    def test_tells_the_template_by_its_bytes(self):
        hashes = {fruit["name"]: fruit["sha256"] for fruit in self.manifest["batch"]["templates"]}
        text = (SOURCE / "templates/radish.toml").read_bytes()
        alone = b"radish.toml\n%d\n" % len(text) + text
        self.assertEqual(hashes["radish"], hashlib.sha256(alone).hexdigest())

    def test_holds_no_time_host_or_folder(self):
        for path in self.whole.rglob("*"):
            if path.is_file():
                self.assertNotIn(self.once.name.encode(), path.read_bytes())

    def test_leaves_nothing_else(self):
        self.assertFalse((self.whole / ".pomona").exists())


class Page(Sandbox):
    def test_holds_all_items_and_escapes_what_they_are_called(self):
        text = (self.whole / "index.html").read_text()
        self.assertIn("<title>Five &amp; &lt;more&gt;</title>", text)
        scripts, open_script = [], []

        class Scripts(html.parser.HTMLParser):
            def handle_starttag(self, tag, attributes):
                attributes = dict(attributes)
                # Nothing is fetched from the network.
                assert "src" not in attributes or tag == "img", attributes
                if tag == "script":
                    open_script.append(attributes.get("id"))

            def handle_data(self, data):
                if self.cdata_elem == "script":
                    scripts.append((open_script[-1], data))

        Scripts().feed(text)
        self.assertNotIn("http", text)
        rows = json.loads("".join(data for name, data in scripts if name == "items"))
        self.assertEqual(len(rows), 9)
        self.assertEqual(rows[0][0], "cut/000")


class BadInput(Sandbox):
    def assert_untouched(self):
        self.assertFalse((self.path / "out").exists())

    def test_shards_out_of_range(self):
        for shard in ("0/3", "4/3", "1/0", "a/b", "1", "-1/3", "1/99999999999"):
            self.assertIn("--shard", self.run_batch(f"--shard={shard}", status=64).stderr)
        self.assert_untouched()

    def test_memory_that_is_none(self):
        for size in ("2", "GB", "-1GB", "twoGB"):
            self.assertIn("--memory", self.run_batch(f"--memory={size}", status=64).stderr)
        self.assert_untouched()

    def test_more_than_ten_million(self):
        (self.path / "small.toml").write_text(SMALL.replace("count = 2", "count = 9000000"))
        self.assertIn("small.toml:11:8: error", self.run_batch(status=65).stderr)
        self.assert_untouched()

    def test_unknown_keys(self):
        (self.path / "small.toml").write_text(SMALL.replace("thumbnail =", "thumbnial ="))
        stderr = self.run_batch(status=65).stderr
        self.assertIn('small.toml:8:1: error: unknown key "thumbnial"', stderr)
        self.assertIn('did you mean "thumbnail"?', stderr)
        self.assert_untouched()

    def test_names_that_are_none(self):
        self.assertIn("did you mean", self.run_batch(batch="smal_batch", status=66).stderr)
        self.run_batch(batch="nowhere.toml", status=66)
        (self.path / "small.toml").write_text(SMALL.replace('"cherry"', '"chery"'))
        self.assertIn("small.toml:12:24: error", self.run_batch(status=66).stderr)
        self.assert_untouched()

    def test_folders_of_another_batch_seed_version_or_template(self):
        shutil.copytree(self.whole, self.path / "out")
        record = self.path / "out/batch.json"
        for old, new, said in (('"name": "test"', '"name": "x"', "another batch"), ('"program": "pomona', '"program": "pear', "another version"),
                               ('"seed": 5', '"seed": 6', "another seed"), ('"sha256": "', '"sha256": "0', "templates that have changed"),
                               ('"detail": 0.1', '"detail": 0.2', "before it was changed"), ("{", "[", "cannot be read")):
            record.write_text((self.whole / "batch.json").read_text().replace(old, new, 1))
            before = tree(self.path / "out")
            self.assertIn(said, self.run_batch("--resume", status=73).stderr)
            self.assertEqual(tree(self.path / "out"), before)

    def test_folders_of_something_else(self):
        (self.path / "out").mkdir()
        (self.path / "out/thesis.txt").write_text("all my work")
        self.assertIn("holds no batch", self.run_batch("--resume", status=73).stderr)
        self.assertEqual([path.name for path in (self.path / "out").iterdir()], ["thesis.txt"])

    def test_where_no_folder_can_be(self):
        (self.path / "out").write_text("a file")
        self.run_batch(status=73)
        (self.path / "out").unlink()
        self.run_pomona("batch", "small.toml", "-o", "no/such/out", status=73)


class Locks(Sandbox):
    def held(self, name, kind):
        (self.path / "out/.pomona").mkdir(parents=True, exist_ok=True)
        file = open(self.path / "out/.pomona" / name, "w")
        fcntl.flock(file, kind)
        return file

    def test_hold_two_runs_of_a_shard_apart(self):
        with self.held("lock", fcntl.LOCK_SH), self.held("1-of-2.lock", fcntl.LOCK_EX):
            self.assertIn("another run", self.run_batch("--shard", "1/2", status=75).stderr)
            self.run_batch("--shard", "2/2")
            self.run_batch("--resume", status=75)
            self.run_pomona("merge", "out", status=75)
        self.run_batch("--shard", "1/2")
        self.run_pomona("merge", "out")
        self.assert_as_expected()

    def test_end_with_who_held_them(self):
        self.held("lock", fcntl.LOCK_EX).close()
        (self.path / "out/.pomona/1-of-1").mkdir()
        (self.path / "out/.pomona/1-of-1/0").write_text("left behind")
        (self.path / "out/.pomona/5-of-9/3").mkdir(parents=True)
        self.run_batch()
        self.assert_as_expected()


class Schema(Sandbox):
    def setUp(self):
        super().setUp()
        self.schema = json.loads((SOURCE / "scenes/batch.schema.json").read_text())

    def test_is_one_and_passes_what_the_program_passes(self):
        jsonschema.Draft7Validator.check_schema(self.schema)
        for text in (SMALL, *((SOURCE / "scenes" / (name + ".toml")).read_text() for name in ("small_batch", "thousand_pieces"))):
            jsonschema.validate(tomllib.loads(text), self.schema)

    def test_refuses_what_the_program_refuses(self):
        # Errors that need knives and templates, or several entries at once.
        beyond = {"not_toml", "bad_knife", "bad_knife_within", "same_names", "too_many", "no_ripeness"}
        for file in (SOURCE / "tests/batch/bad").glob("*.toml"):
            if file.stem not in beyond:
                with self.assertRaises(jsonschema.ValidationError, msg=file.stem):
                    jsonschema.validate(tomllib.loads(file.read_text()), self.schema)

    def test_knows_the_keys_that_the_reader_asks_for(self):
        text = (SOURCE / "generator/batch/batch_file.cpp").read_text()
        properties = self.schema["properties"]
        listed = subprocess.run([PROGRAM, "pages", "options"], capture_output=True, check=True).stdout
        of_options = {option["key"] for option in json.loads(listed) if option["batch_key"]}
        for key in {*properties["batch"]["properties"], *properties["entry"]["items"]["properties"]}:
            self.assertTrue(f'"{key}"' in text or key in of_options, key)


class Listed(Sandbox):
    def test_by_list_and_passed_by_check(self):
        names = [line.split("\t")[0] for line in self.run_pomona("list", "--batches").stdout.splitlines()]
        self.assertEqual(names, ["small_batch", "thousand_pieces"])
        self.assertNotIn("batch", self.run_pomona("list", "--scenes").stdout)
        self.run_pomona("check", "small.toml")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
