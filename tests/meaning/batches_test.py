#!/usr/bin/env python3
"""Every list of a batch with two values, in both orders, and every other option in two entries: each file of each item equals,
to the byte, the output of `cut` with the options in the item's record. So no item depends on the one before.

    batches_test.py PROGRAM SOURCE
"""

import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from boxes import Program  # noqa: E402

# Lists: the key, two values, the rest of the entry.
LISTS = [
    ("templates", ["radish", "cherry"], {}),
    ("seeds", [5, 3], {}),
    ("folds", [5, 4], {"templates": "pepper"}),
    ("ripeness", [1.6, 0.4], {"templates": "tomato"}),
    ("browning", [0.7, 0.2], {"templates": "apple"}),
    ("knives", ["half", "wedges:3"], {}),
    ("knives", [["half", "across"], "across"], {}),
    ("quality", ["final", "draft"], {}),
    ("texture", [128, 64], {}),
    ("lod", [1, 0], {"detail": 0.3}),
]
# Options with one value: two entries that differ in it. None: it is not set.
ENTRIES = [
    ("detail", [0.1, 0.2]), ("variation", [1.5, 0.5]), ("scale", [2, 0.5]), ("faces", ["coarse", "fine"]), ("explode", [2, 1]),
    ("piece", [2, 1]), ("style", ["plate", "plain"]), ("engine", ["godot", "any"]), ("feature_ids", [True, None]),
    ("as_drawn", [True, None]), ("curves_only", [True, None]), ("maps", ["color", "all"]), ("texel", ["0.5mm", "1mm"]),
    ("diffuser", ["harmonic", "cpu"]),
]
USUAL = {"templates": "radish", "seeds": 3, "knives": "half", "quality": "draft", "detail": 0.1}
WORDS = ("variation", "scale", "detail", "faces", "explode", "piece", "style", "engine", "maps", "texel", "diffuser", "quality")


def text(value):
    return json.dumps(value)


class Batches(Program):
    cut = {}  # what words make, of all tests

    def batch(self, entries):
        """Makes one batch of these entries, by one thread; returns the records of each entry's items, in order."""
        said = '[batch]\nformat = 1\nname = "b"\nseed = 2\n'
        for number, entry in enumerate(entries):
            said += f'[[entry]]\nname = "e{number}"\n'
            said += "".join(f"{key} = {text(value)}\n" for key, value in entry.items() if value is not None)
        (self.path / "b.toml").write_text(said)
        self.pomona("batch", "b.toml", "-o", "out", "--threads", "1")
        items = json.loads((self.path / "out/manifest.json").read_text())["items"]
        return [[item for item in items if item["entry"] == f"e{number}"] for number in range(len(entries))]

    def assert_as_cut(self, item, entry):
        """Checks that `cut` makes these files."""
        words = [item["template"], "--seed", item["seed"]]
        for knife in item["knives"]:
            words += ["--knife", knife]
        for key in ("folds", "ripeness", "browning"):
            if entry.get(key) is not None and key in item:
                words += [f"--{key}", item[key]]
        for key in WORDS:
            value = item.get(key, entry.get(key)) if key == "quality" else entry.get(key)
            if key == "maps" and value is None and ("texture" in item or "texel" in entry):
                value = "color"  # what a batch says where its file says nothing
            if value is not None:
                words += ["--" + key.replace("_", "-"), value]
        for key in ("texture", "lod"):
            if item.get(key):
                words += [f"--{key}", item[key]]
        for key in ("feature_ids", "as_drawn", "curves_only"):
            if entry.get(key):
                words.append("--" + key.replace("_", "-"))
        for file in item["files"]:
            made = self.by_hand(tuple(map(str, words)), file["name"])
            self.assertEqual(made, (self.path / "out" / item["item"] / file["name"]).read_bytes(), (item["item"], file["name"], words))

    def by_hand(self, words, name):
        if (words, name) not in self.cut:
            with tempfile.TemporaryDirectory(dir=self.path) as folder:
                self.pomona("cut", *words, "-o", pathlib.Path(folder) / name)
                self.cut[words, name] = (pathlib.Path(folder) / name).read_bytes()
        return self.cut[words, name]

    def test_lists_in_both_orders(self):
        entries = [{**USUAL, **besides, key: order} for key, values, besides in LISTS for order in (values, values[::-1])]
        made = self.batch(entries)
        for number, (key, values, _) in enumerate(LISTS):
            hashes = {}
            for entry, items in zip(entries[2 * number:2 * number + 2], made[2 * number:2 * number + 2]):
                self.assertEqual(len(items), 2, (key, entry[key]))
                for item, value in zip(items, entry[key]):
                    with self.subTest(key=key, value=value):
                        shown = {"templates": item["template"], "seeds": item["seed"],
                                 "knives": item["knives"] if len(item["knives"]) > 1 else item["knives"][0]}.get(key, item.get(key, 0))
                        self.assertEqual(shown, value)
                        self.assert_as_cut(item, {**entry, key: value})
                        files = [file["sha256"] for file in item["files"]]
                        self.assertEqual(hashes.setdefault(text(value), files), files, "the order of a list changes no item")
            self.assertNotEqual(*hashes.values(), key)

    def test_entries_in_both_orders(self):
        entries = [{**USUAL, **({"texture": 64} if key == "maps" else {}), key: value}
                   for key, values in ENTRIES for value in (*values, values[0])]
        for items, entry in zip(self.batch(entries), entries, strict=True):
            for item in items:
                with self.subTest(entry=entry):
                    self.assert_as_cut(item, entry)

    def test_formats_in_both_orders(self):
        kinds = ["glb", "usda", "ply", "obj", "stl", "pov", "svg"]
        entries = [{**USUAL, "formats": kinds}, {**USUAL, "formats": kinds[::-1]}]
        (one,), (other,) = self.batch(entries)
        by_name = lambda item: sorted((file["name"], file["sha256"]) for file in item["files"])
        self.assertEqual(by_name(one), by_name(other))
        self.assertGreaterEqual({name.split(".")[-1] for name, _ in by_name(one)}, set(kinds))
        one["files"] = [file for file in one["files"] if file["name"].split(".")[-1] in ("glb", "ply", "obj", "stl", "usda")]
        self.assert_as_cut(one, entries[0])

    def test_two_entries_of_one_template_differ(self):
        entry = {"templates": "tomato", "count": 2, "knives": "half", "quality": "draft", "detail": 0.1}
        items = sum(self.batch([entry, entry]), [])
        self.assertEqual(len({item["seed"] for item in items}), 4)
        self.assertEqual(len({file["sha256"] for item in items for file in item["files"]}), 4)
        for item in items:
            self.assert_as_cut(item, entry)


if __name__ == "__main__":
    Program.program, Program.source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
