"""The add-on in a window, driven by Blender's timers: undo and redo, a plane that moves, Escape, the studio, and how
long the window waits.

    blender --factory-startup -P in_window.py -- ADDON.zip PROGRAM FOLDER [MODULE_FOLDER]

xdotool presses a key as a keyboard does."""

import os
import pathlib
import subprocess
import sys
import time
import traceback

import bpy

ADDON, PROGRAM, FOLDER, *MODULE = sys.argv[sys.argv.index("--") + 1:]
FOLDER = pathlib.Path(FOLDER)
FOLDER.mkdir(parents=True, exist_ok=True)
sys.path[:0] = MODULE
os.environ["PATH"] = os.path.dirname(PROGRAM) + ":" + os.environ["PATH"]
# A browser that writes the address down.
os.environ["BROWSER"] = f"sh -c 'echo %s >{FOLDER / 'opened'}'"
bpy.ops.preferences.addon_install(filepath=ADDON, overwrite=True)
bpy.ops.preferences.addon_enable(module="pomona_blender")

from pomona_blender import build_objects, settings  # noqa: E402
from pomona_blender.keeper import keeper  # noqa: E402
from pomona_blender.workshop import workshop  # noqa: E402

LONGEST = 0.5  # seconds for which nothing may hold up the window without a progress bar


class Clock:
    """Seconds that this thread was at work or let itself wait: the time of day less the time in which it was ready but
    others had the processor. So a busy machine does not count as the add-on's fault."""

    def __init__(self):
        self.restart()

    @staticmethod
    def now():
        ready = int(pathlib.Path("/proc/thread-self/schedstat").read_text().split()[1])
        return time.monotonic() - ready / 1e9

    def restart(self):
        self._began = self.now()

    @property
    def seconds(self):
        return self.now() - self._began


def roots():
    return list(settings.roots())


def pieces(root):
    return build_objects.pieces_of(root)


def in_window(operator, *words, **options):
    """As from a menu: with the window's context, and a step of undo."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        return operator(*words, **options)


def is_quiet():
    return not keeper().is_busy


def is_watched():
    return bpy.context.window_manager.pomona_is_watched


def steps():
    """What a person does, in words, and what is waited for while Blender draws."""
    yield "begin", is_quiet
    in_window(bpy.ops.ed.undo_push, message="begin")
    in_window(bpy.ops.pomona.add, "EXEC_DEFAULT", True, template="tomato", knives="half", quality="draft")
    yield "add", is_quiet
    assert len(pieces(roots()[0])) == 2
    volume = pieces(roots()[0])[0].data["volume"]

    in_window(bpy.ops.pomona.another_seed, "EXEC_DEFAULT", True)
    yield "another seed", is_quiet
    assert pieces(roots()[0])[0].data["volume"] != volume
    while "--seed 1" in roots()[0].pomona.made:  # late work has a step of its own
        in_window(bpy.ops.ed.undo)
        yield "undo", is_quiet
    assert pieces(roots()[0])[0].data["volume"] == volume, "undo brings the first back"
    in_window(bpy.ops.ed.redo)
    yield "redo", is_quiet
    assert pieces(roots()[0])[0].data["volume"] != volume, "redo the second"

    # A plane as the knife, dragged as by its gizmo: the cut follows while it moves.
    in_window(bpy.ops.pomona.add_knife, "EXEC_DEFAULT", True, is_plane=True)
    yield "a plane", is_quiet
    assert len(pieces(roots()[0])) > 2
    followed = {roots()[0].pomona.made}
    for _ in range(60):
        roots()[0].pomona.knives[1].plane.rotation_euler.z += 0.01
        yield "drag it", lambda: True
        followed.add(roots()[0].pomona.made)
    yield "let it go", is_quiet
    followed.add(roots()[0].pomona.made)
    assert len(followed) > 2, "drafts on the way, then as ordered"
    in_window(bpy.ops.ed.undo_push, message="moved")
    for _ in range(12):  # back beyond everything, and forward again
        if in_window(bpy.ops.ed.undo.poll):
            in_window(bpy.ops.ed.undo)
            yield "undo all", is_quiet
    for _ in range(12):
        if in_window(bpy.ops.ed.redo.poll):
            in_window(bpy.ops.ed.redo)
            yield "redo all", is_quiet

    # Long work has a bar, and a real Escape stops it.
    in_window(bpy.ops.pomona.add, "EXEC_DEFAULT", True, template="kiwi", knives="half", texture=4096)
    name = bpy.context.view_layer.objects.active.name
    assert not pieces(bpy.data.objects[name]), "it is under way"
    yield "a texture", is_watched
    began = time.monotonic()
    presses = subprocess.Popen(["xdotool", "mousemove", "300", "200", "key", "Escape"])
    yield "Escape", is_quiet
    assert presses.wait() == 0 and time.monotonic() - began < 10, "it ended because of the key"
    assert bpy.data.objects[name].pomona.message == "Stopped", bpy.data.objects[name].pomona.message
    yield "the bar goes", lambda: not is_watched()

    # Much to build: textures, levels of detail, a scene of many fruits.
    in_window(bpy.ops.pomona.add, "EXEC_DEFAULT", True, template="strawberry", knives="half", texture=256, lod=2,
              quality="draft")
    yield "textures and levels", is_quiet
    assert len(build_objects.levels_of(bpy.context.view_layer.objects.active)) == 4
    in_window(bpy.ops.pomona.add_scene, "EXEC_DEFAULT", True, scene="ripeness")
    yield "a scene", is_quiet
    assert len(pieces(bpy.context.view_layer.objects.active)) > 4

    # The studio opens in the browser, and does not let the window wait for it.
    in_window(bpy.ops.wm.save_as_mainfile, filepath=str(FOLDER / "window.blend"))
    yield "save", is_quiet
    bpy.context.view_layer.objects.active = roots()[0]
    assert in_window(bpy.ops.pomona.studio, "EXEC_DEFAULT", True) == {"FINISHED"}
    yield "the studio", (FOLDER / "opened").is_file
    assert (FOLDER / "opened").read_text().startswith("http://127.0.0.1:")
    bpy.ops.screen.screenshot(filepath=str(FOLDER / "window.png"))


def driven(script, seconds=600):
    """A timer of Blender's that goes through the steps, and ends Blender."""
    clock, longest, state = Clock(), {}, {"since": time.monotonic()}
    state["doing"], state["waits"] = next(script)

    def tick():
        if state["doing"] not in ("begin", "save"):  # Blender's own first drawing, and its file
            longest[state["doing"]] = max(longest.get(state["doing"], 0), clock.seconds)
        clock.restart()
        try:
            if state["waits"]():
                state["doing"], state["waits"] = next(script)
                state["since"] = time.monotonic()
            assert time.monotonic() - state["since"] < seconds, f"this takes too long: {state['doing']}"
        except StopIteration:
            finish(longest)
        except BaseException:
            traceback.print_exc()
            leave(1)
        return 0.02

    return tick


def finish(longest):
    """On a busy machine other threads, which this one waits for, are late as well: in the same share."""
    at_work, ready = map(int, pathlib.Path("/proc/thread-self/schedstat").read_text().split()[:2])
    share = at_work / (at_work + ready)
    print("held up the window:", ", ".join(f"{doing} {held:.2f} s" for doing, held in longest.items()),
          f"with {share:.2f} of a processor")
    late = {doing: held for doing, held in longest.items() if held * share > LONGEST}
    print(f"too long: {late}" if late else "never too long")
    leave(1 if late else 0)


def leave(status):
    sys.stdout.flush()
    bpy.ops.preferences.addon_disable(module="pomona_blender")
    os._exit(status)


bpy.app.timers.register(driven(steps()), first_interval=1.0)
