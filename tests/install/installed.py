"""Installs a build into a folder of its own, and runs what is installed there."""

import os
import pathlib
import subprocess

PREFIX = "usr/local"


def run(*words, folder=None, status=0):
    """Standard output of a program that must end with `status`."""
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True)
    if done.returncode != status:
        raise AssertionError(f"{words[0]} ended with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout if status == 0 else done.stderr


def install(build, folder):
    """The installed tree, below `folder` by way of DESTDIR, then moved: nothing may know where it was made for."""
    environment = {**os.environ, "DESTDIR": f"{folder}/staged"}
    command = ["cmake", "--install", build, "--prefix", "/" + PREFIX]
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    tree = pathlib.Path(folder) / "tree"
    (pathlib.Path(folder) / "staged" / PREFIX).rename(tree)
    return tree
