#!/usr/bin/env python3
"""Makes a data set of pictures with ground truth: COCO's annotations of all of them, and a Croissant file that describes it
(docs/guides/data.md). Picture number i is a command with seed FIRST + i, so each can be made again by itself.

    data_set.py -o FOLDER --command "scene salad" --count 1000
    data_set.py -o FOLDER --command "cut kiwi --knife half" --command "cut lemon --knife wedges:6" --count 1000

    FOLDER/images/000000.png ...       the pictures
    FOLDER/truth/000000/...            their ground truth, as `pomona --aov` writes it
    FOLDER/annotations.json            COCO's keys, of all pictures
    FOLDER/croissant.json              MLCommons Croissant 1.0: what lies where

What is there already is kept: an interrupted run goes on where it was.
"""

import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import time

CC0 = "https://creativecommons.org/publicdomain/zero/1.0/"


def words_of(options, number):
    """The command of a picture, but for where it goes: by turns, each with the picture's own seed."""
    command = shlex.split(options.command[number % len(options.command)])
    return [*command, "--seed", str(options.first + number), *shlex.split(options.options)]


def make(options, folder, number):
    """One picture and its truth, put into place when both are whole. Returns what it took, in seconds."""
    name = f"{number:06d}"
    picture, truth = folder / "images" / f"{name}.png", folder / "truth" / name
    if picture.is_file() and truth.is_dir():
        return 0.0
    start = time.monotonic()
    part = folder / f".part-{name}"
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir()
    words = [options.program, *words_of(options, number), "--threads", "1", "--quiet"]
    outputs = ["-o", str(part / picture.name), "--aov", str(part / "truth"), "--aov-format", options.aov_format]
    subprocess.run([*words, *outputs], check=True)
    shutil.rmtree(truth, ignore_errors=True)
    (part / "truth").rename(truth)
    (part / picture.name).rename(picture)
    part.rmdir()
    return time.monotonic() - start


class Numbers:
    """Numbers from 1 for keys, in the order in which they come."""

    def __init__(self):
        self.of = {}

    def __call__(self, *key):
        return self.of.setdefault(key, len(self.of) + 1)


def joined(options, folder):
    """COCO's annotations of all pictures as one. Categories and parts are numbered for the whole; what a picture's own part.png
    calls 3 is `parts["3"]` of its entry in `images`, and `instance` is an annotation's number in instance.png."""
    category, part = Numbers(), Numbers()
    images, annotations, hidden, info = [], [], [], {}
    for number in range(options.count):
        name = f"{number:06d}"
        one = json.loads((folder / "truth" / name / "annotations.json").read_text())
        info = one["info"]
        species = {c["id"]: category(c["name"]) for c in one["categories"]}
        parts = {str(p["id"]): part(species[p["category_id"]], p["name"]) for p in one["parts"]}
        image = one["images"][0] | {"id": number + 1, "file_name": f"images/{name}.png"}
        image["layers"] = [f"truth/{name}/{layer}" for layer in image["layers"]]
        image["command"] = shlex.join(["pomona", *words_of(options, number)])
        images.append(image | {"parts": parts})
        for kind, entries in ((annotations, one["annotations"]), (hidden, one["hidden"])):
            for entry in entries:
                own = {"instance": entry["id"], "image_id": number + 1, "category_id": species[entry["category_id"]]}
                kind.append(entry | own | {"id": len(annotations) + len(hidden) + 1})
    return {
        "info": info | {"description": options.description},
        "licenses": [{"id": 1, "name": "license", "url": options.license}],
        "images": [image | {"license": 1} for image in images],
        "categories": [{"id": n, "name": name, "supercategory": "object"} for (name,), n in category.of.items()],
        "parts": [{"id": n, "name": name, "category_id": kind} for (kind, name), n in part.of.items()],
        "annotations": annotations,
        "hidden": hidden,
    }


# The context that the Croissant specification gives for version 1.0.
CONTEXT = {
    "@language": "en", "@vocab": "https://schema.org/", "citeAs": "cr:citeAs", "column": "cr:column",
    "conformsTo": "dct:conformsTo", "cr": "http://mlcommons.org/croissant/", "rai": "http://mlcommons.org/croissant/RAI/",
    "data": {"@id": "cr:data", "@type": "@json"}, "dataType": {"@id": "cr:dataType", "@type": "@vocab"},
    "dct": "http://purl.org/dc/terms/", "examples": {"@id": "cr:examples", "@type": "@json"}, "extract": "cr:extract",
    "field": "cr:field", "fileProperty": "cr:fileProperty", "fileObject": "cr:fileObject", "fileSet": "cr:fileSet",
    "format": "cr:format", "includes": "cr:includes", "isLiveDataset": "cr:isLiveDataset", "jsonPath": "cr:jsonPath",
    "key": "cr:key", "md5": "cr:md5", "parentField": "cr:parentField", "path": "cr:path", "recordSet": "cr:recordSet",
    "references": "cr:references", "regex": "cr:regex", "repeated": "cr:repeated", "replace": "cr:replace",
    "sc": "https://schema.org/", "separator": "cr:separator", "source": "cr:source", "subField": "cr:subField",
    "transform": "cr:transform",
}


def record_set(name, description, path, fields):
    """Records out of annotations.json: one field for each of these keys."""
    return {
        "@type": "cr:RecordSet", "@id": name, "name": name, "description": description,
        "field": [
            {
                "@type": "cr:Field", "@id": f"{name}/{key}", "name": key, "dataType": kind,
                "source": {"fileObject": {"@id": "annotations"}, "extract": {"jsonPath": f"$.{path}[*].{key}"}},
            }
            for key, kind in fields.items()
        ],
    }


def croissant(options, annotations_bytes):
    whole, number, text = "sc:Integer", "sc:Float", "sc:Text"
    return {
        "@context": CONTEXT,
        "@type": "sc:Dataset",
        "conformsTo": "http://mlcommons.org/croissant/1.0",
        "name": options.name,
        "description": options.description,
        "license": options.license,
        "url": options.url,
        "version": "1.0.0",
        "distribution": [
            {
                "@type": "cr:FileObject", "@id": "annotations", "name": "annotations",
                "description": "COCO's annotations of all pictures, with volume, mass, occlusion and amodal masks",
                "contentUrl": "annotations.json", "encodingFormat": "application/json",
                "sha256": hashlib.sha256(annotations_bytes).hexdigest(),
            },
            {
                "@type": "cr:FileSet", "@id": "image-files", "name": "image-files", "description": "the pictures",
                "encodingFormat": "image/png", "includes": "images/*.png",
            },
            {
                "@type": "cr:FileSet", "@id": "truth-files", "name": "truth-files",
                "description": "what each pixel shows: ids, depth, normals, masks",
                "encodingFormat": "image/x-exr" if options.aov_format == "exr" else "image/png",
                "includes": f"truth/*/*.{options.aov_format}",
            },
        ],
        "recordSet": [
            {
                "@type": "cr:RecordSet", "@id": "pictures", "name": "pictures", "description": "the pictures themselves",
                "field": [
                    {
                        "@type": "cr:Field", "@id": "pictures/name", "name": "name", "dataType": text,
                        "source": {"fileSet": {"@id": "image-files"}, "extract": {"fileProperty": "filename"}},
                    },
                    {
                        "@type": "cr:Field", "@id": "pictures/content", "name": "content", "dataType": "sc:ImageObject",
                        "source": {"fileSet": {"@id": "image-files"}, "extract": {"fileProperty": "content"}},
                    },
                ],
            },
            record_set("images", "what each picture is, and the command that makes it again", "images",
                       {"id": whole, "file_name": text, "width": whole, "height": whole, "seed": whole, "command": text}),
            record_set("categories", "the species", "categories", {"id": whole, "name": text}),
            record_set("annotations", "the pieces that pictures show", "annotations",
                       {"id": whole, "image_id": whole, "category_id": whole, "instance": whole, "name": text, "area": whole,
                        "amodal_area": whole, "occlusion": number, "volume": number, "mass": number}),
        ],
    }


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER")
    parser.add_argument("--command", action="append", required=True, metavar="WORDS",
                        help="of pomona, without seed and output; several are taken by turns")
    parser.add_argument("--count", type=int, required=True, help="pictures")
    parser.add_argument("--first", type=int, default=1, help="seed of the first picture; 1")
    parser.add_argument("--options", default="--size 640x480 --quality draft", help="of all commands; --size 640x480 --quality draft")
    parser.add_argument("--aov-format", choices=("png", "exr"), default="png")
    parser.add_argument("--jobs", type=int, default=2, help="commands at once; 2")
    parser.add_argument("--program", default=str(pathlib.Path(__file__).resolve().parent.parent / "build" / "pomona"))
    parser.add_argument("--name", help="of the data set; the folder's")
    parser.add_argument("--description", default="Pictures of cut fruit and vegetables with exact ground truth, made by Pomona")
    parser.add_argument("--license", default=CC0, help="as a URL; CC0, as the templates that come with the program")
    parser.add_argument("--url", default="https://example.org/", help="where the data set is published")
    options = parser.parse_args()
    if options.count < 1 or options.jobs < 1:
        parser.error("--count and --jobs are at least 1")
    options.name = options.name or pathlib.Path(options.output).resolve().name
    return options


def main():
    options = parsed()
    folder = pathlib.Path(options.output)
    for room in ("images", "truth"):
        (folder / room).mkdir(parents=True, exist_ok=True)
    start, seconds = time.monotonic(), []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        tasks = [pool.submit(make, options, folder, number) for number in range(options.count)]
        for task in concurrent.futures.as_completed(tasks):
            try:
                seconds.append(task.result())
            except subprocess.CalledProcessError as failed:
                pool.shutdown(cancel_futures=True)
                sys.exit(f"data_set.py: {shlex.join(failed.cmd)} ended with status {failed.returncode}")
    made = sum(1 for s in seconds if s > 0)
    print(f"{made} pictures made, {options.count - made} there already; {time.monotonic() - start:.1f} s")

    # These two appear last: where they are, everything is.
    annotations = (json.dumps(joined(options, folder)) + "\n").encode()
    for name, content in (("annotations.json", annotations),
                          ("croissant.json", (json.dumps(croissant(options, annotations), indent=1) + "\n").encode())):
        part = folder / f".part-{name}"
        part.write_bytes(content)
        part.rename(folder / name)


if __name__ == "__main__":
    main()
