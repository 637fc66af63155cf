#!/usr/bin/env python3
"""Breaks each rule of check_sources.py once in a made-up tree, and keeps each once: a checker that finds
nothing wrong must be one that could."""

import pathlib
import tempfile
import unittest

import check_sources

HEADER = "// What it is.\n#pragma once\n"


class Tree(unittest.TestCase):
    check = staticmethod(check_sources.check)

    def wrong_with(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return self.check(folder)

    def assert_wrong(self, files, place, words):
        wrong = self.wrong_with(files)
        self.assertEqual(len(wrong), 1, wrong)
        self.assertTrue(wrong[0].startswith(place + ":"), wrong)
        self.assertIn(words, wrong[0])

    def assert_fine(self, files):
        self.assertEqual(self.wrong_with(files), [])


class Rules(Tree):
    def test_includes_point_backwards(self):
        surface = {"generator/surface/sweep/sweep.h": HEADER}
        self.assert_fine(surface | {"generator/cut/cut.cpp": '#include "generator/surface/sweep/sweep.h"\n'})
        self.assert_wrong(
            surface | {"generator/base/curve.cpp": '\n#include "generator/surface/sweep/sweep.h"\n'},
            "generator/base/curve.cpp:2",
            "ahead on the road",
        )
        self.assert_wrong(
            {"render/gl/draw.h": HEADER, "generator/scene/scene.cpp": '#include "render/gl/draw.h"\n'},
            "generator/scene/scene.cpp:1",
            "ahead on the road",
        )

    def test_scripts_point_backwards_and_not_in_circles(self):
        page = {"render/page/board.js": "import {Camera} from './camera.js';\n", "render/page/camera.js": "\n"}
        self.assert_fine(page | {"cli/studio/page/main.js": "import {Board} from '../../../render/page/board.js';\n"})
        self.assert_wrong(
            page | {"render/page/x.js": "import {\n  A\n} from '../../cli/a.js';\n"}, "render/page/x.js:3", "ahead on the road"
        )
        self.assert_wrong(
            page | {"render/page/camera.js": "import {Board} from './board.js';\n"}, "render/page/board.js:1", "camera.js"
        )
        self.assert_wrong(page | {"render/page/x.js": f"f({'1' * 120});\n"}, "render/page/x.js:1", "120")

    def test_tests_may_see_everything_but_are_seen_by_none(self):
        shapes = {"tests/shapes/box.h": HEADER}
        self.assert_fine(shapes | {"tests/cut/cut_test.cpp": '#include "tests/shapes/box.h"\n'})
        self.assert_wrong(
            shapes | {"cli/main.cpp": '#include "tests/shapes/box.h"\n'}, "cli/main.cpp:1", "no part of the road"
        )

    def test_digits_may_have_separators(self):
        self.assert_wrong({"generator/base/x.cpp": "f(300'000, std::sin(x), 10'000);\n"}, "generator/base/x.cpp:1", "sin()")

    def test_json_becomes_text_in_one_way(self):
        self.assert_fine({"generator/base/json_text.h": HEADER + "json.dump(indent);\n", "cli/list.cpp": "json_text(all);\n"})
        self.assert_wrong({"cli/list.cpp": "\nall.dump(2);\n"}, "cli/list.cpp:2", "json_text()")

    def test_includes_are_written_from_the_root(self):
        files = {"generator/cut/cut.h": HEADER, "generator/cut/cut.cpp": '#include "cut.h"\n'}
        self.assert_wrong(files, "generator/cut/cut.cpp:1", "not a path from the repository root")
        files["generator/cut/cut.cpp"] = "#include <generator/cut/cut.h>\n"
        self.assert_wrong(files, "generator/cut/cut.cpp:1", "is included with")

    def test_tests_include_what_they_are_written_with(self):
        self.assert_wrong({"tests/cut/cut_test.cpp": "\nTEST(Cut, Cuts) {}\n"}, "tests/cut/cut_test.cpp:2", "gtest.h")
        self.assert_fine({"tests/cut/cut_test.cpp": "#include <gmock/gmock.h>\n\nTEST(Cut, Cuts) {}\n"})

    def test_heavy_packages_stay_where_they_belong(self):
        include = "#include <CGAL/Constrained_Delaunay_triangulation_2.h>\n"
        self.assert_fine({"generator/cut/plane/triangulate.cpp": include})
        self.assert_wrong({"generator/surface/bodies.cpp": include}, "generator/surface/bodies.cpp:1", "CGAL")
        self.assert_wrong({"generator/cut/plane/plane_triangulation.h": HEADER + include}, "generator/cut/plane/plane_triangulation.h:3", "header")

    def test_no_libm(self):
        for call in ("std::sin(x)", "glm::pow(x, y)", "::cosf(x)", "sin (x)", "std::hypot(x, y)"):
            self.assert_wrong({"generator/base/a.cpp": f"double f = {call};\n"}, "generator/base/a.cpp:1", "C library")
        for call in ("reproducible::sin(x)", "std::sqrt(x)", "point.sin(x)", "asinine(x)", "// std::sin(x)"):
            self.assert_fine({"generator/base/a.cpp": f"double f = {call};\n"})
        self.assert_fine({"generator/base/a.cpp": "using reproducible::cos;\nauto c = cos(x);\n"})
        self.assert_fine({"render/gl/a.cpp": "auto c = std::cos(x);\n"})

    def test_no_foreign_randomness(self):
        for call in ("std::normal_distribution<double> d;", "std::mt19937 g;", "int i = rand();", "std::shuffle(a, b, g);"):
            self.assert_wrong({"render/style/a.cpp": call + "\n"}, "render/style/a.cpp:1", "RandomStream" )

    def test_a_type_has_a_name_of_its_own(self):
        a = {"generator/cut/a.cpp": "namespace {\n\nstruct Face {\n  struct Edge {\n  };\n};\n}\n"}
        for other in ("struct Face {", "class Face final : public Cut {", "enum class Face : char {", "using Face = int;"):
            self.assert_wrong(a | {"render/gl/b.cpp": f"//\n{other}\n"}, "render/gl/b.cpp:2", "Face is something else in generator/cut/a.cpp")
        for other in ("struct Edge {", "struct Face;", "// Face\nstruct Other {", "struct Face::Edge {", "using Face = Mesh::Face;"):
            self.assert_fine(a | {"render/gl/b.cpp": other + "\n"})
        self.assert_fine(a | {"tests/cut/a_test.cpp": "struct Face {\n"})
        exact = {"generator/cut/c.cpp": "using Exact =\n    CGAL::Exact;\n", "generator/cut/d.cpp": "using Exact = double;\n"}
        self.assert_fine({**exact, "generator/cut/d.cpp": "using Exact = CGAL::Exact;\n"})
        self.assert_wrong({**exact, "generator/cut/c.cpp": "using Exact = float;\n"}, "generator/cut/d.cpp:1", "Exact")

    def test_no_door_is_included_by_its_parts(self):
        door = {"generator/cut/door.h": HEADER, "generator/cut/door.cpp": '#include "generator/cut/door.h"\n#include "generator/cut/part.h"\n'}
        self.assert_fine(door | {"generator/cut/part.h": HEADER})
        self.assert_wrong(
            door | {"generator/cut/part.h": HEADER + '#include "generator/cut/door.h"\n'},
            "generator/cut/part.h:3",
            "goes in a circle: door -> part -> door",
        )
        far = {"generator/cut/part.h": HEADER, "generator/cut/part.cpp": '#include "generator/cut/detail.h"\n'}
        self.assert_wrong(
            door | far | {"generator/cut/detail.h": HEADER + '#include "generator/cut/door.h"\n'},
            "generator/cut/part.cpp:1",
            "in a circle",
        )

    def test_files_are_named_after_something(self):
        self.assert_wrong({"generator/base/curve_utils.h": HEADER}, "generator/base/curve_utils.h:1", "says nothing")
        self.assert_wrong({"generator/base/Curve.h": HEADER}, "generator/base/Curve.h:1", "snake_case")
        self.assert_wrong({"generator/base/curve.hpp": HEADER}, "generator/base/curve.hpp:1", "snake_case")

    def test_headers_say_what_they_are_and_come_once(self):
        self.assert_wrong({"cli/a.h": "#pragma once\n"}, "cli/a.h:1", "comment")
        self.assert_wrong({"cli/a.h": "// What it is.\n"}, "cli/a.h:1", "#pragma once")


class Readmes(Tree):
    check = staticmethod(check_sources.check_readmes)

    ROOM = {"cli/README.md": "Start with `main.cpp`.\n", "cli/main.cpp": ""}

    def test_every_folder_of_the_road_has_one(self):
        self.assert_fine(self.ROOM)
        self.assert_wrong({"cli/main.cpp": ""}, "cli:1", "no README.md")
        self.assert_wrong(self.ROOM | {"cli/pages/page.h": HEADER}, "cli/pages:1", "no README.md")
        self.assert_fine(self.ROOM | {"cli/templates/fruit.toml": "", "shaders/noise.glsl": ""})

    def test_tests_and_benches_have_one_for_the_whole(self):
        self.assert_wrong({"tests/cut/cut_test.cpp": ""}, "tests:1", "no README.md")
        self.assert_fine({"tests/cut/cut_test.cpp": "", "tests/README.md": ""})

    def test_they_name_only_what_is_there(self):
        for named in ("main.cpp", "page.h", "pages/page.h", "cli/pages/page.h", "docs/reference/commands.md"):
            files = {"cli/pages/page.h": HEADER, "cli/pages/README.md": "", "docs/reference/commands.md": ""}
            self.assert_fine(self.ROOM | files | {"cli/README.md": f"See `{named}`.\n"})
        for named in ("gone.cpp", "pages/gone.h", "generator/cut/gone.h", "../docs/gone.md"):
            self.assert_wrong(self.ROOM | {"cli/README.md": f"\nSee `{named}`.\n"}, "cli/README.md:2", named)


class Sizes(Tree):
    check = staticmethod(check_sources.check_sizes)

    def test_folders_of_the_command_line_are_small(self):
        files = {f"cli/batch/{n}.cpp": "" for n in range(30)}
        self.assert_fine(files)
        self.assert_wrong(files | {"cli/batch/more.cpp": ""}, "cli/batch:1", "31 files")


if __name__ == "__main__":
    unittest.main()
