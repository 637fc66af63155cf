#!/usr/bin/env python3
"""scripts/data_set.py: two pictures of two commands, their data, and a second run that keeps them.

    data_set_test.py POMONA
"""

import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "data_set.py"


def run(program, folder, *more):
    words = [sys.executable, str(SCRIPT), "--program", program, "-o", str(folder), "--count", "2", "--first", "5",
             "--command", "cut cherry --knife half", "--command", "cut lemon --knife wedges:3",
             "--options", "--size 80x60 --quality draft --detail 0.3", *more]
    return subprocess.run(words, capture_output=True, text=True)


def expect(holds, what):
    if not holds:
        sys.exit(f"data_set_test: {what}")


def check_coco(folder):
    all_of_it = json.loads((folder / "annotations.json").read_text())
    for key in ("info", "licenses", "images", "annotations", "categories"):
        expect(key in all_of_it, f"no {key}")
    expect([i["seed"] for i in all_of_it["images"]] == [5, 6], "seeds go up from the first")
    expect([c["name"] for c in all_of_it["categories"]] == ["cherry", "lemon"], "each species once")
    ids = [a["id"] for a in all_of_it["annotations"]]
    expect(len(ids) == 5 and len(set(ids)) == 5, "two halves and three wedges, each with a number of its own")
    species = {c["id"]: c["name"] for c in all_of_it["categories"]}
    for image in all_of_it["images"]:
        expect((folder / image["file_name"]).is_file(), "no picture")
        expect(all((folder / layer).is_file() for layer in image["layers"]), "no layer")
        own = json.loads((folder / "truth" / pathlib.Path(image["file_name"]).stem / "annotations.json").read_text())
        names = {p["id"]: p["name"] for p in all_of_it["parts"]}
        expect(all(names[image["parts"][str(p["id"])]] == p["name"] for p in own["parts"]), "parts keep their names")
        kinds = {species[a["category_id"]] for a in all_of_it["annotations"] if a["image_id"] == image["id"]}
        expect(kinds == {image["command"].split()[2]}, "pieces are of the species that was cut")
    return all_of_it


def check_croissant(folder):
    """The keys that the Croissant specification 1.0 requires; sources exist."""
    croissant = json.loads((folder / "croissant.json").read_text())
    for key in ("@context", "@type", "conformsTo", "name", "description", "license", "url", "distribution", "recordSet"):
        expect(key in croissant, f"no {key} in croissant.json")
    expect(croissant["conformsTo"] == "http://mlcommons.org/croissant/1.0", "another version of Croissant")
    files = {file["@id"]: file for file in croissant["distribution"]}
    digest = hashlib.sha256((folder / files["annotations"]["contentUrl"]).read_bytes()).hexdigest()
    expect(files["annotations"]["sha256"] == digest, "annotations.json has another SHA-256")
    for file_set in ("image-files", "truth-files"):
        expect(list(folder.glob(files[file_set]["includes"])), f"{file_set} names no file")
    annotations = json.loads((folder / "annotations.json").read_text())
    for record_set in croissant["recordSet"]:
        for field in record_set["field"]:
            expect({"@id", "@type", "name", "dataType", "source"} <= set(field), f"a field of {record_set['name']} lacks keys")
            source = field["source"]
            expect((source.get("fileObject") or source["fileSet"])["@id"] in files, "a source that is not there")
            if "fileObject" in source:  # "$.images[*].id"
                entries, key = source["extract"]["jsonPath"].removeprefix("$.").split("[*].")
                expect(all(key in entry for entry in annotations[entries]), f"not all of {entries} have {key}")


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary) / "set"
        first = run(program, folder)
        expect(first.returncode == 0 and "2 pictures made" in first.stdout, first.stdout + first.stderr)
        annotations = check_coco(folder)
        check_croissant(folder)

        # A second run finds all, and writes the same; a picture that is lost comes back to the byte, by its own command
        # too.
        before = {p: p.read_bytes() for p in folder.rglob("*") if p.is_file()}
        lost = folder / "images" / "000001.png"
        lost.unlink()
        again = run(program, folder)
        expect(again.returncode == 0 and "1 pictures made, 1 there already" in again.stdout, again.stdout + again.stderr)
        expect({p: p.read_bytes() for p in folder.rglob("*") if p.is_file()} == before, "a second run changes bytes")
        words = annotations["images"][1]["command"].split()[1:]
        alone = pathlib.Path(temporary) / "alone.png"
        subprocess.run([program, *words, "--quiet", "-o", str(alone)], check=True)
        expect(alone.read_bytes() == before[lost], "the command of a picture makes another one")

        # A failing command is named, with its status.
        failed = run(program, pathlib.Path(temporary) / "other", "--command", "cut nothing --knife half", "--count", "3")
        expect(failed.returncode != 0 and "ended with status 66" in failed.stderr, failed.stderr)


if __name__ == "__main__":
    main()
