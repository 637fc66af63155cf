#!/usr/bin/env python3
"""`pomona data`, as a user starts it: the same bytes on any threads, in any shards and after a stop; labels against pictures,
meshes and cameras; what is told of bad input.

    data_test.py PROGRAM SOURCE [unittest's words]
"""

import hashlib
import json
import pathlib
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest
import zlib

import jsonschema

HERE = pathlib.Path(__file__).parent
sys.path[:0] = [str(HERE.parent / "batch"), str(HERE.parents[1] / "meaning")]
from batches import pomona, tree  # noqa: E402
from png import Picture  # noqa: E402

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()

SMALL = """
[data]
format = 1
name = "small"
seed = 4
count = 6
size = [128, 96]
detail = 0.15
style = ["ink", "photo"]
classes = "species and state"
models = true
split = [2, 1, 1]

[scene]
fruits = [1, 2]
arrangement = ["heap", "rows"]
distractors = 1

[camera]
noise = [0, 0.05]

[[dishes]]
name = "knife"
mesh = "knife.obj"
unit = "1cm"

[[fruit]]
name = "cut"
templates = ["cherry", "lemon"]
knives = ["half", "wedges:4", "random"]
pieces = [1, 2]
ripeness = [0.8, 1.2]

[[fruit]]
name = "whole"
templates = "radish"
"""


def png_bytes(width, height, color):
    """A picture of one colour."""
    return png_of((b"\0" + bytes(color) * width) * height, width, height)


def png_of(rows, width, height):
    """A picture of rows, each after a byte that says that it is not filtered."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def pixels(path):
    """Those of a .png, row by row: all channels of each, or its number."""
    picture = Picture(path.read_bytes())
    return [picture.at(x, y) for y in range(picture.height) for x in range(picture.width)]


def ply_points(path):
    """The vertices of a binary .ply of the program's."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode().splitlines()
    count = int(next(line for line in lines if line.startswith("element vertex")).split()[2])
    sizes = {"float": 4, "int": 4, "uchar": 1}
    stride = 0
    for line in lines[lines.index(f"element vertex {count}") + 1:]:
        if not line.startswith("property"):
            break
        stride += sizes[line.split()[1]]
    return [struct.unpack_from("<fff", body, i * stride) for i in range(count)]


class Sandbox(unittest.TestCase):
    """A folder with small.toml in it; the set itself is made once for all."""

    @classmethod
    def setUpClass(cls):
        cls.once = tempfile.TemporaryDirectory(prefix="pomona-test-")
        cls.home = pathlib.Path(cls.once.name)
        cls.prepare(cls.home)
        result = pomona(PROGRAM, "data", "small.toml", "-o", "whole", "--threads", 2, folder=cls.home)
        assert result.returncode == 0, result.stderr
        cls.whole = cls.home / "whole"
        cls.expected = tree(cls.whole)

    @staticmethod
    def prepare(folder, text=SMALL):
        (folder / "small.toml").write_text(text)
        shutil.copy(SOURCE / "scenes/dishes/knife.obj", folder)

    @classmethod
    def tearDownClass(cls):
        cls.once.cleanup()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="pomona-test-")
        self.path = pathlib.Path(self.folder.name)
        self.prepare(self.path)

    def tearDown(self):
        self.folder.cleanup()

    def run_pomona(self, *words, status=0):
        result = pomona(PROGRAM, *words, folder=self.path)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def run_data(self, *words, status=0):
        return self.run_pomona("data", "small.toml", "-o", "out", *words, status=status)

    def assert_as_expected(self, folder="out"):
        self.assertEqual(tree(self.path / folder), self.expected)

    def pictures(self):
        """Each picture's folder and its annotations."""
        for path in sorted((self.whole / "pictures").iterdir()):
            yield path, json.loads((path / "annotations.json").read_text())


class SameBytes(Sandbox):
    def test_of_one_thread(self):
        self.run_data("--threads", "1")
        self.assert_as_expected()

    def test_of_shards(self):
        for number in (2, 1):
            self.run_data("--shard", f"{number}/2")
        self.run_pomona("merge", "out")
        self.assert_as_expected()

    def test_of_a_picture_by_its_own_command(self):
        image = json.loads((self.whole / "pictures/003/annotations.json").read_text())["images"][0]
        words = image["command"].split()
        self.assertEqual(words[0], "pomona")
        self.run_pomona(*words[1:])
        again = tree(self.path / "again/pictures/003")
        self.assertEqual(again, tree(self.whole / "pictures/003"))
        self.assertEqual([path.name for path in (self.path / "again/pictures").iterdir()], ["003"])

    def write_own(self, count, ground=""):
        """A set whose style and template lie beside its file, and a folder of pictures elsewhere."""
        sub = self.path / "sets/fruit"
        for folder in (sub / "own", self.path / "photos"):
            folder.mkdir(parents=True)
        shutil.copy(SOURCE / "templates/radish.toml", sub / "own")
        shutil.copy(SOURCE / "styles/photo.toml", sub / "own/mine.toml")
        (self.path / "photos/green.png").write_bytes(png_bytes(50, 50, (40, 160, 90)))
        (sub / "small.toml").write_text(f'[data]\nformat = 1\nname = "small"\ncount = {count}\nsize = [64, 48]\n'
                                        'detail = 0.1\nstyle = "own/mine.toml"\n[scene]\nfruits = 1\n'
                                        f'{ground}[[fruit]]\nname = "own"\ntemplates = "own/radish.toml"\n')
        return sub

    def test_of_shards_and_a_farm_from_other_folders(self):
        sub = self.write_own(3, '[ground]\npicture = "../../photos"\n')
        made = pomona(PROGRAM, "data", "small.toml", "-o", "alone", "--quiet", folder=sub)
        self.assertEqual(made.returncode, 0, made.stderr)
        for shard in ("2/2", "1/2"):
            self.run_pomona("data", "sets/fruit/small.toml", "-o", "shared", "--shard", shard)
        lines = self.run_pomona("farm", "commands", "sets/fruit/small.toml", "-o", "farmed", "--tasks", "2").stdout
        for line in lines.splitlines():
            subprocess.run(["sh", "-c", line], cwd="/", check=True, capture_output=True)
        for out in ("shared", "farmed"):
            self.run_pomona("merge", out)
            self.assertEqual(tree(self.path / out), tree(sub / "alone"), out)

    def test_from_any_folder(self):
        # A style and a template beside the file, pictures elsewhere: all is found, and told as from the file's folder.
        sub = self.write_own(1)
        for folder, file, photos, out in ((self.path, "sets/fruit/small.toml", "photos", "outside"),
                                          (sub, "small.toml", "../../photos/", "../../inside"),
                                          (self.path, sub / "small.toml", "./photos", "absolute")):
            made = pomona(PROGRAM, "data", file, "--background", photos, "-o", out, folder=folder)
            self.assertEqual(made.returncode, 0, made.stderr)
        made = tree(self.path / "outside")
        for out in ("inside", "absolute"):
            self.assertEqual(tree(self.path / out), made, out)
        told = json.loads((self.path / "outside/pictures/000/annotations.json").read_text())["images"][0]
        self.assertEqual(told["style"], "own/mine.toml")
        words = shlex.split(told["command"])
        self.assertEqual(words[2:5], ["small.toml", "--background", "../../photos"])
        again = pomona(PROGRAM, *words[1:], folder=sub)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(tree(sub / "again/pictures"), tree(self.path / "outside/pictures"))
        # Of a path that means nothing on another machine, the name is told.
        made = pomona(PROGRAM, "data", "sets/fruit/small.toml", "--background", self.path / "photos", "-o", "name",
                      folder=self.path)
        self.assertEqual(made.returncode, 0, made.stderr)
        told = json.loads((self.path / "name/pictures/000/annotations.json").read_text())["images"][0]
        self.assertEqual(told["command"], "pomona data small.toml --background photos --picture 0 -o again")

    def test_after_a_kill(self):
        run = subprocess.Popen([PROGRAM, "data", "small.toml", "-o", "out", "--threads", "1", "--quiet"], cwd=self.path)
        while run.poll() is None and not (self.path / "out/pictures/001").exists():
            time.sleep(0.01)
        run.kill()
        run.wait()
        self.run_data(status=73)
        self.run_data("--resume")
        self.assert_as_expected()

    def test_of_a_set_that_has_grown(self):
        self.prepare(self.path, SMALL.replace("count = 6", "count = 4"))
        self.run_data("--quiet")
        self.prepare(self.path)
        report = json.loads(self.run_data("--update", "--json").stdout)
        self.assertEqual((report["made"], report["found"]), (2, 4))
        self.assert_as_expected()


class Labels(Sandbox):
    def test_say_what_was_done(self):
        states, seen = set(), 0
        for _, one in self.pictures():
            species = {c["id"]: c["name"] for c in one["categories"]}
            for piece in one["annotations"]:
                if "state" not in piece:
                    self.assertEqual(species[piece["category_id"]].split("-")[0], "knife")
                    continue
                seen += 1
                states.add((species[piece["category_id"]], piece["state"]))
                expected = {"half": "half", "wedges:4": "wedge"}
                knives = piece["knives"]
                state = expected.get(knives[0], "piece") if knives else "whole"
                self.assertEqual(piece["state"], state)
                self.assertEqual(species[piece["category_id"]] == "radish", not knives)
                self.assertLessEqual(piece["piece"], piece["pieces"])
                if "ripeness" in piece:
                    self.assertTrue(0.8 <= piece["ripeness"] <= 1.2)
        self.assertGreater(seen, 6)
        self.assertGreater(len(states), 1)

    def test_of_parts_cover_their_pieces(self):
        for path, one in self.pictures():
            counted = {}
            for piece, part in zip(pixels(path / "instance.png"), pixels(path / "part.png")):
                if piece and part:
                    counted[piece, part] = counted.get((piece, part), 0) + 1
            told = {(p["annotation_id"], p["part_id"]): p["area"] for p in one["part_annotations"]}
            self.assertEqual(told, counted)

    def test_of_poses_bring_the_meshes_into_their_boxes(self):
        lemons = 0
        for path, one in self.pictures():
            names = {c["id"]: c["name"] for c in one["categories"]}
            species = {piece["id"]: names[piece["category_id"]] for piece in one["annotations"]}
            camera = json.loads((path / "scene_camera.json").read_text())["0"]["cam_K"]
            poses = json.loads((path / "scene_gt.json").read_text())["0"]
            infos = json.loads((path / "scene_gt_info.json").read_text())["0"]
            for pose, info in zip(poses, infos):
                r, t, points = pose["cam_R_m2c"], pose["cam_t_m2c"], []
                for p in ply_points(path / f"obj_{pose['obj_id']:06d}.ply"):
                    x, y, z = (sum(r[3 * i + k] * p[k] for k in range(3)) + t[i] for i in range(3))
                    points.append((camera[0] * x / z + camera[2], camera[4] * y / z + camera[5]))
                left, top, width, height = info["bbox_obj"]
                u, v = [min(127, max(0, p[0])) for p in points], [min(95, max(0, p[1])) for p in points]
                # Pixels have their middles at whole numbers; those whose middle is covered are in the box. Roots and
                # stems may be thinner than a pixel.
                is_thin = species[pose["obj_id"]] != "lemon"
                for beyond in (left - min(u), top - min(v), max(u) - left - width + 1, max(v) - top - height + 1):
                    self.assertGreater(beyond, -0.6, (path.name, pose["obj_id"]))
                    self.assertLess(beyond, 20 if is_thin else 1.5, (path.name, pose["obj_id"]))
                    lemons += not is_thin
        self.assertGreaterEqual(lemons, 8)

    def test_of_yolo_are_the_boxes(self):
        classes = (self.whole / "classes.txt").read_text().split("\n")[:-1]
        for path, one in self.pictures():
            species = {c["id"]: c["name"] for c in one["categories"]}
            pieces = [piece for piece in one["annotations"] if "state" in piece]
            lines = (path / "picture.txt").read_text().splitlines()
            self.assertEqual(len(lines), len(pieces))
            for line, piece in zip(lines, pieces):
                number, x, y, w, h = line.split()
                self.assertEqual(classes[int(number)], f"{species[piece['category_id']]} {piece['state']}")
                box = [128 * (float(x) - float(w) / 2), 96 * (float(y) - float(h) / 2), 128 * float(w), 96 * float(h)]
                for told, found in zip(piece["bbox"], box):
                    self.assertAlmostEqual(told, found, delta=0.001)


class Looks(Sandbox):
    LOOK = SMALL.replace("count = 6", "count = 2").replace("models = true", 'layers = "png"').replace("noise = [0, 0.05]", "noise = 0")

    def test_before_a_picture(self):
        color = (40, 160, 90)
        (self.path / "behind").mkdir()
        (self.path / "behind/green.png").write_bytes(png_bytes(50, 50, color))
        (self.path / "behind/note.txt").write_text("no picture")
        self.prepare(self.path, self.LOOK + '[ground]\npicture = "behind"\n')
        self.run_data("--quiet")
        for number in ("000", "001"):
            folder = self.path / "out/pictures" / number
            both = list(zip(pixels(folder / "picture.png"), pixels(folder / "instance.png")))
            one = json.loads((folder / "annotations.json").read_text())
            self.assertEqual(one["images"][0]["background"], "green.png")
            # Most of what is not covered is the green, and shadows only darken it.
            ground = [color for color, piece in both if piece == 0]
            self.assertGreater(sum(max(abs(a - b) for a, b in zip(p, color)) <= 2 for p in ground), 0.25 * len(ground))
            self.assertLess(sum(p[1] > color[1] + 3 for p in ground), 0.02 * len(ground) + 40)

    def test_before_pictures_of_the_command(self):
        (self.path / "my pictures").mkdir()
        (self.path / "my pictures/green.png").write_bytes(png_bytes(50, 50, (40, 160, 90)))
        self.prepare(self.path, self.LOOK)
        of_file = self.LOOK + '[ground]\npicture = "my pictures"\n'
        self.run_data("--quiet", "--background", "my pictures")
        told = json.loads((self.path / "out/pictures/001/annotations.json").read_text())["images"][0]
        self.assertEqual(told["background"], "green.png")
        # The picture's own command makes it again, and so does a file that names the folder.
        words = shlex.split(told["command"])
        self.assertEqual(words[:5], ["pomona", "data", "small.toml", "--background", "my pictures"])
        self.run_pomona(*words[1:], "--quiet")
        (self.path / "named.toml").write_text(of_file)
        self.run_pomona("data", "named.toml", "-o", "named", "--quiet")
        for folder in ("out", "named"):
            self.assertEqual((self.path / folder / "pictures/001/picture.png").read_bytes(),
                             (self.path / "again/pictures/001/picture.png").read_bytes())
        # Of two folders both pictures of a name are known.
        (self.path / "more").mkdir()
        (self.path / "more/green.png").write_bytes(png_bytes(50, 50, (50, 150, 80)))
        self.run_pomona("data", "small.toml", "--background", "my pictures", "--background", "more",
                        "--picture", "0", "-o", "both", "--quiet")
        known = json.loads((self.path / "both/batch.json").read_text())["files"]
        self.assertEqual([one["file"] for one in known if "green" in one["file"]],
                         ["picture green.png", "picture green.png 2"])
        # A folder of other pictures is another set.
        self.run_data("--quiet", "--resume", status=73)
        other = ["data", "small.toml", "-o", "other", "--background"]
        self.assertIn("nowhere: is no picture", self.run_pomona(*other, "nowhere", status=66).stderr)
        self.prepare(self.path, self.LOOK + "[ground]\ntransparent = true\n")
        self.run_pomona(*other, "my pictures", status=64)

    def test_in_an_environment(self):
        # A lamp to the right of a viewer from +Z, over black ground: the same set is lit by it wherever the camera is.
        sky = [[(90, 90, 90)] * 64 for _ in range(16)] + [[(0, 0, 0)] * 64 for _ in range(16)]
        for y in range(6, 10):
            sky[y][44:52] = [(255, 200, 120)] * 8
        (self.path / "room.png").write_bytes(png_of(b"".join(b"\0" + b"".join(map(bytes, row)) for row in sky), 64, 32))
        self.prepare(self.path, self.LOOK + '[ground]\nenvironment = "room.png"\n')
        self.run_data("--quiet")
        for number in ("000", "001"):
            folder = self.path / "out/pictures" / number
            one = json.loads((folder / "annotations.json").read_text())
            self.assertEqual(one["images"][0]["environment"], "room.png")
            both = list(zip(pixels(folder / "picture.png"), pixels(folder / "instance.png")))
            # Seen from above, what stands behind is below the horizon.
            ground = [color for color, piece in both if piece == 0]
            self.assertGreater(sum(max(p) < 12 for p in ground), 0.8 * len(ground))
        # The same room as light: what is black stays black, and 255 is no limit.
        codes = {(90, 90, 90): (90, 90, 90, 128), (255, 200, 120): (255, 200, 120, 138), (0, 0, 0): (0, 0, 0, 0)}
        rows = b"".join(bytes(codes[color]) for row in sky for color in row)
        (self.path / "rooms").mkdir()
        (self.path / "rooms/sun.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n" + rows)
        self.prepare(self.path, self.LOOK)
        self.run_pomona("data", "small.toml", "--environment", "rooms", "--picture", "0", "-o", "sunny", "--quiet")
        told = json.loads((self.path / "sunny/pictures/000/annotations.json").read_text())["images"][0]
        self.assertEqual(told["environment"], "sun.hdr")
        self.prepare(self.path, self.LOOK + '[ground]\nenvironment = "square.png"\n')
        (self.path / "square.png").write_bytes(png_bytes(8, 8, (9, 9, 9)))
        self.assertIn("twice as wide as high", self.run_pomona("check", "small.toml", status=65).stderr)

    def test_before_nothing(self):
        self.prepare(self.path, self.LOOK + "[ground]\ntransparent = true\n")
        self.run_data("--quiet")
        for number in ("000", "001"):
            folder = self.path / "out/pictures" / number
            both = list(zip(pixels(folder / "picture.png"), pixels(folder / "instance.png")))
            inside = [color[3] for color, piece in both if piece]
            self.assertGreater(sum(a == 255 for a in inside), 0.6 * len(inside))
            outside = [color[3] for color, piece in both if not piece]
            self.assertGreater(sum(a < 30 for a in outside), 0.25 * len(outside))


class Files(Sandbox):
    def test_of_coco_have_every_picture_once(self):
        names, images, last = set(), 0, 0
        for split in ("train", "validation", "test"):
            coco = json.loads((self.whole / f"{split}.json").read_text())
            listed = (self.whole / f"{split}.txt").read_text().split()
            self.assertEqual(["./" + image["file_name"] for image in coco["images"]], listed)
            categories = {c["id"]: c["name"] for c in coco["categories"]}
            self.assertEqual(list(categories.values()), (self.whole / "classes.txt").read_text().split("\n")[:-1])
            ids = [piece["id"] for piece in coco["annotations"] + coco["hidden"]]
            self.assertEqual(len(ids), len(set(ids)))
            parts = {part["id"]: part for part in coco["parts"]}
            by_picture = {image["id"]: image for image in coco["images"]}
            for piece in coco["annotations"]:
                self.assertEqual(categories[piece["category_id"]], f"{piece['species']} {piece['state']}")
                self.assertIn(piece["image_id"], by_picture)
            for part in coco["part_annotations"]:
                self.assertIn(part["part_id"], parts)
                self.assertIn(part["part_id"], by_picture[part["image_id"]]["parts"].values())
            for image in coco["images"]:
                self.assertTrue((self.whole / image["file_name"]).is_file())
                self.assertTrue(all((self.whole / layer).is_file() for layer in image["layers"]))
                names.add(image["file_name"])
                images += 1
            counts = json.loads((self.whole / "statistics.json").read_text())[split]
            self.assertEqual((counts["pictures"], counts["pieces"]), (len(coco["images"]), len(coco["annotations"])))
            last += len(coco["images"])
        self.assertEqual((len(names), images), (6, 6))

    def test_of_croissant_name_what_is_there(self):
        croissant = json.loads((self.whole / "croissant.json").read_text())
        self.assertEqual(croissant["conformsTo"], "http://mlcommons.org/croissant/1.0")
        files = {file["@id"]: file for file in croissant["distribution"]}
        for file in files.values():
            if "contentUrl" in file:
                self.assertEqual(hashlib.sha256((self.whole / file["contentUrl"]).read_bytes()).hexdigest(), file["sha256"])
            else:
                self.assertEqual(len(list(self.whole.glob(file["includes"]))), 6)
        for record_set in croissant["recordSet"]:
            for field in record_set["field"]:
                source = field["source"]
                coco = json.loads((self.whole / files[source["fileObject"]["@id"]]["contentUrl"]).read_text())
                entries, key = source["extract"]["jsonPath"].removeprefix("$.").split("[*].")
                self.assertTrue(all(key in entry for entry in coco[entries]), key)

    def test_are_all_in_the_manifest(self):
        manifest = json.loads((self.whole / "manifest.json").read_text())
        for item in manifest["items"]:
            for file in item["files"]:
                data = (self.whole / item["item"] / file["name"]).read_bytes()
                self.assertEqual((len(data), hashlib.sha256(data).hexdigest()), (file["bytes"], file["sha256"]))
        self.assertIn("picture.png", (self.whole / "index.html").read_text())

    def test_hold_no_time_host_or_folder(self):
        for path in self.whole.rglob("*"):
            if path.is_file():
                self.assertNotIn(self.once.name.encode(), path.read_bytes(), path)

    def test_of_the_schema_pass_what_the_program_passes(self):
        schema = json.loads((SOURCE / "scenes/data.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        for text in (SMALL, (SOURCE / "scenes/cut_fruit.toml").read_text()):
            jsonschema.validate(tomllib.loads(text), schema)
        # Each key of the schema is one that the reader asks for.
        reader = (SOURCE / "generator/data/data_file.cpp").read_text()
        for name, table in schema["properties"].items():
            keys = table.get("items", table).get("properties", {})
            for key in keys if name != "dishes" else ["use"]:
                self.assertIn(f'"{key}"', reader)


class BadInput(Sandbox):
    def told(self, text, status=65):
        (self.path / "small.toml").write_text(text)
        result = self.run_data(status=status)
        self.assertFalse((self.path / "out").exists())
        return result.stderr

    def test_is_told_with_its_place(self):
        self.assertIn('small.toml:6:1: error: unknown key "cuont"', self.told(SMALL.replace("count =", "cuont =")))
        self.assertIn("small.toml:29:14: error", self.told(SMALL.replace('"cherry", "lemon"', '"chery", "lemon"'), status=66))
        wrong_style = self.told(SMALL.replace('"photo"', '"phot"'))
        self.assertIn("small.toml:9:17: error", wrong_style)
        self.assertIn("did you mean", wrong_style)
        (self.path / "small.toml").write_text("[[entry]]\n[batch]\n")
        self.assertIn("pomona batch takes batches", self.run_data(status=65).stderr)
        self.prepare(self.path)
        self.assertIn("pomona data takes data sets", self.run_pomona("batch", "small.toml", "-o", "out", status=65).stderr)

    def test_of_the_words(self):
        self.assertIn("0 to 5", self.run_data("--picture", "6", status=64).stderr)
        self.run_data("--picture", "1", "--shard", "1/2", status=64)
        self.run_data("--update", "--shard", "1/2", status=64)

    def test_check_knows_data_sets(self):
        self.run_pomona("check", "small.toml", "cut_fruit")
        self.assertNotIn("cut_fruit", self.run_pomona("list", "--scenes").stdout)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
