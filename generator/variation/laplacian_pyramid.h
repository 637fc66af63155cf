// The Laplacian pyramid of a cyclic signal: its bands of frequencies, for texture synthesis.
#pragma once

#include <vector>

namespace pomona {

/// A periodic signal. Its length is a power of two.
using CyclicSignal = std::vector<double>;

/// Band 0 is the finest. The last band is what remains after all others; it has `coarsest` values. The children of
/// value i of a band are the values 2 i and 2 i + 1 of the next finer band.
using LaplacianPyramid = std::vector<CyclicSignal>;

/// Decomposes a signal [Burt & Adelson 1983], in one dimension, with the binomial filter 1 4 6 4 1.
LaplacianPyramid decompose(CyclicSignal signal, std::size_t coarsest = 8);

/// Composes a signal again: the inverse, exact up to rounding.
CyclicSignal compose(const LaplacianPyramid& pyramid);

}  // namespace pomona
