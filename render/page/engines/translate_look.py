#!/usr/bin/env python3
"""Makes the look-up in HLSL, WGSL and Godot's shading language of its text in GLSL, so that it is written once.

    translate_look.py FOLDER      writes look.hlsl, look.wgsl and look.gdshaderinc there

It knows the GLSL of look.glsl, no more: one statement a line, `do` loops that count up, no names but its own.
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ABOUT = """// The colour inside a fruit at any point, in {language}: look.glsl, translated.
// docs/reference/asset.md tells how the four textures are made of an asset. {more}

"""
SAMPLERS = ("pomona_grid", "pomona_cell", "pomona_list", "pomona_triangle")
COMPARED = {"greaterThanEqual": ">=", "lessThanEqual": "<=", "lessThan": "<"}


def split(text):
    """At commas that stand in no parentheses."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def closing(text, at):
    """Where the parenthesis that opens at `at` is closed."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "(") - (text[i] == ")")
        if depth == 0:
            return i
    raise ValueError(f"no end: {text}")


def calls(text, names, made):
    """Each call of one of the names as made(name, arguments) has it, inner ones first."""
    at = 0
    while match := re.compile(rf"\b({names})\(").search(text, at):
        end = closing(text, match.end() - 1)
        inside = calls(text[match.end():end], names, made)
        whole = made(match.group(1), split(inside))
        text = text[:match.start()] + whole + text[end + 1:]
        at = match.start() + len(whole)
    return text


def parts_of(text):
    """The uniforms as (what is said of it, type, name), and the functions."""
    uniforms = re.findall(r"// (.*)\nuniform (?:highp )?(\w+) (\w+);\n", text)
    return uniforms, text[text.index("\n\n", text.rindex("\nuniform")) + 2:]


def godot(uniforms, body):
    hints = {name: "filter_nearest, repeat_disable" for name in SAMPLERS} | {
        "pomona_grid": "source_color, filter_linear, repeat_disable"}
    head = ABOUT.format(language="Godot 4's shading language", more='Use it by #include "look.gdshaderinc".')
    for said, kind, name in uniforms:
        head += f"// {said}\nuniform {kind} {name}{' : ' + hints[name] if name in hints else ''};\n"
    return head + "\n" + body


HLSL_MIX = """// `b` where `which` says so, else `a`.
float4 pomona_mix(float4 a, float4 b, bool4 which) {
  return float4(which.x ? b.x : a.x, which.y ? b.y : a.y, which.z ? b.z : a.z, which.w ? b.w : a.w);
}

"""


def hlsl(uniforms, body):
    kinds = {"pomona_grid": "Texture3D<float4>", "pomona_cell": "Texture3D<uint2>", "pomona_list": "Texture2D<uint>",
             "pomona_triangle": "Texture2D<uint4>"}
    text = ABOUT.format(language="HLSL", more="Shader model 5 or later: Unreal, Unity, Direct3D.")
    for said, kind, name in uniforms:
        if name in kinds:
            text += f"// {said}\n{kinds[name]} {name};\n"
    text += "// Of the grid: linear, clamped.\nSamplerState pomona_linear;\ncbuffer pomona {\n"
    for said, kind, name in uniforms:
        if name not in kinds:
            text += f"  // {said}\n  {kind} {name};\n"
    text += "};\n\n"

    body = calls(body, "texelFetch", lambda _, of: f"{of[0]}.Load(int{'4' if of[0] in SAMPLERS[:2] else '3'}({of[1]}, 0))")
    body = calls(body, "textureLod", lambda _, of: f"{of[0]}.SampleLevel(pomona_linear, {of[1]}, {of[2]})")
    body = calls(body, "|".join(COMPARED), lambda name, of: f"({of[0]} {COMPARED[name]} {of[1]})")
    body = re.sub(r"(Pomona\w+ \w+ = )Pomona\w+\((.*)\);", r"\1{\2};", body).replace("mix(", "pomona_mix(")
    body = calls(body, r"[iub]?vec[234]", lambda name, of: f"({name})({of[0]})" if len(of) == 1 else f"{name}({', '.join(of)})")
    text += HLSL_MIX + body
    text = re.sub(r"\b([iub]?)vec([234])\b", lambda m: {"": "float", "i": "int", "u": "uint", "b": "bool"}[m[1]] + m[2], text)
    return text.replace("mat3", "float3x3").replace("  do {", "  [loop] do {", 1)


WGSL_TYPES = {"float": "f32", "int": "i32", "uint": "u32", "bool": "bool", "mat3": "mat3x3f"} | {
    f"{kind}vec{n}": f"vec{n}{letter}" for kind, letter in (("", "f"), ("i", "i"), ("u", "u")) for n in (2, 3, 4)} | {
    "bvec4": "vec4<bool>", "PomonaFit": "PomonaFit", "PomonaRays": "PomonaRays"}
TYPE = "|".join(WGSL_TYPES)


def selected(text):
    """`c ? a : b` as select(b, a, c), in parentheses and outside them."""
    at = 0
    while match := re.compile(r"\(").search(text, at):
        end = closing(text, match.start())
        inside = ", ".join(selected(part) for part in split(text[match.end():end]))
        text = text[:match.end()] + inside + text[end:]
        at = match.end() + len(inside) + 1
    depth, colon, question = 0, -1, -1
    for i, letter in enumerate(text):
        depth += (letter in "([") - (letter in ")]")
        if depth == 0 and letter == "?" and question < 0:
            question = i
        if depth == 0 and letter == ":":
            colon = i
    if question < 0:
        return text
    yes, no = text[question + 1:colon].strip(), text[colon + 1:].strip()
    return f"select({no}, {yes}, {text[:question].strip()})"


def wgsl_statement(line):
    indent, code, said = re.fullmatch(r"( *)(.*?)(  //.*)?", line).groups()
    said = said or ""
    if match := re.fullmatch(rf"(?:{TYPE}) (\w+ = .*);", code):
        made = [re.sub(r"^(\w+) = (.*)", lambda m: f"var {m[1]} = {selected(m[2])};", one) for one in split(match.group(1))]
        return "\n".join(indent + one for one in made) + said
    if match := re.fullmatch(r"if \((.*)\) ([^{]*;)", code):
        return f"{indent}if ({match.group(1)}) {{ {match.group(2)} }}{said}"
    if code == "do {":
        return indent + "loop {"
    if match := re.fullmatch(r"\} while \(\+\+(\w+) < (.*)\);", code):
        name, end = match.groups()
        return f"{indent}  continuing {{\n{indent}    {name}++;\n{indent}    break if {name} >= {end};\n{indent}  }}\n{indent}}}"
    if match := re.fullmatch(r"(.* [-+]?= )(.*);", code):
        return f"{indent}{match.group(1)}{selected(match.group(2))};{said}"
    return line


def wgsl_function(match):
    kind, name, given, body = match.groups()
    given = [re.fullmatch(r"(inout |out )?(\w+) (\w+)", one).groups() for one in split(" ".join(given.split()))]
    body = "\n".join(wgsl_statement(line) for line in body.split("\n"))
    for how, of, what in given:
        if how == "inout ":
            body = re.sub(rf"\b{what}\.", f"(*{what}).", body)
    told = [what for how, _, what in given if how == "out "]
    if told:
        body = "\n".join(f"  var {what}: {WGSL_TYPES[of]};" for how, of, what in given if how == "out ") + "\n" + body
        body = re.sub(r"return (true|false);", lambda m: f"return PomonaFound({m[1]}, {', '.join(told)});", body)
        kind = "PomonaFound"
    taken = [f"{what}: " + (f"ptr<function, {of}>" if how else WGSL_TYPES[of]) for how, of, what in given if how != "out "]
    result = "" if kind == "void" else f" -> {WGSL_TYPES.get(kind, kind)}"
    return f"fn {name}({', '.join(taken)}){result} {{\n{body}\n}}"


WGSL_FOUND = """// Whether a point is inside, not in air; its colour, linear; which part of the fruit it is.
struct PomonaFound {
  inside: bool,
  color: vec3f,
  part: i32,
}

"""


def wgsl(uniforms, body):
    kinds = {"pomona_grid": "texture_3d<f32>", "pomona_cell": "texture_3d<u32>", "pomona_list": "texture_2d<u32>",
             "pomona_triangle": "texture_2d<u32>"}
    text = ABOUT.format(language="WGSL", more="The bindings are in a group of their own.") + "struct Pomona {\n"
    for said, kind, name in uniforms:
        if name not in kinds:
            text += f"  // {said}\n  {name.removeprefix('pomona_')}: {WGSL_TYPES[kind]},\n"
    text += "}\n"
    bound = [(name, kinds[name], said) for said, _, name in uniforms if name in kinds]
    bound.insert(1, ("pomona_linear", "sampler", "Of the grid: linear, clamped."))
    for number, (name, kind, said) in enumerate(bound):
        text += f"// {said}\n@group(0) @binding({number}) var {name}: {kind};\n"
    text += f"@group(0) @binding({len(bound)}) var<uniform> pomona: Pomona;\n\n" + WGSL_FOUND

    body = re.sub(r"([=*(,])\n +", r"\1 ", body)
    body = calls(body, "texelFetch", lambda _, of: f"textureLoad({', '.join(of)})")
    body = calls(body, "textureLod", lambda _, of: f"textureSampleLevel({of[0]}, pomona_linear, {of[1]}, {of[2]})")
    body = calls(body, "|".join(COMPARED), lambda name, of: f"({of[0]} {COMPARED[name]} {of[1]})")
    body = calls(body, "mix", lambda _, of: f"select({', '.join(of)})")
    body = re.sub(r"struct (\w+) \{\n(.*?)\};", lambda m: f"struct {m[1]} {{\n" + re.sub(
        rf"({TYPE}) (\w+);", lambda of: f"{of[2]}: {WGSL_TYPES[of[1]]},", m[2]) + "}", body, flags=re.S)
    body = re.sub(rf"^({TYPE}|void) (\w+)\(([^)]*)\) \{{\n(.*?)\n\}}", wgsl_function, body, flags=re.S | re.M)
    body = re.sub(r"\b(pomona_add|pomona_meet)\((?=\w+,)(?!\w+: )", r"\1(&", body)
    body = re.sub(rf"\b({TYPE})\(", lambda m: WGSL_TYPES[m[1]] + "(", body)
    return text + re.sub(r"\bpomona_(count|units|low|high)\b", r"pomona.\1", body)


def main():
    folder = pathlib.Path(sys.argv[1])
    uniforms, body = parts_of((HERE.parent / "look.glsl").read_text(encoding="utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    for name, made in (("look.hlsl", hlsl), ("look.wgsl", wgsl), ("look.gdshaderinc", godot)):
        (folder / name).write_text(made(uniforms, body), encoding="utf-8")


main()
