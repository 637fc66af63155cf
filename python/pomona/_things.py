"""Fruit, pieces, sections and scenes: what the functions of the package give."""

import functools
import os
from collections.abc import Mapping, Sequence

import numpy

from . import _core
from ._options import takes
from ._toml import text_of


def named(what, kind):
    """What the binding opens: a name or path, or the text of a file and what messages call it."""
    if isinstance(what, Mapping):
        return f"a {kind} of Python", text_of(what)
    if isinstance(what, os.PathLike):
        return os.fspath(what), None
    if not isinstance(what, str):
        raise TypeError(f"a {kind} is a name, a path, the text of a file or a dictionary: no {type(what).__name__}")
    return (f"a {kind} of Python", what) if "\n" in what else (what, None)


def names(path, more):
    return [os.fspath(one) for one in (path, *more)]


class Drawn:
    """What can be written and drawn."""

    def __init__(self, core):
        self._core = core


class Truth:
    """What each pixel of a picture shows. The arrays have the picture's shape; numbers begin at 1, 0 is the table.

    instance, fruit, part   numbers; `instances`, `fruits` and `parts` are what they stand for, from 1 on
    organ                   of pieces and scenes: the berry of a bunch, by its number; 0: the fruit itself
    depth                   metres along the line of sight of the picture's middle
    normal                  unit, in the scene's frame
    section                 1 where a cut face shows
    """

    def __init__(self, arrays):
        for name, value in arrays.items():
            setattr(self, name, value)

    def __repr__(self):
        return f"<pomona.Truth {self.instance.shape[1]}x{self.instance.shape[0]}, {len(self.instances)} instances>"


class Piece(Drawn):
    """A piece of a fruit, or a solid of a scene. Its arrays show what the .glb holds; they are views: nothing is
    copied, nobody can write to them, and they keep what they show alive."""

    def __init__(self, pieces, number):
        self._pieces, self._number = pieces, number
        self._words = pieces.words(number)

    @functools.cached_property
    def _core(self):
        return self._pieces.lone(self._number)

    @functools.cached_property
    def _arrays(self):
        return self._pieces.arrays(self._number)

    @functools.cached_property
    def _facts(self):
        return self._pieces.facts(self._number)

    @property
    def name(self):
        """Unique among its pieces: "tomato.wedge-2"."""
        return self._words["name"]

    @property
    def part_names(self):
        """What the numbers of `parts` stand for."""
        return self._words["part_names"]

    @property
    def template(self):
        """The template's name or path, as it was given."""
        return self._words["template"]

    @property
    def seed(self):
        return self._words["seed"]

    @property
    def index(self):
        """Which of the seed's variants."""
        return self._words["index"]

    @property
    def knives(self):
        """By which it was cut, in their order."""
        return self._words["knives"]

    @property
    def closed(self):
        """Whether its mesh encloses a volume."""
        return self._words["closed"]

    @property
    def crumb(self):
        """Whether it is one of the bits below a millionth of the fruit."""
        return self._words["crumb"]

    @functools.cached_property
    def command(self):
        """The command of the program that makes it again; "" if it is no piece of a template that has a name."""
        return self._pieces.command(self._number)

    @property
    def positions(self):
        """n x 3, metres, in the frame in which the fruit grew; +Y is up."""
        return self._arrays["positions"]

    @property
    def normals(self):
        """n x 3, of unit length."""
        return self._arrays["normals"]

    @property
    def colors(self):
        """n x 3, linear RGB, 0 to 1."""
        return self._arrays["colors"]

    @property
    def parts(self):
        """n indices into `part_names`."""
        return self._arrays["parts"]

    @property
    def uv(self):
        """n x 2, (0, 0) is the upper left corner of `texture`; 0 x 2 without the option texture."""
        return self._arrays["uv"]

    @property
    def texture(self):
        """Height x width x 3, sRGB of 8 bits; None without the option texture."""
        return self._arrays.get("texture")

    @property
    def triangles(self):
        """m x 3 indices, counter-clockwise seen from the air."""
        return self._arrays["triangles"]

    @property
    def cut_faces(self):
        """m indices: which cut face a triangle belongs to, -1 on the skin."""
        return self._arrays["cut_faces"]

    @property
    def volume(self):
        """Cubic metres."""
        return self._facts["volume"]

    @property
    def mass(self):
        """Kilograms; parts inside may have densities of their own."""
        return self._facts["mass"]

    @property
    def density(self):
        """The mean, kilograms per cubic metre."""
        return self._facts["density"]

    @property
    def center(self):
        """The centre of mass, metres."""
        return self._facts["center"]

    @property
    def inertia(self):
        """3 x 3, about the centre of mass, along the axes of the positions, kg m^2."""
        return self._facts["inertia"]

    @property
    def bounds(self):
        """2 x 3: the lowest and the highest corner of its box, metres."""
        return numpy.array([self._facts["low"], self._facts["high"]])

    @takes("cut", "write")
    def write(self, path, *more, progress=None, **options):
        """Writes the piece alone, in the format of the path's ending; several paths at once. Returns the paths of all
        files that were written."""
        return self._core.write(names(path, more), options, progress)

    @takes("cut", "write")
    def render(self, *, progress=None, **options):
        """A picture of the piece: height x width x 3, sRGB of 8 bits."""
        return self._core.render(options, progress)

    def to_trimesh(self):
        """The piece as a trimesh.Trimesh, with its colours at the vertices, where trimesh is installed."""
        import trimesh  # none of Pomona's own needs

        light = numpy.clip(self.colors, 0, 1)
        srgb = numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
        return trimesh.Trimesh(self.positions, self.triangles, vertex_normals=self.normals,
                               vertex_colors=numpy.round(255 * srgb).astype(numpy.uint8), process=False)

    def __repr__(self):
        return f"<pomona.Piece {self.name}>"


class Pieces(Drawn, Sequence):
    """The pieces of a fruit, in the order of cutting: a sequence of `Piece`."""

    def __getitem__(self, which):
        if isinstance(which, slice):
            return [self[number] for number in range(*which.indices(len(self)))]
        number = range(len(self))[which]
        return Piece(self._core, number)

    def __len__(self):
        return len(self._core)

    @takes("cut", "write")
    def write(self, path, *more, progress=None, **options):
        """Writes all pieces, in the format of the path's ending, as `pomona cut` does; several paths at once. Returns
        the paths of all files that were written."""
        return self._core.write(names(path, more), options, progress)

    @takes("cut", "write")
    def render(self, *, progress=None, **options):
        """A picture of the pieces side by side: height x width x 3, sRGB of 8 bits."""
        return self._core.render(options, progress)

    @takes("cut", "write")
    def ground_truth(self, *, progress=None, **options):
        """What each pixel of render() shows: a `Truth`."""
        return Truth(self._core.ground_truth(options, progress))

    def __repr__(self):
        return f"<pomona.Pieces, {len(self)} of them>"


class Section(Drawn):
    """The cut faces of a fruit, as one mesh. Its arrays are views, as those of a `Piece`."""

    @functools.cached_property
    def _arrays(self):
        return self._core.arrays()

    @property
    def positions(self):
        """n x 3, metres."""
        return self._arrays["positions"]

    @property
    def colors(self):
        """n x 3, linear RGB, 0 to 1."""
        return self._arrays["colors"]

    @property
    def parts(self):
        """n indices into `part_names`."""
        return self._arrays["parts"]

    @property
    def triangles(self):
        """m x 3 indices."""
        return self._arrays["triangles"]

    @property
    def cut_faces(self):
        """m indices: which cut face a triangle belongs to."""
        return self._arrays["cut_faces"]

    @property
    def part_names(self):
        """What the numbers of `parts` stand for."""
        return self._arrays["part_names"]

    @takes("cut", "write")
    def write(self, path, *more, progress=None, **options):
        """Writes the section: .ply, .png or .svg. Returns the paths of all files that were written."""
        return self._core.write(names(path, more), options, progress)

    @takes("cut", "write")
    def render(self, *, progress=None, **options):
        """A picture of the section: height x width x 3, sRGB of 8 bits."""
        return self._core.render(options, progress)

    def __repr__(self):
        return f"<pomona.Section of {len(self.triangles)} triangles>"


class Fruit(Drawn):
    """A fruit as it grew, or several seeds of it side by side. Nothing changes it: cut it as often as you like."""

    @property
    def name(self):
        """Of its template."""
        return self._core.name

    @property
    def title(self):
        """For people: "Bell pepper"."""
        return self._core.title

    @property
    def part_names(self):
        return self._core.part_names

    @takes("cut", "cut")
    def cut(self, *knives, progress=None, **options):
        """Cuts it by these knives, one after another, and colours what they open: `Pieces`; with section=True a
        `Section`. docs/reference/knives.md tells of knives. Without any its bodies come out whole."""
        options["knife"] = [*knives, *as_list(options.get("knife"))]
        core = self._core.cut(options, progress)
        return Section(core) if isinstance(core, _core.BareSection) else Pieces(core)

    @takes("cut", "cut")
    def section(self, *knives, progress=None, **options):
        """The cut faces alone, in place of the pieces: a `Section`."""
        return self.cut(*knives, progress=progress, **{**options, "section": True})

    @takes("grow", "cut")
    def write(self, path, *more, progress=None, **options):
        """Writes it whole, in the format of the path's ending, as `pomona grow` does; several paths at once. Returns
        the paths of all files that were written."""
        return self._core.write(names(path, more), options, progress)

    @takes("grow", "cut")
    def render(self, *, progress=None, **options):
        """A picture of it, standing: height x width x 3, sRGB of 8 bits."""
        return self._core.render(options, progress)

    @takes("grow", "cut")
    def ground_truth(self, *, progress=None, **options):
        """What each pixel of render() shows: a `Truth`."""
        return Truth(self._core.ground_truth(options, progress))

    def __repr__(self):
        return f"<pomona.Fruit {self.name}>"


class Scene(Drawn):
    """Many cut variants, settled. `pieces` has each solid once; `instances` says where they lie."""

    @property
    def name(self):
        return self._core.name

    @property
    def title(self):
        """For people."""
        return self._core.title

    @property
    def seed(self):
        return self._core.seed

    @functools.cached_property
    def pieces(self):
        """The solids, dishes last: a list of `Piece`."""
        return [Piece(self._core, number) for number in range(len(self._core))]

    @functools.cached_property
    def instances(self):
        """Names of what lies in the scene, in the order of `poses`."""
        return [name for name, _ in self._core.instances()]

    @functools.cached_property
    def solids(self):
        """n indices into `pieces`: what each instance is."""
        return numpy.array([solid for _, solid in self._core.instances()], dtype=numpy.int32)

    @functools.cached_property
    def poses(self):
        """n x 4 x 4: from where a piece grew to where it lies, metres."""
        return self._core.poses()

    @takes("scene", "write")
    def write(self, path, *more, progress=None, **options):
        """Writes the scene, in the format of the path's ending, as `pomona scene` does; several paths at once. Returns
        the paths of all files that were written."""
        return self._core.write(names(path, more), options, progress)

    @takes("scene", "write")
    def render(self, *, progress=None, **options):
        """A picture of the scene: height x width x 3, sRGB of 8 bits."""
        return self._core.render(options, progress)

    @takes("scene", "write")
    def ground_truth(self, *, progress=None, **options):
        """What each pixel of render() shows: a `Truth`."""
        return Truth(self._core.ground_truth(options, progress))

    def __repr__(self):
        return f"<pomona.Scene {self.name}, {len(self.instances)} instances>"


def as_list(knives):
    return [knives] if isinstance(knives, str) else list(knives or [])


@takes("grow", "grow")
def grow(template, *, progress=None, **options):
    """Grows a fruit of a template: a `Fruit`. A template is a name of `pomona.templates()`, a path, the text of a
    template file, or the same as a dictionary."""
    return Fruit(_core.grow(*named(template, "template"), options, progress))


@takes("scene", "grow")
def scene(description, *, progress=None, **options):
    """Composes a scene: a `Scene`. It is described by a name of `pomona.scenes()`, a path, the text of a scene file, or
    the same as a dictionary."""
    return Scene(_core.scene(*named(description, "scene"), options, progress))
