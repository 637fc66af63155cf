"""What has been shown, and what is said of what survived."""

import tomllib

from .faults import all_faults, sources
from .places import RESULTS, SAID


def read_results():
    lines = RESULTS.read_text(encoding="utf-8").splitlines() if RESULTS.is_file() else []
    return {line.split("\t")[0]: line.split("\t")[1:] for line in lines}


def add_result(fault, told):
    with open(RESULTS, "a", encoding="utf-8") as file:
        file.write(f"{fault.name}\t{told}\n")


def said(kind):
    return tomllib.loads(SAID.read_text(encoding="utf-8")).get(kind, []) if SAID.is_file() else []


def why(fault, known):
    """What is said of a fault. Constants are alike in many lines: what is said of one goes by the fault's name."""
    found = [r["why"] for r in known if (r["file"], r["sound"], r.get("fault", "")) == (fault.file, fault.sound.strip(), (fault.text or "").strip())
             and r.get("name", fault.name) == fault.name]
    return found[0] if found else ""


def survivors():
    """What survived and is not said to be no fault, whether it is drawn yet or not, as long as it is found in its file."""
    results, known = read_results(), said("equivalent")
    found = [f for file in sources() for f in all_faults(file) if results.get(f.name, ("",))[0] == "survived" and not why(f, known)]
    return list({f.name: f for f in found}.values())
