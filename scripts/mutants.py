#!/usr/bin/env python3
"""Changes the generator and its exporters by itself, one small fault at a time, and asks the tests whether they see it.

    mutants.py list [--count N] [--only PATH]        the faults, one a line
    mutants.py make [...]                            compiles them all at once; drops those that do not compile
    mutants.py map                                   which test reaches which fault, and what each test costs
    mutants.py show [...] [--seconds S]              shows each fault to the tests that reach it; goes on where it was stopped
    mutants.py report                                what was seen, folder by folder, and what survived: docs/reports/mutants.md
    mutants.py make|map|show --survivors [--asked T] the same for what survived alone, in build/mutants_survivors: a matter of
                                                     minutes, with the tests written for it

Faults are turned comparisons, signs and conditions, other constants, limits that are left out, arguments that change
places, statements that are missing. A fixed seed draws them from all sources (.cpp) of `generator` and `render/export`,
from each file in proportion to its lines. All are compiled into one copy of the sources, each behind
`(pomona_fault(K) ? faulty : sound)`; the environment variable POMONA_MUTANT chooses one when a program starts.

GoogleTest tests are asked; golden pictures, tests by other programs, scripts and published hashes are not. Each test
first runs once without a fault and notes which faults' places it reaches (POMONA_MUTANT_MAP). A fault is then shown to
those tests alone, the cheap ones first, until one fails. A crash, more than four times the usual processor time and ten
seconds, or more than 6 GB counts as seen. tests/mutants.toml says of survivors why nothing can see them. Works in
build/mutants; what was shown is kept in tests/mutants_shown.tsv.
"""

import argparse
import os
import sys

from mutation.faults import drawn
from mutation.faulty_copy import FaultyCopy
from mutation.report import report
from mutation.results import survivors
from mutation.show import map_all, show_all


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("verb", choices=("list", "make", "map", "show", "report"))
    parser.add_argument("--count", type=int, default=460, help="how many are drawn; some of them will not compile")
    parser.add_argument("--only", default="", help="show only files whose path begins so; several with commas between")
    parser.add_argument("--survivors", action="store_true",
                        help="those alone that survived, and are not said to be no faults: in a copy of its own, build/mutants_survivors")
    parser.add_argument("--seconds", type=float, default=1e9, help="of processor time after which a fault is shown to no further tests")
    parser.add_argument("--again", default="", help="tests that are noted once more, as a regular expression")
    parser.add_argument("--asked", default="", help="note and ask only tests of these names, a regular expression: new ones, for survivors")
    parser.add_argument("--tests", default="", help="make only the tests of these folders, with commas between; only they are asked then")
    parser.add_argument("--unchecked", action="store_true", help="what is left is known to compile")
    parser.add_argument("--longest", type=float, default=300, help="of processor time that a test may take without a fault, to be asked at all")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    copy = FaultyCopy("mutants_survivors" if options.survivors else "mutants")
    if options.survivors and options.verb == "make":
        copy.keep_survivors()
    faults = drawn(options.count) if not options.survivors else survivors() if options.verb == "list" else copy.kept_survivors()
    if options.verb == "list":
        for number, fault in enumerate(faults, 1):
            if fault.file.startswith(tuple(options.only.split(","))):
                print(number, fault.kind, fault.told())
    elif options.verb == "make":
        copy.make(faults, options)
        print(f"{len(copy.numbered(faults))} faults compile")
    elif options.verb == "map":
        map_all(copy, faults, options)
    elif options.verb == "show":
        show_all(copy, faults, options)
    else:
        report(faults)
    return 0


if __name__ == "__main__":
    sys.exit(main())
