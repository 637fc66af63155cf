"""What can go wrong in a line of C++, and which of all such faults are drawn."""

import hashlib
import random
import re

from .places import MUTATED, ROOT

SEED = 18


def blanked(text):
    """The same text, character for character, with comments, literals and preprocessor lines made blank."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#[^\n]*', re.S | re.M)
    return pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group(0)), text)


OPENING, CLOSING = "([{", ")]}"
# Where an expression of this operator ends, to the left and to the right, unless inside brackets.
LOOSER = {"logic": r"[,;?]|(?<!:):(?!:)|(?<![=!<>+\-*/|&^%])=(?!=)|<<|>>|\breturn\b|[-+*/|&]=", "order": r"&&|\|\|", "sum": r"[<>]=?|[=!]="}
ENDS = {
    "logic": re.compile(LOOSER["logic"]),
    "order": re.compile("|".join((LOOSER["logic"], LOOSER["order"]))),
    "sum": re.compile("|".join((LOOSER["logic"], LOOSER["order"], LOOSER["sum"], r"[+\-*/%|&^]="))),
}


def edge(line, places, brackets, other):
    """The first place, of these, that lies outside the brackets the walk began in."""
    depth = 0
    for i in places:
        if line[i] in other:
            depth += 1
        elif line[i] in brackets:
            if depth == 0:
                return i
            depth -= 1
    return None


def extent(line, at, length, kind):
    """Where the expression around an operator begins and ends; none where it does not lie within the line."""
    opening, closing = edge(line, range(at - 1, -1, -1), OPENING, CLOSING), edge(line, range(at + length, len(line)), CLOSING, OPENING)
    begin, end = 0 if opening is None else opening + 1, len(line) if closing is None else closing
    flat, depth = "", 0  # the same with the insides of brackets blank
    for c in line[begin:end]:
        depth -= c in CLOSING
        flat += " " if depth > 0 else c
        depth += c in OPENING
    ends = [(begin + found.start(), begin + found.end()) for found in ENDS[kind].finditer(flat)]
    left = max((after for _, after in ends if after <= at), default=None if opening is None else begin)
    right = min((before for before, _ in ends if before >= at + length), default=None if closing is None else end)
    if left is None or right is None:
        return None
    inside = line[left:right]
    left += len(inside) - len(inside.lstrip())
    return left, left + len(inside.strip())


def arguments(line, opening):
    """Begins and ends of the arguments of a call, and where it closes; none where that is not in this line."""
    depth, begin, found = 0, opening + 1, []
    for i in range(opening, len(line)):
        if line[i] in OPENING:
            depth += 1
        elif line[i] in CLOSING:
            depth -= 1
            if depth == 0:
                return found + [(begin, i)], i
        elif line[i] == "," and depth == 1:
            found.append((begin, i))
            begin = i + 2
    return None


TURNED = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ",
          " && ": " || ", " || ": " && ", " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * "}
KINDS = {" && ": "logic", " || ": "logic", " + ": "sum", " - ": "sum", " * ": "sum", " / ": "sum"}
SYMMETRIC = {"dot", "distance", "min", "max", "static_cast", "if", "for", "while", "switch", "assert", "lerp", "hypot", "minmax"}


def other_constant(text):
    if re.fullmatch(r"\d+u?", text):
        return {"0": "1", "1": "2"}.get(text, str(int(text.rstrip("u")) + 1) + ("u" if text.endswith("u") else ""))
    return f"(2 * {text} + (({text}) == 0 ? 1 : 0))"


def candidates(line):
    """(kind, begin, end, what stands there in the fault) for each thing that can go wrong in a line without comments."""
    for operator, other in TURNED.items():
        for found in re.finditer(re.escape(operator), line):
            span = extent(line, found.start(), len(operator), KINDS.get(operator, "order"))
            if span and span[0] < found.start() < span[1]:
                whole = line[span[0]:span[1]]
                at = found.start() - span[0]
                yield "operator", *span, whole[:at] + other + whole[at + len(operator):]
    for found in re.finditer(r"(?<![\w.])(\d+\.\d*(?:e-?\d+)?f?|\d+e-?\d+|\d+u?)(?![\w.'])", line):
        yield "constant", *found.span(), other_constant(found.group(0))
    for found in re.finditer(r"\b(?:if|while) \(", line):
        whole = arguments(line, found.end() - 1)
        if whole and len(whole[0]) == 1 and ";" not in line[slice(*whole[0][0])] and " = " not in line[slice(*whole[0][0])]:
            yield "condition", *whole[0][0], "!(" + line[slice(*whole[0][0])] + ")"
    for found in re.finditer(r"std::(min|max|clamp)\(", line):
        whole = arguments(line, found.end() - 1)
        if whole and len(whole[0]) in (2, 3):
            yield "limit", found.start(), whole[1] + 1, "(" + line[slice(*whole[0][0])] + ")"
    for found in re.finditer(r"(?:(?<=return )|(?<=[^\w>] )|(?<=[(\[!.]))([a-z]\w*)\((?=[^)])", line):
        whole = arguments(line, found.end() - 1)
        if whole and len(whole[0]) == 2 and found.group(1) not in SYMMETRIC:
            first, second = (line[slice(*span)] for span in whole[0])
            if first.strip() != second.strip() and not re.search(r"\bconst\b|&\s*\w+$", first):
                yield "arguments", found.start(), whole[1] + 1, f"{found.group(1)}({second.strip()}, {first.strip()})"
    for found in re.finditer(r"(?:(?<=[(\[])|(?<=[,=?:] )|(?<=return ))-(?=[\w(])", line):
        operand = re.match(r"-(?:[\w.:]+|\([^()]*\))(?:\([^()]*\))?", line[found.start():])
        if operand and not re.match(r"-\d", operand.group(0)):
            yield "sign", found.start(), found.start() + operand.end(), operand.group(0)[1:]
    found = re.fullmatch(r"(\s+)((?:[\w\]\[.()]|->)+ (?:[-+*/|]?=) .*;|(?:std::(?:sort|reverse)|\w+\.(?:push_back|insert|erase))\(.*\);)\s*", line)
    if found and not found.group(2).startswith(("return", "const", "auto")):
        yield "statement", found.start(2), found.end(2), None


def sources():
    files = [path for part in MUTATED for path in (ROOT / part).rglob("*.cpp")]
    return sorted(file.relative_to(ROOT).as_posix() for file in files)


class Fault:
    def __init__(self, file, line, kind, begin, end, text, sound):
        self.file, self.line, self.kind, self.begin, self.end, self.text, self.sound = file, line, kind, begin, end, text, sound
        words = "\0".join((file, kind, sound, text or "", str(begin)))
        self.name = hashlib.sha256(words.encode()).hexdigest()[:10]

    def told(self):
        return f"{self.file}:{self.line}: `{self.sound.strip()}` -> " + (f"`{self.text.strip()}`" if self.text else "left out")


def all_faults(file):
    """All candidates of a file, those of one line in turn; lines of constants that a compiler must know are left alone."""
    text = (ROOT / file).read_text(encoding="utf-8")
    for number, (line, raw) in enumerate(zip(blanked(text).splitlines(), text.splitlines()), 1):
        if re.search(r"\b(static_assert|template|case|enum|using|constexpr \w+ \w+\()", line) or re.match(r"\S", line) and not line.startswith("constexpr"):
            continue
        if re.match(r"\s*(?:static )?constexpr", line) and not re.match(r"\s*(?:static )?constexpr (?:double|float) \w+ = [^,]*;", line):
            continue
        for kind, begin, end, faulty in candidates(line):
            # Literals come back from the line as it is; where the fault moves them about it is left out.
            if '"' in raw[begin:end] and kind in ("arguments",):
                continue
            sound = raw[begin:end]
            if faulty is not None and sound != line[begin:end]:
                continue
            yield Fault(file, number, kind, begin, end, faulty, sound)


def drawn(count):
    """The same faults as long as the sources are the same: from each file in proportion to its lines, one a line."""
    files = sources()
    lines = {file: len((ROOT / file).read_text(encoding="utf-8").splitlines()) for file in files}
    total, owed, chosen = sum(lines.values()), 0.0, []
    for file in files:
        owed += count * lines[file] / total
        stream = random.Random(f"{SEED} {file}")
        by_kind = {}
        for fault in all_faults(file):
            by_kind.setdefault(fault.kind, []).append(fault)
        taken = set()
        while owed >= 1 and by_kind:
            kind = stream.choice(sorted(by_kind))
            fault = by_kind[kind].pop(stream.randrange(len(by_kind[kind])))
            if not by_kind[kind]:
                del by_kind[kind]
            # Two like lines of a file have like faults, of one name.
            if fault.line not in taken and fault.name not in taken:
                taken |= {fault.line, fault.name}
                chosen.append(fault)
                owed -= 1
    return chosen
