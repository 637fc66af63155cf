"""What was seen, folder by folder, and what survived: docs/reports/mutants.md."""

import textwrap

from .faults import all_faults, sources
from .places import PAGE
from .results import read_results, said, why


def first_figures():
    """What was seen before tests were added for survivors; the results themselves know only the last."""
    return [r.get("text") or f"At first {r['seen']} of {r['shown']} faults of `{r['folder']}` were seen; tests were added for what survived, and the "
            "table is what they see now." for r in said("first")]


def folder_of(file):
    return "/".join(file.split("/")[:2])


def report(faults):
    """Writes the page and says its figures."""
    results, equivalent, unseen = read_results(), said("equivalent"), said("unseen")
    # A change of some source moves what is drawn; what was shown counts as long as it can be found in its file.
    there = {f.name: f for file in sources() for f in all_faults(file)} | {f.name: f for f in faults}
    judged = sorted(((there[name], result) for name, result in results.items() if name in there), key=lambda one: (one[0].file, one[0].line))
    survived = [(f, r) for f, r in judged if r[0] != "seen"]
    figures = told_figures(faults, results, judged, [f for f, _ in survived], equivalent)
    lines = ["# Mutants", "",
             f"Faults that a tool has put into the sources, and whether tests other than goldens see them. `make mutants` writes "
             "this page; `scripts/mutants.py` says how they are drawn and shown.", "",
             figures, "", *[line for first in first_figures() for line in (first, "")],
             *folders_table(judged, equivalent), "",
             "Survivors that could be seen; `tests/mutants.toml` says of the others why nothing can see them. \"Asked\" is how many tests a "
             "fault was shown to, of those that reach its place.", "",
             *survivors_table([one for one in survived if not why(one[0], equivalent)], unseen)]
    lines = [line if line.startswith("|") else textwrap.fill(line, 120, break_long_words=False) for line in lines]
    PAGE.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(figures)


def told_figures(faults, results, judged, survived, equivalent):
    """How many were drawn, shown, seen, in words."""
    excused = sum(bool(why(f, equivalent)) for f in survived)
    not_shown = sum(f.name not in results for f in faults)
    seen, could = len(judged) - len(survived), len(judged) - excused
    files = {f.file for f, _ in judged}
    return (f"{len(faults)} faults are drawn; {not_shown} of them have not been shown, for they do not compile, or are drawn anew since sources "
            f"changed. {len(judged)} have been shown, those that are no longer drawn but still found in their files among them, in "
            f"{len(files)} of {len(sources())} files: {seen} were seen, {len(survived)} survived, of which {excused} change nothing "
            f"that could be seen. That is {100 * seen / max(1, could):.1f} % of the {could} that could be seen, or {100 * seen / max(1, len(judged)):.1f} % of all.")


def folders_table(judged, equivalent):
    lines = ["| folder | faults | seen | survived | that could be seen |", "|---|--:|--:|--:|--:|"]
    for folder in sorted({folder_of(f.file) for f, _ in judged}):
        here = [(f, r) for f, r in judged if folder_of(f.file) == folder]
        left = [f for f, r in here if r[0] != "seen"]
        could = sum(not why(f, equivalent) for f in left)
        lines.append(f"| {folder} | {len(here)} | {len(here) - len(left)} | {len(left) or ''} | {could or ''} |")
    return lines


def survivors_table(survived, unseen):
    def row(fault, result):
        reason = f"{untold(result[2])} {why(fault, unseen)}"
        return f"| {fault.told().replace('|', chr(92) + '|')} | {result[2].replace('/', ' of ')} | {reason} |"

    return ["| fault | asked | why |", "|---|--:|---|", *(row(*one) for one in survived)]


def untold(asked):
    return "**no test comes by**" if asked.endswith("/0") else "**not seen**"
