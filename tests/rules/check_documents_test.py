#!/usr/bin/env python3
"""Breaks each rule of check_documents.py once in a made-up tree, and keeps each once."""

import unittest

import check_documents
from check_sources_test import Tree

LONG = "word " * 24 + "word"


class Documents(Tree):
    check = staticmethod(check_documents.check)

    def test_prose_is_wrapped(self):
        self.assert_wrong({"docs/a.md": f"# A\n\n{LONG}\n"}, "docs/a.md:3", "124 columns")
        self.assert_wrong({"a.md": f"- {LONG[4:]}\n"}, "a.md:1", "122 columns")
        self.assert_fine({"a.md": LONG[5:]})

    def test_tables_code_pictures_and_long_words_may_be_longer(self):
        self.assert_fine({"a.md": f"| {LONG} |\n"})
        self.assert_fine({"a.md": f"```sh\n{LONG}\n```\n"})
        self.assert_fine({"a.md": f"As in\n\n    {LONG}\n    {LONG}\n"})
        self.assert_fine({"b.png": "", "a.md": f"![{LONG}](b.png)\n"})
        self.assert_fine({"a.md": "- https://example.org/" + "x" * 120 + "\n"})

    def test_rows_have_as_many_cells_as_their_table(self):
        self.assert_fine({"a.md": "| a | b |\n|---|---|\n| `c|d` | e\\|f |\n\n| a |\n"})
        self.assert_wrong({"a.md": "| a |\n|---|\n| c | | d |\n"}, "a.md:3", "cells")

    def test_what_follows_code_is_prose_again(self):
        self.assert_wrong({"a.md": f"```\n\n```\n{LONG}\n"}, "a.md:4", "columns")
        self.assert_wrong({"a.md": f"As in\n\n    code\n\n{LONG}\n"}, "a.md:5", "columns")

    def test_links_and_pictures_lead_somewhere(self):
        there = {"docs/b.md": "# B\n\n## A `c` part, and more\n", "docs/p.png": ""}
        links = "[b](docs/b.md), [c](docs/b.md#a-c-part-and-more), ![](docs/p.png), <img src=\"docs/p.png\">, [d](docs)\n"
        self.assert_fine(there | {"a.md": links + "[w](https://example.org) [s](#a)\n# A\n"})
        for gone in ("[b](b.md)", "![](p.png)", "<img src=\"p.png\" alt=\"\">", "[b](docs/b.md#gone)", "[s](#gone)"):
            self.assert_wrong(there | {"a.md": f"\nSee {gone}.\n"}, "a.md:2", "no ")

    def test_files_that_are_named_are_there(self):
        self.assert_fine({"cli/b.h": "", "docs/a.md": "See `cli/b.h`, `b.h` and `out/x.png`.\n"})
        self.assert_wrong({"docs/a.md": "See `cli/b.h`.\n"}, "docs/a.md:1", "no `cli/b.h`")
        self.assert_fine({"CHANGELOG.md": "`cli/b.h` is `cli/c.h`.\n"})

    def test_scripts_that_commands_begin_with_may_be_run(self):
        there = {"scripts/a.py": "#!/usr/bin/env python3\n"}
        for command in ("Run\n\n    scripts/a.py FILE\n", "Look,\n\n`scripts/a.py FILE`.\n", "Run\n\n    scripts/a.py\n"):
            self.assert_wrong(there | {"a.md": command}, "a.md:3", "scripts/a.py may not be run")
        self.assert_fine(there | {"a.md": "See `scripts/a.py`, and run `python3 scripts/a.py FILE`.\n"})

    def test_what_is_code_is_no_link(self):
        self.assert_fine({"a.md": "`[a](b)`\n\n```\n[a](b)\n```\n"})

    def test_what_is_built_is_not_read(self):
        self.assert_fine({"build/a.md": LONG, "build-clang/a.md": LONG, "out/a.md": LONG, ".npm/a.md": LONG})


if __name__ == "__main__":
    unittest.main()
