"""What the module costs beside the program's own work: at most 5 milliseconds a call, and no copy of a mesh.

    cost_test.py
"""

import resource
import time
import unittest

import pomona


def milliseconds(work, times):
    """The fastest of so many runs: the others waited for something else, too."""
    taken = []
    for _ in range(times):
        began = time.perf_counter()
        work()
        taken.append(1000 * (time.perf_counter() - began))
    return min(taken)


class Cost(unittest.TestCase):
    def test_a_call_into_the_module_and_its_thread(self):
        # The meshes are there: what is left is a thread that begins and ends, and the arrays around them.
        pieces = pomona.grow("cherry", detail=0.2).cut("half", quality="draft")
        pieces[0].positions
        self.assertLess(milliseconds(lambda: pieces[0].positions, 50), 5)

    def test_keywords_and_progress_beside_the_work(self):
        # The same picture, asked for in few words and in many, in turn.
        section = pomona.grow("cherry", detail=0.2).section("half", quality="draft")
        few, many = [], []
        for _ in range(40):
            few.append(milliseconds(lambda: section.render(size=(64, 64)), 1))
            many.append(milliseconds(lambda: section.render(size=(64, 64), dpi=72, style="ink", progress=print), 1))
        self.assertLess(min(many) - min(few), 5)

    def test_arrays_cost_nothing_and_no_memory(self):
        pieces = pomona.grow("tomato", seed=1).cut("half", quality="draft")
        pieces[0].positions
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        kept = []

        def look():
            piece = pieces[0]
            kept.append((piece.positions, piece.normals, piece.colors, piece.triangles))

        self.assertLess(milliseconds(look, 200), 5)
        held = sum(array.nbytes for array in kept[0])
        self.assertGreater(len(kept) * held, 40e6, "copies would show")
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - peak, 0.1 * len(kept) * held / 1024)


if __name__ == "__main__":
    unittest.main()
