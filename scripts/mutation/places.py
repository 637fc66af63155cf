"""Where the sources are that get faults, and what is kept of what was found."""

import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MUTATED = ("generator", "render/export")
RESULTS = ROOT / "tests" / "mutants_shown.tsv"
SAID = ROOT / "tests" / "mutants.toml"
PAGE = ROOT / "docs" / "reports" / "mutants.md"
