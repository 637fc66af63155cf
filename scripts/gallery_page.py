#!/usr/bin/env python3
"""A gallery for the web: an index of all fruits, and a page for each that cuts it live (docs/reference/page.md).

    gallery_page.py PROGRAM FOLDER [TEMPLATE ...]   all templates unless some are named; ends with 1 beyond 40 MB
"""
import html
import json
import pathlib
import re
import subprocess
import sys

MOST_BYTES = 40_000_000
INDEX = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Fruit to be cut</title>
<style>
:root {{ --paper: #f7f3eb; --ink: #3a2e25; --faint: #3a2e2599; color-scheme: light; }}
@media (prefers-color-scheme: dark) {{ :root {{ --paper: #211e1b; --ink: #e9dfd0; --faint: #e9dfd099; color-scheme: dark; }} }}
body {{ margin: 0 auto; max-width: 1180px; padding: clamp(18px, 4vw, 48px); color: var(--ink); background: var(--paper);
  font: 17px/1.35 "EB Garamond", "Iowan Old Style", "Palatino Linotype", Palatino, Georgia, serif; }}
h1 {{ margin: 0; font-weight: 400; font-size: clamp(28px, 5vw, 46px); letter-spacing: .045em; font-variant-caps: small-caps; }}
p {{ margin: .2em 0 1.6em; font-style: italic; color: var(--faint); }}
ul {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(210px, 1fr)); gap: 26px; margin: 0; padding: 0; list-style: none; }}
a {{ display: block; color: inherit; text-decoration: none; text-align: center; }}
a:hover b, a:focus-visible b {{ text-decoration: underline; text-underline-offset: 4px; }}
img {{ width: 100%; height: auto; display: block; border-radius: 4px; }}
b {{ display: block; margin-top: .35em; font-weight: 400; font-size: 20px; }}
i {{ color: var(--faint); font-size: 15px; }}
</style>
</head>
<body>
<h1>Fruit to be cut</h1>
<p>{count} fruits, each a page of its own: turn it, cut it, pull it apart. {size:.0f} MB in all; nothing is loaded from elsewhere.</p>
<ul>
{items}
</ul>
</body>
</html>
"""


def latin_of(page):
    """Its Latin name, as the page has it."""
    found = re.search(r'<p id="latin" lang="la">(.*?)</p>', page.read_text()[:20_000])
    return html.unescape(found[1]) if found else ""


def entry(name, title, latin):
    said = html.escape(title)
    return (f'<li><a href="{name}.html"><img src="{name}.png" width="420" height="360" alt="{said}, cut in half" loading="lazy">'
            f"<b>{said}</b><i lang=\"la\">{html.escape(latin)}</i></a></li>")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, folder, wanted = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    known = json.loads(subprocess.run([program, "list", "--json"], check=True, capture_output=True, text=True).stdout)
    fruits = [fruit for fruit in known if not wanted or fruit["name"] in wanted]
    folder.mkdir(parents=True, exist_ok=True)
    for fruit in fruits:
        name = fruit["name"]
        print(f"gallery page: {name}", file=sys.stderr)
        subprocess.run([program, "cut", name, "--knife", "half", "--quiet", "--size", "420x360",
                        "-o", f"{folder}/{name}.html", "-o", f"{folder}/{name}.png"], check=True)
    files = [folder / f"{fruit['name']}.{kind}" for fruit in fruits for kind in ("html", "png")]
    size = sum(file.stat().st_size for file in files)
    items = "\n".join(entry(fruit["name"], fruit["title"], latin_of(folder / f"{fruit['name']}.html")) for fruit in fruits)
    (folder / "index.html").write_text(INDEX.format(count=len(fruits), size=size / 1e6, items=items))
    print(f"gallery page: {folder}/index.html, {len(fruits)} fruits, {size / 1e6:.1f} MB")
    return 1 if size > MOST_BYTES or not fruits else 0


if __name__ == "__main__":
    sys.exit(main())
