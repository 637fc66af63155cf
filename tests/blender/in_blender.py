"""The add-on as it is installed, tried by Blender without a window:

    blender -b --factory-startup --python-exit-code 1 -P in_blender.py -- ADDON.zip PROGRAM FOLDER [MODULE_FOLDER]

FOLDER is scratch. With MODULE_FOLDER, which holds the Python package pomona, the add-on works by that."""

import ast
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import unittest
import urllib.request

import bpy
import numpy
from mathutils import Vector

ADDON, PROGRAM, FOLDER, *MODULE = sys.argv[sys.argv.index("--") + 1:]
FOLDER = pathlib.Path(FOLDER)
sys.path[:0] = MODULE
os.environ["PATH"] = os.path.dirname(PROGRAM) + ":" + os.environ["PATH"]
bpy.ops.preferences.addon_install(filepath=ADDON, overwrite=True)
bpy.ops.preferences.addon_enable(module="pomona_blender")

import pomona_blender  # noqa: E402
from pomona_blender import build_objects, flat_faces, glb_file, option_table, orders, settings, studio  # noqa: E402
from pomona_blender.keeper import keeper  # noqa: E402
from pomona_blender.workshop import open_workshop, workshop  # noqa: E402


SOURCE = pathlib.Path(__file__).parents[2]
DOCUMENTS = [re.search(r"(?ms)^In Blender, after.*?^<!-- gallery", (SOURCE / "README.md").read_text())[0],
             (SOURCE / "docs/guides/blender.md").read_text()]


def told_by_program(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


def made_by_program(*words):
    """What the program makes of a command, as the add-on reads it."""
    path = FOLDER / "expected.glb"
    told_by_program(*words, "-o", str(path))
    return glb_file.read_glb(path.read_bytes())


def add(template, **words):
    """Its root."""
    assert bpy.ops.pomona.add(template=template, **{"quality": "draft", **words}) == {"FINISHED"}
    return bpy.context.object


def points(mesh):
    places = numpy.empty(3 * len(mesh.vertices), numpy.float32)
    mesh.vertices.foreach_get("co", places)
    return places.reshape(-1, 3)


def pieces(root):
    return build_objects.pieces_of(root)


def tick_until(is_so, seconds=30):
    """Lets the add-on work as a window does. How long that took, and the longest that it kept a window from drawing."""
    began, longest = time.monotonic(), 0.0
    while not is_so():
        if time.monotonic() - began > seconds:
            raise AssertionError(f"not so after {seconds} s")
        before = time.monotonic()
        delay = keeper().tick()
        longest = max(longest, time.monotonic() - before)
        time.sleep(delay)
    return time.monotonic() - began, longest


def bowl():
    """Of an open hemisphere, 16 cm wide, with a wall of 5 mm."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16, radius=0.08)
    thing = bpy.context.object
    mesh = thing.data
    upper = [vertex.index for vertex in mesh.vertices if vertex.co.z > 0.001]
    faces = [tuple(face.vertices) for face in mesh.polygons if not set(face.vertices) & set(upper)]
    places = [tuple(vertex.co) for vertex in mesh.vertices]
    mesh.clear_geometry()
    mesh.from_pydata(places, [], faces)
    wall = thing.modifiers.new("wall", "SOLIDIFY")
    wall.thickness = 0.005
    bpy.ops.object.select_all(action="DESELECT")
    thing.select_set(True)
    bpy.context.view_layer.objects.active = thing
    thing.name = "bowl"
    return thing


class InBlender(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
        if not hasattr(bpy.types.Object, "pomona"):
            bpy.ops.preferences.addon_enable(module="pomona_blender")

    def test_its_options_are_those_of_the_table(self):
        table = {row["name"]: row for row in json.loads(told_by_program("pages", "options"))}
        self.assertLessEqual(option_table.NOT_ASKED, set(table))
        root = add("cherry")
        known = {name: prop for name, prop in root.pomona.options.bl_rna.properties.items()
                 if name not in ("rna_type", "name")}
        expected = [row for name, row in table.items() if "cut" in row["commands"]
                    and (not row["formats"] or "glb" in row["formats"]) and name not in option_table.NOT_ASKED]
        self.assertEqual(list(known), [row["key"] for row in expected])
        for row in expected:
            prop = known[row["key"]]
            self.assertEqual(prop.description, row["help"])
            if row["type"] in ("number", "whole"):
                self.assertAlmostEqual(prop.hard_min, row["low"], places=5)
                self.assertAlmostEqual(prop.hard_max, row["high"], places=5)
            if row["type"] == "choice":
                self.assertEqual(list(prop.enum_items.keys()), row["words"])
            if row["usual"] and row["type"] in ("number", "choice"):
                self.assertEqual(str(prop.default).removesuffix(".0"), row["usual"])
        operator = bpy.ops.pomona.add.get_rna_type().properties
        self.assertLessEqual({row["key"] for row in expected}, set(operator.keys()))

    def test_pieces_are_the_programs(self):
        root = add("tomato", knives="half wedges:2", seed=3, ripeness=0.4)
        model = made_by_program("cut", "tomato", "--knife", "half", "--knife", "wedges:2", "--seed", "3", "--ripeness",
                                "0.4", "--quality", "draft")
        self.assertEqual([thing.name for thing in pieces(root)], [placed.name for placed in model.placed])
        for thing, placed in zip(pieces(root), model.placed):
            told = model.meshes[placed.mesh]
            turned = numpy.stack([told.positions[:, 0], -told.positions[:, 2], told.positions[:, 1]], axis=1)
            numpy.testing.assert_array_equal(points(thing.data), turned)
            x, y, z = placed.place[:3, 3]
            numpy.testing.assert_allclose(thing.location, (x, -z, y), atol=1e-7)
            self.assertEqual(len(thing.data.polygons), len(told.triangles))
            self.assertEqual(thing.data["command"], told.extras["command"])
            self.assertAlmostEqual(thing.data["volume"], told.extras["volume"], places=12)

    def test_looks_are_named_by_part_and_shared(self):
        first, second = add("tomato", knives="half"), add("tomato", knives="wedges:4", seed=2)
        used = [{slot.material.name for thing in pieces(root) for slot in thing.material_slots}
                for root in (first, second)]
        self.assertIn("tomato gel", used[0] & used[1])
        self.assertFalse([name for name in used[0] | used[1] if "." in name], "no copies")
        textured = add("tomato", knives="half", texture=64)
        groups = {node.node_tree.name for thing in pieces(textured) for slot in thing.material_slots
                  for node in slot.material.node_tree.nodes if node.type == "GROUP"}
        self.assertLessEqual(groups, used[0] | used[1], "the same looks, with textures and without")
        gel = bpy.data.node_groups["tomato gel"].nodes["Principled BSDF"]
        self.assertGreater(gel.inputs["Subsurface"].default_value, 0.1)
        self.assertTrue(gel.inputs["Clearcoat"].is_linked, "juice")
        self.assertLess(gel.inputs["Subsurface Radius"].default_value[0], 0.1, "metres")
        self.assertTrue(all(image.packed_file for image in bpy.data.images if image.name.startswith("tomato")))

    def test_levels_of_detail_are_hidden(self):
        root = add("cherry", knives="half", lod=1)
        levels = build_objects.levels_of(root)
        self.assertEqual(len(levels), len(pieces(root)))
        for level, thing in zip(levels, pieces(root)):
            self.assertLess(len(level.data.polygons), 0.7 * len(thing.data.polygons))
            self.assertFalse(level.visible_get())

    def test_faces_lie_up(self):
        root = add("lemon", knives="wedges:3", face_up=True)
        bpy.context.view_layer.update()
        for thing in pieces(root):
            mesh = thing.data
            mesh.calc_loop_triangles()
            triangles = numpy.array([triangle.vertices for triangle in mesh.loop_triangles])
            normal = flat_faces.largest_flat_face(points(mesh), triangles)
            self.assertGreater((thing.matrix_world.to_3x3() @ Vector(normal)).z, 0.999)
            heights = [(thing.matrix_world @ vertex.co).z for vertex in mesh.vertices]
            self.assertAlmostEqual(min(heights), 0, places=5)

    def test_another_seed_and_again_by_the_command(self):
        root = add("radish", knives="half")
        before = points(pieces(root)[0].data)
        self.assertEqual(bpy.ops.pomona.another_seed(), {"FINISHED"})
        self.assertEqual(len(pieces(root)), 2)
        after = points(pieces(root)[1].data)
        self.assertFalse(before.shape == after.shape and numpy.array_equal(before, after))
        bpy.context.view_layer.objects.active = pieces(root)[1]
        self.assertEqual(bpy.ops.pomona.make_again(), {"FINISHED"})
        again = pieces(bpy.context.object)
        self.assertEqual(len(again), 1)
        numpy.testing.assert_array_equal(points(again[0].data), after)

    def test_a_plane_cuts_where_it_stands_and_within_a_second(self):
        root = add("tomato")
        self.assertEqual(len(pieces(root)), 1)
        root.location, root.rotation_euler = (0.3, -0.1, 0.2), (0.2, 0.1, 0.7)
        bpy.context.view_layer.update()
        bpy.ops.pomona.add_knife(is_plane=True)
        plane = root.pomona.knives[0].plane
        self.assertEqual(len(pieces(root)), 2)
        for step in (1, 2, 3):
            plane.location.y += 0.004
            plane.rotation_euler.z = 0.1 * step
            bpy.context.view_layer.update()
            order = settings.order_of(root, workshop().asked)
            # A slow machine may go on to the lasting cut at once.
            wanted = (settings.hasty(order, workshop().asked).key, order.key)
            took, longest = tick_until(lambda: root.pomona.made in wanted)
            self.assertLess(longest, 0.5)
            bpy.context.view_layer.update()
            inverse = plane.matrix_world.inverted()
            sides = [[(inverse @ thing.matrix_world @ vertex.co).z for vertex in thing.data.vertices]
                     for thing in pieces(root)]
            self.assertLess(min(max(min(side), -max(side)) for side in sides), 1e-5)
            self.assertGreater(min(max(min(side), -max(side)) for side in sides), -1e-4, "pieces end at the plane")
            print(f"the cut followed after {took:.2f} s")
        tick_until(lambda: not keeper().is_busy)
        ordered = settings.order_of(root, workshop().asked).key
        self.assertEqual(root.pomona.made, ordered, "when all is quiet, as ordered")
        bpy.ops.pomona.remove_knife()
        self.assertEqual(len(pieces(root)), 1)

    def test_a_slider_is_followed_and_nothing_blocks(self):
        root = add("pomegranate", knives="half")
        before = points(pieces(root)[0].data)
        root.pomona.options.seed = 5
        _, longest = tick_until(lambda: not keeper().is_busy and root.pomona.made.count("--seed 5") == 1)
        self.assertLess(longest, 0.5)
        self.assertFalse(numpy.array_equal(before[:100], points(pieces(root)[0].data)[:100]))

    def test_work_stops_when_asked(self):
        root = add("kiwi", knives="half")
        root.pomona.options.texture = 4096
        tick_until(lambda: any(job.seconds > 1 for job in workshop().jobs.values()))
        job = next(iter(workshop().jobs.values()))
        made = root.pomona.made
        workshop().stop_all()
        self.assertTrue(job.wait(3), "it ends soon")
        self.assertIsNone(job.model)
        tick_until(lambda: not keeper().is_busy)
        self.assertEqual((root.pomona.made, root.pomona.message), (made, "Stopped"))
        self.assertEqual(len(pieces(root)), 2, "what was there stays")

    def test_what_is_wrong_is_told(self):
        for words, said in (({"template": "tomatoe"}, "tomatoe"), ({"template": "kidney", "ripeness": 0.3}, "ripe"),
                            ({"template": "cherry", "knives": "halve"}, "halve")):
            with self.assertRaisesRegex(RuntimeError, said):
                bpy.ops.pomona.add(**words)
            self.assertFalse(list(bpy.data.objects), "nothing is left of it")

    def test_without_pomona_it_says_what_to_install(self):
        door = workshop().door
        try:
            open_workshop(None)
            self.assertFalse(bpy.ops.pomona.add.poll())
            self.assertEqual(pomona_blender.doors.INSTALL.count(". "), 0, "one sentence")
        finally:
            open_workshop(door)

    def test_a_bowl_is_filled(self):
        dish = bowl()
        dish.location = (0.1, 0.2, 0.5)
        bpy.context.view_layer.update()
        bpy.ops.pomona.add_serving()
        row = bpy.context.scene.pomona_servings[0]
        row.template, row.knives, row.count, row.size = "cherry", "half", 4, 0.8
        self.assertEqual(bpy.ops.pomona.serve(way="FILL", seed=2), {"FINISHED"})
        root = bpy.context.object
        self.assertEqual(root.pomona.message, "")
        self.assertEqual(len(pieces(root)), 8)
        for thing in pieces(root):
            away = thing.matrix_world.translation - dish.matrix_world.translation
            self.assertLess((away.x**2 + away.y**2) ** 0.5, 0.08, "in the bowl")
            self.assertLess(away.z, 0.03)
            self.assertGreater(away.z, -0.08)
        places = [thing.matrix_world.copy() for thing in pieces(root)]
        bpy.ops.wm.save_as_mainfile(filepath=str(FOLDER / "bowl.blend"))
        bpy.ops.wm.open_mainfile(filepath=str(FOLDER / "bowl.blend"))
        root = bpy.context.object
        self.assertEqual(bpy.ops.pomona.make(), {"FINISHED"})
        self.assertEqual([thing.matrix_world for thing in pieces(root)], places)

    def test_a_mesh_is_strewn_over(self):
        """A sheet with one side, which slopes."""
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=4, y_subdivisions=4, size=0.4)
        for vertex in bpy.context.object.data.vertices:
            vertex.co.z = 0.3 * vertex.co.x
        bpy.ops.pomona.add_serving()
        row = bpy.context.scene.pomona_servings[0]
        row.template, row.count, row.size = "radish", 5, 0.6
        self.assertEqual(bpy.ops.pomona.serve(way="STREW"), {"FINISHED"})
        bpy.context.view_layer.update()
        for thing in pieces(bpy.context.object):
            place = thing.matrix_world.translation
            self.assertLess(abs(place.z - 0.3 * place.x - 0.015), 0.03)

    def test_a_mesh_becomes_a_template(self):
        bpy.ops.mesh.primitive_cube_add(size=0.1, location=(0, 0, 0.05))
        bpy.context.object.name = "Small Loaf"
        bpy.context.object.data.flip_normals()
        self.assertEqual(bpy.ops.pomona.from_mesh(filepath=str(FOLDER / "loaf.toml"), knives="slices:4"), {"FINISHED"})
        checked = subprocess.run([PROGRAM, "check", FOLDER / "loaf.toml"], capture_output=True, text=True, check=True)
        self.assertEqual(checked.stderr, "", "the inner surface lies within, though the mesh faced inwards")
        root = bpy.context.object
        self.assertEqual(len(pieces(root)), 4)
        self.assertAlmostEqual(sum(thing.data["volume"] for thing in pieces(root)), 1e-3, places=7)
        made = root.pomona.made
        text = (FOLDER / "loaf.toml").read_text()
        (FOLDER / "loaf.toml").write_text(text + "\n# edited\n")
        self.assertNotEqual(settings.order_of(root, workshop().asked).key, made, "an edited template is made anew")

    def test_a_template_file_is_followed(self):
        folder = FOLDER / "own"
        folder.mkdir(exist_ok=True)
        self.assertEqual(bpy.ops.pomona.open_template(filepath=str(self.drawn_copy(folder))), {"FINISHED"})
        root = bpy.context.object
        self.assertEqual((root.name, len(pieces(root))), ("cherry", 1))
        self.edit_and_follow(root, folder)

    def test_the_studio_draws_a_copy_that_is_followed(self):
        folder = FOLDER / "studio"
        folder.mkdir(exist_ok=True)
        root = add("cherry", knives="half")
        bpy.ops.wm.save_as_mainfile(filepath=str(folder / "fruit.blend"))
        root = next(settings.roots())
        bpy.context.view_layer.objects.active = root
        self.assertEqual(bpy.ops.pomona.studio(), {"FINISHED"})
        copy = self.drawn_copy(folder)
        self.assertEqual(root.pomona.what, "cherry", "there is no copy before it is saved")
        tick_until(lambda: root.pomona.what == str(copy) and not keeper().is_busy)
        self.assertIn(str(copy), root.pomona.made)
        self.edit_and_follow(root, folder)
        bpy.context.view_layer.objects.active = root
        with self.assertRaisesRegex(RuntimeError, "did not start: .*is open in another studio hint: "):
            bpy.ops.pomona.studio()

    def drawn_copy(self, folder):
        """The cherry's template as the studio saves it for a browser."""
        address = next((one.address for one in studio._studios), None)
        if address is None:
            opened = studio.open_studio(str(PROGRAM), "cherry", folder, shows=False)
            self.addCleanup(studio.end_studios)
            opened.wait()
            address = opened.address
        self.addCleanup(studio.end_studios)
        at, token = address.split("/?token=")

        def told(path, said=None):
            data = json.dumps(said).encode() if said is not None else None
            head = {"X-Pomona-Token": token, "Content-Type": "application/json"}
            asked = urllib.request.Request(at + path, data, head)
            with urllib.request.urlopen(asked, timeout=20) as answer:
                return json.load(answer)

        told("/api/save", {"seen": told("/api/document")["version"]})
        return folder / "cherry.toml"

    def edit_and_follow(self, root, folder):
        """Another fruit grows once the file says so, though nothing moves in Blender."""
        tick_until(lambda: not keeper().is_busy)
        count, file = len(pieces(root)[0].data.vertices), folder / "cherry.toml"
        made = root.pomona.made
        file.write_text(file.read_text().replace("around = 128", "around = 40"))
        tick_until(lambda: root.pomona.made != made and not keeper().is_busy)
        self.assertLess(len(pieces(root)[0].data.vertices), count, root.pomona.message)
        made = root.pomona.made
        os.utime(file.with_suffix(".svg"))
        tick_until(lambda: root.pomona.made != made)

    def test_documents_name_what_is_there(self):
        """Each word in italics of the README's quick start and of the guide is one that people see in Blender."""
        seen = {"Edit", "Preferences", "Add-ons", "Install", "Add", "Mesh"}  # Blender's own
        seen |= {one.title for one in workshop().templates}
        package = pathlib.Path(pomona_blender.__file__).parent
        for file in package.glob("*.py"):
            seen |= {node.value.removesuffix("...") for node in ast.walk(ast.parse(file.read_text()))
                     if isinstance(node, ast.Constant) and isinstance(node.value, str)}
        seen |= {prop.name for prop in add("cherry").pomona.options.bl_rna.properties}
        seen |= {"Fill a Dish"}  # how the panel's title begins
        for document in DOCUMENTS:
            italics = re.findall(r"(?<!\*)\*([A-Z][^*]+)\*(?!\*)", document)
            said = {" ".join(word.split()) for words in italics for word in re.split(r",\s", words)}
            self.assertGreater(len(said), 8)
            self.assertLessEqual(said - {"Fill a Dish", "Strew over a Mesh"}, seen)

    def test_quick_start_of_the_readme(self):
        """Its lines in turn, by the same operators and settings that its words name."""
        self.assertEqual(len(re.findall(r"(?m)^\d\. ", DOCUMENTS[0])), 6, "lines")
        root = add("tomato")
        root.pomona.options.seed, root.pomona.options.ripeness = 3, 0.4
        tick_until(lambda: "--seed 3 --ripeness 0.4" in root.pomona.made and not keeper().is_busy)
        bpy.ops.pomona.add_knife(is_plane=True)
        root.pomona.knives[0].plane.location.x += 0.01
        bpy.context.view_layer.update()
        tick_until(lambda: not keeper().is_busy)
        self.assertEqual(len(pieces(root)), 2)
        bpy.ops.pomona.another_seed()
        self.assertIn("--seed 4", root.pomona.made)
        root.pomona.options.texture = 1024
        tick_until(lambda: "--texture 1024" in root.pomona.made and not keeper().is_busy, seconds=120)
        self.drawn_color("quick_start")
        bowl()
        bpy.ops.pomona.add_serving()
        bpy.context.scene.pomona_servings[0].template = "cherry"
        self.assertEqual(bpy.ops.pomona.serve(way="FILL"), {"FINISHED"})
        self.assertEqual(len(pieces(bpy.context.object)), 4)

    def test_what_is_saved_is_there_again(self):
        root = add("cherry", knives="half", seed=7, texture=64)
        volume, made = pieces(root)[0].data["volume"], root.pomona.made
        bpy.ops.wm.save_as_mainfile(filepath=str(FOLDER / "saved.blend"))
        bpy.ops.wm.open_mainfile(filepath=str(FOLDER / "saved.blend"))
        root = next(settings.roots())
        self.assertEqual((root.pomona.made, pieces(root)[0].data["volume"]), (made, volume))
        self.assertEqual(settings.order_of(root, workshop().asked).key, made, "nothing is to do")
        self.assertTrue(all(image.packed_file for image in bpy.data.images if image.users))
        bpy.context.view_layer.objects.active = root
        self.assertEqual(bpy.ops.pomona.another_seed(), {"FINISHED"})
        self.assertIn("--seed 8", root.pomona.made)

    def test_nothing_is_left_behind(self):
        root = add("cherry", knives="half", texture=64)
        count = [len(blocks) for blocks in (bpy.data.meshes, bpy.data.materials, bpy.data.images, bpy.data.node_groups)]
        for _ in range(2):
            bpy.ops.pomona.another_seed()
        self.assertEqual([len(blocks) for blocks in (bpy.data.meshes, bpy.data.materials, bpy.data.images,
                                                     bpy.data.node_groups)], count)
        self.assertTrue(root.pomona.made)

    def test_a_command_becomes_an_order(self):
        order = orders.order_from_command("pomona cut 'my fruit.toml' --knife half --seed 3 --as-drawn -o x.glb",
                                          workshop().table)
        self.assertEqual(order.words(), ["cut", "my fruit.toml", "--knife", "half", "--seed", "3", "--as-drawn"])
        with self.assertRaises(ValueError):
            orders.order_from_command("rm -r folder", workshop().table)

    def test_cycles_draws_it(self):
        """Colours of vertices and textures both, at 32 samples."""
        for name, options, hue in (("tomato", {}, 0), ("kiwi", {"texture": 128}, 1)):
            self.setUp()
            add(name, knives="half", face_up=True, **options)
            color = self.drawn_color(name)
            self.assertEqual(int(color.argmax()), hue, f"{name} {color}")
            self.assertGreater(color[hue], 1.2 * color[2])
            self.assertLess(color.max(), 0.95)

    def drawn_color(self, name):
        """The mean of what is opaque in a small picture from above."""
        scene = bpy.context.scene
        camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        scene.collection.objects.link(camera)
        camera.location, scene.camera = (0, 0, 0.4), camera
        scene.world = bpy.data.worlds.new("white")
        scene.world.use_nodes = True
        scene.world.node_tree.nodes["Background"].inputs[0].default_value = (1, 1, 1, 1)
        scene.render.engine, scene.render.film_transparent = "CYCLES", True
        scene.cycles.samples, scene.cycles.seed, scene.cycles.use_denoising = 32, 0, False
        scene.render.resolution_x, scene.render.resolution_y = 80, 60
        scene.render.filepath = str(FOLDER / f"{name}.png")
        bpy.ops.render.render(write_still=True)
        pixels = numpy.array(bpy.data.images.load(scene.render.filepath).pixels[:]).reshape(-1, 4)
        return pixels[pixels[:, 3] > 0.5][:, :3].mean(axis=0)


FOLDER.mkdir(parents=True, exist_ok=True)
print("door:", workshop().door.name if workshop().door else None)
assert ("module" in workshop().door.name) == bool(MODULE)
result = unittest.main(argv=["in_blender"], exit=False).result
bpy.ops.preferences.addon_disable(module="pomona_blender")
sys.exit(0 if result.wasSuccessful() else 1)
