"""The add-on in a window, driven by Blender's timers: undo and redo, and how long the window waits.

    blender --factory-startup -P in_window.py -- ADDON.zip PROGRAM FOLDER
"""

import os
import pathlib
import sys
import time
import traceback

import bpy

ADDON, PROGRAM, FOLDER = sys.argv[sys.argv.index("--") + 1:]
pathlib.Path(FOLDER).mkdir(parents=True, exist_ok=True)
os.environ["PATH"] = os.path.dirname(PROGRAM) + ":" + os.environ["PATH"]
bpy.ops.preferences.addon_install(filepath=ADDON, overwrite=True)
bpy.ops.preferences.addon_enable(module="pomona_blender")

from pomona_blender import build_objects, settings  # noqa: E402
from pomona_blender.keeper import keeper  # noqa: E402
from pomona_blender.workshop import workshop  # noqa: E402


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


def steps():
    """What a person does; each yield waits until it is so, while Blender draws."""
    yield is_quiet
    in_window(bpy.ops.ed.undo_push, message="begin")
    began = time.monotonic()
    in_window(bpy.ops.pomona.add, "EXEC_DEFAULT", True, template="tomato", knives="half", quality="draft")
    took = time.monotonic() - began
    print(f"add returned after {took:.2f} s")
    assert took < 1.2, "the window waits some 0.4 s, and as long for the building of what has come"
    yield is_quiet
    assert len(pieces(roots()[0])) == 2
    volume = pieces(roots()[0])[0].data["volume"]

    in_window(bpy.ops.pomona.another_seed, "EXEC_DEFAULT", True)
    yield is_quiet
    assert pieces(roots()[0])[0].data["volume"] != volume
    while "--seed 1" in roots()[0].pomona.made:  # late work has a step of its own
        in_window(bpy.ops.ed.undo)
        yield is_quiet
    assert pieces(roots()[0])[0].data["volume"] == volume, "undo brings the first back"
    in_window(bpy.ops.ed.redo)
    yield is_quiet
    assert pieces(roots()[0])[0].data["volume"] != volume, "redo the second"

    # A plane as the knife, moved by hand.
    in_window(bpy.ops.pomona.add_knife, "EXEC_DEFAULT", True, is_plane=True)
    yield is_quiet
    root = roots()[0]
    assert len(pieces(root)) > 2
    made = root.pomona.made
    root.pomona.knives[1].plane.rotation_euler.z += 0.4
    yield lambda: roots()[0].pomona.made != made
    yield is_quiet
    in_window(bpy.ops.ed.undo_push, message="moved")
    for _ in range(12):  # back beyond everything, and forward again
        if in_window(bpy.ops.ed.undo.poll):
            in_window(bpy.ops.ed.undo)
            yield is_quiet
    for _ in range(12):
        if in_window(bpy.ops.ed.redo.poll):
            in_window(bpy.ops.ed.redo)
            yield is_quiet

    # Long work: a bar, and Escape.
    in_window(bpy.ops.pomona.add, "EXEC_DEFAULT", True, template="kiwi", knives="half", texture=4096)
    root = bpy.context.view_layer.objects.active
    assert not pieces(root), "it is under way"
    yield lambda: bpy.context.window_manager.pomona_is_watched
    workshop().stop_all()
    yield is_quiet
    yield lambda: not bpy.context.window_manager.pomona_is_watched
    bpy.ops.screen.screenshot(filepath=str(pathlib.Path(FOLDER, "window.png")))


def driven(script, seconds=120):
    """A timer of Blender's that goes through the steps, and ends Blender."""
    state = {"waits": next(script), "since": time.monotonic(), "last": time.monotonic(), "longest": 0.0}

    def tick():
        now = time.monotonic()
        state["longest"] = max(state["longest"], now - state["last"])
        try:
            if state["waits"]():
                state["waits"], state["since"] = next(script), time.monotonic()
            assert now - state["since"] < seconds, "this takes too long"
        except StopIteration:
            print(f"the longest between two timers: {state['longest']:.2f} s")
            finish(0)
        except BaseException:
            traceback.print_exc()
            finish(1)
        state["last"] = time.monotonic()
        return 0.02

    return tick


def finish(status):
    sys.stdout.flush()
    bpy.ops.preferences.addon_disable(module="pomona_blender")
    os._exit(status)


bpy.app.timers.register(driven(steps()), first_interval=1.0)
