// A cyclic signal taken apart into bands of frequencies, as texture synthesis needs it.
#pragma once

#include <vector>

namespace pomona {

/// A periodic signal. Its length is a power of two.
using CyclicSignal = std::vector<double>;

/// Band 0 is the finest; the last one is what remains after all others, with `coarsest` values. Value i of a
/// band has values 2 i and 2 i + 1 of the next finer band as its children.
using LaplacianPyramid = std::vector<CyclicSignal>;

/// [Burt & Adelson 1983] in one dimension, with the binomial filter 1 4 6 4 1.
LaplacianPyramid taken_apart(CyclicSignal signal, std::size_t coarsest = 8);

/// The exact inverse up to rounding.
CyclicSignal put_together(const LaplacianPyramid& pyramid);

}  // namespace pomona
