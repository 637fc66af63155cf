"""What the installed module promises, from a folder that knows nothing of where it was built.

    module_test.py PROGRAM SOURCE
"""

import concurrent.futures
import gc
import inspect
import json
import os
import pathlib
import pickle
import pydoc
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
import unittest
import warnings

import numpy

PROGRAM, SOURCE = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
FOLDER = tempfile.TemporaryDirectory(prefix="pomona-test-")
os.chdir(FOLDER.name)

import pomona

QUICK = {"quality": "draft", "detail": 0.4}
ARRAYS = ("positions", "normals", "colors", "parts", "triangles", "cut_faces")
TAKERS = {  # every function, whose options it takes, and from which step of the road on
    pomona.grow: ("grow", "grow"), pomona.scene: ("scene", "grow"),
    pomona.Fruit.cut: ("cut", "cut"), pomona.Fruit.section: ("cut", "cut"),
    pomona.Fruit.write: ("grow", "cut"), pomona.Fruit.render: ("grow", "cut"), pomona.Fruit.ground_truth: ("grow", "cut"),
    pomona.Pieces.write: ("cut", "write"), pomona.Pieces.render: ("cut", "write"),
    pomona.Pieces.ground_truth: ("cut", "write"), pomona.Piece.write: ("cut", "write"), pomona.Piece.render: ("cut", "write"),
    pomona.Section.write: ("cut", "write"), pomona.Section.render: ("cut", "write"),
    pomona.Scene.write: ("scene", "write"), pomona.Scene.render: ("scene", "write"),
    pomona.Scene.ground_truth: ("scene", "write"),
}


def run_program(*words):
    return subprocess.run([PROGRAM, *map(str, words)], check=True, capture_output=True, text=True).stdout


class Options(unittest.TestCase):
    def keywords(self, function):
        own = {"self", "progress", "path", "more", "knives", "template", "description"}
        return set(inspect.signature(function).parameters) - own

    def test_functions_take_what_the_table_says_and_nothing_else(self):
        steps = ["grow", "cut", "write"]
        for function, (taker, first) in TAKERS.items():
            rows = [o for o in pomona.options() if taker in o.takers and steps.index(o.step) >= steps.index(first)]
            self.assertEqual(self.keywords(function), {row.keyword for row in rows}, function)

    def test_the_table_is_the_programs(self):
        for taker in ("grow", "cut", "scene"):
            said = run_program(taker, "-h").split("Options:")[1]
            flags = {line.split()[0].removeprefix("--") for line in said.splitlines() if line.startswith("  --")}
            own = {"format", "stats", "quiet", "json", "watch", "output", "help"}
            self.assertEqual({o.name for o in pomona.options() if taker in o.takers}, flags - own, taker)

    def test_every_option_can_be_given_somewhere(self):
        given = set().union(*(self.keywords(function) for function in TAKERS))
        doors = {"grow", "cut", "scene"}
        self.assertEqual({o.keyword for o in pomona.options() if doors & set(o.takers)}, given)

    def test_help_tells_every_option_and_what_it_takes(self):
        told = pydoc.plain(pydoc.render_doc(pomona.Fruit.cut))
        for option in pomona.options():
            if "cut" in option.takers and option.step != "grow":
                self.assertIn(f"    {option.keyword}", told)
                self.assertIn(option.help[:40], told)

    def test_all_that_is_public_is_described(self):
        for name in set(pomona.__all__):
            self.assertTrue(inspect.getdoc(getattr(pomona, name)), name)

    def test_values_are_pythons_own(self):
        pieces = pomona.grow("tomato", seed=numpy.int64(3), ripeness=numpy.float32(0.5), **QUICK).cut(
            "half", size=(64, 48), crumbs=False, style=None)
        self.assertEqual(pieces.render().shape, (48, 64, 3))
        self.assertEqual(pieces[0].seed, 3)
        self.assertEqual(pieces.render(size="80x60").shape, (60, 80, 3))

    def test_mistakes_are_told_with_what_was_meant(self):
        with self.assertRaisesRegex(TypeError, "there is no option ripenes: did you mean ripeness"):
            pomona.grow("tomato", ripenes=1)
        for odd in (3, None, b"tomato"):
            with self.assertRaisesRegex(TypeError, "a template is a name, a path, .*: no " + type(odd).__name__):
                pomona.grow(odd)
        with self.assertRaisesRegex(TypeError, "a scene is a name"):
            pomona.scene(["salad"])
        with self.assertRaisesRegex(pomona.Error, '^ripeness: "3" is not a number from 0 to 2'):
            pomona.grow("tomato", ripeness=3)
        with self.assertRaisesRegex(pomona.Error, '"fnal" is none of draft, final'):
            pomona.grow("tomato").cut("half", quality="fnal")
        with self.assertRaises(pomona.Error) as late:
            pomona.grow("tomato", **QUICK).cut("half", seed=3)
        self.assertEqual((late.exception.message, late.exception.hint), ("seed comes too late here", "give it to grow()"))


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.fruit = pomona.grow("tomato", seed=3, ripeness=0.4, **QUICK)
        cls.pieces = cls.fruit.cut("wedges:6")

    def test_pieces_are_a_sequence(self):
        self.assertEqual(len(self.pieces), 6)
        self.assertEqual([piece.name for piece in self.pieces][-1], self.pieces[-1].name)
        self.assertEqual(len(self.pieces[1:3]), 2)
        with self.assertRaises(IndexError):
            self.pieces[6]

    def test_arrays_have_their_shapes_and_kinds(self):
        piece = self.pieces[0]
        n, m = len(piece.positions), len(piece.triangles)
        shapes = {"positions": ((n, 3), "f4"), "normals": ((n, 3), "f4"), "colors": ((n, 3), "f4"), "parts": ((n,), "i4"),
                  "triangles": ((m, 3), "u4"), "cut_faces": ((m,), "i4"), "uv": ((0, 2), "f4")}
        for name, (shape, kind) in shapes.items():
            array = getattr(piece, name)
            self.assertEqual((array.shape, array.dtype), (shape, numpy.dtype(kind)), name)
        self.assertLess(piece.triangles.max(), n)
        self.assertLess(piece.parts.max(), len(piece.part_names))
        numpy.testing.assert_allclose(numpy.linalg.norm(piece.normals, axis=1), 1, atol=1e-5)

    def test_arrays_are_views_that_nobody_writes_to_and_that_keep_what_they_show(self):
        pieces = self.fruit.cut("half")
        array, again = pieces[0].positions, pieces[0].positions
        self.assertEqual(array.ctypes.data, again.ctypes.data, "the same memory, not a copy")
        self.assertFalse(array.flags.owndata)
        with self.assertRaises(ValueError):
            array[0] = 0
        kept = array.copy()
        del pieces, again
        gc.collect()
        pomona.grow("lemon", **QUICK).cut("half")[0].positions
        numpy.testing.assert_array_equal(array, kept)

    def test_volumes_are_what_the_mesh_encloses_and_add_up(self):
        for piece in self.pieces:
            a, b, c = (piece.positions[piece.triangles[:, i]].astype(float) for i in range(3))
            self.assertAlmostEqual(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6 / piece.volume, 1, delta=1e-3)
        (whole,) = self.fruit.cut()
        self.assertAlmostEqual(sum(piece.volume for piece in self.pieces) / whole.volume, 1, delta=1e-6)

    def test_facts_are_those_of_the_piece_list(self):
        self.pieces.write("wedges.glb", pieces="wedges.json")
        for piece, listed in zip(self.pieces, json.loads(pathlib.Path("wedges.json").read_text())["pieces"], strict=True):
            for fact in ("name", "volume", "mass", "density"):
                self.assertEqual(getattr(piece, fact), listed[fact])
            numpy.testing.assert_array_equal(piece.center, listed["center"])
            numpy.testing.assert_array_equal(piece.inertia, listed["inertia"])
            numpy.testing.assert_array_equal(piece.bounds, [listed["low"], listed["high"]])

    def test_its_command_makes_a_piece_again(self):
        self.assertIn("--ripeness 0.4 --detail 0.4 --knife wedges:6", self.pieces[1].command)
        self.assertIn("--piece 2", self.pieces[1].command)

    def test_textures_come_with_uv(self):
        piece = self.fruit.cut("half", texture=64)[0]
        self.assertEqual(piece.uv.shape, (len(piece.positions), 2))
        self.assertEqual(piece.texture.shape, (64, 64, 3))
        self.assertTrue(((0 <= piece.uv) & (piece.uv <= 1)).all())
        self.assertIsNone(self.pieces[0].texture)

    def test_textures_that_are_asked_for_too_late_are_refused(self):
        with self.assertRaises(pomona.Error) as late:
            self.pieces.write("late.glb", texture=64)
        self.assertEqual(late.exception.hint, "give it to cut()")

    def test_arrays_are_what_a_glb_holds(self):
        self.pieces.write("arrays.glb")
        glb = pathlib.Path("arrays.glb").read_bytes()
        length = int.from_bytes(glb[12:16], "little")
        head, binary = json.loads(glb[20:20 + length]), glb[28 + length:]
        nodes = {node["name"]: node for node in head["nodes"]}
        for piece in self.pieces:
            node = nodes[piece.name]
            attributes = head["meshes"][node["mesh"]]["primitives"][0]["attributes"]
            held = {name: strided(head, binary, index) for name, index in attributes.items()}
            numpy.testing.assert_allclose(held["POSITION"] + node["translation"], piece.positions, atol=1e-8)
            numpy.testing.assert_array_equal(held["NORMAL"], piece.normals)
            corners = sum(head["accessors"][p["indices"]]["count"] for p in head["meshes"][node["mesh"]]["primitives"])
            self.assertEqual(corners, piece.triangles.size)

    def test_sections_have_arrays_and_files(self):
        section = self.fruit.section("half")
        self.assertEqual(section.positions.shape[1], 3)
        self.assertLess(section.triangles.max(), len(section.positions))
        self.assertEqual([path.name for path in section.write("section.svg")], ["section.svg"])
        self.assertEqual(section.render(size=(64, 64)).shape, (64, 64, 3))
        with self.assertRaisesRegex(pomona.Error, "cannot write that"):
            section.write("section.glb")

    def test_pictures_are_what_a_png_holds(self):
        from_file = self.pieces.write("picture.png", size=(160, 120))
        self.assertEqual([path.name for path in from_file], ["picture.png"])
        picture = self.pieces.render(size=(160, 120))
        numpy.testing.assert_array_equal(picture, png_pixels(pathlib.Path("picture.png").read_bytes()))

    def test_a_piece_alone_is_written_and_drawn(self):
        self.assertEqual([path.name for path in self.pieces[0].write("one.glb", "one.stl")], ["one.glb", "one.stl"])
        self.assertEqual(self.pieces[0].render(size=(64, 48)).shape, (48, 64, 3))

    def test_ground_truth_tells_pieces_apart(self):
        truth = self.pieces.ground_truth(size=(160, 120))
        self.assertEqual(truth.instance.shape, (120, 160))
        self.assertEqual(set(numpy.unique(truth.instance)), set(range(7)))
        self.assertEqual(truth.instances, [piece.name for piece in self.pieces])
        self.assertTrue((truth.depth[truth.instance > 0] > 0).all())

    def test_several_seeds_stand_side_by_side(self):
        row = pomona.grow("cherry", seeds=range(1, 4), **QUICK)
        halves = row.cut("half")
        self.assertEqual(len(halves), 6)
        self.assertIn("-seed-3", halves[-1].name)

    def test_browning_is_told_when_it_is_cut(self):
        fresh, brown = (pomona.grow("avocado", **QUICK).cut("half", browning=b)[0] for b in (0, 1))
        self.assertGreater(abs(fresh.colors - brown.colors).max(), 0.05)


def strided(head, binary, index):
    """An attribute of three floats that lies among others."""
    accessor = head["accessors"][index]
    if (accessor["type"], accessor["componentType"]) != ("VEC3", 5126):
        return None
    view = head["bufferViews"][accessor["bufferView"]]
    begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return numpy.ndarray((accessor["count"], 3), "<f4", binary, begin, (view.get("byteStride", 12), 4))


def png_pixels(png):
    """By the standard library: 8-bit RGB without interlacing."""
    import struct
    import zlib

    at, packed, width, height = 8, b"", 0, 0
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        if kind == b"IHDR":
            width, height = struct.unpack(">II", png[at + 8:at + 16])
        packed += png[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    rows = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + 3 * width)
    pixels = numpy.zeros((height + 1, width + 1, 3), int)
    for y in range(height):
        line = rows[y, 1:].reshape(width, 3).astype(int)
        for x in range(width):
            left, up, corner = pixels[y + 1, x], pixels[y, x + 1], pixels[y, x]
            guess = left + up - corner
            by_left, by_up, by_corner = abs(guess - left), abs(guess - up), abs(guess - corner)
            paeth = numpy.where((by_left <= by_up) & (by_left <= by_corner), left, numpy.where(by_up <= by_corner, up, corner))
            pixels[y + 1, x + 1] = (line[x] + [0, left, up, (left + up) // 2, paeth][rows[y, 0]]) % 256
    return pixels[1:, 1:].astype(numpy.uint8)


class Work(unittest.TestCase):
    def test_errors_have_file_line_column_and_hint(self):
        text = (SOURCE / "templates/tomato.toml").read_text().replace("[[surface]]", "[[surfaces]]", 1)
        pathlib.Path("wrong.toml").write_text(text)
        with self.assertRaises(pomona.Error) as told:
            pomona.grow("wrong.toml")
        error = told.exception
        self.assertEqual((error.file, error.status), ("wrong.toml", 65))
        self.assertGreater(error.line, 1)
        self.assertGreater(error.column, 0)
        self.assertIn(f"wrong.toml:{error.line}:{error.column}: ", str(error))
        with self.assertRaises(pomona.Error) as mistyped:
            pomona.grow("tomatoe")
        self.assertEqual((mistyped.exception.hint, mistyped.exception.status), ("did you mean tomato?", 66))
        self.assertEqual(str(pickle.loads(pickle.dumps(error))), str(error))

    def test_warnings_are_pythons_and_about_the_line_that_called(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            pomona.grow("cherry", variation=2, **QUICK)
        self.assertEqual([(w.category, w.filename) for w in told], [(pomona.PomonaWarning, __file__)])
        self.assertIn("variation is about variants", str(told[0].message))

    def test_templates_come_from_paths_texts_and_dictionaries(self):
        file = SOURCE / "templates/radish.toml"
        by_path = pomona.grow(file, seed=2, **QUICK).cut("half")
        by_text = pomona.grow(file.read_text(), seed=2, **QUICK).cut("half")
        by_dict = pomona.grow(tomllib.loads(file.read_text()), seed=2, **QUICK).cut("half")
        for other in (by_text, by_dict):
            numpy.testing.assert_array_equal(by_path[0].positions, other[0].positions)
        with self.assertRaises(pomona.Error) as told:
            pomona.grow({"title": "Nothing"})
        self.assertIn("Python", told.exception.file)

    def test_all_templates_scenes_and_styles_are_known(self):
        listed = json.loads(run_program("list", "--json"))
        self.assertEqual([(t.name, t.title, t.parts) for t in pomona.templates()], [(t["name"], t["title"], t["parts"]) for t in listed])
        self.assertEqual([s.name for s in pomona.scenes()], [s["name"] for s in json.loads(run_program("list", "--scenes", "--json"))])
        self.assertEqual([s.name for s in pomona.styles()], [s["name"] for s in json.loads(run_program("list", "--styles", "--json"))])

    def test_progress_is_told_on_the_calling_thread(self):
        told = []
        pomona.scene("ripeness", progress=lambda *words: told.append((threading.get_ident(), *words)), **QUICK)
        self.assertTrue(told)
        for thread, stage, done, total in told:
            self.assertEqual(thread, threading.get_ident())
            self.assertLessEqual(done, total)
            self.assertIsInstance(stage, str)

    def test_what_progress_throws_ends_the_work(self):
        def stop(stage, done, total):
            raise LookupError(stage)

        with self.assertRaises(LookupError):
            pomona.scene("salad", progress=stop, **QUICK)

    def test_ctrl_c_stops_long_work(self):
        script = "import pomona, sys\nprint('begun', flush=True)\npomona.scene('salad', quality='reference', detail=2)\n"
        run = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(run.stdout.readline(), "begun\n")
        time.sleep(0.7)
        pressed = time.monotonic()
        run.send_signal(signal.SIGINT)
        _, errors = run.communicate(timeout=60)
        self.assertIn("KeyboardInterrupt", errors)
        self.assertLess(time.monotonic() - pressed, 10)

    def test_other_threads_of_python_run_meanwhile(self):
        ticks = []
        over = threading.Event()

        def tick():
            while not over.wait(0.005):
                ticks.append(1)

        ticker = threading.Thread(target=tick)
        ticker.start()
        pomona.grow("pomegranate", seed=1).cut("half", quality="draft")
        over.set()
        ticker.join()
        self.assertGreater(len(ticks), 10)

    def test_seeds_in_parallel_have_the_same_bytes(self):
        def halves(seed):
            path = pathlib.Path(f"{threading.get_ident()}-{seed}.glb")
            pomona.grow("cherry", seed=seed, threads=1, **QUICK).cut("half").write(path)
            return path.read_bytes()

        seeds = range(1, 9)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(halves, seeds)), [halves(seed) for seed in seeds])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
