"""Godot 3 without a window: imports a .glb, and runs a script on it."""

import pathlib
import re
import shutil
import subprocess
import time


def imported(file, folder, atlas=None):
    """A project with this scene, imported, and with its like that has an atlas. The folder is made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    scenes = {"scene.glb": file} | ({"atlas.glb": atlas} if atlas else {})
    for name, source in scenes.items():
        shutil.copy(source, folder / name)
    (folder / "project.godot").write_text('config_version=4\n[application]\nconfig/name="pomona"\n')

    # Godot 3's server imports what is in the folder, and then never ends: so it is ended when the scene is there.
    with open(folder / "import.log", "w") as log:
        editor = subprocess.Popen(["godot3-server", "--editor", "--quit", "--path", folder], stdout=log, stderr=log)
        ends = time.monotonic() + 120
        missing = lambda: [name for name in scenes if not list((folder / ".import").glob(f"{name}-*.md5"))]  # noqa: E731
        while missing() and time.monotonic() < ends and editor.poll() is None:
            time.sleep(0.1)
        time.sleep(0.5)
        editor.kill()
        editor.wait()


def printed(folder, script, seconds=120):
    """What a script beside this file prints, run in the project within so many seconds."""
    shutil.copy(pathlib.Path(__file__).with_name(script), folder)
    result = subprocess.run(["godot3-server", "--path", folder, "-s", script], capture_output=True, text=True, timeout=seconds)
    return result.stdout


def places(out, word):
    """Of the pieces by their names, metres, as godot_crate.gd prints them after this word."""
    return {name: tuple(map(float, place.split())) for name, place in re.findall(rf"^{word} (\S+) (.*)$", out, re.M)}
