#!/usr/bin/env python3
"""Checks the rules of the house that a compiler does not: which folder may include which, where heavy
packages stay, how files are named, and that nothing in the road rests on the C library's functions or on
randomness that is not ours. And what a reader relies on: every folder of the road has a README, which names no file
that is not there.

    check_sources.py ROOT      prints "file:line: what is wrong", and exits with 1 if anything is
"""

import pathlib
import posixpath
import re
import sys
from functools import partial

# The road. A folder may include itself and what stands before it. A folder within a folder is a room of its own: it
# stands before the other's own files where these are the door to it, behind them where they are what it works on.
ROAD = [
    "generator/base",
    "generator/text",
    "generator/mesh",
    "generator/template",
    "generator/template/read",
    "generator/surface",
    "generator/surface/file",
    "generator/surface/sweep",
    "generator/surface/grains",
    "generator/variation",
    "generator/compose",
    "generator/knife",
    "generator/cut/section",
    "generator/cut/plane",
    "generator/cut/carve",
    "generator/cut/unite",
    "generator/cut",
    "generator/diffusion",
    "generator/diffusion/pmvc",
    "generator/diffusion/harmonic",
    "generator/diffusion/walk",
    "generator/piece",
    "generator/piece/lod",
    "generator/order",
    "generator/scene/settle",
    "generator/scene",
    "generator/batch",
    "generator/data",
    "render/image",
    "render/style",
    "render/marks",
    "render/lettering",
    "render/plate",
    "render/picture",
    "render/compare",
    "render/strokes",
    "render/truth",
    "render/texture",
    "render/gl",
    "render/diffusion",
    "render/export/transaction",
    "render/export",
    "render/export/collision",
    "render/export/gltf",
    "render/export/usd",
    "render/export/simulation",
    "render/thumbnail",
    "render/page",
    "render/deliver",
    "cli",
    "python",
]

# Each heavy package, the headers it is known by, and the only places that may know it. None may be a header.
HEAVY = {
    "CGAL": (r"CGAL/", r"generator/cut/(plane|carve)/\w+\.cpp|generator/mesh/(polygon_triangles|crossings/tie_rule)\.cpp|render/export/convex_hull\.cpp|bench/baselines/tetrahedral_mesh\.cpp"),
    "toml++": (r"toml(\+\+|plusplus)?(/|\.h)", r"generator/text/\w+\.cpp"),
    "lib2geom": (r"2geom/", r"generator/text/\w+\.cpp"),
    "pugixml": (r"pugixml\.hpp", r"generator/text/\w+\.cpp|tests/render/export/\w+\.cpp"),
    "tinygltf": (r"tiny_gltf\.h", r"generator/surface/file/gl(b|tf)_\w+\.(cpp|h)|tests/render/export/read_glb\.cpp"),
    "meshoptimizer": (r"meshoptimizer\.h", r"render/export/gltf/meshopt\.cpp|bench/(\w+/)?\w+\.cpp"),
    "libpng": (r"png\.h", r"generator/base/png_rows\.cpp|render/image/\w+\.cpp|tests/\w+/\w+\.cpp"),
    "OpenEXR": (r"Imf\w+\.h", r"render/truth/truth_exr\.cpp|tests/\w+/\w+\.cpp"),
    "MurmurHash": (r"murmurhash\.h", r"render/truth/cryptomatte\.cpp"),
    "zlib": (r"zlib\.h", r"render/page/deflate\.cpp"),
    "cpp-httplib": (r"httplib\.h", r"cli/studio/loopback_server\.cpp"),
    "EGL": (r"EGL/", r"render/gl/\w+\.cpp"),
    "OSMesa": (r"GL/osmesa\.h", r"render/gl/\w+\.cpp"),
    "OpenGL": (r"GL/(?!osmesa)", r"render/gl/\w+\.(cpp|h)"),
    "Highway": (r"hwy/", r"(generator|tests)/diffusion/(\w+/)?\w+\.(cpp|h)"),
    "Eigen": (r"Eigen/", r"tests/\w+/\w+\.cpp|bench/baselines/tetrahedral_poisson\.cpp"),
    "TBB": (r"(tbb|oneapi/tbb)/", r"generator/base/parallel\.cpp"),
    "SLEEF": (r"sleef\.h", r"generator/base/(reproducible|many_values)\.cpp"),
    "Nettle": (r"nettle/", r"generator/base/(sha256|base64)\.cpp"),
    "Random123": (r"Random123/", r"generator/base/random\.cpp"),
    "pybind11": (r"pybind11/", r"python/binding/python\.h"),
    "CLI11": (r"CLI/", r"((tests/)?cli|tests/order|bench)/(\w+/)?\w+\.(cpp|h)"),
}
HEADERS_ALLOWED = {"OpenGL", "CLI11", "Highway", "pybind11", "tinygltf"}

# Folders whose values end up in files that must be the same on every machine.
REPRODUCIBLE = ("generator/", "render/style/", "render/marks/", "render/image/", "render/picture/", "render/compare/", "render/export/", "render/thumbnail/", "render/page/", "render/deliver/", "render/texture/",
                "render/strokes/", "render/lettering/", "render/plate/")

LIBM = "a?(?:sin|cos|tan)h?|atan2|sincos|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erf|tgamma|lgamma|fma"
FORBIDDEN = [
    (re.compile(rf"(?:\bstd|\bglm|(?<![\w>])):: ?({LIBM})[fl]?\s*\("), "the C library's {0}() differs between processors: use reproducible::{0}()"),
    (re.compile(rf"(?<![\w:.>])((?:{LIBM})[fl]?)\s*\("), "the C library's {0}() differs between processors: use generator/base/reproducible.h"),
    (re.compile(r"\bglm::(rotate|angleAxis|slerp|mix_?slerp|eulerAngles|perspective\w*|polar|euclidean|axis|angle)\s*\("), "glm::{0}() calls the C library's sine and its kin"),
    (re.compile(r"\bstd::(\w+_distribution)\b"), "std::{0} is defined by each library for itself: use RandomStream"),
    (re.compile(r"\bstd::(shuffle|sample|random_shuffle|random_device|mt19937(?:_64)?|minstd_rand0?|default_random_engine)\b"), "std::{0}: all randomness comes from RandomStream"),
    (re.compile(r"(?<![\w:.>])(?:std::)?(s?rand|drand48|random)\s*\(\s*\)"), "{0}(): all randomness comes from RandomStream"),
    (re.compile(r"\bstd::(reduce|transform_reduce)\b"), "std::{0} sums in no fixed order"),
    (re.compile(r"\bstd::chrono::(system_clock)\b"), "std::chrono::{0}: no time of day in what is made"),
]

FILE_NAME = re.compile(r"[a-z0-9_]+\.(h|cpp|h\.in|cpp\.in)")
BANNED_WORDS = {"util", "utils", "utility", "utilities", "helper", "helpers", "misc", "common", "stuff"}


def without_comments_and_strings(text):
    """The same text, line for line, with comments and the insides of literals blanked."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\'', re.S)

    def blank(match):
        found = match.group(0)
        kept = '""' if found[0] in "\"R" else " "
        return kept + "\n" * found.count("\n")

    return pattern.sub(blank, text)


def place_on_road(path):
    """The index of the innermost room that holds the file; or none."""
    rooms = [index for index, folder in enumerate(ROAD) if path.startswith(folder + "/")]
    return max(rooms, key=lambda index: len(ROAD[index]), default=None)


def check_includes(root, name, text):
    text = re.sub(r'R"(\w*)\(.*?\)\1"', lambda raw: "\n" * raw.group(0).count("\n"), text, flags=re.S)
    for number, line in enumerate(text.splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if not match:
            continue
        kind, target = match.groups()
        if kind == '"':
            yield from ((number, why) for why in wrong_with_own_include(root, name, target))
        else:
            if (root / target).is_file() and target.split("/")[0] in ("generator", "render", "cli", "python", "tests"):
                yield number, f'own header <{target}> is included with "..."'
            yield from ((number, why) for why in wrong_with_package(name, target))


def wrong_with_own_include(root, name, target):
    if not (root / target).is_file() and not (root / (target + ".in")).is_file():
        yield f'"{target}" is not a path from the repository root'
        return
    if name.startswith(("tests/", "bench/")):
        return
    here, there = place_on_road(name), place_on_road(target)
    if there is None:
        yield f'"{target}" is no part of the road'
    elif here is not None and there > here:
        yield f'"{target}" lies ahead on the road: {ROAD[here]} may not know {ROAD[there]}'


def wrong_with_package(name, target):
    for package, (headers, allowed) in HEAVY.items():
        if not re.match(headers, target):
            continue
        if name.endswith(".h") and package not in HEADERS_ALLOWED:
            yield f"{package} in a header: keep it behind one .cpp"
        elif not re.fullmatch(allowed, name):
            yield f"{package} may be included only by {allowed}"


def check_test_includes(name, text):
    """Sources compiled together lend each other what one of them includes."""
    test = re.search(r"^(?:TEST|TEST_F|TEST_P)\(", text, re.M)
    if name.startswith("tests/") and test and not re.search(r"#include <g(?:test/gtest|mock/gmock)\.h>", text):
        yield text.count("\n", 0, test.start()) + 1, "a source with tests includes <gtest/gtest.h> or <gmock/gmock.h>"


def check_words(name, text):
    if not name.startswith(REPRODUCIBLE) or name.startswith("generator/base/reproducible"):
        return
    code = without_comments_and_strings(text)
    own = set(re.findall(r"\busing\s+(?:pomona::)?reproducible::(\w+)", code))
    for number, line in enumerate(code.splitlines(), 1):
        for pattern, why in FORBIDDEN:
            for match in pattern.finditer(line):
                if match.group(1) not in own or "::" in match.group(0):
                    yield number, why.format(match.group(1))


def check_json(name, text):
    """Names of files need not be UTF-8: nlohmann's dump() throws then, json_text() does not."""
    if name == "generator/base/json_text.h" or name.startswith(("tests/", "bench/")):
        return
    for number, line in enumerate(without_comments_and_strings(text).splitlines(), 1):
        if re.search(r"\.dump\(", line):
            yield number, "JSON becomes text by json_text()"


IMPORT = re.compile(r"^(?:import|export)\b[^;]*?\bfrom '(\.[^']*)'", re.M)


def imports_of(name, text):
    """Our own modules that a script imports, as (line, path from the root)."""
    for match in IMPORT.finditer(text):
        path = posixpath.normpath(posixpath.join(posixpath.dirname(name), match.group(1)))
        yield text.count("\n", 0, match.end()) + 1, path


def check_scripts(root):
    """Lines of 120; a page's modules know what comes before them on the road, and do not go round in a circle."""
    wrong, known = [], {}
    for path in sorted(p for top in ("render", "cli", "tests", "scripts") for p in (root / top).rglob("*.*js")):
        name, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
        long = [number for number, line in enumerate(text.splitlines(), 1) if len(line) > 120]
        wrong += [f"{name}:{number}: longer than 120 characters" for number in long]
        known[name] = list(imports_of(name, text))
        here = place_on_road(name)
        wrong += [f"{name}:{number}: \"{target}\" lies ahead on the road" for number, target in known[name]
                  if here is not None and (place_on_road(target) or 0) > here]
    done = set()

    def visit(name, way):
        if name in way:
            wrong.append(f"{name}:1: imports itself by way of {' and '.join(way[way.index(name) + 1:])}")
        if name in done or name in way:
            return
        for _, target in known.get(name, []):
            visit(target, [*way, name])
        done.add(name)

    for name in known:
        visit(name, [])
    return wrong


def check_file(name, text):
    file_name = name.rsplit("/", 1)[1]
    if not FILE_NAME.fullmatch(file_name):
        yield 1, "file names are snake_case with .h or .cpp"
    banned = BANNED_WORDS.intersection(re.split(r"[_.]", file_name))
    if banned:
        yield 1, f'"{banned.pop()}" says nothing: name the file after the noun it serves'
    if re.search(r"^\s*#\s*define\s+\w*TINYGLTF_IMPLEMENTATION", text, re.M):
        yield 1, "tinygltf is a shared library here: never define TINYGLTF_IMPLEMENTATION"
    if file_name.endswith((".h", ".h.in")):
        if not text.startswith("//"):
            yield 1, "a header begins with a comment that says what it is"
        if not re.search(r"^#pragma once$", text, re.M):
            yield 1, "a header says #pragma once"


# A type that a namespace holds, an unnamed one too: what is within a class is indented. And another name for one.
TYPE = re.compile(r"^(?:struct|class|union|enum(?: class| struct)?) (\w+)(?: final)?\s*(?::(?!:)[^;{]*)?\{", re.M)
ALIAS = re.compile(r"^using (\w+) =\s*([^;]+);", re.M)


def types_of(text):
    """Name, line and what it stands for of each type of a source that a reader could take for another file's."""
    code = without_comments_and_strings(text)
    for match in TYPE.finditer(code):
        yield match.group(1), code.count("\n", 0, match.start()) + 1, None
    for match in ALIAS.finditer(code):
        meaning = re.sub(r"\s+", " ", match.group(2))
        if not meaning.endswith("::" + match.group(1)):  # no more than short for that one
            yield match.group(1), code.count("\n", 0, match.start()) + 1, meaning


def check_type_names(texts):
    """A name stands for one thing in all of the product, so that whoever searches for it finds that one."""
    known = {}
    for name, text in texts.items():
        for word, number, meaning in types_of(text):
            before, meant = known.setdefault(word, (name, meaning))
            if before != name and (meaning is None or meaning != meant):
                yield f"{name}:{number}: {word} is something else in {before}"


def check_circles(texts):
    """No .h with its .cpp includes what includes it in turn, by whatever way: plain types that both ends need get a
    header of their own."""
    unit = lambda name: name.rsplit(".", 1)[0]
    known = {}
    for name, text in texts.items():
        found = re.finditer(r'^\s*#\s*include\s*"([^"]+)"', text, re.M)
        arrows = ((unit(m.group(1)), f"{name}:{text.count(chr(10), 0, m.start()) + 1}") for m in found)
        known.setdefault(unit(name), []).extend((to, place) for to, place in arrows if to != unit(name))

    # Walk from each unit along its arrows; one that leads back to a unit under way closes a circle.
    done, way = set(), []

    def walk(here):
        way.append(here)
        for to, place in known.get(here, []):
            if to in way:
                yield f"{place}: goes in a circle: " + " -> ".join(part.rsplit("/", 1)[1] for part in [*way[way.index(to):], to])
            elif to not in done:
                yield from walk(to)
        done.add(way.pop())

    for start in sorted(known):
        if start not in done:
            yield from walk(start)


def check(root):
    """All that is wrong below `root`, as "file:line: what"."""
    root = pathlib.Path(root)
    wrong, product = [], {}
    files = [p for top in ("generator", "render", "cli", "python", "tests", "bench") for p in (root / top).rglob("*")]
    for path in sorted(p for p in files if p.suffix in (".h", ".cpp", ".hpp", ".cc", ".cxx", ".in")):
        name = path.relative_to(root).as_posix()
        text = path.read_text(encoding="utf-8")
        checks = check_file, partial(check_includes, root), check_test_includes, check_words, check_json
        found = [wrong_here for check_one in checks for wrong_here in check_one(name, text)]
        wrong += [f"{name}:{number}: {why}" for number, why in sorted(found)]
        if name.startswith(("generator/", "render/", "cli/", "python/")):
            product[name] = text
    return wrong + [*check_type_names(product), *check_circles(product), *check_scripts(root)]


# Below these every folder that holds sources has a README of its own; tests and benches have one each for the whole.
EXPLAINED = ("generator", "render", "cli", "python")
EXPLAINED_AS_A_WHOLE = ("tests", "bench")
MAY_BE_EXPLAINED = ("shaders", "scripts", "scenes", "styles")

# A file named in backticks: `pieces.h`, `section/face.h`, `generator/cut/cut.h`.
NAMED_FILE = re.compile(r"`([\w./-]+\.(?:h|cpp|py|sh|glsl|toml|txt|md))`")


def holds_sources(folder):
    return any(path.suffix in (".h", ".cpp") for path in folder.rglob("*"))


def folders_to_explain(root):
    for top in EXPLAINED:
        yield from (p for p in [root / top, *(root / top).rglob("*")] if p.is_dir() and holds_sources(p))
    yield from (root / top for top in EXPLAINED_AS_A_WHOLE if holds_sources(root / top))


def names_a_file(root, folder, named):
    """Whether the README of a folder may name it: by its way from there or from the root, or by its name alone if it
    lies in the folder or below."""
    if (folder / named).is_file() or (root / named).is_file() and "/" in named:
        return True
    return "/" not in named and any(path.is_file() for path in folder.rglob(named))


# A folder of the command line holds no more files than a reader takes in.
MAX_CLI_FILES = 30


def check_sizes(root):
    """All folders of the command line with too many files, as "file:line: what"."""
    root = pathlib.Path(root)
    cli = root / "cli"
    counts = {p: sum(f.is_file() for f in p.iterdir()) for p in [cli, *cli.rglob("*")] if p.is_dir()}
    return [f"{p.relative_to(root).as_posix()}:1: {n} files, of {MAX_CLI_FILES} at most"
            for p, n in sorted(counts.items()) if n > MAX_CLI_FILES]


def check_readmes(root):
    """All folders of the road without a README, and all that READMEs name and is not there, as "file:line: what"."""
    root = pathlib.Path(root)
    missing = [folder for folder in folders_to_explain(root) if not (folder / "README.md").is_file()]
    wrong = [f"{p.relative_to(root).as_posix()}:1: no README.md that tells its road" for p in missing]
    tops = EXPLAINED + EXPLAINED_AS_A_WHOLE + MAY_BE_EXPLAINED
    for path in [p for top in tops for p in (root / top).rglob("README.md")]:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            absent = [n for n in NAMED_FILE.findall(line) if not names_a_file(root, path.parent, n)]
            wrong += [f"{path.relative_to(root).as_posix()}:{number}: there is no `{named}`" for named in absent]
    return sorted(wrong)


def main():
    wrong = check(sys.argv[1]) + check_readmes(sys.argv[1]) + check_sizes(sys.argv[1])
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
