#!/usr/bin/env python3
"""Does variety pay? Trains a small classifier of fruit on pictures in one style, in another, and in both, as many each, and
tests each on pictures of every style, of which the last is one that none has seen (docs/guides/data.md).

    train_styles.py scenes/cut_fruit.toml -o FOLDER --styles ink photo --unseen gouache --count 200 --size 320 240

makes the data sets with `pomona data` (what is there already is kept) and prints a table: the share of pieces whose species
is named right. The classifier is linear: softmax regression on histograms of colours and of directions of edges (HOG) of
each piece's box.
"""

import argparse
import json
import pathlib
import re
import subprocess

import numpy as np
from PIL import Image

SIDE, CELL, BINS = 64, 16, 8  # pixels of a box once scaled, of a cell of HOG, and its directions


def data_set(options, name, styles, count):
    """The folder of a set in these styles, made unless it is there."""
    text = options.file.read_text()
    text = re.sub(r"(?m)^style = .*$", "style = " + json.dumps(styles), text)
    text = re.sub(r"(?m)^count = .*$", f"count = {count}", text)
    text = re.sub(r"(?m)^size = .*$", f"size = {options.size}", text)
    # Its own seed: no two sets show the same pictures. Names of files start from the folder of the original.
    text = re.sub(r"(?m)^seed = .*$", f"seed = {sum(map(ord, name))}", text)
    folder = options.output / name
    file = options.file.with_name(f"{options.file.stem}.{name}.toml")
    file.write_text(text)
    try:
        subprocess.run([options.program, "data", file, "-o", folder, "--resume", "--quiet"], check=True)
    finally:
        file.unlink()
    return folder


def features(picture, box):
    """Colours in 4 x 4 x 4 bins, and directions of edges in cells of the box."""
    left, top, width, height = box
    margin = 0.05 * max(width, height)
    piece = picture.crop((left - margin, top - margin, left + width + margin, top + height + margin)).resize((SIDE, SIDE))
    rgb = np.asarray(piece, dtype=np.float64) / 255
    bins = np.minimum((rgb * 4).astype(int), 3)
    colors = np.bincount((bins @ [16, 4, 1]).ravel(), minlength=64) / (SIDE * SIDE)

    down, across = np.gradient(rgb.mean(axis=2))
    strength, direction = np.hypot(down, across), np.arctan2(down, across) % np.pi
    cells = SIDE // CELL
    place = np.arange(SIDE) // CELL
    index = (place[:, None] * cells + place[None, :]) * BINS + np.minimum((direction / np.pi * BINS).astype(int), BINS - 1)
    edges = np.bincount(index.ravel(), weights=strength.ravel(), minlength=cells * cells * BINS)
    return np.concatenate([np.sqrt(colors), edges / (np.linalg.norm(edges) + 1e-6)])


def pieces_of(folder, splits):
    """Features and species of all annotated pieces."""
    rows, species = [], []
    for split in splits:
        coco = json.loads((folder / f"{split}.json").read_text())
        files = {image["id"]: folder / image["file_name"] for image in coco["images"]}
        pictures = {}
        for piece in coco["annotations"]:
            if piece["area"] < 200 or piece["occlusion"] > 0.7:
                continue
            number = piece["image_id"]
            if number not in pictures:
                pictures = {number: Image.open(files[number]).convert("RGB")}
            rows.append(features(pictures[number], piece["bbox"]))
            species.append(piece["species"])
    return np.array(rows), np.array(species)


def trained(rows, species, steps=400, rate=2.0, decay=1e-4):
    """Softmax regression by gradient descent; every species counts as much, however many pieces it has."""
    names = np.unique(species)
    mean, deviation = rows.mean(axis=0), rows.std(axis=0) + 1e-3
    x = np.hstack([(rows - mean) / deviation, np.ones((len(rows), 1))]) / np.sqrt(rows.shape[1])
    y = (species[:, None] == names[None, :]).astype(float)
    share = 1 / (y @ y.sum(axis=0)) / len(names)
    weights = np.zeros((x.shape[1], len(names)))
    for _ in range(steps):
        score = x @ weights
        chance = np.exp(score - score.max(axis=1, keepdims=True))
        chance /= chance.sum(axis=1, keepdims=True)
        weights -= rate * len(names) * (x.T @ ((chance - y) * share[:, None]) + decay * weights)
    return lambda some: names[np.argmax(np.hstack([(some - mean) / deviation, np.ones((len(some), 1))])
                                        / np.sqrt(rows.shape[1]) @ weights, axis=1)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=pathlib.Path, help="a data set file with lines `style = `, `seed = `, `count = ` and `size = `")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--styles", nargs=2, default=["ink", "photo"])
    parser.add_argument("--unseen", default="gouache")
    parser.add_argument("--count", type=int, default=200, help="pictures of each set to train on")
    parser.add_argument("--tests", type=int, help="pictures of each set to test on; half as many unless told")
    parser.add_argument("--size", type=int, nargs=2, default=[640, 480], help="of pictures, pixels")
    parser.add_argument("--program", default=pathlib.Path(__file__).resolve().parent.parent / "build" / "pomona")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    parts = ("train", "validation", "test")
    first, second = options.styles
    training = {first: [first], second: [second], f"{first} and {second}": [first, second]}
    count = options.tests or max(1, options.count // 2)
    tests = {style: pieces_of(data_set(options, "test-" + style, [style], count), parts)
             for style in (first, second, options.unseen)}
    print("| trained on | pieces | " + " | ".join(f"tested on {style}" for style in tests) + " |")
    print("|---|--:|" + "--:|" * len(tests))
    for name, styles in training.items():
        rows, species = pieces_of(data_set(options, "train-" + "-".join(styles), styles, options.count), parts)
        model = trained(rows, species)
        right = [f"{np.mean(model(some) == wanted):.0%}" for some, wanted in tests.values()]
        print(f"| {name} | {len(rows)} | " + " | ".join(right) + " |")
    print("pieces tested: " + ", ".join(f"{style} {len(wanted)}" for style, (_, wanted) in tests.items()))


if __name__ == "__main__":
    main()
