#!/usr/bin/env python3
"""Writes what documents and schemas say of an order's options from the program's own table.

    option_docs.py write PROGRAM     makes the table of docs and the keys of the schemas in scenes/ anew
    option_docs.py check PROGRAM     status 1, and the names of the files, where they are not as it would write them
"""

import json
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
DOCUMENT = SOURCE / "docs/reference/commands.md"
BATCH_SCHEMA = SOURCE / "scenes/batch.schema.json"
SCENE_SCHEMA = SOURCE / "scenes/scene.schema.json"
BEGIN, END = "<!-- options: scripts/option_docs.py writes this -->", "<!-- end of the options -->"


def plain(number):
    """1000000, 0.05."""
    return str(int(number)) if number == int(number) else f"{number:g}"


def value_words(option):
    """What follows the option, as documents say it."""
    if option["type"] == "flag":
        return ""
    if option["type"] == "choice":
        return ", ".join(f"`{word}`" for word in option["words"])
    if option["type"] in ("whole", "number"):
        return f"{plain(option['low'])} to {plain(option['high'])}" + (f" {option['unit']}" if "unit" in option else "")
    if option["type"] == "count":
        return "a whole number"
    return option.get("shown_type", "TEXT")


def table(options):
    rows = ["| option | value | default | commands | formats | |", "|---|---|---|---|---|---|"]
    for option in options:
        usual = f"`{option['usual']}`" if option["usual"] else ""
        formats = " ".join("." + name for name in option["formats"]) or "all"
        cells = [f"`--{option['name']}`", value_words(option), usual, ", ".join(option["commands"]), formats, option["help"]]
        rows.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(rows)


def with_table(text, options):
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    return f"{before}{BEGIN}\n\n{table(options)}\n\n{END}{after}"


def schema_of(option):
    """What a batch file may give the key."""
    kinds = {"flag": {"type": "boolean"}, "text": {"type": "string", "minLength": 1}}
    if option["type"] == "choice":
        schema = {"enum": option["words"]}
    elif option["type"] in ("whole", "number"):
        number = {"type": "integer" if option["type"] == "whole" else "number", "minimum": option["low"], "maximum": option["high"]}
        can_be_off = option["batch_key"] and option["type"] == "whole" and option["low"] > 0
        schema = {"anyOf": [{"const": 0}, number]} if can_be_off else number
    else:
        schema = dict(kinds[option["type"]])
        if option["key"] == "ripeness_variants":
            schema = {"anyOf": [schema, {"type": "array", "items": {"type": "number", "minimum": 0, "maximum": 2}, "minItems": 1, "maxItems": 16}]}
    return {**schema, "description": option["help"]}


def batch_formats(options):
    """All formats that options of batches heed, but pictures of solids, which are no format of a batch."""
    heeded = [name for option in options if "batch" in option["commands"] for name in option["formats"] if name != "png"]
    return list(dict.fromkeys(heeded))


def with_keys(schema, options):
    """Keys of options first as they stand, new ones in the order of the table, keys that no option has any more taken out."""
    keys = {option["key"]: schema_of(option) for option in options if option["batch_key"]}
    for properties in (schema["properties"]["batch"]["properties"], schema["properties"]["entry"]["items"]["properties"]):
        for key, value in keys.items():
            properties[key] = value
        for format_list in (properties["formats"]["anyOf"][0], properties["formats"]["anyOf"][1]["items"]):
            format_list["enum"] = batch_formats(options)
    return schema


# Keys of a scene's [[pieces]] that are options: the key, the option, and whether [lowest, highest] may stand for a number.
SCENE_KEYS = [("folds", "folds", False), ("variation", "variation", False), ("detail", "detail", False),
              ("size", "scale", True), ("ripeness", "ripeness", True), ("browning", "browning", True)]


def with_scene_keys(schema, options):
    """Keys of entries that are options, as the table has them."""
    wanted = {option for _, option, _ in SCENE_KEYS}
    of_options = {option["key"]: schema_of(option) for option in options if option["key"] in wanted}
    entry = schema["properties"]["pieces"]["items"]["properties"]
    for key, option, ranged in SCENE_KEYS:
        entry[key] = {**of_options[option]}
        description = entry[key].pop("description")
        if ranged:
            ends = {"type": "array", "items": entry[key], "minItems": 2, "maxItems": 2}
            entry[key] = {"anyOf": [entry[key], ends]}
            description += "; or [lowest, highest], random for each variant"
        entry[key]["description"] = description
    return schema


def main():
    verb, program = sys.argv[1:]
    options = json.loads(subprocess.run([program, "pages", "options"], check=True, capture_output=True, text=True).stdout)
    wanted = {
        DOCUMENT: with_table(DOCUMENT.read_text(), options),
        BATCH_SCHEMA: json.dumps(with_keys(json.loads(BATCH_SCHEMA.read_text()), options), indent=1) + "\n",
        SCENE_SCHEMA: json.dumps(with_scene_keys(json.loads(SCENE_SCHEMA.read_text()), options), indent=1) + "\n",
    }
    stale = [path for path, text in wanted.items() if path.read_text() != text]
    for path in stale:
        print(path.relative_to(SOURCE).as_posix(), "is not as the table of options has it" if verb == "check" else "written")
        if verb == "write":
            path.write_text(wanted[path])
    return 1 if stale and verb == "check" else 0


if __name__ == "__main__":
    sys.exit(main())
