#!/usr/bin/env python3
"""scenes/scene.schema.json says of scene files what the reader says.

    scene_schema_test.py SOURCE
"""

import json
import pathlib
import re
import sys
import tomllib
import unittest

import jsonschema

SOURCE = pathlib.Path(sys.argv[1]).resolve()
SCHEMA = json.loads((SOURCE / "scenes/scene.schema.json").read_text())

# What only a reader of profiles and knives, or one that compares entries or numbers with each other, can know.
BEYOND = {"bad_knife", "dish_part_of_mistyped", "dish_part_of_none", "in_mistyped_dish", "in_no_dish", "not_toml",
          "on_what_others_are_in", "profile_crosses_itself", "profile_far_up", "profile_is_no_path",
          "profile_off_axis", "profile_upside_down", "ripeness_range_empty", "same_name_twice", "share_of_no_total",
          "too_many_copies", "too_many_pieces", "total_without_shares"}


def keys_of(schema):
    """Every key of objects, at any depth."""
    if isinstance(schema, list):
        return set().union(*map(keys_of, schema))
    if not isinstance(schema, dict):
        return set()
    return set(schema.get("properties", {})).union(*map(keys_of, schema.values()))


class SceneSchema(unittest.TestCase):
    def test_is_one(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)

    def test_passes_every_shipped_scene(self):
        scenes = [path for path in (SOURCE / "scenes").glob("*.toml") if "\n[[pieces]]" in path.read_text()]
        self.assertGreaterEqual(len(scenes), 10)
        for path in scenes:
            with self.subTest(path.name):
                self.assertTrue(path.read_text().startswith("#:schema ./scene.schema.json\n"))
                jsonschema.validate(tomllib.loads(path.read_text()), SCHEMA)

    def test_refuses_what_the_reader_refuses(self):
        for path in (SOURCE / "tests/scene/bad").glob("*.toml"):
            if path.stem not in BEYOND:
                with self.subTest(path.name), self.assertRaises(jsonschema.ValidationError):
                    jsonschema.validate(tomllib.loads(path.read_text()), SCHEMA)

    def test_has_the_keys_that_the_reader_asks_for(self):
        readers = "".join((SOURCE / "generator/scene" / name).read_text() for name in ("scene_file.cpp", "read_dish.cpp"))
        asked = set(re.findall(r'\b(?:get|need|has)\("(\w+)"\)', readers))
        self.assertEqual(asked, keys_of(SCHEMA))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
