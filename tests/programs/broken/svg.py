"""Broken drawings: a body of two views."""

import re

from .case import Case

WHOLE = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" width="300mm" height="200mm" viewBox="0 0 300 200">
<g id="a" inkscape:label="side view"><path inkscape:label="axis" d="M 100 120 L 100 40"/><path inkscape:label="skin" d="M 100 40 C 120 40 140 60 140 80 C 140 100 120 120 100 120"/></g>
<g id="b" inkscape:label="top view"><circle inkscape:label="axis" cx="220" cy="80" r="2"/><circle inkscape:label="skin" cx="220" cy="80" r="40"/></g>
</svg>
"""
OUTLINE = "M 100 40 C 120 40 140 60 140 80 C 140 100 120 120 100 120"


def cases():
    whole = WHOLE.encode()

    def case(kind, done, text, wanted="told"):
        data = text if isinstance(text, bytes) else text.encode()
        assert data != whole, done
        return Case(f"SVG: {kind}", done, data, "svg", wanted, whole)

    def put(old, new, count=1):
        assert old in WHOLE, old
        return WHOLE.replace(old, new, count)

    # Paths
    for done, path in {"nothing": "", "blanks": "  ", "no command": "100 40 L 1 2", "an unknown command": "M 100 40 X 1 2", "half a number": "M 100 40 L 1e",
                       "a number too few": "M 100 40 C 1 2 3 4 5", "nan": "M nan 40 L 1 2", "inf": "M inf 40 L 1 2", "1e300": "M 1e300 40 L 1 2",
                       "1e999": "M 1e999 40 L 1 2", "one point": "M 100 40", "one place": "M 100 40 L 100 40", "a line first": "L 100 40 L 1 2",
                       "a flag of 2": "M 100 40 A 5 5 0 2 0 100 120", "a flag of 0.5": "M 100 40 A 5 5 0 0.5 0 100 120", "letters": "M a b L c d",
                       "a control character": "M 100 40 L \x1b 2", "HTML": "M 100 40 &lt;script&gt;", "a comma too many": "M 100,,40 L 1 2",
                       "a semicolon": "M 100 40; L 1 2", "units": "M 100mm 40mm L 1 2"}.items():
        yield case("paths", f"an outline of {done}", put(OUTLINE, path))
    for done, path in {"two strokes": OUTLINE + " M 10 10 L 20 20", "a crossing": "M 100 40 L 140 60 L 110 60 L 140 40 L 100 120",
                       "across the axis": "M 100 40 L 60 80 L 140 90 L 100 120", "away from the axis": "M 130 40 L 140 80 L 130 120"}.items():
        yield case("paths", f"an outline of {done}", put(OUTLINE, path))
    for done, path in {"glued numbers": OUTLINE.replace(" 40 ", "+40 "), "small commands": "m 100 40 c 20 0 40 20 40 40 c 0 20 -20 40 -40 40",
                       "more digits": OUTLINE.replace("120", "120.00"), "exponents": OUTLINE.replace("100", "1e2"),
                       "commas and line ends": OUTLINE.replace(" ", ",\n").replace("M,\n", "M ").replace(",\nC,\n", "\nC ")}.items():
        yield case("paths", f"an outline with {done}", put(OUTLINE, path), "whole")
    for length in range(2, len(OUTLINE), 5):
        yield case("paths", f"the first {length} letters of an outline", put(OUTLINE, OUTLINE[:length]), "told" if "C" in OUTLINE[:length] and length < 37 or length < 9 else "either")

    # Shapes
    for name, values in {"cx": ("x", "nan", "1e999", "5 5", "5parsecs", "1e300"), "r": ("x", "-40", "0", "nan", "", "40em", "1e300")}.items():
        for value in values:
            old = 'cx="220" cy="80" r="40"'
            yield case("shapes", f'{name}="{value}"', put(old, re.sub(rf'{name}="\d+"', f'{name}="{value}"', old)))
    for tag in ("image", "text", "foreignObject", "g", "script", "metadata", "use", "unknown", "html:div"):
        yield case("shapes", f"<{tag}> for an outline", put('<circle inkscape:label="skin"', f'<{tag} inkscape:label="skin"'))
    for done, old, new in (("polygon of one point", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<polygon inkscape:label="skin" points="1 2"/>'),
                           ("polygon of half a point", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<polygon inkscape:label="skin" points="1 2 3"/>'),
                           ("rectangle below nothing", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<rect inkscape:label="skin" width="-1" height="2"/>'),
                           ("use of nothing", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<use inkscape:label="skin" href="#none"/>'),
                           ("use of itself", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<use id="u" inkscape:label="skin" href="#u"/>'),
                           ("use of what uses it", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<use id="u" inkscape:label="skin" href="#w"/><use id="w" href="#u"/>'),
                           ("use of another file", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<use inkscape:label="skin" href="more.svg#a"/>'),
                           ("use of a group around it", '<circle inkscape:label="skin" cx="220" cy="80" r="40"/>', '<use inkscape:label="skin" href="#b"/>')):
        yield case("shapes", f"a {done}", put(old, new))

    # Transforms
    for value in ("rotate(x)", "rotate(", "rotate()", "matrix(1 0 0 1 0)", "matrix(1 0 0 1 0 0 0)", "scale(0)", "scale(1e300)", "translate(nan)", "skewX(90)",
                  "spin(3)", "translate(1 2 3)", "scale(1e999)", "matrix(0 0 0 0 0 0)", "translate(1,2) x", "rotate3d(1 0 0 5)"):
        yield case("transforms", value, put('<g id="a"', f'<g id="a" transform="{value}"'))
    for style in ("transform: rotate(5deg)", "transform:scale(2)", "transform-origin:center;transform:rotate(9deg)"):
        yield case("transforms", f"by its style, {style}", put('<g id="a"', f'<g id="a" style="{style}"'))
    for value in ("", "none", "translate(0)", "rotate(0)", " scale( 1 , 1 ) ", "matrix(1,0,0,1,0,0)translate(0,0)"):
        yield case("transforms", f"nothing, as {value!r}", put('<g id="a"', f'<g id="a" transform="{value}"'), "either" if value == "none" else "whole")

    # The page
    for value in ("", "0 0 300", "0 0 0 0", "0 0 -300 200", "0 0 nan 200", "x", "0 0 300 200 5", "0 0 1e300 1e300", "0 0 inf 200"):
        yield case("pages", f'viewBox="{value}"', put('viewBox="0 0 300 200"', f'viewBox="{value}"'), "either" if value == "" else "told")
    for value in ("", "0mm", "-300mm", "300parsecs", "nan", "1e999mm", "mm", "300 mm mm", "auto"):
        yield case("pages", f'width="{value}"', put('width="300mm"', f'width="{value}"'), "either" if value in ("auto", "") else "told")
    yield case("pages", "a page within the page", put('<g id="b"', '<svg viewBox="0 0 1 1"><g id="b"').replace("</svg>", "</svg></svg>"))

    # Names
    for done, old, new in (("no skin in a view", 'inkscape:label="skin" d', 'inkscape:label="peel" d'), ("no axis", 'inkscape:label="axis" d', 'inkscape:label="line" d'),
                           ("no side view", "side view", "view"), ("no top view", "top view", "view"), ("two skins", "</g>\n<g", f'<path inkscape:label="skin" d="{OUTLINE}"/></g>\n<g'),
                           ("two axes", "</g>\n<g", '<path inkscape:label="axis" d="M 90 120 L 90 40"/></g>\n<g'), ("two side views", "top view", "side view"),
                           ("an axis that is level", "M 100 120 L 100 40", "M 100 120 L 200 120"),
                           ("an axis of one place", "M 100 120 L 100 40", "M 100 120 L 100 120")):
        yield case("names", done, put(old, new))
    yield case("names", "a name in capitals", put('"skin"', '"SKIN"'), "either")
    yield case("names", "an id twice", put('id="b"', 'id="a"'), "either")
    yield case("names", "a control character in a name", put('"skin" d', '"sk&#x1b;in" d'))
    yield case("names", "NUL in a name", whole.replace(b'"skin" d', b'"sk\0in" d'))
    yield case("names", "a name in Latin-1", whole.replace(b'"skin" d', b'"sk\xefn" d'))
    yield case("names", "an unknown prefix", put("inkscape:label", "ink:label", 8))
    yield case("names", "another namespace by the usual prefix", put("http://www.inkscape.org/namespaces/inkscape", "http://example.com/"))
    yield case("names", "another namespace for all", put("http://www.w3.org/2000/svg", "http://example.com/"))

    # XML
    for length in (0, 1, 10, 60, *range(100, len(whole) - 8, 40)):
        yield case("XML", f"the first {length} bytes", whole[:length])
    for done, text in {"a tag that does not end": WHOLE.replace("</g>", "", 1), "tags that cross": WHOLE.replace("</g>\n</svg>", "</svg></g>"),
                       "an attribute without quotes": put('id="a"', "id=a"), "an attribute twice": put('id="a"', 'id="a" id="a"'), "two roots": WHOLE + "<svg/>",
                       "an unknown entity": put('"skin" d', '"&skin;" d'), "an ampersand alone": put('"skin" d', '"s & k" d'), "HTML around it": "<html>" + WHOLE[39:] + "</html>",
                       "a text before it": "drawing" + WHOLE[39:], "1000 groups": WHOLE.replace("</svg>", "<g>" * 1000 + "</g>" * 1000 + "</svg>"),
                       "entities of entities": '<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;">]>' + put("<g id", "<title>&b;</title><g id")[39:],
                       "an entity that is a file": '<!DOCTYPE svg [<!ENTITY a SYSTEM "/etc/passwd">]>' + put('"skin" d', '"&a;" d')[39:]}.items():
        yield case("XML", done, text, "either" if done in ("entities of entities", "two roots", "an attribute twice") else "told")
    yield case("XML", "compressed", b"\x1f\x8b\x08\0" + whole)
    for code in ("utf-16", "utf-32"):
        yield case("XML", f"as {code}", WHOLE.encode(code), "either")
    yield case("XML", "with a mark", b"\xef\xbb\xbf" + whole, "whole")
    yield case("XML", "with CR LF", WHOLE.replace("\n", "\r\n"), "whole")
    yield case("XML", "bytes behind its end", whole + b"\0\0\0", "either")
