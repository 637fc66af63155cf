"""The rules of the house over the documents: `check_documents.py ROOT` prints "file:line: what" and exits with 1 if
a line is longer than 120 columns, a table's row has not as many cells as its head, a link, a picture or a named file is
not there, or a command begins with a script that may not be run.

Tables, code, pictures, and lines that no space would let one break may be longer.
"""

import os
import pathlib
import re
import sys

WIDTH = 120
NO_DOCUMENTS = {"out", "build", "node_modules"}

LINK = re.compile(r"\]\(([^()\s]+)\)|(?:src|href)=\"([^\"]+)\"")
SCHEME = re.compile(r"[a-z]+:")
HEADING = re.compile(r"#+ +(.*)")
# Lists, quotes and what stands before a link: what is left is one word.
UNBREAKABLE = re.compile(r"\s*(?:[-*>]|\d+\.)?\s*\S+\s*")
# A file named by its path from the root: `generator/cut/cut.h`.
TOPS = ("bench", "cli", "cmake", "docs", "generator", "python", "render", "scenes", "scripts", "shaders", "styles", "templates", "tests")
NAMED = re.compile(rf"`((?:{'|'.join(TOPS)})/[\w./-]+\.\w+)`")
# A command that begins with a script: a line of code, or `scripts/look.py FILE`.
STARTED = re.compile(rf"(?:^ {{4}}|`)((?:{'|'.join(TOPS)})/[\w./-]+\.(?:py|sh|mjs))(?= [^`]|$)", re.M)
TELLS_THE_PAST = ("CHANGELOG.md",)  # what it names may be gone
TABLE_OR_PICTURE = re.compile(r"\s*(?:\||!\[|\[?<img|\[!\[|<!--)")


def documents(root):
    """All .md files but those that are built."""
    for path in sorted(root.rglob("*.md")):
        folders = path.relative_to(root).parts[:-1]
        if not any(name in NO_DOCUMENTS or name.startswith((".", "build")) for name in folders):
            yield path


def prose(text):
    """The numbered lines that are not code."""
    fenced, before = False, ""
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced and not indented_code(line, before):
            yield number, line
        # An indented block goes on as long as lines are indented.
        before = "" if not fenced and indented_code(line, before) else line


def indented_code(line, before):
    return line.startswith("    ") and not before.strip()


def anchor(heading):
    """A heading's anchor, as GitHub makes it."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
    return re.sub(r"[^\w\- ]", "", plain).strip().replace(" ", "-")


def anchors(path):
    """Those of a document; a heading that stands twice is numbered."""
    found = []
    for _, line in prose(path.read_text(encoding="utf-8")):
        if match := HEADING.fullmatch(line):
            name = anchor(match[1])
            same = sum(a == name or re.fullmatch(re.escape(name) + r"-\d+", a) is not None for a in found)
            found.append(f"{name}-{same}" if same else name)
    return found


def fault_of(path, target):
    """What is wrong with a link of the document `path`, or nothing."""
    place, _, fragment = target.partition("#")
    if SCHEME.match(target):
        return None
    leads_to = path.parent / place if place else path
    if not leads_to.exists():
        return f"there is no {target}"
    if fragment and leads_to.suffix == ".md" and fragment not in anchors(leads_to):
        return f"{leads_to.name} has no heading #{fragment}"
    return None


def uneven_rows(lines):
    """The numbers of the rows that have more or fewer cells than the head of their table."""
    head, before = 0, -1
    for number, line in lines:
        if line.startswith("|"):
            cells = re.sub(r"`[^`]*`", "", line.replace("\\|", "")).count("|")
            head = cells if number != before + 1 else head
            before = number
            if cells != head:
                yield number


def started_scripts(text):
    """The scripts that commands begin with, by the numbers of their lines."""
    for match in STARTED.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, match[1]


def check(root):
    """All that is wrong below `root`, as "file:line: what"."""
    root = pathlib.Path(root)
    wrong = []
    for path in documents(root):
        name = path.relative_to(root).as_posix()
        text = path.read_text(encoding="utf-8")
        lines = list(prose(text))
        wrong += [f"{name}:{number}: {script} may not be run: chmod +x" for number, script in started_scripts(text)
                  if (root / script).exists() and not os.access(root / script, os.X_OK)]
        wrong += [f"{name}:{number}: another number of cells than the table's head" for number in uneven_rows(lines)]
        for number, line in lines:
            if len(line) > WIDTH and not TABLE_OR_PICTURE.match(line) and not UNBREAKABLE.fullmatch(line):
                wrong.append(f"{name}:{number}: {len(line)} columns, more than {WIDTH}")
            shown = re.sub(r"`[^`]*`", "``", line)
            targets = [first or second for first, second in LINK.findall(shown)]
            wrong += [f"{name}:{number}: {why}" for t in targets if (why := fault_of(path, t))]
            named = NAMED.findall(line) if name not in TELLS_THE_PAST else []
            wrong += [f"{name}:{number}: there is no `{n}`" for n in named if not (root / n).exists()]
    return wrong


def main():
    wrong = check(sys.argv[1])
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
