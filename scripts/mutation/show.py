"""Shows faults to the tests that come by them, and keeps what they said."""

import re

from . import asked_tests
from .results import add_result, read_results


def tests_to_ask(copy, options):
    return [test for test in asked_tests.tests_of(copy.build) if re.search(options.asked, test.name)]


def map_all(copy, faults, options):
    """Notes for each test that was not noted yet which faults it reaches, by their names."""
    names = {number: fault.name for number, fault in enumerate(faults, 1)}
    asked_tests.note_all(tests_to_ask(copy, options), copy.work, names, options)


def asked_for(copy, faults, options):
    """Those of the files that the options name, in an order that any first part of is spread over all of them."""
    only = tuple(options.only.split(","))
    return sorted(((n, f) for n, f in copy.numbered(faults) if f.file.startswith(only)), key=lambda one: one[1].name)


def show_all(copy, faults, options):
    """A line in the results for each fault that has none; those that survived are asked again where they may be seen now."""
    tests, done = asked_tests.noted(tests_to_ask(copy, options), copy.work), read_results()
    wanted = [(n, f) for n, f in asked_for(copy, faults, options) if f.name not in done or options.survivors]

    def shown(one):
        number, fault = one
        seen, asked, reaching = asked_tests.show(number, fault.name, fault.file, tests, copy.work, options.seconds)
        if not seen and fault.name in done and asked <= int(done[fault.name][2].split("/")[0]):
            print(f"{number}\tsurvived these, too\t{asked}/{reaching}\t{fault.told()}", flush=True)
            return  # it has been shown to more
        told = f"{'seen' if seen else 'survived'}\t{seen}\t{asked}/{reaching}\t{fault.told()}"
        add_result(fault, told)
        print(f"{number}\t{told}", flush=True)

    asked_tests.in_turn(shown, wanted, options.jobs)
